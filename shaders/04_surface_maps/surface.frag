// A surface with all its maps, lit. A map whose macro is 0, because its knob is off or the material lacks it, is not in
// the shader.
#include "common/material.glsl"
#include "02_lambert_phong/reflection.glsl"
#include "03_attenuation/arriving.glsl"
#include "04_surface_maps/knobs.glsl"
#include "04_surface_maps/moving_uv.glsl"
#include "04_surface_maps/parallax.glsl"
#include "04_surface_maps/unpack_normal.glsl"
#include "04_surface_maps/blend_detail.glsl"
#include "04_surface_maps/mix_orm.glsl"
#include "04_surface_maps/cutout.glsl"

layout(location = 0) in vec3 world_position;
layout(location = 1) in vec3 world_normal;
layout(location = 2) in vec3 world_tangent;
layout(location = 3) in float handedness;
layout(location = 4) in vec2 metres_per_uv;
layout(location = 5) in vec2 uv;
layout(location = 6) flat in uint material_index;
layout(location = 0) out vec4 color;

layout(scalar) uniform ViewBlock { CameraView view; };
layout(scalar) readonly buffer LightBuffer { LightData lights[]; };
layout(scalar) uniform AmbientBlock { vec3 ambient; };
uniform sampler2D specular_map, emissive_map, opacity_map, normal_map, orm_map, occlusion_map, gloss_map,
    detail_normal_map;

#define HAS_PARALLAX (HEIGHT && METHOD != METHOD_FLAT && METHOD != METHOD_NORMAL && MESH == MESH_LOADED)
#define HAS_NORMAL (NORMAL && METHOD != METHOD_FLAT)

const float white_texels = 32.0;  // an error that SHOW shows as white
const float walk_m = 0.05;        // by which the eye comes closer along the surface from one frame to the next: for swim

// Tangent space in the world: columns along u, along v, along the normal.
mat3 tangent_space(vec3 normal) {
    // Normals of opposite vertices cancel between them: there the mesh's own slope has to do.
    vec3 n = dot(normal, normal) > 1e-8 ? normalize(normal) : normalize(cross(dFdy(world_position), dFdx(world_position)));
    vec3 t = world_tangent - n * dot(n, world_tangent);
    t = dot(t, t) > 1e-8 ? normalize(t) : normalize(abs(n.x) < 0.6 ? vec3(0.0, n.z, -n.y) : vec3(-n.z, 0.0, n.x));
    return mat3(t, handedness * cross(n, t), n);
}

struct Coordinates {
    vec2 uv, dx, dy;  // and how they change from pixel to pixel
};

// The level by the formula, not by textureGrad: devices may take shortcuts there, and Mesa 22.3 does.
vec4 read(sampler2D map, Coordinates at) {
    vec2 size = vec2(textureSize(map, 0)), dx = at.dx * size, dy = at.dy * size;
    float texels = max(max(dot(dx, dx), dot(dy, dy)), 1e-12);  // squared, from one pixel to the next
    return textureLod(map, image_uv(at.uv), 0.5 * log2(texels));
}

vec3 read_normal(sampler2D map, Coordinates at, out float mean_length) {
    vec4 texel = read(map, at);
    // Alpha holds the root of what the mean of the normals below this texel lacks in length.
    mean_length = 1.0 - texel.a * texel.a;
#if NORMAL_Y == NORMAL_Y_DOWN
    texel.y = 1.0 - texel.y;
#endif
    return unpack_normal(texel.xy, knobs.strength);
}

// [normal]
// The normal in tangent space, and how long the mean of all normals within the pixel is.
vec3 normal_at(Coordinates at, out float mean_length) {
    mean_length = 1.0;
    vec3 normal = vec3(0.0, 0.0, 1.0);
#if HAS_NORMAL
    normal = read_normal(normal_map, at, mean_length);
#endif
#if DETAIL_NORMAL && METHOD != METHOD_FLAT
    float detail_length;
    float n = knobs.detail_tiles;
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
#if ORM
    orm = read(orm_map, at).rgb;
    s.occlusion = orm.r;
#endif
    bool has_orm = ORM == 1 || material.roughness >= 0.0;
    if (has_orm) {
        s.mixed = mix_orm(base, overridden(orm.g, material.roughness), overridden(orm.b, material.metalness));
        s.ambient_specular = s.mixed.specular;
    }
#if OCCLUSION
    s.occlusion *= read(occlusion_map, at).r;
#endif
#if SPECULAR
    s.mixed.specular *= read(specular_map, at).rgb;
#endif
#if GLOSS
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

struct Shaded {
    vec3 color;
    float alpha;
};

Shaded shade(vec3 position, vec3 normal, Coordinates at) {
    MaterialData material = materials[material_index];
    mat3 frame = tangent_space(normal);
    vec3 to_eye = normalize(view.eye - position);
#if HEIGHT && MESH == MESH_LOADED && (HAS_PARALLAX || MEASURES_HITS)
    at.uv -= round(at.uv);  // textures repeat, and numbers near 0 are finer; unlike fract this loses no bit
    vec3 eye_in_frame = to_eye * frame;
    vec2 deepest = knobs.height_m / metres_per_uv;
#if SHOW == SHOW_HIT_ERROR
    return Shaded(vec3(hit_error(at.uv, eye_in_frame, deepest, knobs.steps) / white_texels), 1.0);
#elif SHOW == SHOW_SWIM
    vec3 from = (view.eye - position) * frame;
    vec3 to = from - vec3(normalize(from.xy + 1e-6) * walk_m, 0.0);
    return Shaded(vec3(swim(at.uv, from, to, deepest, knobs.height_m, knobs.steps) / white_texels), 1.0);
#else
    Hit hit = find_hit(at.uv, eye_in_frame, deepest, knobs.steps);
    position -= to_eye * (knobs.height_m * hit.depth / max(eye_in_frame.z, lowest_eye));
    at.uv = hit.uv;
#endif
#elif MEASURES_HITS
    return Shaded(vec3(0.0), 1.0);
#endif

    vec4 base = vec4(material.diffuse, 1.0);
    float opacity = 1.0;
#if DIFFUSE
    base *= read(diffuse_map, at);
#endif
#if OPACITY
    opacity = read(opacity_map, at).r;
#endif
    float alpha = surface_alpha(base.a, opacity, material.opacity);

    float mean_length;
    Surface surface;
    surface.normal = frame * normal_at(at, mean_length);
    surface.to_eye = to_eye;
#if SHOW == SHOW_NORMAL
    return Shaded(0.5 + 0.5 * surface.normal, alpha);
#endif
    Substance s = substance_at(at, material, base.rgb);
    surface.shininess = s.mixed.shininess;
#if FILTER == FILTER_TOKSVIG
    surface.shininess = toksvig(surface.shininess, mean_length);
#endif
    vec3 sum = (s.mixed.diffuse + s.ambient_specular) * ambient * s.occlusion;
    for (int i = 0; i < lights.length(); ++i) {
        Arriving light = arriving_light(lights[i], position, 1.0);
        Reflected reflected = reflect_light(surface, light.to_light, Wrap(0.0, 1.0, vec3(1.0)));
        // What a bump turns towards a light that is below the mesh stays dark: the mesh is in the way.
        float above = dot(frame[2], light.to_light) > 0.0 ? 1.0 : 0.0;
        sum += above * light.radiance * (s.mixed.diffuse * reflected.diffuse + s.mixed.specular * reflected.specular);
    }
    vec3 glow = material.emissive;
#if EMISSIVE
    glow *= read(emissive_map, at).rgb;
#endif
    return Shaded(sum + glow, alpha);
}

// [samples]
// The mean over samples × samples points of the pixel, where all is continued linearly from its middle.
void main() {
    vec2 moved = moving_uv(uv, view.time_s);
    vec2 uv_dx = dFdx(moved), uv_dy = dFdy(moved);
    vec3 position_dx = dFdx(world_position), position_dy = dFdy(world_position);
    vec3 normal_dx = dFdx(world_normal), normal_dy = dFdy(world_normal);
    float count = float(knobs.samples);
    vec3 sum = vec3(0.0);
    float there = 0.0;
    for (int y = 0; y < knobs.samples; ++y)
        for (int x = 0; x < knobs.samples; ++x) {
            vec2 o = (vec2(x, y) + 0.5) / count - 0.5;
            Shaded shaded = shade(world_position + o.x * position_dx + o.y * position_dy,
                                  world_normal + o.x * normal_dx + o.y * normal_dy,
                                  Coordinates(moved + o.x * uv_dx + o.y * uv_dy, uv_dx / count, uv_dy / count));
            if (is_cut_out(shaded.alpha, knobs.cutoff)) continue;
            sum += shaded.color;
            there += 1.0;
        }
    if (there < max(0.5 * count * count, 1.0)) discard;
    color = vec4(sum / there, 1.0);
}
// [/samples]
