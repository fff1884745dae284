// The Earth's clouds: a shell of their own above the ground.
#include "10_atmosphere/ground_light.glsl"
#include "17_planets/air_shell.glsl"
#include "17_planets/limb_fade.glsl"
#include "17_planets/map_lookup.glsl"

uniform sampler2D cloud_map;
const float cloud_m = 9000.0;  // height of the shell: that of high clouds

vec2 cloud_uv(vec3 round_up) {
    vec2 uv = map_uv(round_up);
    return vec2(uv.x + body.cloud_turn, uv.y);
}

float cloud_opacity(vec2 uv, float footprint_rad) { return planets.clouds * map_texel(cloud_map, uv, footprint_rad).r; }

// Straight above a place.
float clouds_over(vec3 round_up, float footprint_rad) { return cloud_opacity(cloud_uv(round_up), footprint_rad); }

// [cloud_shadow]
// The share of sunlight that reaches a place on the ground through the clouds where the ray to the sun meets the shell. Close
// to the terminator that is far away, and the shell's curve matters: the ray meets a sphere, not a plane.
float cloud_shadow(vec3 round_up, vec3 to_sun, float footprint_rad) {
    float r = body.radius, mu0 = dot(round_up, to_sun);
    if (mu0 <= 0.0) return 1.0;
    float t = cloud_m * (2.0 * r + cloud_m) / (r * mu0 + sqrt(r * r * mu0 * mu0 + cloud_m * (2.0 * r + cloud_m)));
    return 1.0 - 0.75 * cloud_opacity(cloud_uv(normalize(round_up * r + t * to_sun)), footprint_rad);
}
// [/cloud_shadow]

// Premultiplied light and alpha of the shell on a ray of round space, if it lies before `end`.
vec4 seen_clouds(vec3 eye, vec3 direction, float end, vec3 to_sun, float pixel_rad) {
    float shell = body.radius + cloud_m, along = -dot(eye, direction), b = length(eye + along * direction);
    if (b >= shell) return vec4(0.0);
    float half_chord = sqrt((shell - b) * (shell + b));
    bool below = dot(eye, eye) < shell * shell;
    float t = below ? along + half_chord : along - half_chord;
    if (t <= 0.0 || t >= end) return vec4(0.0);
    vec3 up = (eye + t * direction) / shell;
    float mu = abs(dot(up, direction)), cosine = dot(up, to_sun);
    float footprint_rad = footprint_of(t * pixel_rad, shell, mu);
    vec2 uv = cloud_uv(up);
    float opacity = cloud_opacity(uv, footprint_rad);
    float alpha = limb_fade(opacity, mu, 0.12);
    if (alpha <= 0.0) return vec4(0.0);
    // Slopes from thickness to the east and the north: cloud tops, seen in low sun.
    float step_uv = max(footprint_rad / 6.2831853, 1.0 / 2048.0);
    float east = cloud_opacity(uv + vec2(step_uv, 0.0), footprint_rad) - opacity;
    float north = cloud_opacity(uv - vec2(0.0, 2.0 * step_uv), footprint_rad) - opacity;
    float around = max(length(up.xz), 0.1);
    vec3 to_east = vec3(up.z, 0.0, -up.x) / around;
    vec3 normal = normalize(up - 0.5 * (east * to_east + north * cross(up, to_east)));
    float lit = clamp((dot(normal, to_sun) + 0.05) / 1.05, 0.0, 1.0);
    vec3 light = 0.92 * body.sunlight * sun_transmittance(Place(cloud_m, cosine)) * lit;
    light += 0.6 * skylight_on(Place(0.0, cosine)) / 3.14159265;
    return vec4(alpha * light, alpha);
}
