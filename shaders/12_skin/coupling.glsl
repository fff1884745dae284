// What facets reflect does not go into the skin, and on its way out light meets them again.
uniform sampler2D skin_reflected;  // x: over the cosine along u, over m along v; y: the mean over all directions

vec2 reflected_share(float cosine, float m) {
    vec2 size = vec2(textureSize(skin_reflected, 0));
    return textureLod(skin_reflected, (0.5 + clamp(vec2(cosine, m), 0.0, 1.0) * (size - 1.0)) / size, 0.0).xy;
}

// [coupling]
// C. Kelemen and L. Szirmay-Kalos, 2001: with these two factors a white surface sends back all light, whatever `scale` of
// the specular reflection and whatever roughness m it has.
float way_in(float cosine, float m, float scale) {
    vec2 share = scale * reflected_share(cosine, m);
    return (1.0 - share.x) / max(1.0 - share.y, 1e-3);
}

float way_out(float cosine, float m, float scale) { return 1.0 - scale * reflected_share(cosine, m).x; }
// [/coupling]
