// How much of what comes from the mirror direction a surface reflects. `cosine` is that between view and normal.

// C. Schlick, An inexpensive BRDF model for physically-based rendering, 1994. `facing` is what it reflects when looked at
// along its normal, 0 to 1.
float fresnel_schlick(float cosine, float facing) {
    float grazing = 1.0 - clamp(cosine, 0.0, 1.0);
    float square = grazing * grazing;
    return facing + (1.0 - facing) * square * square * grazing;
}

// 1 - cosine^k, scaled to run from `facing` to 1: no physics, but a rim as wide as one likes.
float fresnel_power(float cosine, float facing, float k) {
    float clamped = clamp(cosine, 0.0, 1.0);
    return facing + (1.0 - facing) * (clamped > 0.0 ? 1.0 - pow(clamped, k) : 1.0);
}
