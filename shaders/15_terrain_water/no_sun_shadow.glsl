// The sun's visibility without shadow maps: all of its light arrives.
float sun_left_by_houses(vec3 position, vec3 normal, vec3 to_sun) { return 1.0; }

// Houses opposite shade the foot of a wall.
float sun_left_on_wall(vec3 position, vec3 normal, vec3 to_sun, float height_m) { return mix(0.5, 1.0, smoothstep(0.0, 14.0, height_m)); }
