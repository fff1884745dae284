// G-buffer of a coated surface for the scene's lights; the environment lights it later.
#include "06_deferred/pixel.glsl"
#include "06_deferred/put_pixel.glsl"
#include "14_environment/coated.glsl"

void main() {
    CoatedSurface c = coated_surface();
    MixedMaterial mixed = MixedMaterial(c.albedo, c.f0, c.m.surface.shininess);
    float has_metalness = float(!c.is_paint && c.m.substance.ambient_specular != vec3(0.0));
    put_pixel(Pixel(c.m.surface.normal, c.m.facing, c.m.surface.plane, c.m.position,
                    PixelMaterial(mixed, c.m.substance.occlusion, has_metalness)));
}
