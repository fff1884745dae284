// Ids as colours: neighbouring numbers look different.
layout(local_size_x = 8, local_size_y = 8) in;
uniform usampler2D ids;
layout(rgba16f) writeonly uniform image2D result;

// The finalizer of MurmurHash3 (A. Appleby).
uint mixed(uint h) {
    h = (h ^ (h >> 16u)) * 0x85ebca6bu;
    h = (h ^ (h >> 13u)) * 0xc2b2ae35u;
    return h ^ (h >> 16u);
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(result)))) return;
    uint id = texelFetch(ids, pixel, 0).r, h = mixed(id);
    vec3 color = id == 0u ? vec3(0.02) : 0.08 + 0.8 * vec3(h & 255u, (h >> 8u) & 255u, (h >> 16u) & 255u) / 255.0;
    imageStore(result, pixel, vec4(color, 1.0));
}
