// A surface with all its maps and shadows. What a screen cannot show is cut off here, where it is to be cut off before
// pixels are mixed.
#include "05_shadow_maps/lit_fragment.glsl"
#include "05_shadow_maps/shadow.glsl"

void main() {
    MappedSurface m;
    vec3 radiance = lit_fragment(m);
#if CLIP == CLIP_BEFORE
    radiance = min(radiance, 1.0);
#endif
    color = vec4(min(radiance, 65504.0), 1.0);
#ifdef TRANSPARENT
    color.a = m.alpha;
#endif
}
