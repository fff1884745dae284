// A surface with all its maps, and its shadows.
#include "05_shadow_maps/lit_fragment.glsl"
#include "05_shadow_maps/shadow.glsl"

void main() {
    MappedSurface m;
    color = vec4(lit_fragment(m), 1.0);
#ifdef TRANSPARENT
    color.a = m.alpha;
#endif
}
