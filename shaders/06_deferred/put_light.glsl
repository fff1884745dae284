// Radiance of a pixel, added to the emission in the target if any surface emits.
#include "06_deferred/reflected.glsl"

#ifndef EMITS
#define EMITS 0
#endif
#if EMITS
layout(rgba16f) uniform image2D hdr;
#else
layout(rgba16f) writeonly uniform image2D hdr;
#endif
layout(scalar) uniform AmbientBlock { vec3 ambient; };
layout(scalar) uniform BackgroundBlock { vec3 background; };

void put_background(ivec2 at) {
    imageStore(hdr, at, vec4(background, 0.0));
}

void put_light(ivec2 at, Pixel p, Lit lit) {
    vec3 radiance = ambient_radiance(p.material, ambient) + reflected(p, lit);
#if EMITS
    radiance += imageLoad(hdr, at).rgb;
#endif
    imageStore(hdr, at, vec4(min(radiance, LARGEST_HALF), lit.lights));
}
