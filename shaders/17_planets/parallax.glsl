// Parallax of the ground: where a ray meets heights above the ball, by each method of the knob `parallax`.
#include "17_planets/body_inputs.glsl"
#include "17_planets/ground.glsl"
#include "17_planets/map_lookup.glsl"

// Height above the ball, from 0 to planets.height_m, in the alpha of the map of normals. Water is level.
float ground_height(vec3 round_up, float footprint_rad) {
    vec2 uv = map_uv(round_up);
    float height = planets.height_m * map_texel(normal_map, uv, footprint_rad).a;
#ifdef BODY_EARTH
    height *= 1.0 - map_texel(water_map, uv, footprint_rad).r;
#endif
    return height;
}

// [ground_way]
// A ray of round space that passes the centre at the distance b, `nearest` metres from the camera. Distance along it to the sphere
// that lies `height` above the ball.
float way_to_height(float nearest, float b, float height) {
    float r = body.radius + height;
    return max(nearest - sqrt(max((r - b) * (r + b), 0.0)), 0.0);
}

// Distance along a ray that meets the ball to the ground above it.
float ground_way(vec3 round_eye, vec3 direction, float nearest, float b, float footprint_rad) {
#define HEIGHT_AT(way) ground_height(normalize(round_eye + (way) * direction), footprint_rad)
#if PLANETS_PARALLAX == PLANETS_PARALLAX_OFFSET
    return way_to_height(nearest, b, HEIGHT_AT(way_to_height(nearest, b, 0.0)));
#else
#if PLANETS_PARALLAX == PLANETS_PARALLAX_TRUTH
    const int steps = 512;
#else
    int steps = planets.parallax_steps;
#endif
    // Down from sphere to sphere. On the ball itself no ray is above the ground.
    float above = planets.height_m, gap = above - HEIGHT_AT(way_to_height(nearest, b, above));
    for (int i = 1; i <= steps && gap > 0.0; ++i) {
        float below = planets.height_m * (1.0 - float(i) / float(steps));
        float left = below - HEIGHT_AT(way_to_height(nearest, b, below));
        if (left <= 0.0) {
#if PLANETS_PARALLAX == PLANETS_PARALLAX_TRUTH
            for (int halving = 0; halving < 12; ++halving) {
                float middle = 0.5 * (above + below);
                if (middle > HEIGHT_AT(way_to_height(nearest, b, middle)))
                    above = middle;
                else
                    below = middle;
            }
            above = below;
#else
            above = mix(above, below, gap / max(gap - left, 1e-6));  // the secant of the last step
#endif
            break;
        }
        above = below;
        gap = left;
    }
    return way_to_height(nearest, b, above);
#endif
#undef HEIGHT_AT
}
// [/ground_way]
