// Clouds over a picture that has its air: single scattering along the pixel's path through the layer, with an estimate of the
// higher orders (M. Wrenninge, C. Kulla and V. Lundqvist, "Oz: the great and volumetric", SIGGRAPH Talks 2013).
#include "10_atmosphere/cloud_density.glsl"
#include "10_atmosphere/in_scatter.glsl"
#include "10_atmosphere/skylight.glsl"
#include "10_atmosphere/sun_table.glsl"
#include "10_atmosphere/view_path.glsl"
#include "common/henyey_greenstein.glsl"
#include "common/light.glsl"
#include "common/view_rays.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f) uniform image2D result;
uniform sampler2D depth;
layout(scalar) uniform RaysBlock { ViewRays rays; };
layout(scalar) uniform SunBlock { vec3 to_sun; };
layout(scalar) uniform JitterBlock { float jitter; };  // the number of the pixel's sample

const float endless = 1e12;
const int sun_steps = 5;
const float ends_below = 0.004;  // of the light behind

// Where a path is within the layer: its near and far end, metres; nothing where the second is not larger. The first crossing
// only: beyond the gap under a layer seen from above lie the horizon and the ground.
vec2 within_layer(Path path, float distance) {
    vec2 top = ray_sphere(path.height, path.slope, air.radius, clouds.top_m);
    if (top.x > top.y || top.y <= 0.0) return vec2(0.0);
    vec2 base = ray_sphere(path.height, path.slope, air.radius, clouds.base_m);
    bool meets = base.x <= base.y;
    vec2 ends = vec2(max(top.x, 0.0), top.y);
    if (path.height < clouds.base_m) ends.x = base.y;
    else if (meets && base.x > 0.0) ends.y = base.x;
    ends.y = min(ends.y, distance);
    return ends;
}

// Optical depth towards the sun.
float depth_to_sun(vec3 at, float height, float up_sun, float share) {
    float sum = 0.0, t = 0.0, part = 45.0;
    for (int i = 0; i < sun_steps; ++i) {
        float middle = t + 0.5 * part;
        sum += part * cloud_density(at + middle * to_sun, height + middle * up_sun, part, share, 4);
        t += part;
        part *= 2.1;
    }
    return clouds.extinction * sum;
}

// Light of the sun and the sky scattered towards the eye, per unit of optical depth.
vec3 scattered_here(Place place, float high, float to_sun_depth, float cos_angle) {
    vec3 sun = air.sun * sun_transmittance(place);
    float sum = 0.0, less = 1.0;
    for (int order = 0; order < 4; ++order) {
        float phase = mix(henyey_greenstein(cos_angle, 0.85 * less, 0.25 / 3.14159265),
                          henyey_greenstein(cos_angle, -0.25 * less, 0.25 / 3.14159265), 0.35);
        sum += less * phase * exp(-less * to_sun_depth);
        less *= 0.5;
    }
    vec3 sky = skylight_on(place) / 3.14159265;
    return sun * sum + sky * mix(0.25, 0.75, high);
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(result)))) return;
    vec3 ray = ray_through(rays, vec2(pixel) + 0.5);
    float stretch = length(ray), stored = texelFetch(depth, pixel, 0).r;
    vec3 direction = ray / stretch;
    Path path = path_from(rays.eye, direction, to_sun);
    float ground = distance_to_ground(path);
    float distance = stored > 0.0 ? stretch * distance_along_view(rays, stored) : ground >= 0.0 ? ground : endless;
    vec2 ends = within_layer(path, distance);
    if (ends.y <= ends.x) return;

    // Steps grow with the distance: a pixel's footprint does.
    float pixel_rad = length(rays.right) / stretch, begin = 400.0;
    float ratio = (ends.y + begin) / (ends.x + begin);
    // J. Jimenez, "Next Generation Post Processing in Call of Duty: Advanced Warfare", SIGGRAPH 2014: interleaved gradients.
    float shift = fract(52.9829189 * fract(dot(vec2(pixel) + 5.588238 * jitter, vec2(0.06711056, 0.00583715))));
    vec3 light = vec3(0.0);
    float through = 1.0, weighted = 0.0, weights = 0.0, t = ends.x;
    for (int i = 0; i < clouds.steps && through > ends_below; ++i) {
        float next = (ends.x + begin) * pow(ratio, float(i + 1) / float(clouds.steps)) - begin, part = next - t;
        float middle = t + shift * part;
        t = next;
        Place place = place_at(path, middle);
        vec3 at = rays.eye + middle * direction;
        float share = cover_at(at), footprint = middle * pixel_rad;
        float dense = cloud_density(at, place.height, max(footprint, 0.5 * part * 0.25), share, 4);
        if (dense <= 0.0) continue;
        float high = clamp((place.height - clouds.base_m) / (clouds.top_m - clouds.base_m), 0.0, 1.0);
        float left = exp(-clouds.extinction * dense * part), weight = through * (1.0 - left);
        light += weight * scattered_here(place, high, depth_to_sun(at, place.height, place.sun, share), path.cos_angle);
        weighted += weight * middle;
        weights += weight;
        through *= left;
    }
    if (weights <= 0.0) return;

    // The air before the clouds, at their mean distance, lies over the hidden part already.
    Along before = Along(vec3(0.0), vec3(1.0));
    Path to_cloud = path;
    if (clip_to_air(to_cloud, weighted / weights)) before = in_scatter(12, to_cloud);
    vec4 seen = imageLoad(result, pixel);
    vec3 mixed = through * seen.rgb + (1.0 - through) * before.light + before.transmittance * light;
    imageStore(result, pixel, vec4(finite_light(mixed), seen.a));
}
