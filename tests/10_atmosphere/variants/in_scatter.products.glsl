// right
#include "10_atmosphere/phase.glsl"
#include "10_atmosphere/sunlight.glsl"
Along in_scatter(int samples, Path path) {
    float part = path.way / float(samples);
    Along a = Along(vec3(0.0), vec3(1.0));
    float r = phase_rayleigh(path.cos_angle), m = phase_dust(path.cos_angle, air.mie_g);
    for (int i = 0; i < samples; ++i) {
        Place p = place_at(path, part * (float(i) + 0.5));
        vec3 d = density_at(p.height), half_through = exp(-0.5 * part * extinction(d));
        vec3 sun = air.sun * sun_transmittance(p), all = scattered_before(p);
        a.transmittance *= half_through;
        a.light += a.transmittance * part * (air.rayleigh * d.x * (sun * r + all) + air.mie * d.y * (sun * m + all));
        a.transmittance *= half_through;
    }
    return a;
}
