// The air before a picture from a few samples: optical depth by a formula, both towards the sun and along the path.
// ONEIL as closed_depth.glsl has it.
#include "10_atmosphere/look.glsl"
#include "10_atmosphere/phase.glsl"
#include "10_atmosphere/sun_closed.glsl"

// The depth between the path's start and a point on it is a difference of two paths out, both away from the ground:
// with the path if it leads up, against it if it leads down.
vec3 depth_between(float height, float slope, float other, float other_slope, bool against) {
    vec3 between = against ? closed_depth(other, -other_slope) - closed_depth(height, -slope)
                           : closed_depth(height, slope) - closed_depth(other, other_slope);
    return max(between, 0.0);
}

Along along(Path path, vec3 direction, ivec2 pixel, float distance) {
    int samples = atmosphere.steps;
    float part = path.way / float(samples), r = air.radius + path.height;
    // Against the path where its end is the lower one.
    bool against = path.slope < 0.0 && height_at(path.height, path.slope, path.way) < path.height;
    vec3 molecules = vec3(0.0), dust = vec3(0.0), between = vec3(0.0);
    for (int i = 0; i < samples; ++i) {
        float t = (float(i) + 0.5) * part;
        Place place = place_at(path, t);
        float slope = clamp((r * path.slope + t) / (air.radius + place.height), -1.0, 1.0);
        vec3 arriving = exp(-depth_between(path.height, path.slope, place.height, slope, against));
        arriving *= sun_transmittance(place) * part;
        vec3 there = density_at(place.height);
        molecules += there.x * arriving;
        dust += there.y * arriving;
    }
    Place end = place_at(path, path.way);
    float slope = clamp((r * path.slope + path.way) / (air.radius + end.height), -1.0, 1.0);
    molecules *= air.rayleigh * phase_rayleigh(path.cos_angle);
    dust *= air.mie * phase_dust(path.cos_angle, air.mie_g);
    return Along(air.sun * (molecules + dust),
                 exp(-depth_between(path.height, path.slope, end.height, slope, against)));
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(pixel, imageSize(result)))) look(pixel);
}
