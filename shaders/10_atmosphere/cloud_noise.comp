// A tile of billowing noise, 0 to 1, that repeats on all sides: S. Worley's cellular basis, 1996, in three octaves.
#include "common/hash.glsl"

layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
layout(r16f) writeonly uniform image3D result;

// 1 at the feature points, of which each of `cells`³ cells has one, and less between them.
float billows(vec3 at, int cells) {
    vec3 place = at * float(cells);
    ivec3 cell = ivec3(floor(place));
    float nearest = 1e9;
    for (int i = 0; i < 27; ++i) {
        ivec3 other = cell + ivec3(i % 3, i / 3 % 3, i / 9) - 1, wrapped = (other + cells) % cells;
        nearest = min(nearest, distance(vec3(other) + hash3(wrapped + 31 * cells), place));
    }
    return clamp(1.0 - nearest, 0.0, 1.0);
}

void main() {
    vec3 at = (vec3(gl_GlobalInvocationID) + 0.5) / vec3(imageSize(result));
    float noise = 0.625 * billows(at, 6) + 0.25 * billows(at, 12) + 0.125 * billows(at, 24);
    imageStore(result, ivec3(gl_GlobalInvocationID), vec4(clamp(1.6 * noise - 0.25, 0.0, 1.0)));
}
