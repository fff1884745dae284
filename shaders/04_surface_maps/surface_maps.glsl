// A surface with all its maps: what the module Maps gives to shaders. A map whose macro is 0, because its knob is off or
// the material lacks it, is not in the shader.
#include "common/material.glsl"
#include "02_lambert_phong/reflection.glsl"
#include "04_surface_maps/knobs.glsl"
#include "04_surface_maps/moving_uv.glsl"
#include "04_surface_maps/parallax.glsl"
#include "04_surface_maps/displacement.glsl"
#include "04_surface_maps/unpack_normal.glsl"
#include "04_surface_maps/blend_detail.glsl"
#include "04_surface_maps/mix_orm.glsl"
#include "04_surface_maps/cutout.glsl"
#include "04_surface_maps/surface_inputs.glsl"
#include "04_surface_maps/tangent_frame.h"

uniform sampler2D specular_map, emissive_map, opacity_map, normal_map, orm_map, occlusion_map, gloss_map,
    detail_normal_map, displacement_map;

#define HAS_PARALLAX                                                                             \
    (MAPS_HEIGHT && MAPS_METHOD != MAPS_METHOD_FLAT && MAPS_METHOD != MAPS_METHOD_NORMAL && \
     MAPS_MESH == MAPS_MESH_LOADED)

// Bumps that are in the mesh itself stay where they are.
#define HAS_DISPLACEMENT (MAPS_DISPLACEMENT && !(MAPS_HEIGHT && MAPS_MESH == MAPS_MESH_DISPLACED))

struct Coordinates {
    vec2 uv, dx, dy;  // and how they change from pixel to pixel
};

// The level by the formula, not by textureGrad: devices may take shortcuts there, and Mesa 22.3 does.
vec4 read(sampler2D map, Coordinates at) {
    vec2 size = vec2(textureSize(map, 0)), dx = at.dx * size, dy = at.dy * size;
    float texels = max(max(dot(dx, dx), dot(dy, dy)), 1e-12);  // squared, from one pixel to the next
    return textureLod(map, image_uv(at.uv), 0.5 * log2(texels));
}

// Of this fragment.
Coordinates coordinates_at(CameraView view) {
    vec2 moved = moving_uv(uv, view.time_s);
    float sharper = exp2(view.lod_bias);
    return Coordinates(moved, sharper * dFdx(moved), sharper * dFdy(moved));
}

// How far one unit of u and of v goes from the top of the height field to its bottom.
vec2 deepest() { return maps.height_m / metres_per_uv; }

vec3 read_normal(sampler2D map, Coordinates at, out float mean_length) {
    vec4 texel = read(map, at);
    // Alpha holds the root of what the mean of the normals below this texel lacks in length.
    mean_length = 1.0 - texel.a * texel.a;
#if MAPS_NORMAL_Y == MAPS_NORMAL_Y_DOWN
    texel.y = 1.0 - texel.y;
#endif
    return unpack_normal(texel.xy, maps.strength);
}

// [normal]
// The normal in tangent space, and how long the mean of all normals within the pixel is.
vec3 normal_at(Coordinates at, out float mean_length) {
    mean_length = 1.0;
    vec3 normal = vec3(0.0, 0.0, 1.0);
#if MAPS_NORMAL && MAPS_METHOD != MAPS_METHOD_FLAT
    normal = read_normal(normal_map, at, mean_length);
#endif
#if MAPS_DETAIL_NORMAL && MAPS_METHOD != MAPS_METHOD_FLAT
    float detail_length;
    float n = maps.detail_tiles;
    normal = blend_detail(normal, read_normal(detail_normal_map, Coordinates(n * at.uv, n * at.dx, n * at.dy), detail_length));
    mean_length *= detail_length;
#endif
    return normal;
}
// [/normal]

struct Substance {
    MixedMaterial mixed;
    float occlusion;
    vec3 ambient_specular;  // what of light from everywhere is reflected as by a mirror
};

// [substance]
Substance substance_at(Coordinates at, MaterialData material, vec3 base) {
    Substance s = Substance(MixedMaterial(base, material.specular, material.shininess), 1.0, vec3(0.0));
    vec3 orm = vec3(1.0, 0.0, 0.0);
#if MAPS_ORM
    orm = read(orm_map, at).rgb;
    s.occlusion = orm.r;
#endif
    bool has_orm = MAPS_ORM == 1 || material.roughness >= 0.0;
    if (has_orm) {
        s.mixed = mix_orm(base, overridden(orm.g, material.roughness), overridden(orm.b, material.metalness));
        s.ambient_specular = s.mixed.specular;
    }
#if MAPS_OCCLUSION
    s.occlusion *= read(occlusion_map, at).r;
#endif
#if MAPS_SPECULAR
    s.mixed.specular *= read(specular_map, at).rgb;
#endif
#if MAPS_GLOSS
    s.mixed.shininess = exp2(mix(3.0, 8.0, read(gloss_map, at).r));  // 8 to 256
#endif
    return s;
}
// [/substance]

// [toksvig]
// M. Toksvig, "Mipmapping Normal Maps", 2005: where the normals within a pixel differ, their mean is shorter than 1,
// and the highlight broader. The normalised model makes it darker by itself.
float toksvig(float shininess, float mean_length) {
    return shininess * mean_length / max(mean_length + shininess * (1.0 - mean_length), 1e-6);
}
// [/toksvig]

// What lighting needs to know, all maps applied.
struct MappedSurface {
    Surface surface;        // the normal with its bumps; the exponent that is left of it from afar
    vec3 facing;            // unit length, world space: the normal of the mesh
    vec3 position;          // metres, world space: where the eye's ray meets the height map
    Substance substance;
    vec3 glow;              // emitted, linear
    float alpha;            // 1 where nothing is cut out
};

// [map_surface]
MappedSurface map_surface(vec3 eye, MaterialData material, Coordinates at) {
    mat3 frame = tangent_space();
    MappedSurface m;
    m.facing = frame[2];
    m.position = world_position;
    m.surface.to_eye = normalize(eye - world_position);
#if HAS_PARALLAX || HAS_DISPLACEMENT
    vec3 eye_in_frame = m.surface.to_eye * frame, to_eye = along_uv(eye_in_frame, cos_uv);
#endif
#if HAS_DISPLACEMENT
    at.uv += displacement_shift(read(displacement_map, at).r, to_eye, maps.displacement_m / metres_per_uv);
#endif
#if HAS_PARALLAX
    at.uv -= round(at.uv);  // textures repeat, and numbers near 0 are finer
    // Always maps.steps, which no compiler knows: Mesa 22.3 crashes on some loops that a uniform ends (common/opaque.glsl).
    int steps = to_eye.z < 2.0 ? maps.steps : 1;
    Hit hit = find_hit(at.uv, to_eye, deepest(), steps);
    m.position -= m.surface.to_eye * (maps.height_m * hit.depth / max(eye_in_frame.z, lowest_eye));
    at.uv = hit.uv;
#endif
    vec4 base = vec4(material.diffuse, 1.0);
    float opacity = 1.0;
#if MAPS_DIFFUSE
    base *= read(diffuse_map, at);
#endif
#if MAPS_OPACITY
    opacity = read(opacity_map, at).r;
#endif
    m.alpha = surface_alpha(base.a, opacity, material.opacity);

    float mean_length;
    m.surface.normal = frame * normal_at(at, mean_length);
    m.substance = substance_at(at, material, base.rgb);
    m.surface.shininess = m.substance.mixed.shininess;
#if MAPS_FILTER == MAPS_FILTER_TOKSVIG
    m.surface.shininess = toksvig(m.surface.shininess, mean_length);
#endif
    m.glow = material.emissive;
#if MAPS_EMISSIVE
    m.glow *= read(emissive_map, at).rgb;
#endif
    return m;
}
// [/map_surface]

// [radiance_of]
// What leaves a surface towards the eye: `diffuse` and `specular` are the lights' per unit of its colours.
vec3 radiance_of(MappedSurface m, vec3 diffuse, vec3 specular, vec3 ambient) {
    Substance s = m.substance;
    vec3 ambient_light = (s.mixed.diffuse + s.ambient_specular) * ambient * s.occlusion;
    return ambient_light + s.mixed.diffuse * diffuse + s.mixed.specular * specular + m.glow;
}
// [/radiance_of]
