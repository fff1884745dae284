// wrong: aberrated(
vec2 aberrated(vec2 uv, float shift) { vec2 a = uv - 0.5; return 0.5 + a * (1.0 + 2.0 * shift * dot(a, a)) / (1.0 + abs(shift)); }
