// Depths as a light's map holds them, in metres and as moments take them.
#include "05_shadow_maps/shadow_data.h"

// [map_distance]
// Metres along the view.
float map_distance(ShadowView view, float depth) {
    float d = view.to_distance.x + view.to_distance.y * depth;
    return view.perspective == 1u ? 1.0 / d : d;
}

// 0 at the near plane, 1 at the far one, in proportion to the distance.
float linear_depth(ShadowView view, float depth) {
    return clamp((map_distance(view, depth) - view.near) / (view.far - view.near), 0.0, 1.0);
}
// [/map_distance]
