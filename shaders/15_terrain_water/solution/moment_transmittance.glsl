// Transmittance before a depth from four power moments of absorbance.

// [moment_transmittance]
// Of all distributions with the moments `b` the one is taken that has mass at z itself and at two other depths
// (C. Muenstermann et al., "Moment-Based Order-Independent Transparency", I3D 2018, section 3; C. Peters and R. Klein, "Moment
// Shadow Mapping", I3D 2015, algorithm 3).
float moment_transmittance(vec4 b, float all, float z, float overestimation) {
    // The two depths are the roots of c.x + c.y t + c.z t², where c solves H c = (1, z, z²) for the matrix of moments
    // H = (1 b1 b2; b1 b2 b3; b2 b3 b4): by Cholesky's L D transpose(L).
    float d11 = b.y - b.x * b.x, l21_d11 = b.z - b.x * b.y;
    float l21 = l21_d11 / d11, d22 = b.w - b.y * b.y - l21_d11 * l21;
    vec3 c = vec3(1.0, z - b.x, z * z - b.y);
    c.z -= l21 * c.y;
    c.y /= d11;
    c.z /= d22;
    c.y -= l21 * c.z;
    c.x -= dot(c.yz, b.xy);
    float p = 0.5 * c.y / c.z, q = c.x / c.z;
    float r = sqrt(max(p * p - q, 0.0));
    float t1 = -p - r, t2 = -p + r;
    // The parabola through the step function's values at z, t1 and t2, in Newton's form; its mean is the mass before z.
    float f0 = overestimation, f1 = t1 < z ? 1.0 : 0.0, f2 = t2 < z ? 1.0 : 0.0;
    float f01 = (f1 - f0) / (t1 - z), f12 = (f2 - f1) / (t2 - t1), f012 = (f12 - f01) / (t2 - z);
    float before = f0 + f01 * (b.x - z) + f012 * (b.y - (z + t1) * b.x + z * t1);
    return exp(-all * before);
}
// [/moment_transmittance]
