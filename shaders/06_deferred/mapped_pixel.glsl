// G-buffer input of a surface with maps.
#include "04_surface_maps/surface_maps.glsl"
#include "06_deferred/pixel.glsl"

Pixel pixel_of(MappedSurface m) {
    MixedMaterial mixed = MixedMaterial(m.substance.mixed.diffuse, m.substance.mixed.specular, m.surface.shininess);
    float ambient_specular = float(m.substance.ambient_specular != vec3(0.0));
    return Pixel(m.surface.normal, m.facing, m.surface.plane, m.position,
                 PixelMaterial(mixed, m.substance.occlusion, ambient_specular));
}
