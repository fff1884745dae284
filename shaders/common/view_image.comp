// Viewer for an image of any format, fitted into a rectangle. SHAPE: 0 plain, 1 layers side by side, 2 cube
// as longitude and latitude, 3 integers. NaN is magenta, infinity cyan.
#include "common/look_parameters.h"
#include "common/srgb.glsl"
#include "common/view_rays.h"

layout(local_size_x = 8, local_size_y = 8) in;

#if SHAPE == 1
uniform sampler2DArray source;
#elif SHAPE == 2
uniform samplerCube source;
#elif SHAPE == 3
uniform usampler2D source;
#else
uniform sampler2D source;
#endif
layout(scalar) uniform LookBlock { LookParameters look; };
layout(rgba8) writeonly uniform image2D result;

// Layers in a nearly square grid.
ivec2 tiles() {
    int columns = int(ceil(sqrt(float(look.layers))));
    return ivec2(columns, (look.layers + columns - 1) / columns);
}

vec2 shown_size() {
#if SHAPE == 1
    return look.image_size * vec2(tiles());
#elif SHAPE == 2
    return look.image_size * vec2(4.0, 2.0);
#else
    return look.image_size;
#endif
}

vec4 fetch(vec2 uv) {
#if SHAPE == 1
    ivec2 tile = ivec2(uv * vec2(tiles()));
    int layer = tile.y * tiles().x + tile.x;
    return layer < look.layers ? textureLod(source, vec3(fract(uv * vec2(tiles())), float(layer)), 0.0) : vec4(0.0);
#elif SHAPE == 2
    float longitude = (uv.x * 2.0 - 1.0) * 3.14159265, latitude = (0.5 - uv.y) * 3.14159265;
    return textureLod(source, vec3(cos(latitude) * sin(longitude), sin(latitude), -cos(latitude) * cos(longitude)), 0.0);
#elif SHAPE == 3
    return vec4(texelFetch(source, ivec2(uv * look.image_size), 0));
#else
    return textureLod(source, uv, 0.0);
#endif
}

vec3 visible(vec4 value) {
    if (any(isnan(value))) return vec3(1.0, 0.0, 1.0);
    if (any(isinf(value))) return vec3(0.0, 1.0, 1.0);
    if (look.kind == LOOK_DEPTH) {
        if (value.r <= 0.0) return vec3(0.02, 0.03, 0.06);
        float distance_m = depth_to_metres(value.r, 1.0 / look.near_m, isinf(look.far_m) ? 0.0 : 1.0 / look.far_m);
        float share = (distance_m - look.bright_m) / max(look.dark_m - look.bright_m, 1e-6);
        return vec3(mix(1.0, 0.08, clamp(share, 0.0, 1.0)));
    }
    vec4 scaled = value * look.scale;
    vec3 color = look.channel == 0 ? scaled.rgb : vec3(scaled[look.channel - 1]);
    if (look.kind == LOOK_NUMBER) return look.channel == 0 ? scaled.rrr : color;
    return look.kind == LOOK_LINEAR ? encode_srgb(color) : color;
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, ivec2(look.size)))) return;
    vec2 size = vec2(look.size);
    float fit = min(size.x / shown_size().x, size.y / shown_size().y);
    vec2 uv = ((vec2(pixel) + 0.5) - 0.5 * (size - fit * shown_size())) / (fit * shown_size());
    bool inside = all(greaterThanEqual(uv, vec2(0.0))) && all(lessThan(uv, vec2(1.0)));
    imageStore(result, pixel + ivec2(look.corner), vec4(inside ? visible(fetch(uv)) : vec3(0.03), 1.0));
}
