// For 08.blur_line: a workgroup's line of texels, its weights, and the shared memory to keep it in.
const int threads = 256;         // of a workgroup, and texels of the line that it blurs
const int most_kept = 2048;      // radius is at most (most_kept - threads) / 2
// 24 KiB: Vulkan promises 16, desktop drivers give 32 and more. A float each, red, green and blue apart: neighbours then
// lie in different banks.
shared float line[3][most_kept];

void keep_texel(int slot, vec3 value) {
    line[0][slot] = value.r;
    line[1][slot] = value.g;
    line[2][slot] = value.b;
}
vec3 kept_texel(int slot) { return vec3(line[0][slot], line[1][slot], line[2][slot]); }

// The i-th texel of this workgroup's line, in front of it and behind it too: slow, from the image.
vec3 texel(int i);

// The weight of the neighbours so many texels to either side.
float weight_at(int distance);
