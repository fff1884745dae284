// right
#include "12_skin/skin.glsl"
float kelemen_szirmay_kalos(vec3 n, vec3 l, vec3 v, float m, float f0) {
    vec3 h = l + v, hn = normalize(h);
    if (dot(n, l) <= 0.0 || dot(n, v) <= 0.0) return 0.0;
    return dot(n, l) * beckmann_of(dot(n, hn), m) * fresnel_of(dot(v, hn), f0) / dot(h, h);
}
