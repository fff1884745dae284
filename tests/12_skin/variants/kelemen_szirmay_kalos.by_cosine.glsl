// right
#include "12_skin/skin.glsl"
float kelemen_szirmay_kalos(vec3 n, vec3 l, vec3 v, float m, float f0) {
    float nl = dot(n, l), nv = dot(n, v);
    if (nl <= 0.0 || nv <= 0.0) return 0.0;
    float square = 2.0 + 2.0 * dot(l, v);
    if (square < 1e-9) return 0.0;
    float nh = (nl + nv) / sqrt(square), vh = 0.5 * sqrt(square);
    return nl * beckmann_of(nh, m) * fresnel_of(vh, f0) / square;
}
