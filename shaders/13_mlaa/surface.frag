// A surface of the picture to filter, as it is drawn.
#include "13_mlaa/clipped.glsl"
#include "common/put_surface.glsl"

void main() {
    MappedSurface m = seen_surface();
    put_surface(clipped_radiance(m, gl_FragCoord), m.alpha, m.tint);
}
