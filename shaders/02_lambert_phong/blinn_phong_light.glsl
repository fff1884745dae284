// Reflection of one light by a surface: Lambert and the normalised Blinn–Phong model.
#include "common/structs.h"
#include "02_lambert_phong/lambert.glsl"
#include "02_lambert_phong/blinn_phong.glsl"

// [reflect_light]
Reflected reflect_by_blinn_phong(Surface surface, vec3 to_light) {
    float received = lambert(surface.normal, to_light);
    float specular = blinn_phong(surface.normal, to_light, surface.to_eye, surface.shininess) *
                     blinn_phong_normalisation(surface.shininess) * received;
    return Reflected(vec3(received), vec3(specular));
}
// [/reflect_light]
