// Occlusion of what is seen, for the surface in this pixel: what the module ScreenOcclusion gives to shaders.
#include "14_environment/bent_cone.glsl"

uniform sampler2D screen_occlusion_image;

struct Openness {
    vec3 bent;         // unit length, world space: the mean direction that is open
    float visibility;  // share of directions that is open, by their cosine
};

// The depth buffer knows the mesh's normal alone: what hides turns the mean direction of a bumpy normal as it turns the
// mesh's.
Openness screen_openness(vec3 normal) {
    vec4 found = texelFetch(screen_occlusion_image, ivec2(gl_FragCoord.xy), 0);
    vec3 bent = normal + found.xyz;
    return Openness(dot(bent, bent) > 1e-6 ? normalize(bent) : normal, clamp(found.w, 0.0, 1.0));
}

// What hides light sends some of it on: more where surfaces are bright (J. Jimenez et al., 2016, section 5).
vec3 with_bounces(float visibility, vec3 albedo) {
    vec3 a = 2.0404 * albedo - 0.3324, b = 0.6417 - 4.7951 * albedo, c = 2.7552 * albedo + 0.6903;
    return max(vec3(visibility), ((a * visibility + b) * visibility + c) * visibility);
}

// Of the lobe around the mirrored direction, of its part above the surface. The cone around the bent normal has the
// visibility as its share of the hemisphere's solid angle.
float reflected_share(Openness open, vec3 normal, vec3 mirrored, float alpha) {
#if SCREEN_OCCLUSION_SPECULAR == SCREEN_OCCLUSION_SPECULAR_VISIBILITY
    return open.visibility;
#else
    float cone = acos(clamp(1.0 - open.visibility, 0.0, 1.0)), lobe = max(atan(alpha) * 2.0, 0.2);
    float above = lobe_in_cone(1.5707963, lobe, acos(clamp(dot(normal, mirrored), -1.0, 1.0)));
    float seen = lobe_in_cone(cone, lobe, acos(clamp(dot(open.bent, mirrored), -1.0, 1.0)));
    return min(seen / max(above, 1e-3), 1.0);
#endif
}
