// Solution of 14.schlick_roughness.
// The power: C. Schlick, "An Inexpensive BRDF Model for Physically-based Rendering", 1994. The limit at grazing angles:
// S. Lagarde, "Adopting a physically based shading model", 2011.
vec3 schlick_roughness(float n_dot_v, vec3 f0, float roughness) {
    float grazing = clamp(1.0 - n_dot_v, 0.0, 1.0), square = grazing * grazing;
    return f0 + (max(vec3(1.0 - roughness), f0) - f0) * square * square * grazing;
}
