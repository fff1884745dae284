// wrong: in_scatter(samples =
#include "10_atmosphere/phase.glsl"
#include "10_atmosphere/sunlight.glsl"
Along in_scatter(int samples, Path path) {
    float part = path.way / float(samples);
    vec3 depth = vec3(0.0), light = vec3(0.0);
    for (int i = 0; i < samples; ++i) {
        Place p = place_at(path, (float(i) + 0.5) * part);
        vec3 d = density_at(p.height), taken = part * extinction(d);
        light += part * exp(-depth - 0.5 * taken) * (air.rayleigh * d.x + air.mie * d.y) * air.sun * sun_transmittance(p);
        depth += taken;
    }
    return Along(light, exp(-depth));
}
