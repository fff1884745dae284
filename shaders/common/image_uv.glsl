// Image rows run from the top, texture v from the bottom.
vec2 image_uv(vec2 uv) { return vec2(uv.x, 1.0 - uv.y); }
