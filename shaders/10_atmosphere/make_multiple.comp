// The table of multiple scattering. S. Hillaire, "A scalable and production ready sky and atmosphere rendering
// technique", Computer Graphics Forum 39(4), 2020, section 5: from the second scattering on light is isotropic, and a
// point returns a share of the light from its surroundings, again and again: a geometric series. The ground is part
// of the surroundings. The first scattering by molecules keeps its own phase function: isotropic, as there, the sky
// is some percent too dark. Dust's is too narrow for 64 directions.
#include "10_atmosphere/phase_rayleigh.glsl"
#include "10_atmosphere/read_tables.glsl"

layout(local_size_x = 64) in;
layout(rgba16f) writeonly uniform image2D result;
shared vec3 second[64], share[64];

const int samples = 20;

vec3 sunlight_at(Place place) {
    float share = sun_share(place);
    return share > 0.0 ? share * read_transmittance(place.height, max(place.sun, horizon_slope(place.height))) : vec3(0.0);
}

// A workgroup is a texel, a thread one of its 64 directions.
void main() {
    ivec2 texel = ivec2(gl_WorkGroupID.xy);
    int own = int(gl_LocalInvocationIndex);
    Place here = multiple_place((vec2(texel) + 0.5) / vec2(imageSize(result)), vec2(imageSize(result)));
    here.height = clamp(here.height, 1.0, air.top - 1.0);

    // Directions evenly over the sphere; `away` is the sun's azimuth seen from each.
    float cosine = 1.0 - (float(own) + 0.5) / 32.0, sine = sqrt(1.0 - cosine * cosine);
    float around = 2.39996323 * float(own), sun_sine = sqrt(max(1.0 - here.sun * here.sun, 0.0));
    Path path = Path(here.height, cosine, here.sun, cosine * here.sun + sine * sun_sine * cos(around), 0.0);
    bool meets_ground = path.slope < horizon_slope(path.height);
    vec2 ground = ray_sphere(path.height, path.slope, air.radius, 0.0);
    path.way = meets_ground ? max(ground.x, 0.0) : ray_sphere(path.height, path.slope, air.radius, air.top).y;

    vec3 depth = vec3(0.0), once = vec3(0.0), passed_on = vec3(0.0);
    float step_m = path.way / float(samples);
    for (int i = 0; i < samples; ++i) {
        Place place = place_at(path, step_m * (float(i) + 0.5));
        place.height = clamp(place.height, 0.0, air.top);
        vec3 there = density_at(place.height), taken = extinction(there) * step_m;
        vec3 scattered = step_m * (air.rayleigh * there.x + air.mie * there.y) * exp(-depth - 0.5 * taken);
        vec3 turned = air.rayleigh * there.x * phase_rayleigh(path.cos_angle) + air.mie * there.y * (0.25 / 3.14159265);
        once += step_m * turned * exp(-depth - 0.5 * taken) * sunlight_at(place);
        passed_on += scattered;
        depth += taken;
    }
    if (meets_ground) {
        Place end = Place(0.0, place_at(path, path.way).sun);
        once += exp(-depth) * air.ground / 3.14159265 * max(end.sun, 0.0) * sunlight_at(end);
        passed_on += exp(-depth) * air.ground;
    }
    second[own] = once / 64.0;
    share[own] = passed_on / 64.0;
    for (int half_of = 32; half_of > 0; half_of /= 2) {
        barrier();
        if (own < half_of) {
            second[own] += second[own + half_of];
            share[own] += share[own + half_of];
        }
    }
    if (own == 0) imageStore(result, texel, vec4(second[0] / (1.0 - min(share[0], 0.98)), 1.0));
}
