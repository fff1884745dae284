// A surface with all its maps: the GLSL of the module Maps. Maps with a macro of 0 (knob off, or absent from the
// material) are compiled out.
#include "common/structs.h"
#include "04_surface_maps/plain_draw.glsl"
#include "04_surface_maps/height_field.glsl"
#include "04_surface_maps/unpack_normal.glsl"
#include "04_surface_maps/blend_detail.glsl"
#include "04_surface_maps/mix_orm.glsl"
#include "04_surface_maps/cutout.glsl"
#include "04_surface_maps/read_map.glsl"

layout(scalar) uniform ViewBlock { CameraView view; };
layout(scalar) uniform AmbientBlock { vec3 ambient; };
layout(scalar) readonly buffer MaterialBuffer { MaterialData materials[]; };
uniform sampler2D diffuse_map, specular_map, emissive_map, opacity_map, normal_map, orm_map, occlusion_map, gloss_map,
    detail_normal_map, displacement_map, metallic_roughness_map;
#if MAPS_PLACED
layout(scalar) readonly buffer PlacementBuffer { MapPlacement map_placements[]; };
#endif
layout(scalar) uniform MapsBlock {
    float height_m;        // depth of a height map's darkest texel, metres
    float displacement_m;  // range of a displacement map, darkest to brightest texel, metres
    int steps;
    float strength;
    float detail_tiles;
    float cutoff;
    float wobble;  // tiles
    float scroll;  // tiles per second
} maps;

// Vertex shader outputs, or variables of these names when shading a visibility buffer.
#ifndef SEEN
layout(location = 0) in vec3 world_position;
layout(location = 1) in vec3 world_normal;
layout(location = 2) in vec3 world_tangent;
layout(location = 3) in float handedness;
layout(location = 4) in vec2 metres_per_uv;
layout(location = 5) in vec2 uv;
layout(location = 6) flat in uint material_index;
layout(location = 7) flat in uint item;
layout(location = 8) in float cos_uv;
#if MAPS_SECOND_UVS
layout(location = 9) in vec2 second_uv;
vec2 second_across() { return dFdx(second_uv); }
vec2 second_down() { return dFdy(second_uv); }
#endif
#if MAPS_COLORS
layout(location = 10) in vec4 vertex_color;
#endif

// Screen-space derivatives; `moved`: uv after moving_uv().
vec2 moved_across(vec2 moved, float time_s) { return dFdx(moved); }
vec2 moved_down(vec2 moved, float time_s) { return dFdy(moved); }
vec3 position_across() { return dFdx(world_position); }
vec3 position_down() { return dFdy(world_position); }
#endif

// Side of the surface that the eye is on: 1 or -1.
float side_seen() {
#if !MAPS_TWO_SIDED
    return 1.0;
#elif defined(SEEN)
    return dot(winding_normal, view.eye - world_position) < 0.0 ? -1.0 : 1.0;
#else
    return gl_FrontFacing ? 1.0 : -1.0;
#endif
}

// Tangent space in world space: columns along u, v and the normal, flipped on back faces.
mat3 tangent_space() {
    // Interpolated normals of opposite directions cancel; the triangle's own normal replaces them.
    vec3 n = dot(world_normal, world_normal) > 1e-8 ? normalize(world_normal)
                                                    : normalize(cross(position_down(), position_across()));
    vec3 t = world_tangent - n * dot(n, world_tangent);
    t = dot(t, t) > 1e-8 ? normalize(t) : normalize(abs(n.x) < 0.6 ? vec3(0.0, n.z, -n.y) : vec3(-n.z, 0.0, n.x));
    return side_seen() * mat3(t, handedness * cross(n, t), n);
}

#define HAS_PARALLAX                                                                             \
    (MAPS_HEIGHT && MAPS_METHOD != MAPS_METHOD_FLAT && MAPS_METHOD != MAPS_METHOD_NORMAL && \
     MAPS_MESH == MAPS_MESH_LOADED)

// Displaced meshes have their bumps in the geometry.
#define HAS_DISPLACEMENT (MAPS_DISPLACEMENT && !(MAPS_HEIGHT && MAPS_MESH == MAPS_MESH_DISPLACED))

// Coordinates of a map with its own transform or the second set.
Coordinates placed(uint slot, Coordinates at) {
#if MAPS_PLACED
    MapPlacement place = map_placements[material_index * MAP_COUNT + slot];
#if MAPS_SECOND_UVS
    if (place.set == 1u) at = Coordinates(second_uv, second_across(), second_down());
#endif
    return Coordinates(place.turn * at.uv + place.offset, place.turn * at.dx, place.turn * at.dy);
#else
    return at;
#endif
}

// State of this fragment.
Coordinates coordinates_at(CameraView view) {
    vec2 moved = moving_uv(uv, maps.wobble, maps.scroll, view.time_s);
    float sharper = exp2(view.lod_bias);
    return Coordinates(moved, sharper * moved_across(moved, view.time_s), sharper * moved_down(moved, view.time_s));
}

// Units of u and v per depth of the height field.
vec2 deepest() { return maps.height_m / metres_per_uv; }

vec3 read_normal(sampler2D map, Coordinates at, float scale, out float mean_length) {
    vec4 texel = read(map, at);
    // Alpha holds √(1 - length of the mean normal).
    mean_length = 1.0 - texel.a * texel.a;
#if MAPS_NORMAL_Y == MAPS_NORMAL_Y_DOWN
    texel.y = 1.0 - texel.y;
#endif
    return unpack_normal(texel.xy, maps.strength * scale);
}

// From the frame of a rotated or mirrored map to that of u and v. A scale moves texels apart and leaves their normals.
vec3 turned_back(vec3 normal) {
#if MAPS_PLACED
    mat2 turn = map_placements[material_index * MAP_COUNT + 4u].turn;
    float side = sign(determinant(turn));
    vec2 along_u = side * normalize(vec2(turn[1][1], -turn[0][1]));  // of the map: its v stays
    if (side != 0.0) normal.xy = mat2(along_u, side * vec2(-along_u.y, along_u.x)) * normal.xy;
#endif
    return normal;
}

// Tangent-space normal, and length of the mean normal within the pixel.
vec3 normal_at(Coordinates at, out float mean_length) {
    mean_length = 1.0;
    vec3 normal = vec3(0.0, 0.0, 1.0);
#if MAPS_NORMAL && MAPS_METHOD != MAPS_METHOD_FLAT
    normal = turned_back(read_normal(normal_map, placed(4u, at), materials[material_index].normal_scale, mean_length));
#endif
#if MAPS_DETAIL_NORMAL && MAPS_METHOD != MAPS_METHOD_FLAT
    float detail_length;
    float n = maps.detail_tiles;
    normal = blend_detail(normal, read_normal(detail_normal_map, Coordinates(n * at.uv, n * at.dx, n * at.dy), 1.0, detail_length));
    mean_length *= detail_length;
#endif
    return normal;
}

struct Substance {
    MixedMaterial mixed;
    float occlusion;
    vec3 ambient_specular;  // specular share of ambient light
};

Substance substance_at(Coordinates at, MaterialData material, vec3 base) {
    Substance s = Substance(MixedMaterial(base, material.specular, material.shininess), 1.0, vec3(0.0));
    vec3 orm = vec3(1.0, 0.0, 0.0);
#if MAPS_ORM
    orm = read(orm_map, at).rgb;
    s.occlusion = orm.r;
#endif
    float roughness = overridden(orm.g, material.roughness), metalness = overridden(orm.b, material.metalness);
#if MAPS_METALLIC_ROUGHNESS
    vec2 factors = read(metallic_roughness_map, placed(11u, at)).gb;
    roughness *= factors.x;
    metalness *= factors.y;
#endif
#if MAPS_METALLIC_ROUGHNESS
    if (material.roughness < 0.0) s.mixed.shininess = mix_orm(base, factors.x, 0.0).shininess;
#endif
    bool has_orm = MAPS_ORM == 1 || material.roughness >= 0.0;
    if (has_orm) {
        s.mixed = mix_orm(base, roughness, metalness);
        s.ambient_specular = s.mixed.specular;
    }
#if MAPS_OCCLUSION
    float open = read(occlusion_map, placed(7u, at)).r, strength = material.occlusion_strength;
    s.occlusion *= strength == 1.0 ? open : mix(1.0, open, strength);
#endif
#if MAPS_SPECULAR
    s.mixed.specular *= read(specular_map, placed(1u, at)).rgb;
#endif
#if MAPS_GLOSS
    s.mixed.shininess = exp2(mix(3.0, 8.0, read(gloss_map, placed(8u, at)).r));  // 8 to 256
#endif
    return s;
}

// M. Toksvig, "Mipmapping Normal Maps", 2005: where the normals within a pixel differ, their mean is shorter than 1,
// and the highlight broader. The normalised model makes it darker by itself.
float toksvig(float shininess, float mean_length) {
    return shininess * mean_length / max(mean_length + shininess * (1.0 - mean_length), 1e-6);
}

// Surface parameters for lighting, all maps applied.
struct MappedSurface {
    Surface surface;        // the normal with its bumps; the exponent that is left of it from afar
    vec3 facing;            // unit length, world space: the normal of the mesh
    vec3 position;          // metres, world space: where the eye's ray meets the height map
    Substance substance;
    vec3 glow;              // emitted, linear
    float alpha;            // 1 where nothing is cut out
    vec3 tint;              // share of light that passes where alpha lets it, by channel
};

// Unit length: the plane of the triangle that is seen. `facing` is interpolated; where both are alike, it is finer.
vec3 plane_of_triangle(vec3 facing) {
    vec3 plane = cross(position_down(), position_across());
    plane *= sign(dot(plane, facing)) * inversesqrt(max(dot(plane, plane), 1e-30));
    return plane == vec3(0.0) || dot(plane, facing) > 0.99995 ? facing : plane;
}

MappedSurface map_surface(vec3 eye, MaterialData material, Coordinates at) {
    mat3 frame = tangent_space();
    MappedSurface m;
    m.facing = frame[2];
    m.surface.plane = plane_of_triangle(m.facing);
    m.position = world_position;
    m.surface.to_eye = normalize(eye - world_position);
#if HAS_PARALLAX || HAS_DISPLACEMENT
    vec3 eye_in_frame = m.surface.to_eye * frame, to_eye = along_uv(eye_in_frame, cos_uv);
#endif
#if HAS_DISPLACEMENT
    // A second map, of its own, that shifts all textures along the view: one look, as if the surface lay at (map - 1/2)
    // * displacement_m above the mesh. Limited, because nothing searches for the true hit afterwards: with the division
    // by z a swell of slope s shows places twice from tan(angle) = 1/s on.
    at.uv += parallax_offset_limited(0.5 - read(displacement_map, at).r, to_eye, maps.displacement_m / metres_per_uv);
#endif
#if HAS_PARALLAX
    at.uv -= round(at.uv);  // textures repeat, and numbers near 0 are finer
    Hit hit = find_hit(at.uv, to_eye, deepest(), maps.steps);
    m.position -= m.surface.to_eye * (maps.height_m * hit.depth / max(eye_in_frame.z, lowest_eye));
    at.uv = hit.uv;
#endif
    vec4 base = vec4(material.diffuse, 1.0);
    float opacity = 1.0;
#if MAPS_COLORS
    base *= vertex_color;
#endif
#if MAPS_DIFFUSE
    base *= read(diffuse_map, placed(0u, at));
#endif
#if MAPS_OPACITY
    opacity = read(opacity_map, placed(3u, at)).r;
#endif
    m.alpha = surface_alpha(base.a, opacity, material.opacity);
    m.tint = material.transmission.r < 0.0 ? vec3(1.0) : material.transmission;

    float mean_length;
    m.surface.normal = frame * normal_at(at, mean_length);
    m.substance = substance_at(at, material, base.rgb);
    m.surface.shininess = m.substance.mixed.shininess;
#if MAPS_FILTER == MAPS_FILTER_TOKSVIG
    m.surface.shininess = toksvig(m.surface.shininess, mean_length);
#endif
    m.glow = material.emissive;
#if MAPS_EMISSIVE
    m.glow *= read(emissive_map, placed(2u, at)).rgb;
#endif
#if MAPS_UNLIT
    m.glow = base.rgb;
    m.substance = Substance(MixedMaterial(vec3(0.0), vec3(0.0), 1.0), 1.0, vec3(0.0));
#endif
    return m;
}

// Surface of this fragment. Cut-outs are discarded, unless alpha blends them.
MappedSurface seen_surface() {
    MappedSurface m = map_surface(view.eye, materials[material_index], coordinates_at(view));
#if !defined(TRANSPARENT) && !defined(SEEN)  // visible, so not cut out
    float own = materials[material_index].alpha_cutoff;
    if (is_cut_out(m.alpha, own < 0.0 ? maps.cutoff : own)) discard;
#endif
    return m;
}

// Radiance towards the camera; `diffuse` and `specular` are the lights' sums per unit of its colours.
vec3 radiance_of(MappedSurface m, vec3 diffuse, vec3 specular, vec3 ambient) {
    Substance s = m.substance;
    vec3 ambient_light = (s.mixed.diffuse + s.ambient_specular) * ambient * s.occlusion;
    return ambient_light + s.mixed.diffuse * diffuse + s.mixed.specular * specular + m.glow;
}
