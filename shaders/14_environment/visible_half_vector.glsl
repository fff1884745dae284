// Half vectors of the facets that are visible from a direction.
#include "14_environment/ggx.glsl"

// A half vector among those visible from `to_eye`: E. Heitz, "Sampling the GGX Distribution of Visible Normals", JCGT
// 7(4), 2018. At grazing angles others are mostly hidden.
vec3 visible_half_vector(vec2 random, vec3 to_eye, float alpha) {
    vec3 eye = normalize(vec3(alpha * to_eye.xy, to_eye.z));  // where the surface is a half sphere
    float r = sqrt(random.x), phi = 2.0 * pi * random.y;
    vec2 disc = r * vec2(cos(phi), sin(phi));
    vec3 across = eye.z < 0.9999 ? normalize(cross(vec3(0.0, 0.0, 1.0), eye)) : vec3(1.0, 0.0, 0.0);
    float share = 0.5 * (1.0 + eye.z);  // of the disc's lower half that is seen
    disc.y = (1.0 - share) * sqrt(1.0 - disc.x * disc.x) + share * disc.y;
    vec3 n = disc.x * across + disc.y * cross(eye, across) + sqrt(max(0.0, 1.0 - dot(disc, disc))) * eye;
    return normalize(vec3(alpha * n.xy, max(n.z, 0.0)));
}
