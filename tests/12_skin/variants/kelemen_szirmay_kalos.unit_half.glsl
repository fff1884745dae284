// wrong: kelemen_szirmay_kalos(
#include "12_skin/beckmann_of.glsl"
#include "12_skin/fresnel_of.glsl"
float kelemen_szirmay_kalos(vec3 n, vec3 l, vec3 v, float m, float f0) {
    vec3 h = l + v;
    if (dot(n, l) <= 0.0 || dot(n, v) <= 0.0 || dot(h, h) < 1e-12) return 0.0;
    h = normalize(h);
    return dot(n, l) * beckmann_of(dot(n, h), m) * fresnel_of(dot(v, h), f0) / dot(h, h);
}
