// The ground by rays, the reference.
#include "15_terrain_water/land_march.glsl"
#include "common/structs.h"
#include "common/view_rays.h"

layout(scalar) uniform RaysBlock { ViewRays rays; };
layout(scalar) uniform ViewBlock { CameraView view; };
layout(location = 0) out float found;

void main() {
    vec3 ray = ray_through(rays, gl_FragCoord.xy);
    float t = march(rays.eye, ray);
    if (t <= 0.0) discard;
    vec4 clip = view.view_projection * vec4(rays.eye + t * ray, 1.0);
    if (clip.z > clip.w) discard;  // before the near plane
    found = t;
    gl_FragDepth = clip.z / clip.w;
}
