// Of the preintegrated table: its curvature, in 1/mm, over v from 0 to 1. The finest detail is a sphere of 1 mm.
float curvature_at(float v) { return v * v; }
float curvature_v(float curvature_per_mm) { return sqrt(clamp(curvature_per_mm, 0.0, 1.0)); }
