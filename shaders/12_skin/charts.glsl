// Which texels of a map belong together. A chart's number is 1 or more; 0 is no surface.
uniform sampler2D skin_position;  // metres, world space; w: the chart

vec4 place_at(ivec2 texel) {
    if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, textureSize(skin_position, 0)))) return vec4(0.0);
    return texelFetch(skin_position, texel, 0);
}
