// For 09.radial_blur and 09.sharpen: the picture that they read.
uniform sampler2D from;
ivec2 picture_size() { return textureSize(from, 0); }
vec3 texel(ivec2 at) { return texelFetch(from, at, 0).rgb; }
vec3 picture(vec2 uv) { return textureLod(from, uv, 0.0).rgb; }
