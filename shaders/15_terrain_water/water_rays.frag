// Where reflected rays begin and go: their direction, and the distance along the view of the water they begin on.
#include "common/structs.h"
#include "15_terrain_water/water_facet.glsl"

layout(location = 0) in vec2 at_rest;
layout(location = 1) in vec3 position;
layout(location = 0) out vec4 ray;

layout(scalar) uniform ViewBlock { CameraView view; };

void main() {
    vec3 to_eye = normalize(view.eye - position);
    ray = vec4(mirrored_direction(facet_at(at_rest, to_eye, false), to_eye), 1.0 / gl_FragCoord.w);
}
