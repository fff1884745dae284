// The depth of a mirror image, with the water as near plane, as the depth of its camera's own near plane.
#include "common/view_rays.h"

layout(scalar) uniform MirrorRaysBlock { ViewRays mirror_rays; };
layout(scalar) uniform ObliqueBlock {
    float level_m;  // of the water
    float scale;    // depth is 1 - scale * (height above the water) / (distance along the view)
} oblique;
uniform sampler2D oblique_depth;

// Along a ray that rises by `up` for each metre along the view, from `below` metres under the water: depth
// = 1 - scale (up t - below) / t, solved for the distance t.
void main() {
    float depth = texelFetch(oblique_depth, ivec2(gl_FragCoord.xy), 0).r;
    float up = ray_through(mirror_rays, gl_FragCoord.xy).y, below = oblique.level_m - mirror_rays.eye.y;
    float per_metre = (depth - 1.0 + oblique.scale * up) / max(oblique.scale * below, 1e-9);  // 1 / t
    float plain = (per_metre - mirror_rays.inverse_far) / (mirror_rays.inverse_near - mirror_rays.inverse_far);
    gl_FragDepth = depth > 0.0 ? clamp(plain, 1e-9, 1.0) : 0.0;
}
