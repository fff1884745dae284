// Decoding of the G-buffer and depth, for lighting passes.
#include "06_deferred/gbuffer.glsl"
#include "06_deferred/position_from_depth.glsl"
#include "common/structs.h"

#if GBUFFER_IS_PACKED
uniform usampler2D gbuffer_normals, gbuffer_diffuse, gbuffer_specular;
#else
uniform sampler2D gbuffer_normal, gbuffer_diffuse, gbuffer_specular;
#if GBUFFER_METHOD == GBUFFER_METHOD_FAT
uniform sampler2D gbuffer_position;
#endif
#endif
uniform sampler2D gbuffer_depth;
layout(scalar) uniform ViewBlock { CameraView view; };
layout(scalar) uniform ClipBlock { mat4 clip_to_offset; };  // to vectors from the eye, since floats are finer near 0

// Stored depth; 0: no surface.
float depth_of(ivec2 at) { return texelFetch(gbuffer_depth, at, 0).r; }

// [read_pixel]
// `depth`: depth_of(at), above 0.
Pixel read_pixel(ivec2 at, float depth) {
    Stored s;
#if GBUFFER_IS_PACKED
    s.normals = texelFetch(gbuffer_normals, at, 0).r;
    s.diffuse = texelFetch(gbuffer_diffuse, at, 0).r;
    s.specular = texelFetch(gbuffer_specular, at, 0).r;
#else
    s.normal = texelFetch(gbuffer_normal, at, 0);
    s.diffuse = texelFetch(gbuffer_diffuse, at, 0);
    s.specular = texelFetch(gbuffer_specular, at, 0);
#if GBUFFER_METHOD == GBUFFER_METHOD_FAT
    s.position = texelFetch(gbuffer_position, at, 0);
#endif
#endif
    Pixel p = restore(s);
#if GBUFFER_METHOD != GBUFFER_METHOD_FAT
    p.position = view.eye + position_from_depth(uvec2(at), depth, view.size, clip_to_offset);
#endif
    return p;
}
// [/read_pixel]
