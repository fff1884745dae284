// [minimal]
#version 460
// A surface in the light of one sun: matt after Lambert, glossy after Blinn and Phong. One run for each pixel.
layout(location = 0) in vec3 position;      // of the surface, in metres, interpolated from the triangle's corners
layout(location = 1) in vec3 corner_normal; // interpolated as well, so its length is not 1
layout(location = 0) out vec4 color;        // linear light: an sRGB render target encodes it
layout(push_constant) uniform Frame { vec4 eye, to_sun, sun_irradiance, albedo, gloss; };

const float pi = 3.14159265;

// The radiance that a surface sends to the eye: the BRDF times the cosine, per unit of irradiance on a plane that faces
// the light. All three directions have unit length and point away from the surface. `albedo` is the share of light that
// the matt part reflects, `specular` that of the glossy part; together at most 1. A larger `shininess`
// (1 to 1000) makes the highlight narrower.
vec3 reflected(vec3 normal, vec3 to_light, vec3 to_eye, vec3 albedo, vec3 specular, float shininess) {
    float cosine = dot(normal, to_light);
    if (cosine <= 0.0) return vec3(0.0);  // the light is behind the surface

    // Matt: the same radiance in all directions. The light of a hemisphere sums to pi times that.
    vec3 matt = albedo / pi;

    // Glossy: mirrors as small as dust are turned in all directions, most of them like the surface. Mirrors turned
    // half way between light and eye reflect it to the eye. The factor keeps the reflected light the same for every
    // shininess: without it, narrow highlights are too dark. It is up to 7.5% too large (below 10).
    vec3 half_way = normalize(to_light + to_eye);
    float lobe = pow(max(dot(normal, half_way), 0.0), shininess);
    vec3 glossy = specular * lobe * (shininess + 8.0) / (8.0 * pi);

    return (matt + glossy) * cosine;  // light at a slant is spread over a larger area
}

void main() {
    vec3 normal = normalize(corner_normal), to_eye = normalize(eye.xyz - position);
    vec3 light = sun_irradiance.rgb * reflected(normal, to_sun.xyz, to_eye, albedo.rgb, vec3(gloss.x), gloss.y);
    vec3 sky = 0.05 * sun_irradiance.rgb * albedo.rgb / pi;  // a little from all sides, so that shadows are not black
    color = vec4(light + sky, 1.0);
}
// [/minimal]
