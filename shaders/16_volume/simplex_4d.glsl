// Gradient noise on simplices of four dimensions: 5 corners instead of 16 (K. Perlin, "Noise hardware", SIGGRAPH 2001
// course notes; S. Gustavson, "Simplex noise demystified", 2005).
#include "16_volume/lattice_4d.glsl"
#include "16_volume/volume_data.h"

// One of the 32 directions to the middles of the edges of a hypercube.
vec4 simplex_direction(ivec4 cell) {
    int h = int((lattice_4d(cell) * 0.5 + 0.5) * 31.999);
    vec3 signs = vec3((ivec3(h) >> ivec3(0, 1, 2)) & 1) * 2.0 - 1.0;
    int none = h >> 3;
    return none == 0 ? vec4(0.0, signs) : none == 1 ? vec4(signs.x, 0.0, signs.yz)
         : none == 2 ? vec4(signs.xy, 0.0, signs.z) : vec4(signs, 0.0);
}

// At a point in metres and a time, with whole cells kept apart: exact after a week.
float simplex_4d(vec3 at, NoiseMoment moment) {
    const float skew = 0.309016994, unskew = 0.138196601;  // (sqrt(5) - 1) / 4 and (5 - sqrt(5)) / 20
    vec4 place = vec4(at, moment.time) + skew * (at.x + at.y + at.z) + moment.skew_time;
    vec4 base = floor(place), rest = place - base;
    ivec4 first = ivec4(base) + moment.skew_cell + ivec4(moment.seed, 0, 0, moment.cell);
    // Which of the 24 simplices of the cell: by the order of the components.
    ivec4 rank = ivec4(0);
    for (int i = 0; i < 4; ++i)
        for (int j = i + 1; j < 4; ++j)
            if (rest[i] > rest[j])
                ++rank[i];
            else
                ++rank[j];
    vec4 from_first = rest - unskew * (rest.x + rest.y + rest.z + rest.w);
    float sum_of = 0.0;
    for (int i = 0; i < 5; ++i) {
        ivec4 corner = ivec4(greaterThanEqual(rank, ivec4(4 - i)));
        vec4 to = from_first - vec4(corner) + unskew * float(i);
        float near = max(0.6 - dot(to, to), 0.0);
        near *= near;
        sum_of += near * near * dot(simplex_direction(first + corner), to);
    }
    return 27.0 * sum_of;
}
