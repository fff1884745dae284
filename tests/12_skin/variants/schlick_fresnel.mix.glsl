// right
float schlick_fresnel(float cosine, float f0) { float a = 1.0 - clamp(cosine, 0.0, 1.0); return mix(f0, 1.0, a * a * a * a * a); }
