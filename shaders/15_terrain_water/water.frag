// A water surface from above or from below: reflection, refraction and foam.
#include "common/view_rays.h"
#include "14_environment/image_light.glsl"
#include "15_terrain_water/fresnel_water.glsl"
#include "15_terrain_water/water_facet.glsl"
#include "15_terrain_water/water_reflection.glsl"

layout(location = 0) in vec2 at_rest;
layout(location = 1) in vec3 position;

layout(location = 0) out vec4 color;

uniform sampler2D foam_tile;

const float WATER_INDEX = 1.333;  // refractive index

// Mean reflectance of rough water from above: C. Bruneton et al., "Real-time Realistic Ocean Lighting", Eurographics 2010,
// equation 23. `smooth_share` is the reflectance of level water at that cosine, `deviation` the standard deviation of the
// slopes along the view: one axis.
float rough_reflectance(float smooth_share, float cosine, float deviation) {
    const float f0 = 0.0204;
    float turned = pow(max(1.0 - cosine, 1e-3), 5.0 * exp(-2.69 * deviation) - 5.0);
    return f0 + (smooth_share - f0) * turned / (1.0 + 22.7 * pow(deviation, 1.5));
}

// Light through the surface from below, after absorption, and light scattered by the water.
vec3 through_water(vec3 normal, vec3 to_eye, float distance_m, out float depth_m) {
    vec2 pixel = gl_FragCoord.xy;
    vec2 size = vec2(textureSize(behind, 0));
    float straight = distance_at(pixel) - distance_m;  // along the view, of the ground behind the surface
    vec2 bent = clamp(pixel + water_now.refraction * normal.xz * min(straight, 4.0) / (water_now.pixel_rad * distance_m),
                      vec2(0.5), size - 0.5);
    if (distance_at(bent) < distance_m) bent = pixel;  // stands before the water
    float below_m = max(distance_at(bent) - distance_m, 0.0) * distance_m_of_ray(bent) * max(to_eye.y, 0.0);
    depth_m = max(straight, 0.0) * distance_m_of_ray(pixel) * max(to_eye.y, 0.05);
    // Straight down, and back along the refracted ray (Snell's law at level water).
    float up = sqrt(1.0 - (1.0 - to_eye.y * to_eye.y) / (WATER_INDEX * WATER_INDEX));
    vec3 left = exp(-water_now.absorption * below_m * (1.0 + 1.0 / up));
    vec3 scattered = water_now.turbid * (water_now.sky + water_now.sun * max(water_now.to_sun.y, 0.0) / 3.14159265);
    return mix(scattered, texelFetch(behind, ivec2(bent), 0).rgb, left);
}

// The sun in facets with normally distributed slopes of `variance` (both axes together). R. Cook and K. Torrance's
// model with P. Beckmann's distribution; C. Bruneton et al., "Real-time Realistic Ocean Lighting using Seamless
// Transitions from Geometry to BRDF", Eurographics 2010.
vec3 glitter(vec3 normal, vec3 to_eye, float variance) {
    vec3 middle = to_eye + water_now.to_sun;
    if (dot(middle, middle) < 1e-8 || water_now.to_sun.y <= 0.0) return vec3(0.0);
    middle = normalize(middle);
    float c = max(dot(normal, middle), 1e-3), square = c * c;
    float facets = exp((square - 1.0) / (square * variance)) / (3.14159265 * variance * square * square);
    float reflected = fresnel_water(dot(middle, to_eye), 1.0, WATER_INDEX);
    float n_dot_v = max(dot(normal, to_eye), 0.02), n_dot_l = max(dot(normal, water_now.to_sun), 0.0);
    return water_now.sun * reflected * facets * n_dot_l / (4.0 * max(n_dot_v * n_dot_l, 0.02) + 1e-4);
}

// Share of the water that foam covers. `jacobian`: 1 at rest, below 0 where the surface folds. `depth_m`: of the water.
// `around`: share of foam around an object.
float foam_share(vec2 at, float jacobian, float depth_m, float spacing, float around) {
    float folded = smoothstep(water_now.foam, water_now.foam - 0.5, jacobian);
    float shore = water_now.shore_m > 0.0 ? 1.0 - smoothstep(0.0, water_now.shore_m, depth_m) : 0.0;
    float amount = max(max(folded, 0.8 * shore), around);
    if (amount <= 0.0) return 0.0;
    float level = log2(max(spacing * water_now.foam_scale * float(textureSize(foam_tile, 0).x), 1.0));
    float bubbles = textureLod(foam_tile, at * water_now.foam_scale, level).r;
    // Little foam keeps the bubbles' borders alone; much fills them.
    return amount * smoothstep(1.0 - amount, 1.6 - amount, bubbles + 0.35);
}

void main() {
    vec3 away = view.eye - position;
    float distance_m = 1.0 / gl_FragCoord.w, far_m = length(away);
    vec3 to_eye = away / far_m;
    bool below = water_now.eye_depth_m > 0.0;

    // 1. The surface as finely as the pixels are.
    Facet facet = facet_at(at_rest, to_eye, below);
    vec3 normal = facet.normal;

    // 2. The reflectance; of a rough surface, the mean over its visible facets. The variance is that of both axes.
    float deviation = sqrt(facet.variance);
    float fresnel = fresnel_water(facet.cosine, below ? WATER_INDEX : 1.0, below ? 1.0 : WATER_INDEX);
    if (!below) fresnel = rough_reflectance(fresnel, facet.cosine, sqrt(0.5 * facet.variance));

    // 3. Reflected and transmitted light.
    float depth_m;
    vec3 through, reflected;
    if (below) {
        vec2 size = vec2(textureSize(behind, 0));
        vec2 bent = clamp(gl_FragCoord.xy + 0.3 * water_now.refraction * normal.xz * size.y, vec2(0.5), size - 0.5);
        through = texelFetch(behind, ivec2(bent), 0).rgb;
        reflected = water_now.turbid * (water_now.sky + water_now.sun * max(water_now.to_sun.y, 0.0) / 3.14159265);
        depth_m = 1e3;
    } else {
        through = through_water(normal, to_eye, distance_m, depth_m);
        reflected = reflected_light(position, normal, to_eye, mirrored_direction(facet, to_eye), deviation, distance_m);
    }
    vec3 light = mix(through, reflected, clamp(fresnel, 0.0, 1.0));
    if (!below) light += glitter(normal, to_eye, max(facet.variance, 2e-5));

    // 4. Foam where the surface folds and along the shore.
    float white = foam_share(at_rest, jacobian(facet.slopes), depth_m, facet.spacing,
                             0.8 * waterline_foam(position.xz));
    vec3 lit = water_now.sky + water_now.sun * max(dot(below ? -normal : normal, water_now.to_sun), 0.0) / 3.14159265;
    light = mix(light, 0.8 * lit, below ? 0.5 * white : white);
    color = vec4(min(light, LARGEST_HALF), 1.0);
}
