// [minimal]
#version 460
// Bloom in one shader: each pixel builds the part of the pyramid that it needs. The light varies along rows alone.
layout(location = 0) in vec2 uv;  // 0 to 1 over the picture
layout(location = 0) out vec4 color;  // linear light
layout(push_constant) uniform Frame { float divider; };
const float threshold = 1.0, share = 0.3, levels = 5.0, exposure = 0.2;  // at most 5 levels
const int widest = 158;  // texels that the three texels of level 5 cover

// A tube, two pixels wide, before a wall.
vec3 light(int at) { return at == 500 || at == 501 ? vec3(9.0, 3.6, 1.2) : vec3(0.5, 0.42, 0.38); }

// Number of a level's texels from which three neighbours of level `last` are made.
int width_at(int level, int last) {
    int wide = 3;
    for (int i = last; i > level; --i) wide = 2 * wide + 2;
    return wide;
}

// Half the resolution: the four texels around the middle of each with the weights 1 3 3 1.
void halve(inout vec3 line[widest], int wide) {
    for (int i = 0; i < wide; ++i)
        line[i] = (line[2 * i] + 3.0 * line[2 * i + 1] + 3.0 * line[2 * i + 2] + line[2 * i + 3]) / 8.0;
}

// Twice the resolution: linear between the two nearest texels. Of three, around texel `at` of the finer level.
void expand(inout vec3 three[3], int at) {
    vec3 coarse[3] = three;
    for (int i = 0; i < 3; ++i) {
        int fine = at + i - 1, own = (fine >> 1) - (at >> 1) + 1, other = (fine & 1) == 1 ? own + 1 : own - 1;
        three[i] = 0.75 * coarse[own] + 0.25 * coarse[other];
    }
}

// Light that spreads to a texel: each level of the pyramid, from narrow to wide, with the same share.
vec3 spread(int at) {
    int last = int(clamp(levels, 1.0, 5.0)), first = at >> last;
    for (int level = last; level > 0; --level) first = level == last ? 2 * first - 3 : 2 * first - 1;
    vec3 line[widest], pyramid[18];  // three texels of each level, around the one above `at`
    for (int i = 0; i < width_at(0, last); ++i) line[i] = max(light(first + i) - threshold, 0.0);
    for (int level = 1; level <= last; ++level) {
        halve(line, width_at(level, last));
        first = (first + 1) >> 1;
        for (int i = 0; i < 3; ++i) pyramid[3 * level + i] = line[(at >> level) - 1 + i - first];
    }
    vec3 sum[3] = vec3[3](vec3(0.0), vec3(0.0), vec3(0.0));
    for (int level = last; level > 0; --level) {
        for (int i = 0; i < 3; ++i) sum[i] += pyramid[3 * level + i];
        expand(sum, at >> (level - 1));
    }
    return sum[1] / float(last);
}

void main() {
    int at = int(floor(420.5 + 160.0 * uv.x));
    color = vec4(exposure * (light(at) + (uv.y > divider ? share * spread(at) : vec3(0.0))), 1.0);
    if (abs(uv.y - divider) < 0.003) color = vec4(1.0, 0.4, 0.0, 1.0);
}
// [/minimal]
