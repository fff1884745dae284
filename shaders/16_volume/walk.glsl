// The reference for scattered light: random walks from the eye.
#include "common/random_walk.glsl"

#if VOLUME_SCATTERING == VOLUME_SCATTERING_WALK
// llvmpipe ends all loops of an invocation after 65,535 rounds in all: in thick clouds, after some twenty paths.
const int most_scatterings = 1024;

// Metres to the next collision with matter that has the majorant everywhere.
float free_path() { return -log(1.0 - random()) / volume_now.majorant; }

// Transmittance from a place to the light by ratio tracking: right on average for any density (J. Novak, A. Selle and
// W. Jarosz, "Residual ratio tracking for estimating attenuation in participating media", TOG 33(6), 2014).
float ratio_tracked(vec3 position) {
    vec4 way = way_to_light(position);
    float through = 1.0;
    for (float t = free_path(); t < way.w && through > 1e-5; t += free_path())
        through *= 1.0 - extinction_of(classified(density_at(position + t * way.xyz)).a) / volume_now.majorant;
    return through;
}

// One walk: its light, and 1 where it met nothing. Free paths by delta tracking (E. R. Woodcock et al., 1965): of the
// collisions with matter of the majorant those count of which the real matter has its share.
vec4 walk(vec3 from, vec3 along, vec2 range) {
    vec3 light = vec3(0.0), weight = vec3(1.0);
    float t = range.x;
    for (int order = 0; order < most_scatterings; ++order) {
        vec4 looks = vec4(0.0);
        bool meets = false;
        while (!meets) {
            t += free_path();
            if (t >= range.y) break;
            looks = classified(density_at(from + t * along));
            meets = random() * volume_now.majorant < extinction_of(looks.a);
        }
        if (!meets) return order == 0 ? vec4(light, 1.0) : vec4(light + weight * volume.sky, 0.0);
        from += t * along;
        vec3 albedo = albedo_of(looks.rgb), irradiance = vec3(0.0), to_light = way_to_light(from).xyz;
#if VOLUME_LIGHT != VOLUME_LIGHT_NONE
        irradiance = unattenuated_light(from) * ratio_tracked(from);
#endif
        light += weight * source_term(albedo, volume.glow * looks.rgb, vec3(0.0), irradiance, to_light, along, volume.g, 0.0);
        weight *= albedo;
        float goes_on = min(max(weight.r, max(weight.g, weight.b)), 1.0);
        if (random() >= goes_on) break;
        weight /= goes_on;
        along = turned(along, henyey_greenstein_cosine(volume.g, 2.0 * random() - 1.0), 6.2831853 * random());
        t = 0.0;
        range.y = volume_range(from, along).y;
    }
    return vec4(light, 0.0);
}

vec4 walks(vec3 from, vec3 along, vec2 range, ivec2 pixel) {
    start_random(uvec2(pixel), volume_now.seed);
    vec4 sum = vec4(0.0);
    for (int i = 0; i < volume.paths; ++i) sum += walk(from, along, range);
    return sum / float(volume.paths);
}
#endif
