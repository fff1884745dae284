// [minimal]
#version 460
// Mipmaps in one shader: a checker on a floor that reaches far away, without levels on the left, with them on the
// right.
layout(location = 0) in vec2 uv;  // 0 to 1 over the picture
layout(location = 0) out vec4 color;  // linear light
layout(push_constant) uniform Frame { float divider; };
const float texels = 64.0, squares = 8.0;  // along an edge of the texture

// A texel of a level of this many texels: the mean of the squares that it covers.
float texel(float level_side, vec2 at) {
    if (level_side < squares) return 0.5;
    vec2 square = floor(mod(at, level_side) * squares / level_side);
    return mod(square.x + square.y, 2.0);
}

// Bilinear: the four nearest texels, weighted by distance.
float level_at(float level, vec2 place) {
    float level_side = exp2(round(log2(texels)) - level);
    vec2 at = place * level_side - 0.5, corner = floor(at), f = at - corner;
    float upper = mix(texel(level_side, corner), texel(level_side, corner + vec2(1.0, 0.0)), f.x);
    float lower = mix(texel(level_side, corner + vec2(0.0, 1.0)), texel(level_side, corner + vec2(1.0, 1.0)), f.x);
    return mix(upper, lower, f.y);
}

// A pixel that covers n texels needs level log2(n); between two levels both are mixed.
float mipmapped(vec2 place, float footprint) {
    float level = clamp(log2(footprint * texels), 0.0, round(log2(texels))), lower = floor(level);
    return mix(level_at(lower, place), level_at(min(lower + 1.0, round(log2(texels))), place), level - lower);
}

// The floor's texture coordinates at a place of a picture of 160 x 120 pixels.
vec2 floor_at(vec2 pixel) { return vec2(0.9 * (pixel.x - 80.0), 40.0) / (pixel.y + 1.0); }

float footprint_at(vec2 pixel) {
    vec2 here = floor_at(pixel);
    return max(floor_at(pixel + vec2(1.0, 0.0)).x - here.x, distance(floor_at(pixel + vec2(0.0, 1.0)), here));
}

void main() {
    vec2 pixel = floor(uv * vec2(160.0, 120.0)) + 0.5;
    bool with = uv.x > divider;
    color = vec4(vec3(with ? mipmapped(floor_at(pixel), footprint_at(pixel)) : level_at(0.0, floor_at(pixel))), 1.0);
    if (abs(uv.x - divider) < 0.002) color = vec4(1.0, 0.4, 0.0, 1.0);
}
// [/minimal]
