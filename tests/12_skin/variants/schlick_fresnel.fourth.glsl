// wrong: schlick_fresnel(
float schlick_fresnel(float cosine, float f0) { float a = 1.0 - clamp(cosine, 0.0, 1.0); return f0 + (1.0 - f0) * a * a * a * a; }
