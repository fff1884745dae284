// Reflection of one light by a surface, by the method in use. A later chapter has neither this chapter's METHOD nor
// DIFFUSE: it gets the normalised model and Lambert. #if takes a name that is not defined for 0, hence `defined`.
#include "02_lambert_phong/lambert.glsl"
#include "02_lambert_phong/phong.glsl"
#include "02_lambert_phong/blinn_phong.glsl"
#include "02_lambert_phong/wrapped_diffuse.glsl"

struct Surface {
    vec3 normal;      // unit length, world space
    vec3 to_eye;      // unit length, world space
    float shininess;  // Blinn–Phong exponent
};

struct Wrap {
    float amount, power;
    vec3 tint;
};

// What of a light of radiance 1 from `to_light` leaves towards the eye, per unit of diffuse and of specular colour.
struct Reflected {
    vec3 diffuse;
    float specular;
};

// [reflect_light]
Reflected reflect_light(Surface surface, vec3 to_light, Wrap wrap) {
    Reflected result;
    float received = lambert(surface.normal, to_light);
#if defined(DIFFUSE_WRAPPED) && DIFFUSE == DIFFUSE_WRAPPED
    float cosine = dot(surface.normal, to_light);
    result.diffuse = wrapped_diffuse(cosine, wrap.amount, wrap.power) * wrapped_tint(cosine, wrap.tint);
#else
    result.diffuse = vec3(received);
#endif
#if defined(METHOD_PHONG) && METHOD == METHOD_PHONG
    // Around the mirror direction the same lobe is about twice as narrow in angle: a quarter of the exponent.
    result.specular = phong(surface.normal, to_light, surface.to_eye, 0.25 * surface.shininess);
#elif defined(METHOD_BLINN_PHONG) && METHOD == METHOD_BLINN_PHONG
    result.specular = blinn_phong(surface.normal, to_light, surface.to_eye, surface.shininess);
#else
    // Gouraud, too, evaluates the normalised model; it only does so less often.
    result.specular = blinn_phong(surface.normal, to_light, surface.to_eye, surface.shininess) *
                      blinn_phong_normalisation(surface.shininess) * received;
#endif
    return result;
}
// [/reflect_light]
