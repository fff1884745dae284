// Structs shared by GLSL and C++. In GLSL they use scalar layout, packed as C++ packs glm's vectors.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

// [vertex]
struct Vertex {
    vec3 position;  // metres, object space
    vec3 normal;    // unit length
    vec2 uv;        // v = 0 is the bottom row of an image
};
// [/vertex]

// Tangent frame of a vertex.
// [tangent_frame]
struct TangentFrame {
    vec3 tangent;        // unit length, object space, perpendicular to the normal: where u grows
    float handedness;    // 1 or -1: v grows along handedness * cross(normal, tangent)
    vec2 metres_per_uv;  // object space: how far one step in u, and one in v, is on the surface
    float cos_uv;        // of the angle between the directions in which u and v grow: 0 where a texture is not sheared
};
// [/tangent_frame]

// How a surface's position changes with its texture coordinates, object space.
struct Derivatives {
    vec3 per_u, per_v;  // metres
};

// [along_uv]
// A tangent-space vector along the directions of growing u and v, which need not be perpendicular; z stays. A step (x,
// y) changes u by x / metres_per_uv.x and v by y / metres_per_uv.y.
SHARED_FUNCTION vec3 along_uv(vec3 v, float cos_uv) {
    float sin_uv = sqrt(max(1.0f - cos_uv * cos_uv, 1e-4f));
    return vec3(v.x - v.y * cos_uv / sin_uv, v.y / sin_uv, v.z);
}
// [/along_uv]

// One drawn part of a mesh; gl_InstanceIndex counts them.
struct Instance {
    mat4 model;          // object to world
    mat3 normal_matrix;  // inverse transpose of its upper 3×3
    uint material;
};

// A material's numbers. The bits of `maps` say which of its textures exist.
struct MaterialData {
    vec3 diffuse;
    float shininess;  // Blinn–Phong exponent
    vec3 specular;
    float opacity;
    vec3 emissive;
    uint maps;
    float roughness, metalness;  // 0 to 1, instead of the ORM map's; below 0: nothing is said
    float alpha_cutoff;          // below it there is a hole; below 0: the file does not say
    float normal_scale, occlusion_strength;
};

// Where a map lies on a surface.
struct MapPlacement {
    mat2 turn;  // uv' = turn * uv + offset
    vec2 offset;
    uint set;  // 1: the second texture coordinates
};
const uint MAP_COUNT = 12u;

// Texture slots, in the order of MaterialData::maps' bits. In a shader the texture is called <slot>_map.
const uint DIFFUSE_MAP = 1u;                // sRGB colour
const uint SPECULAR_MAP = 2u;               // linear
const uint EMISSIVE_MAP = 4u;               // sRGB colour
const uint OPACITY_MAP = 8u;                // linear
const uint NORMAL_MAP = 16u;                // linear, +y up
const uint HEIGHT_MAP = 32u;                // linear, 1 is the surface
const uint ORM_MAP = 64u;                   // linear: occlusion, roughness, metalness
const uint OCCLUSION_MAP = 128u;            // linear
const uint GLOSS_MAP = 256u;                // linear
const uint DETAIL_NORMAL_MAP = 512u;        // linear, +y up
const uint DISPLACEMENT_MAP = 1024u;        // linear, 1/2 is the surface
const uint METALLIC_ROUGHNESS_MAP = 2048u;  // linear: green times roughness, blue times metalness

// Camera data for all shaders.
struct CameraView {
    mat4 view_projection;  // world to clip space: y down, depth 1 near and 0 far
    vec3 eye;              // metres, world space
    float time_s;
    vec2 size;       // pixels
    uint seed;       // of --seed
    vec2 origin;     // of this picture in the one it is a part of, pixels
    float lod_bias;  // for mip levels: 0, or less where the mean of several pictures is taken, each of which is sharper
};

// Image rows run from the top, texture v from the bottom.
SHARED_FUNCTION vec2 image_uv(vec2 uv) { return vec2(uv.x, 1.0f - uv.y); }

// [moving_uv]
// Texture coordinates that change with time, as for lava and water: a wave of `wobble` tiles across both, and a steady flow
// of `scroll` tiles per second along v.
SHARED_FUNCTION vec2 moving_uv(vec2 uv, float wobble, float scroll, float time_s) {
    const float tau = 6.2831853f;
    return uv + wobble * sin(tau * (vec2(uv.y, uv.x) + vec2(0.31f, 0.23f) * time_s)) + vec2(0.0f, scroll * time_s);
}
// [/moving_uv]

const float LARGEST_HALF = 65504.0f;  // the largest number that a target of half floats holds

#ifndef __cplusplus
// A surface as reflection sees it.
struct Surface {
    vec3 normal;      // unit length, world space
    vec3 to_eye;      // unit length, world space
    float shininess;  // Blinn–Phong exponent
};

// Light that leaves towards the camera for radiance 1, per unit of diffuse and of specular colour.
struct Reflected {
    vec3 diffuse, specular;
};

// Material parameters for reflection.
struct MixedMaterial {
    vec3 diffuse, specular;  // linear
    float shininess;         // Blinn–Phong exponent
};

const float most_shininess = 8192.0;
#endif

END_SHARED
