// Ambient occlusion of what is seen: horizons in slices of the depth buffer, and the integral between them.
#include "14_environment/horizon.glsl"
#include "14_environment/occlusion_step.glsl"
#include "14_environment/slice_integral.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba16f) writeonly uniform image2D found;

const float pi = 3.14159265;

// Of two neighbours, the one on the same surface: the nearer one in depth.
vec3 step_along(ivec2 pixel, vec3 here, float stored, ivec2 along) {
    float before = stored_at(pixel - along), after = stored_at(pixel + along);
    bool forward = abs(after - stored) < abs(before - stored);
    // At the border the neighbour is the pixel itself.
    ivec2 size = textureSize(depth, 0);
    if (any(greaterThanEqual(pixel + along, size))) forward = false;
    if (any(lessThan(pixel - along, ivec2(0)))) forward = true;
    if (forward) return after > 0.0 ? place_of(pixel + along, after) - here : vec3(0.0);
    return before > 0.0 ? here - place_of(pixel - along, before) : vec3(0.0);
}

vec3 normal_at(ivec2 pixel, vec3 here, float stored) {
    vec3 right = step_along(pixel, here, stored, ivec2(1, 0)), down = step_along(pixel, here, stored, ivec2(0, 1));
    vec3 normal = cross(down, right);
    float length2 = dot(normal, normal);
    vec3 to_eye = -normalize(here);
    if (length2 == 0.0) return to_eye;
    normal *= inversesqrt(length2);
    return dot(normal, to_eye) < 0.0 ? -normal : normal;
}

// A 4x4 pattern: neighbours seek in other slices and at other steps, and widen_occlusion.comp takes their mean.
vec2 noise_at(ivec2 at) {
    int place = 4 * (at.y & 3) + (at.x & 3), mixed = place * 5 & 15;
    return vec2((float(mixed) + 0.5) / 16.0, (float((at.x ^ at.y) & 3) + 0.5) / 4.0);
}

// [horizon_search]
// Cosine of the horizon's angle from the line of sight, to one side. Behind what raised it, it falls by `thickness` of the
// way for each radius walked, whatever the number of steps.
float horizon_of(ivec2 pixel, vec3 here, vec3 to_eye, vec3 normal, vec2 direction, float reach, float offset) {
    float horizon = -1.0, walked = 0.0;
    for (int i = 0; i < occlusion_step.steps; ++i) {
        float share = (float(i) + offset) / float(occlusion_step.steps), pixels = max(share * share * reach, float(i) + 1.0);
        ivec2 there = pixel + ivec2(round(direction * pixels));
        if (pixels > reach || any(lessThan(there, ivec2(0))) || any(greaterThanEqual(there, textureSize(depth, 0)))) break;
        float fall = 1.0 - pow(1.0 - occlusion_step.thickness, (pixels - walked) / reach);
        walked = pixels;
        float stored = stored_at(there);
        if (stored <= 0.0) continue;
        vec3 away = place_of(there, stored) - here;
        float metres = length(away);
        if (metres == 0.0) continue;
        float found = dot(away, to_eye) / metres;
        if (dot(away, normal) < 0.02 * metres) found = min(found, horizon);  // the surface itself, which hides nothing
        horizon = raised_horizon(horizon, found, metres, occlusion_step.radius_m, fall);
    }
    return horizon;
}
// [/horizon_search]

// Sum of the directions between two angles of a slice, by solid angle: along the line of sight, and across it.
vec2 directions_between(float before, float after) {
    vec2 h = vec2(before, after), sine = sin(h), both = h - sine * cos(h);
    return 0.5 * vec2(dot(sine, sine), both.x + both.y);
}

void main() {
    ivec2 place = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(place, imageSize(found)))) return;
    ivec2 pixel = min(ivec2(vec2(place) * occlusion_step.shrink), textureSize(depth, 0) - 1);
    float stored = stored_at(pixel);
    if (stored <= 0.0) {
        imageStore(found, place, vec4(0.0, 0.0, 0.0, 1.0));
        return;
    }
    vec3 here = place_of(pixel, stored), to_eye = -normalize(here), normal = normal_at(pixel, here, stored);
    float distance_m = distance_along_view(occlusion_step.rays, stored);
    float reach = occlusion_step.radius_m / distance_m * occlusion_step.pixels_per_rad;
    vec2 noise = noise_at(place);
    vec3 right = normalize(occlusion_step.rays.right), down = normalize(occlusion_step.rays.down), bent = vec3(0.0);
    // What is hidden is summed, not what is open: few slices then leave an open plane as it is.
    float visible = 0.0;
    for (int i = 0; i < occlusion_step.slices; ++i) {
        float turn = pi * (float(i) + noise.x) / float(occlusion_step.slices);
        vec2 direction = vec2(cos(turn), sin(turn));
        // The slice's plane holds the line of sight; `along` lies in it, at a right angle to that line.
        vec3 along = direction.x * right + direction.y * down;
        along = normalize(along - dot(along, to_eye) * to_eye);
        vec3 across = cross(to_eye, along), projected = normal - dot(normal, across) * across;
        float share = length(projected);
        if (share < 1e-4) continue;
        float tilt = atan(dot(projected, along), dot(projected, to_eye));
        float after = acos(clamp(horizon_of(pixel, here, to_eye, normal, direction, reach, noise.y), -1.0, 1.0));
        float before = -acos(clamp(horizon_of(pixel, here, to_eye, normal, -direction, reach, noise.y), -1.0, 1.0));
        float lowest_before = tilt - 0.5 * pi, lowest_after = tilt + 0.5 * pi;
        before = max(before, lowest_before);
        after = min(after, lowest_after);
        visible += share * (slice_integral(before, after, tilt) - slice_integral(lowest_before, lowest_after, tilt));
        vec2 hidden = directions_between(before, after) - directions_between(lowest_before, lowest_after);
        bent += hidden.x * to_eye + hidden.y * along;
    }
    imageStore(found, place, vec4(bent, visible) / float(occlusion_step.slices) + vec4(0.0, 0.0, 0.0, 1.0));
}
