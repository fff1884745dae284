// Four lines of 256 texels in shared memory, two complex fields each, and the factors of their transforms.
#ifndef OCEAN_LINE_GIVEN  // checks have memory of their own
shared vec4 line[4 * OCEAN_TEXELS];  // 16 KiB
shared vec2 turns[OCEAN_TEXELS / 2u];

vec2 times(vec2 a, vec2 b) { return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x); }
vec4 turned(vec4 two, uint by) { return vec4(times(two.xy, turns[by]), times(two.zw, turns[by])); }
#endif
