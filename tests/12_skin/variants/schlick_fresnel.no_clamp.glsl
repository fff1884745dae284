// wrong: schlick_fresnel(
float schlick_fresnel(float cosine, float f0) { return f0 + (1.0 - f0) * pow(1.0 - cosine, 5.0); }
