// wrong: are different
float film_grain(uvec2 pixel, uint frame) {
    return 2.0 * fract(sin(dot(vec2(pixel), vec2(12.9898, 78.233)) + float(frame)) * 43758.5453) - 1.0;
}
