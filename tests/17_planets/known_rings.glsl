// For tests of a pixel's footprint on rings: their light is the width that is asked for.
#pragma replaces "17_planets/rings.glsl"
vec4 ring_light(Rings rings, vec3 point, vec3 to_eye, vec3 to_sun, float width_m) { return vec4(width_m); }
float ring_shadow(Rings rings, vec3 point, vec3 to_sun, float sun_rad) { return 1.0; }
