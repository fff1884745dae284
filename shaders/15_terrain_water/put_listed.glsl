// Per-pixel lists: every fragment that is not hidden goes into its pixel's list. J. Yang, J. Hensley, H. Gruen and
// N. Thibieroz, "Real-Time Concurrent Linked List Construction on the GPU", EGSR 2010.
#include "15_terrain_water/packed_tint.glsl"
#include "15_terrain_water/tint.glsl"
#include "15_terrain_water/transparency_data.h"

layout(early_fragment_tests) in;  // else surfaces behind opaque ones would be listed

layout(scalar) uniform TransparencyNowBlock { TransparencyNow transparency_now; };
layout(scalar) buffer ListHeadsBuffer { uint list_heads[]; };
layout(scalar) buffer ListedBuffer { ListedFragment listed[]; };
layout(scalar) buffer ListCountBuffer { uint list_count[]; };

// [listed]
void put_surface(vec3 radiance, float alpha, vec3 tint) {
    uint place = atomicAdd(list_count[0], 1u);
    if (place >= transparency_now.capacity) return;  // no room: this fragment is lost
    uvec2 pixel = uvec2(gl_FragCoord.xy);
    uint next = atomicExchange(list_heads[pixel.y * transparency_now.width + pixel.x], place + 1u);
    listed[place] = ListedFragment(packHalf2x16(radiance.rg), packHalf2x16(vec2(radiance.b, alpha)),
                                   packed_tint(used_tint(tint)), gl_FragCoord.z, next);
}
// [/listed]
