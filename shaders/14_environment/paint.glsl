// Car paint as the module Paint gives it to shaders. Its table and its flakes; the clear coat is a surface of its own.
#include "14_environment/image_light.glsl"
#include "14_environment/paint_brdf.glsl"
#include "common/hash.glsl"

// Albedo towards n·v: row 0 of the pigment, row 1 of the flakes.
vec3 paint_albedo(float n_dot_v, int row) {
    float x = n_dot_v * float(PAINT_TEXELS - 1);
    int left = min(int(x), PAINT_TEXELS - 2);
    return mix(texelFetch(paint_table, ivec2(left, PAINT_TEXELS + row), 0).rgb,
               texelFetch(paint_table, ivec2(left + 1, PAINT_TEXELS + row), 0).rgb, x - float(left));
}

// [flakes]
// Light from the flakes: each cell of the coat holds one, which mirrors along a normal of its own. Where cells are smaller than
// a pixel, all of them together are a lobe.
vec3 flake_light(vec3 position, vec3 normal, vec3 to_eye) {
    float cell_m = 0.001 * paint.flake_mm;
    vec3 along_x = across(position), along_y = down(position);
    float pixel_m = sqrt(max(dot(along_x, along_x), dot(along_y, along_y)));
    vec3 mean = prefiltered_along(position, reflect(-to_eye, normal), paint_layers.flake_roughness);
    float apart = clamp(1.5 - pixel_m / cell_m, 0.0, 1.0);
    if (apart == 0.0) return mean;
    vec3 random = hash3(ivec3(floor(position / cell_m)));
    float alpha = paint_layers.flake_roughness * paint_layers.flake_roughness;
    vec3 tilted = frame_around(normal) * importance_sample_ggx(random.xy, alpha);
    vec3 single = prefiltered_along(position, reflect(-to_eye, tilted), 0.25);
    return mix(mean, single, apart);
}
// [/flakes]
