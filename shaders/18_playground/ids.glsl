// Image of item numbers: id_at(p) for p from (0, 0) to ids_size() - 1.
uniform usampler2D ids;
ivec2 ids_size() { return textureSize(ids, 0); }
uint id_at(ivec2 at) { return texelFetch(ids, at, 0).r; }
