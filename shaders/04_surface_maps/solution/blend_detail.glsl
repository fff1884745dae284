// Solution of 04.blend_detail (C. Barré-Brisebois and S. Hill, "Blending in Detail", 2012: reoriented normal mapping).

vec3 blend_detail(vec3 base, vec3 detail) {
    vec3 t = base + vec3(0.0, 0.0, 1.0);
    vec3 u = detail * vec3(-1.0, -1.0, 1.0);
    return normalize(t * dot(t, u) / t.z - u);
}
