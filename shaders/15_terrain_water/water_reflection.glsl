// Reflections in a water surface: the surroundings from a cube, the picture itself, the scene drawn from below, or
// rays.
#include "common/structs.h"
#include "common/view_rays.h"

layout(scalar) uniform ViewBlock { CameraView view; };
layout(scalar) uniform WaterRaysBlock { ViewRays water_rays; };
uniform sampler2D behind;        // the picture without the water
uniform sampler2D behind_depth;  // reversed
uniform sampler2D mirror;        // the mirror image, flipped left to right; method rays: the hits

// Along the view, of a pixel's surface; depth at least a nanometre, so that the sky is far but finite.
float distance_at(vec2 pixel) {
    float depth = texelFetch(behind_depth, ivec2(pixel), 0).r;
    return distance_along_view(water_rays, max(depth, 1e-7));
}

// Metres along a pixel's ray for each metre along the view.
float distance_m_of_ray(vec2 pixel) { return length(ray_through(water_rays, pixel)); }

vec3 sky_along(vec3 from, vec3 direction, float deviation) {
    // Facets spread reflections over twice their angle.
    float level = log2(max(2.0 * atan(2.0 * deviation) * image_light_state.texels / 1.5708, 1.0));
    return radiance_along(from, direction, min(level, 4.0));  // beyond it texels of the cube would be seen
}

// The ray's hit within the picture: steps that grow with the distance, then halved. w: 0 if there is none.
vec4 screen_space(vec3 from, vec3 direction, float distance_m) {
    float t = 0.05 * distance_m, before = 0.0;
    vec2 size = vec2(textureSize(behind, 0));
    for (int i = 0; i < 40; ++i) {
        vec4 clip = view.view_projection * vec4(from + t * direction, 1.0);
        if (clip.w <= 0.0) return vec4(0.0);
        vec2 pixel = (clip.xy / clip.w * 0.5 + 0.5) * size;
        if (any(lessThan(pixel, vec2(0.0))) || any(greaterThanEqual(pixel, size))) return vec4(0.0);
        float there = distance_at(pixel);
        if (clip.w > there) {
            // Behind the visible surface: slightly means a hit, far means the ray passed behind it.
            float low = before, high = t;
            for (int k = 0; k < 6; ++k) {
                float middle = 0.5 * (low + high);
                vec4 c = view.view_projection * vec4(from + middle * direction, 1.0);
                pixel = clamp((c.xy / c.w * 0.5 + 0.5) * size, vec2(0.0), size - 1.0);
                there = distance_at(pixel);
                if (c.w > there) high = middle; else low = middle;
                clip = c;
            }
            if (clip.w - there > 0.1 * clip.w + 0.5 * (t - before)) return vec4(0.0);
            vec2 edge = min(pixel, size - pixel) / (0.08 * size);  // fades out where the picture ends
            return vec4(texelFetch(behind, ivec2(pixel), 0).rgb, clamp(min(edge.x, edge.y), 0.0, 1.0));
        }
        before = t;
        t *= 1.25;
    }
    return vec4(0.0);
}

// The mirror image at this pixel, counted from the opposite edge. A normal tilted by an angle turns the reflection by
// twice that angle in the plane of view, and less sideways at flatter views. Exact for distant objects.
vec3 planar(vec3 normal, vec3 to_eye) {
    vec2 size = vec2(textureSize(behind, 0));  // the mirror image may have fewer pixels
    vec3 forward = normalize(vec3(-to_eye.x, 0.0, -to_eye.z) + vec3(1e-6, 0.0, 0.0));
    vec3 right = vec3(-forward.z, 0.0, forward.x);
    vec2 tilt = vec2(dot(normal, right), dot(normal, forward)) / max(normal.y, 0.2);
    vec2 moved = 2.0 * tilt * vec2(clamp(to_eye.y, 0.0, 1.0), 1.0) / water_now.pixel_rad;
    moved.y = min(moved.y, 0.95 * max(to_eye.y, 0.0) / water_now.pixel_rad);  // no ray goes below the horizon
    vec2 pixel = vec2(size.x - gl_FragCoord.x, gl_FragCoord.y) - moved;
    return textureLod(mirror, clamp(pixel, vec2(0.5), size - 0.5) / size, 0.0).rgb;
}

vec3 reflected_light(vec3 from, vec3 normal, vec3 to_eye, vec3 direction, float deviation, float distance_m) {
#if WATER_REFLECTION == WATER_REFLECTION_NONE
    return vec3(0.0);
#elif WATER_REFLECTION == WATER_REFLECTION_CUBE
    return sky_along(from, direction, deviation);
#elif WATER_REFLECTION == WATER_REFLECTION_SCREEN_SPACE
    vec4 met = screen_space(from, direction, distance_m);
    return mix(sky_along(from, direction, deviation), met.rgb, met.a);
#elif WATER_REFLECTION == WATER_REFLECTION_RAYS
    // The hit of the pixel's ray through the air; behind it air and sky.
    vec4 met = texelFetch(mirror, ivec2(gl_FragCoord.xy), 0);
    return met.rgb + (1.0 - met.a) * sky_along(from, direction, deviation);
#else
    return planar(normal, to_eye);
#endif
}
