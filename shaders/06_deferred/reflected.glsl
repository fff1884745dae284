// From a pixel to the inputs of chapter 03's lights, and from their sum to the light that leaves it.
#include "02_lambert_phong/reflection.glsl"
#include "03_attenuation/lighting.glsl"
#include "05_shadow_maps/shadow.glsl"
#include "06_deferred/pixel.glsl"

Surface surface_of(Pixel p, vec3 eye) { return Surface(p.normal, normalize(eye - p.position), p.material.mixed.shininess); }

vec3 reflected(Pixel p, Lit lit) {
    return p.material.mixed.diffuse * lit.diffuse + p.material.mixed.specular * lit.specular;
}
