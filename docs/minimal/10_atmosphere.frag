// [minimal]
#version 460
// The sky of the Earth: light that molecules and dust scatter once, summed along the ray of a pixel. Kilometres.
layout(location = 0) in vec3 ray;  // of the pixel; y points up
layout(location = 0) out vec4 color;
layout(push_constant) uniform Sky { vec4 to_sun; float eye_km; };  // eye_km: height of the eye above the sea

const float earth_km = 6360.0, top_km = 100.0;  // the planet's radius, and where the air is taken to end
const vec3 rayleigh = vec3(5.802e-3, 13.558e-3, 33.1e-3);  // scattered by molecules, per km at the sea: blue most
const float dust = 3.996e-3, dust_lost = 4.44e-3;           // scattered by dust, and scattered or absorbed
const vec3 ozone = vec3(0.65e-3, 1.881e-3, 0.085e-3);       // absorbed by ozone, around a height of 25 km

// The density of each of the three at a height, relative to its greatest one.
vec3 amounts(float height) {
    return vec3(exp(-height / 8.0), exp(-height / 1.2), max(1.0 - abs(height - 25.0) / 15.0, 0.0));
}
vec3 extinction(vec3 amount) { return rayleigh * amount.x + dust_lost * amount.y + ozone * amount.z; }

float height_at(vec3 place) { return length(place) - earth_km; }

// How far it is along a ray to the top of the air, or to the ground if that is nearer. `place` is in the air.
float way_to_end(vec3 place, vec3 direction) {
    float slope = dot(place, direction), height = height_at(place);
    // r² - R² as (r - R)(r + R): the squares themselves are too large for floats to keep the difference.
    float to_top = slope * slope - (height - top_km) * (2.0 * earth_km + height + top_km);
    float to_ground = slope * slope - height * (2.0 * earth_km + height);
    if (slope < 0.0 && to_ground >= 0.0) return -slope - sqrt(to_ground);
    return -slope + sqrt(max(to_top, 0.0));
}

// The share of the sun's light that reaches a place: none through the planet.
vec3 sunlight(vec3 place, vec3 sun) {
    float slope = dot(place, sun), height = height_at(place);
    if (slope < 0.0 && slope * slope >= height * (2.0 * earth_km + height)) return vec3(0.0);
    float part = way_to_end(place, sun) / 16.0;
    vec3 depth = vec3(0.0);
    for (int i = 0; i < 16; ++i) depth += part * extinction(amounts(height_at(place + (float(i) + 0.5) * part * sun)));
    return exp(-depth);
}

// The radiance of the sky for a sun of irradiance 1: light scattered towards the eye, weakened on the way there.
vec3 sky(float eye_height, vec3 direction, vec3 sun, int steps) {
    vec3 eye = vec3(0.0, earth_km + eye_height, 0.0), light = vec3(0.0), depth = vec3(0.0);
    float c = dot(direction, sun), way = way_to_end(eye, direction), g = 0.8;
    float by_molecules = 0.0596831 * (1.0 + c * c);  // 3 / 16 pi: nearly the same in all directions
    float by_dust = 0.0795775 * (1.0 - g * g) / pow(1.0 + g * g - 2.0 * g * c, 1.5);  // 1 / 4 pi: mostly forwards
    for (int i = 0; i < steps; ++i) {
        vec2 ends = way * pow(vec2(i, i + 1) / float(steps), vec2(2.0));  // short where the air is dense
        float part = ends.y - ends.x;
        vec3 place = eye + 0.5 * (ends.x + ends.y) * direction, amount = amounts(max(height_at(place), 0.0));
        vec3 lost = part * extinction(amount);
        vec3 scattered = rayleigh * amount.x * by_molecules + dust * amount.y * by_dust;
        light += part * scattered * sunlight(place, sun) * exp(-depth - 0.5 * lost);
        depth += lost;
    }
    return light;
}

void main() { color = vec4(20.0 * sky(eye_km, normalize(ray), to_sun.xyz, 32), 1.0); }
// [/minimal]
