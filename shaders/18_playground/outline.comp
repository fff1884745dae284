// Outline of each selected entry: pixels next to it of what is not selected, or of an entry selected before it.
#include "18_playground/id_buffer.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f) uniform image2D picture;
layout(scalar) readonly buffer SelectedBuffer { uint selected[]; };
layout(scalar) uniform LookBlock { float width; };

uint selected_at(ivec2 pixel) {
    uint id = id_at(clamp(pixel, ivec2(0), imageSize(picture) - 1));
    return id == 0u ? 0u : selected[item_of(id)];
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(picture)))) return;
    uint own = selected_at(pixel);
    int reach = int(ceil(width));
    float nearest = 1e9;
    for (int y = -reach; y <= reach; ++y)
        for (int x = -reach; x <= reach; ++x)
            if (selected_at(pixel + ivec2(x, y)) > own) nearest = min(nearest, length(vec2(x, y)));
    float share = clamp(width + 0.5 - nearest, 0.0, 1.0);
    if (share <= 0.0) return;
    vec4 before = imageLoad(picture, pixel);
    imageStore(picture, pixel, vec4(mix(before.rgb, vec3(1.0, 0.36, 0.03), share), before.a));
}
