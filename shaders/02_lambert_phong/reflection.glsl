// Reflection of one light by a surface: Lambert and the normalised Blinn–Phong model, for every chapter from here on.
#include "02_lambert_phong/lambert.glsl"
#include "02_lambert_phong/blinn_phong.glsl"

struct Surface {
    vec3 normal;      // unit length, world space
    vec3 to_eye;      // unit length, world space
    float shininess;  // Blinn–Phong exponent
};

// What of a light of radiance 1 from `to_light` leaves towards the eye, per unit of diffuse and of specular colour.
struct Reflected {
    vec3 diffuse;
    float specular;
};

// [reflect_light]
Reflected reflect_light(Surface surface, vec3 to_light) {
    float received = lambert(surface.normal, to_light);
    float specular = blinn_phong(surface.normal, to_light, surface.to_eye, surface.shininess) *
                     blinn_phong_normalisation(surface.shininess) * received;
    return Reflected(vec3(received), specular);
}
// [/reflect_light]
