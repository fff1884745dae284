// Skin, shaded as it is drawn, or in compute by skin_seen.comp: light that comes out of it, light that comes through it,
// light that its surface reflects.
#include "03_attenuation/lighting.glsl"
#include "12_skin/matt_color.glsl"
#include "05_shadow_maps/shadow.glsl"
#include "common/environment.glsl"
#include "12_skin/kelemen_szirmay_kalos.glsl"
#include "12_skin/mix_albedo.glsl"
#include "12_skin/skin.glsl"
#include "12_skin/transmittance.glsl"

// Values of DIFFUSE.
#define BY_LAMBERT 0
#define BY_WRAP 1
#define BY_TABLE 2
#define BY_SCREEN 3
#define BY_MAP 4
const int shows_specular = 0, shows_thickness = 1;  // else the charts

#if VIEWS
layout(scalar) uniform ShownBlock { int shown; };
#endif
uniform sampler2D skin_occlusion, skin_diffused, skin_stretch, skin_position, skin_preintegrated;

// Path of the light through the tissue to this point, in mm: from the nearest surface in the light's map. The point
// is moved inwards, so that at an edge the map does not show its neighbourhood. Below 0: no map.
float thickness_mm(uint index, vec3 position, vec3 facing, float inwards_m) {
#if SHADOW_METHOD == SHADOW_METHOD_NONE
    return -1.0;
#else
    ShadowLight light = shadow_lights[index];
    if (light.views == 0u) return -1.0;
    vec3 inside = position - inwards_m * facing;
    ShadowView map = shadow_views[view_of(light, inside)];
    if (map.layer == NO_LAYER) return -1.0;
    vec3 place = light_clip_position(map.to_clip, inside);
    if (place.z <= 0.0) return -1.0;
    return 1000.0 * max(map_distance(map, place.z) - map_distance(map, read_depth(place.xy, map.layer)), 0.0);
#endif
}

// Share of a light's radiance that a white surface with that cosine emits, near the point itself.
vec3 entering(float cosine, float curvature) {
#if DIFFUSE == BY_WRAP
    // Reddest where it is farthest from the light; divided so that as much light comes back as went in.
    vec3 wrap = skin.wrap * vec3(1.0, 0.4, 0.25), lit = max((cosine + wrap) / (1.0 + wrap), 0.0);
    return lit / (1.0 + wrap);
#elif DIFFUSE == BY_TABLE
    vec2 size = vec2(textureSize(skin_preintegrated, 0));
    vec2 at = vec2(0.5 + 0.5 * cosine, curvature_v(curvature));
    return textureLod(skin_preintegrated, (0.5 + at * (size - 1.0)) / size, 0.0).rgb;
#else
    return vec3(max(cosine, 0.0));
#endif
}

// Light leaving the skin towards the eye, linear; BY_SCREEN: without `light`, which is blurred (a: distance in
// metres) and then multiplied by `after_blur`.
void shade_skin(out vec4 color, out vec4 light_before, out vec4 after_blur) {
    light_before = after_blur = vec4(0.0);
    MappedSurface m = map_surface(view.eye, materials[material_index], coordinates_at(view));
    vec3 albedo = matt_color(m.substance), map = m.substance.mixed.specular;
    vec3 n = m.surface.normal, v = m.surface.to_eye, position = m.position;
    float rough = skin.roughness * (map.g > 0.0 ? map.g : 1.0);  // also of a material without a map
    float scale = skin.specular_scale * map.r;
    vec2 at = image_uv(uv);
    float occlusion = textureLod(skin_occlusion, at, 0.0).r;
    float thickness = 1e3;
    vec3 specular = vec3(0.0), through = vec3(0.0);
#if DIFFUSE == BY_MAP
    vec3 diffuse = textureLod(skin_diffused, at, 0.0).rgb;
#else
    vec3 diffuse = occlusion * surroundings_light(m.facing);
    float curvature = textureLod(skin_stretch, at, 0.0).a;
#endif

    for (uint i = 0u; i < lights_data.length(); ++i) {
        VisibleLight light = visible_light(i, position, m.facing, m.surface.plane);
        if (light.radiance == vec3(0.0)) continue;
        float cosine = dot(m.facing, light.to_light);
        vec3 seen = light.visible * light.radiance;
#if DIFFUSE != BY_MAP
        diffuse += seen * entering(cosine, curvature) * way_in(max(cosine, 0.0), rough, scale);
#endif
        // The lights' radiance is that of a white surface: the irradiance is pi times that.
        if (cosine > 0.0) specular += 3.14159265 * scale * kelemen_szirmay_kalos(n, light.to_light, v, rough, skin.f0) * seen;
        // Light on the far side is taken to arrive as steeply as it would from behind here.
        float mm = thickness_mm(i, position, m.facing, 0.001 * skin.inwards_mm);
        if (mm >= 0.0) {
            if (cosine < 0.0) thickness = min(thickness, mm);
            through += clamp(0.3 - cosine, 0.0, 1.0) * transmittance(mm / max(skin.translucency, 1e-3)) * light.radiance;
        }
    }

    float cos_v = max(dot(n, v), 0.0);
    specular += scale * reflected_share(cos_v, rough).x * occlusion * surroundings_mirrored(reflect(-v, n), rough);
    vec3 before = albedo_before(albedo, skin.before);
    vec3 after = albedo_after(albedo, skin.before) * way_out(cos_v, rough, scale);
    color = vec4(specular + albedo * through + m.glow, 1.0);
#if DIFFUSE == BY_SCREEN
    light_before = vec4(min(before * diffuse, LARGEST_HALF), length(view.eye - position));
    after_blur = vec4(after, 1.0);
#elif DIFFUSE == BY_MAP
    color.rgb += after * diffuse;
#else
    color.rgb += after * before * diffuse;
#endif
#if VIEWS
    // Each chart in its own colour, dark where a texel's neighbours are another's.
    ivec2 texel = ivec2(at * vec2(textureSize(skin_position, 0)));
    int chart = int(texelFetch(skin_position, texel, 0).w);
    bool border = false;
    for (int i = 0; i < 4; ++i)
        border = border || int(texelFetch(skin_position, texel + ivec2(i - 1, (i & 1) * 3 - 1), 0).w) != chart;
    vec3 hue = 0.5 + 0.5 * cos(2.4 * float(chart) + vec3(0.0, 2.1, 4.2));
    vec3 charts = (border ? vec3(0.02) : hue) * (0.2 + 0.8 * abs(dot(n, v)));
    vec3 thin = thickness < 1e3 ? transmittance(thickness / max(skin.translucency, 1e-3)) : vec3(0.0);
    color.rgb = shown == shows_specular ? specular : shown == shows_thickness ? thin : charts;
#endif
    color.rgb = min(color.rgb, LARGEST_HALF);
}

#ifndef SEEN
layout(location = 0) out vec4 color;
#if DIFFUSE == BY_SCREEN
layout(location = 1) out vec4 light_out;  // to be blurred
layout(location = 2) out vec4 after_out;  // factor after the blur
#endif

void main() {
    vec4 light, after;
    shade_skin(color, light, after);
#if DIFFUSE == BY_SCREEN
    light_out = light;
    after_out = after;
#endif
}
#endif
