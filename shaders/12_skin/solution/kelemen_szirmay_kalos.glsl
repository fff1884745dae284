// Solution of 12.kelemen_szirmay_kalos.
#include "12_skin/skin.glsl"

float kelemen_szirmay_kalos(vec3 n, vec3 l, vec3 v, float m, float f0) {
    float cosine = dot(n, l);
    vec3 sum = l + v;
    float square = dot(sum, sum);
    if (cosine <= 0.0 || dot(n, v) <= 0.0 || square < 1e-12) return 0.0;
    vec3 h = sum * inversesqrt(square);
    return cosine * beckmann_of(dot(n, h), m) * fresnel_of(dot(v, h), f0) / square;
}
