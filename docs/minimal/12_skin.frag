// [minimal]
#version 460
// Skin in one shader: light that enters at one place leaves around it, red the farthest. The irradiance is blurred by
// six Gaussians for each colour (E. d'Eon and D. Luebke, GPU Gems 3, 2007), across the edges of shadows.
layout(location = 0) in vec2 uv;  // 0 to 1 over the picture
layout(location = 0) out vec4 color;  // linear light
layout(push_constant) uniform Frame { float divider; };
const float scale = 1.0, slat_mm = 3.0;  // widths of the Gaussians, 1 for skin; distance between slats
const float texel_mm = 1.0 / 50.0, wide_mm = 96.0 / 4.0;  // the picture's width
const vec3 albedo = vec3(0.78, 0.52, 0.40);  // applied after the blur, or its detail would be blurred too
const vec4 skin[6] = vec4[6](  // weights of red, green, blue, which add up to 1; variance, mm²
    vec4(0.233, 0.455, 0.649, 0.0064), vec4(0.100, 0.336, 0.344, 0.0484), vec4(0.118, 0.198, 0.000, 0.187),
    vec4(0.113, 0.007, 0.007, 0.567), vec4(0.358, 0.004, 0.000, 1.99), vec4(0.078, 0.000, 0.000, 7.41));

// The light that arrives: a shadow left of 0, or the shadows of slats.
float irradiance(float at_mm, bool slats) {
    return slats ? step(0.5, fract(at_mm / slat_mm)) : step(0.0, at_mm);
}

float blurred(float at_mm, float variance_mm2, bool slats) {
    int reach = int(ceil(4.0 * sqrt(variance_mm2) / texel_mm));  // less than one part in 10,000 is left out
    float middle = (floor(at_mm / texel_mm) + 0.5) * texel_mm, sum = 0.0, weights = 0.0;
    for (int i = -reach; i <= reach; ++i) {
        float away_mm = float(i) * texel_mm, weight = exp(-0.5 * away_mm * away_mm / variance_mm2);
        sum += weight * irradiance(middle + away_mm, slats);
        weights += weight;
    }
    return sum / weights;
}

// The light that leaves: each blur, weighted for each colour.
vec3 leaving(float at_mm, bool slats) {
    vec3 sum = vec3(0.0);
    for (int k = 0; k < 6; ++k) sum += skin[k].rgb * blurred(at_mm, max(scale * scale * skin[k].a, 1e-4), slats);
    return sum;
}

void main() {
    bool slats = uv.y > 0.5;
    float at_mm = (uv.x - 0.5) * wide_mm;
    color = vec4(albedo * (uv.y > divider ? leaving(at_mm, slats) : vec3(irradiance(at_mm, slats))), 1.0);
    if (abs(uv.y - divider) < 0.003) color = vec4(0.1, 0.5, 1.0, 1.0);
}
// [/minimal]
