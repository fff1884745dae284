// wrong: in_scatter(samples =
#include "10_atmosphere/phase.glsl"
#include "10_atmosphere/sunlight.glsl"
Along in_scatter(int samples, Path path) {
    float part = path.way / float(samples);
    vec3 through = vec3(1.0), light = vec3(0.0);
    for (int i = 0; i < samples; ++i) {
        Place p = place_at(path, float(i) * part);
        vec3 d = density_at(p.height);
        through *= exp(-part * extinction(d));
        light += part * through * (air.rayleigh * d.x * phase_rayleigh(path.cos_angle) + air.mie * d.y * phase_dust(path.cos_angle, air.mie_g)) * air.sun * sun_transmittance(p);
    }
    return Along(light, through);
}
