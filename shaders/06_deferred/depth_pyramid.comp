// Five levels of a depth pyramid per dispatch; each workgroup computes the area under one texel of the fifth.
#include "06_deferred/culling_data.h"

layout(local_size_x = 256) in;

uniform sampler2D source;
layout(r32f) writeonly uniform image2D level[PYRAMID_STEP];
layout(scalar) uniform PyramidStepBlock { int made; } pyramid_step;  // number of levels to compute, at most five

const int widest = 31;  // texels of the first level in the last workgroup, for odd sizes
shared float texels[2][widest * widest];

// [farthest]
void main() {
    ivec2 group = ivec2(gl_WorkGroupID.xy), from = textureSize(source, 0), stride = ivec2(0);
    bvec2 is_last = equal(group, ivec2(gl_NumWorkGroups.xy) - 1);
    for (int made = 0, side = 16; made < pyramid_step.made; ++made, side /= 2) {
        ivec2 size = max(from / 2, ivec2(1)), first = side * group, wide = mix(ivec2(side), size - first, is_last);
        for (int i = int(gl_LocalInvocationIndex); i < wide.x * wide.y; i += 256) {
            ivec2 at = first + ivec2(i % wide.x, i / wide.x);
            ivec2 last = mix(2 * at + 1, from - 1, equal(at, size - 1));  // for odd sizes the last texel covers three
            float farthest = 1.0;
            for (int y = 2 * at.y; y <= last.y; ++y)
                for (int x = 2 * at.x; x <= last.x; ++x) {
                    int before = stride.x * (y - 2 * first.y) + x - 2 * first.x;  // index in the previous level
                    farthest = min(farthest, made == 0 ? texelFetch(source, ivec2(x, y), 0).r : texels[made & 1][before]);
                }
            texels[1 - (made & 1)][i] = farthest;
            imageStore(level[made], at, vec4(farthest));
        }
        barrier();  // before the next level reads
        from = size;
        stride = wide;
    }
}
// [/farthest]
