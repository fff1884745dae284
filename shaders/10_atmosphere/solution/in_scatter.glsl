// Solution of 10.in_scatter.
#include "10_atmosphere/phase.glsl"
#include "10_atmosphere/sunlight.glsl"

Along in_scatter(int samples, Path path) {
    float part = path.way / float(samples);
    vec3 molecules = air.rayleigh * phase_rayleigh(path.cos_angle), dust = air.mie * phase_dust(path.cos_angle, air.mie_g);
    vec3 depth = vec3(0.0), light = vec3(0.0);
    for (int i = 0; i < samples; ++i) {
        Place place = place_at(path, (float(i) + 0.5) * part);
        vec3 there = density_at(place.height), taken = part * extinction(there);
        vec3 sent = (molecules * there.x + dust * there.y) * air.sun * sun_transmittance(place);
        sent += (air.rayleigh * there.x + air.mie * there.y) * scattered_before(place);
        light += part * sent * exp(-depth - 0.5 * taken);
        depth += taken;
    }
    return Along(light, exp(-depth));
}
