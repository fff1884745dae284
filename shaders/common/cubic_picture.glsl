// A level of a picture of all directions by a cubic B-spline, which magnifies without the corners of a linear filter
// (Sigg and Hadwiger, GPU Gems 2, 2005, chapter 20: four linear reads).

// Half of a spline's weights along one axis: two reads at `at`, which weigh 1 - share and share.
struct Reads {
    vec2 at;
    float share;
};

Reads reads_along(float position) {
    float f = fract(position - 0.5), first = position - f;  // the middle of the texel before
    float w0 = (1.0 - f) * (1.0 - f) * (1.0 - f), w1 = 4.0 - 6.0 * f * f + 3.0 * f * f * f;
    float w3 = f * f * f, w2 = 6.0 - w0 - w1 - w3;
    return Reads(first + vec2(w1 / (w0 + w1) - 1.0, 1.0 + w3 / (w2 + w3)), (w2 + w3) / 6.0);
}

// `uv`: 0 to 1; columns go around, rows end at the poles.
vec3 cubic_picture(sampler2D picture, vec2 uv, float lod) {
    vec2 texels = vec2(textureSize(picture, int(lod)));
    vec2 position = uv * texels;
    Reads x = reads_along(position.x), y = reads_along(position.y);
    vec2 rows = clamp(y.at, 0.5, texels.y - 0.5) / texels.y, columns = x.at / texels.x;
    vec3 above = mix(textureLod(picture, vec2(columns.x, rows.x), lod).rgb,
                     textureLod(picture, vec2(columns.y, rows.x), lod).rgb, x.share);
    vec3 below = mix(textureLod(picture, vec2(columns.x, rows.y), lod).rgb,
                     textureLod(picture, vec2(columns.y, rows.y), lod).rgb, x.share);
    return mix(above, below, y.share);
}
