// Light leaving a surface, except for reflections of the scene's lights: reflected surroundings and emission. The
// includer selects occlusion: unoccluded.glsl or occluded.glsl.
#include "03_attenuation/lighting.glsl"
#include "05_shadow_maps/shadow.glsl"
#include "14_environment/coated.glsl"
#include "14_environment/image_light.glsl"
#include "14_environment/paint.glsl"
#include "14_environment/all_open.glsl"

// Paint under the scene's lights; each light's radiance is that of a matt white surface.
vec3 paint_lights(MappedSurface m, float n_dot_v) {
    vec3 sum = vec3(0.0);
    for (uint i = 0u; i < lights_data.length(); ++i) {
        Arriving arriving = arriving_light(lights_data[i], m.position, lights.fade_k);
        float n_dot_l = dot(m.surface.normal, arriving.to_light);
        if (n_dot_l <= 0.0 || dot(m.facing, arriving.to_light) <= 0.0) continue;
        vec3 visible = light_visibility(i, m.position, m.facing, m.surface.plane, arriving.to_light);
        sum += pi * n_dot_l * visible * arriving.radiance *
               paint_brdf(n_dot_l, n_dot_v, dot(m.surface.to_eye, arriving.to_light));
    }
    return sum;
}

// Radiance towards the eye, below the coat and of the coat itself.
struct Leaving {
    vec3 body, coat;
};

Leaving leaving(CoatedSurface c) {
    MappedSurface m = c.m;
    vec3 normal = m.surface.normal, to_eye = m.surface.to_eye;
    float n_dot_v = clamp(dot(normal, to_eye), 1e-3, 1.0);
    bool has_metalness = !c.is_paint && m.substance.ambient_specular != vec3(0.0);
    Blend blend = blend_of(c.f0, c.albedo, has_metalness);
    FromAround reflected = reflected_from_around(LitFromAround(m.position, normal, to_eye, c.f0, c.alpha, blend));
#ifdef OCCLUDED
    vec3 around = diffuse_of_samples(m.position, normal, uint(image_light.samples));
#else
    vec3 around = diffuse_light(m.position, normal);
#endif
#ifdef SCREEN_OCCLUDED
    Openness open = screen_openness(normal);
    around = with_bounces(open.visibility, c.is_paint ? paint_albedo(n_dot_v, 0) : c.albedo) *
             diffuse_light(m.position, normal);
    reflected.specular *= reflected_share(open, normal, reflect(-to_eye, normal), c.alpha);
#endif
    Leaving light = Leaving(c.albedo * reflected.diffuse_share * around * m.substance.occlusion,
                            reflected.specular * m.substance.occlusion + m.glow);
    if (c.is_paint)
        light.body = paint_albedo(n_dot_v, 0) * around * m.substance.occlusion + paint_lights(m, n_dot_v) +
                     paint_albedo(n_dot_v, 1) * flake_light(m.position, normal, to_eye);
    return light;
}
