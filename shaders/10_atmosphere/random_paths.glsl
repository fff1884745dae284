// Light that was scattered twice and more often, by random walks from places on a path towards where the light comes from:
// without a table. Every walk has a colour of its own, red, green or blue. Sunlight by a formula that is good to 0.3% of the
// depth: a loop for each turn would be too many, as llvmpipe ends all loops of an invocation after 65,535 rounds in all
// (path_parts.glsl).
#include "10_atmosphere/closed_depth.glsl"
#include "10_atmosphere/phase.glsl"
#include "10_atmosphere/view_path.glsl"
#include "common/random_walk.glsl"

const int places_of_a_walk = 8;

vec3 sunlight_of_walk(Place place) {
    float share = sun_share(place), height = max(place.height, 0.0);
    return share > 0.0 ? share * exp(-closed_depth(height, max(place.sun, horizon_slope(height)))) : vec3(0.0);
}

// Scattering coefficients at a point in the walk's colour: molecules and dust, per metre.
vec2 scattering_at(vec3 densities, int c) { return vec2(air.rayleigh[c] * densities.x, air.mie[c] * densities.y); }

// Cosine of a scattering angle. Molecules: inverts the integral of 3/8 (1 + x²) (J. R. Frisvad, Journal of the
// Optical Society of America A 28(12), 2011); dust: Henyey and Greenstein's, with `weight` set to the ratio of the
// air's own phase function to it.
float draw_cosine(bool dust, inout float weight) {
    float x = 2.0 * random() - 1.0;
    if (!dust) {
        float a = 2.0 * x, root = pow(sqrt(1.0 + a * a) + abs(a), 1.0 / 3.0);
        return sign(a) * (root - 1.0 / root);
    }
    float g = clamp(air.mie_g, -0.99, 0.99), cosine = henyey_greenstein_cosine(g, x);
    weight *= phase_dust(cosine, air.mie_g) / phase_henyey_greenstein(cosine, abs(g) > 1e-3 ? g : 0.0);
    return cosine;
}

// Radiance from -direction of light that the sun has sent and the air or the ground has turned, in one colour, for a sun of
// 1. Free ways by delta tracking (E. R. Woodcock et al., 1965): steps as if all air were as dense as at its densest, of which
// only as many meet something as there is.
float walk(vec3 position, vec3 direction, vec3 to_sun, int c) {
    float densest = air.rayleigh[c] + air.mie_extinction[c] + air.layer[c], weight = 1.0, light = 0.0;
    for (int turn = 0; turn < 64; ++turn) {
        Path path = path_from(position, direction, to_sun);
        path.height = clamp(path.height, 0.0, air.top);
        float ground = distance_to_ground(path), t = 0.0;
        float end = ground >= 0.0 ? ground : ray_sphere(path.height, path.slope, air.radius, air.top).y;
        vec3 there = vec3(0.0);
        bool meets = false;
        while (!meets) {
            t -= log(1.0 - random()) / densest;
            if (t >= end) break;
            there = density_at(height_at(path.height, path.slope, t));
            meets = random() * densest < extinction(there)[c];
        }
        if (!meets && ground < 0.0) break;  // into space
        Place place = place_at(path, min(t, end));
        position += min(t, end) * direction;
        vec3 sunlight = sunlight_of_walk(place);
        if (meets) {
            vec2 scatters = scattering_at(there, c);
            float all = scatters.x + scatters.y;
            weight *= all / extinction(there)[c];
            light += weight * sunlight[c] * dot(scatters / all, vec2(phase_rayleigh(path.cos_angle), phase_dust(path.cos_angle, air.mie_g)));
            direction = turned(direction, draw_cosine(random() * all < scatters.y, weight), 6.2831853 * random());
        } else {
            vec3 up = normalize(position + vec3(0.0, air.radius, 0.0));
            weight *= air.ground[c];
            light += weight * sunlight[c] * max(place.sun, 0.0) / 3.14159265;
            position += up;  // a metre: the next path begins above the ground
            direction = turned(up, sqrt(random()), 6.2831853 * random());
        }
        if (turn > 3) {
            if (random() > 0.8 || weight <= 0.0) break;
            weight /= 0.8;
        }
    }
    return light;
}

// Result of `walks` of them, spread over the path; `squares` grows by the squares of each one's contribution.
// `through` is the transmittance from the path's start to the eye, and becomes that from its end.
vec3 scattered_often(Path path, int walks, inout vec3 through, inout float squares) {
    // Where the path is, in a world of its own: +y is up at its start.
    float sine = sqrt(max(1.0 - path.slope * path.slope, 0.0)), sun_sine = sqrt(max(1.0 - path.sun * path.sun, 0.0));
    float sun_x = sine > 1e-4 ? clamp((path.cos_angle - path.slope * path.sun) / sine, -sun_sine, sun_sine) : sun_sine;
    vec3 to_sun = vec3(sun_x, path.sun, sqrt(max(sun_sine * sun_sine - sun_x * sun_x, 0.0)));
    vec3 start = vec3(0.0, path.height, 0.0), direction = vec3(sine, path.slope, 0.0), depth = vec3(0.0), light = vec3(0.0);
    float part = path.way / float(walks * places_of_a_walk);
    for (int i = 0; i < walks; ++i) {
        int chosen = int(random() * float(places_of_a_walk)), c = int(3.0 * random());
        for (int k = 0; k < places_of_a_walk; ++k) {
            float t = (float(i * places_of_a_walk + k) + 0.5) * part;
            vec3 there = density_at(height_at(path.height, path.slope, t)), taken = part * extinction(there);
            depth += taken;
            vec2 scatters = scattering_at(there, c);
            float all = scatters.x + scatters.y;
            if (k != chosen || all <= 0.0) continue;
            float weight = 3.0 * float(places_of_a_walk) * part * all * exp(0.5 * taken[c] - depth[c]) * air.sun[c] * through[c];
            vec3 next = turned(direction, draw_cosine(random() * all < scatters.y, weight), 6.2831853 * random());
            float sent = weight * walk(start + t * direction, next, to_sun, c);
            light[c] += sent;
            squares += sent * sent;
        }
    }
    through *= exp(-depth);
    return light;
}
