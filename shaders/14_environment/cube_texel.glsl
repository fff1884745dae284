// The solid angle of a cube's texel, in steradians.

// Of the part of a face from its middle to (x, y), -1 to 1: M. Gotz, "Cubemap Texel Solid Angle", 2011; the area element
// 1 / (x² + y² + 1)^(3/2) integrated twice.
float face_angle(float x, float y) { return atan(x * y, sqrt(x * x + y * y + 1.0)); }

float texel_solid_angle(uvec2 texel, float size) {
    vec2 a = 2.0 * vec2(texel) / size - 1.0, b = 2.0 * vec2(texel + 1u) / size - 1.0;
    return face_angle(a.x, a.y) - face_angle(a.x, b.y) - face_angle(b.x, a.y) + face_angle(b.x, b.y);
}
