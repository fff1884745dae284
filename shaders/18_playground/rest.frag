// Light of a surface beyond the scene's lights, to be added to theirs.
#include "14_environment/leaving.glsl"
#include "14_environment/unoccluded.glsl"

layout(location = 0) out vec4 color;

void main() {
    Leaving light = leaving(coated_surface());
    color = vec4(min(light.body + light.coat, LARGEST_HALF), 0.0);
}
