// One step of a blur: reads one image, writes another.
#include "08_bloom/step_parameters.h"

#if !defined(COUNTED) && !defined(IMPULSE_X)  // checks of exercises have texels of their own
layout(scalar) uniform StepNowBlock { StepParameters step_now; };
uniform sampler2D from;
#ifdef FULL_FLOATS
layout(rgba32f) uniform image2D into;
#else
layout(rgba16f) uniform image2D into;
#endif

// In texels of `from`, texels' middles at halves; outside it is what the border says.
vec3 read(vec2 position) { return textureLod(from, position / vec2(textureSize(from, 0)), 0.0).rgb; }

bool is_outside(ivec2 texel) { return any(greaterThanEqual(texel, imageSize(into))); }

void put(ivec2 texel, vec3 found) {
    vec3 value = step_now.weight * found;
    if (step_now.keep != 0.0) value += step_now.keep * imageLoad(into, texel).rgb;
    imageStore(into, texel, vec4(value, 1.0));
}
#endif
