// The pixel that the G-buffer and the depth buffer hold, for passes that light it.
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

vec3 place_at(ivec2 at, float depth) { return position_from_depth(uvec2(at), depth, view.size, clip_to_offset); }

// Depth error of a line through the next two pixels: on a triangle 1/z, and so depth, is affine on the screen.
float off_the_line(ivec2 at, float depth, ivec2 along) {
    ivec2 second = at + 2 * along;
    if (any(lessThan(second, ivec2(0))) || any(greaterThanEqual(second, ivec2(view.size)))) return 1e30;
    float near = depth_of(at + along), far = depth_of(second);
    return near == 0.0 || far == 0.0 ? 1e30 : abs(2.0 * near - far - depth);
}

// To the neighbour that continues the triangle: of two, the one whose line predicts this depth; 0 if neither does.
vec3 step_on_surface(ivec2 at, float depth, ivec2 along) {
    float before = off_the_line(at, depth, -along), after = off_the_line(at, depth, along);
    if (min(before, after) > 2e-4 * depth) return vec3(0.0);
    ivec2 there = at + (after <= before ? along : -along);
    vec3 away = place_at(there, depth_of(there)) - place_at(at, depth);
    return after <= before ? away : -away;
}

// The triangle's plane, for targets that do not hold it. The mesh's normal where pixels are too few to tell: at outlines,
// and on triangles of a pixel.
vec3 plane_of_depth(ivec2 at, float depth, vec3 facing) {
    vec3 plane = cross(step_on_surface(at, depth, ivec2(0, 1)), step_on_surface(at, depth, ivec2(1, 0)));
    plane *= sign(dot(plane, facing)) * inversesqrt(max(dot(plane, plane), 1e-30));
    float alike = dot(plane, facing);
    return alike < 0.5 || alike > 0.99995 ? facing : plane;
}

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
    p.plane = plane_of_depth(at, depth, p.facing);
#endif
    return p;
}
