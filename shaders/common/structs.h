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
    vec3 tangent;        // unit length, object space, perpendicular to the normal, towards increasing u
    float handedness;    // 1 or -1: v grows along handedness * cross(normal, tangent)
    vec2 metres_per_uv;  // object space: length of one unit of u, and of v, on the surface
    float cos_uv;        // cosine of the angle between the u and v directions; 0: no shear
};
// [/tangent_frame]

// How a surface's position changes with its texture coordinates, object space.
struct Derivatives {
    vec3 per_u, per_v;  // metres
};

// [along_uv]
// Tangent-space vector in the oblique basis of increasing u and v; z stays. A step (x, y) changes u by
// x / metres_per_uv.x and v by y / metres_per_uv.y.
SHARED_FUNCTION vec3 along_uv(vec3 v, float cos_uv) {
    float sin_uv = sqrt(max(1.0f - cos_uv * cos_uv, 1e-4f));
    return vec3(v.x - v.y * cos_uv / sin_uv, v.y / sin_uv, v.z);
}
// [/along_uv]

// Drawn part of a mesh, by gl_InstanceIndex.
struct Instance {
    mat4 model;          // object to world
    mat3 normal_matrix;  // inverse transpose of model's upper 3×3
    uint material;
};

// Material parameters; the bits of `maps` mark existing textures.
struct MaterialData {
    vec3 diffuse;
    float shininess;  // Blinn–Phong exponent
    vec3 specular;
    float opacity;
    vec3 emissive;
    uint maps;
    float roughness, metalness;  // 0 to 1, overriding the ORM map; below 0: unset
    float alpha_cutoff;          // lower alphas are holes; below 0: unset
    float normal_scale, occlusion_strength;
    vec3 transmission;  // share of light that passes where opacity lets it; below 0: unset, all of it
};

// Texture transform of a map.
struct MapPlacement {
    mat2 turn;  // uv' = turn * uv + offset
    vec2 offset;
    uint set;  // 1: second set of texture coordinates
};
const uint MAP_COUNT = 12u;

// Texture slots by the bits of MaterialData::maps; in shaders, <slot>_map.
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
const uint METALLIC_ROUGHNESS_MAP = 2048u;  // linear: green scales roughness, blue scales metalness

// Camera data for all shaders.
struct CameraView {
    mat4 view_projection;  // world to clip space: y down, depth 1 near and 0 far
    vec3 eye;              // metres, world space
    float time_s;
    vec2 size;       // pixels
    uint seed;       // value of --seed
    vec2 origin;     // offset within the whole picture, pixels
    float lod_bias;  // mip bias; below 0 for pictures averaged over several sharper ones
};

// Image rows run from the top, texture v from the bottom.
SHARED_FUNCTION vec2 image_uv(vec2 uv) { return vec2(uv.x, 1.0f - uv.y); }

// [moving_uv]
// Animated texture coordinates, for lava and water: a wave of `wobble` tiles in u and v, and a flow of `scroll` tiles
// per second along v.
SHARED_FUNCTION vec2 moving_uv(vec2 uv, float wobble, float scroll, float time_s) {
    const float tau = 6.2831853f;
    return uv + wobble * sin(tau * (vec2(uv.y, uv.x) + vec2(0.31f, 0.23f) * time_s)) + vec2(0.0f, scroll * time_s);
}
// [/moving_uv]

const float LARGEST_HALF = 65504.0f;  // largest finite half

#ifndef __cplusplus
// Surface point for reflection models.
struct Surface {
    vec3 normal, to_eye;  // unit length, world space
    float shininess;      // Blinn–Phong exponent
    vec3 plane;           // normal of the triangle, which receives shadows; unit length, world space
};

// Radiance towards the camera for incident radiance 1, per unit of diffuse and of specular colour.
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
