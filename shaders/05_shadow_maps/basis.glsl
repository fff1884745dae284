// T. Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017. `n` has unit length.
void basis_of(vec3 n, out vec3 x, out vec3 y) {
    float s = n.z < 0.0 ? -1.0 : 1.0, a = -1.0 / (s + n.z), b = n.x * n.y * a;
    x = vec3(1.0 + s * n.x * n.x * a, s * b, -s * n.x);
    y = vec3(b, s + n.y * n.y * a, -n.y);
}
