// Structs written once and read by GLSL and C++ alike. In GLSL they lie in buffers with scalar layout, which packs
// members without padding, as C++ packs glm's vectors.
#pragma once
#include "common/shared.h"

BEGIN_SHARED

// [vertex]
struct Vertex {
    vec3 position;  // metres, object space
    vec3 normal;    // unit length
    vec2 uv;        // v = 0 is the bottom row of an image
};
// [/vertex]

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
    float roughness, metalness;  // of the scene file, 0 to 1, instead of the ORM map's; below 0: it says nothing
};

// Texture slots, in the order of MaterialData::maps' bits. In a shader the texture is called <slot>_map.
const uint DIFFUSE_MAP = 1u;          // sRGB colour
const uint SPECULAR_MAP = 2u;         // linear
const uint EMISSIVE_MAP = 4u;         // sRGB colour
const uint OPACITY_MAP = 8u;          // linear
const uint NORMAL_MAP = 16u;          // linear, +y up
const uint HEIGHT_MAP = 32u;          // linear, 1 is the surface
const uint ORM_MAP = 64u;             // linear: occlusion, roughness, metalness
const uint OCCLUSION_MAP = 128u;      // linear
const uint GLOSS_MAP = 256u;          // linear
const uint DETAIL_NORMAL_MAP = 512u;  // linear, +y up
const uint DISPLACEMENT_MAP = 1024u;  // linear, 1/2 is the surface

// What every vertex and fragment may know of the camera.
struct CameraView {
    mat4 view_projection;  // world to clip space: y down, depth 1 near and 0 far
    vec3 eye;              // metres, world space
    float time_s;
    vec2 size;       // pixels
    uint seed;       // of --seed
    vec2 origin;     // of this picture in the one it is a part of, pixels
    float lod_bias;  // for mip levels: 0, or less where the mean of several pictures is taken, each of which is sharper
};

END_SHARED
