// wrong: moment_transmittance(
// Right for three depths. With one or two, a determinant of rounded products is noise.
float moment_transmittance(vec4 b, float all, float z, float overestimation) {
    vec3 q = inverse(mat3(1.0, b.x, b.y, b.x, b.y, b.z, b.y, b.z, b.w)) * vec3(1.0, z, z * z);
    float root = sqrt(max(q.y * q.y - 4.0 * q.z * q.x, 0.0));
    vec3 t = vec3(z, (-q.y - root) / (2.0 * q.z), (-q.y + root) / (2.0 * q.z));
    vec3 mass = inverse(mat3(1.0, t.x, t.x * t.x, 1.0, t.y, t.y * t.y, 1.0, t.z, t.z * t.z)) * vec3(1.0, b.xy);
    return exp(-all * dot(mass, vec3(overestimation, lessThan(t.yz, vec2(z)))));
}
