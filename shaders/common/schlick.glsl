// Schlick's Fresnel reflectance ("An Inexpensive BRDF Model for Physically-based Rendering", Computer Graphics Forum
// 13(3), 1994).

// (1 - cosine)^5.
float schlick_power(float cosine) {
    float grazing = clamp(1.0 - cosine, 0.0, 1.0), square = grazing * grazing;
    return square * square * grazing;
}

// `f0`: reflectance along the normal, 0 to 1.
float schlick(float cosine, float f0) { return f0 + (1.0 - f0) * schlick_power(cosine); }
