// For tests of clip_to_air.
#include "10_atmosphere/view_path.glsl"

vec2 clipped(float height, float slope, float to) {
    Path path = Path(height, slope, 0.5, 0.5, 0.0);
    return clip_to_air(path, to) ? vec2(path.way, path.height) : vec2(-1.0);
}
