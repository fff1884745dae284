// One step of a blur: reads one image, writes another.
#include "08_bloom/step_parameters.h"

layout(scalar) uniform StepNowBlock { StepParameters step_now; };
uniform sampler2D from;
#ifdef FULL_FLOATS
layout(rgba32f) uniform image2D into;
#else
layout(rgba16f) uniform image2D into;
#endif

// In texels of `from`: 0 at the picture's left and top border, texel centres at halves. Beyond the picture the border
// rule applies: a level has an apron of computed texels; farther out it ends, is clamped, or is mirrored at the
// picture's border, which may lie within a texel.
vec3 read(vec2 position) {
    vec2 size = vec2(textureSize(from, 0)), at = position;
#ifdef OF_A_LEVEL
    if (step_now.mirrors != 0) {
        vec2 last = size - float(step_now.from_apron) - 0.5;
        bvec2 beyond = notEqual(at, clamp(at, vec2(0.5 - float(step_now.from_apron)), last));
        if (any(beyond)) {  // few are: the others need no division
            vec2 extent = step_now.extent;
            vec2 mirrored = extent - abs(2.0 * extent * fract(at / (2.0 * extent)) - extent);
            at = mix(at, mirrored, beyond);
        }
    }
#endif
    return textureLod(from, (at + float(step_now.from_apron)) / size, 0.0).rgb;
}

// Where a texel of the image that is written lies: 0 is the picture's first.
ivec2 place_of(ivec2 texel) { return texel - step_now.apron; }

bool is_outside(ivec2 texel) { return any(greaterThanEqual(texel, imageSize(into))); }

void put(ivec2 texel, vec3 found) {
    vec3 value = step_now.weight * found;
    if (step_now.keep != 0.0) value += step_now.keep * imageLoad(into, texel).rgb;
    imageStore(into, texel, vec4(value, 1.0));
}
