// Light from 7 stops below middle grey to 8 above, from left to right: grey, and below it every hue.
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f) writeonly uniform image2D result;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy), size = imageSize(result);
    if (any(greaterThanEqual(pixel, size))) return;
    vec2 uv = (vec2(pixel) + 0.5) / vec2(size);
    float hue = max(uv.y - 0.2, 0.0) / 0.8;
    vec3 pure = clamp(abs(fract(hue + vec3(0.0, 2.0, 1.0) / 3.0) * 6.0 - 3.0) - 1.0, 0.0, 1.0);
    vec3 light = 0.18 * exp2(15.0 * uv.x - 7.0) * (uv.y < 0.2 ? vec3(1.0) : mix(vec3(0.02), vec3(1.0), pure));
    imageStore(result, pixel, vec4(light, 1.0));
}
