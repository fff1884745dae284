// The module's numbers.
layout(scalar) uniform SkinBlock {
    float before;
    float roughness, specular_scale, f0;
    float wrap, inwards_mm, translucency;
} skin;
