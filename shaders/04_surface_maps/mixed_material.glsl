// What reflection needs to know of a surface's substance.
struct MixedMaterial {
    vec3 diffuse, specular;  // linear
    float shininess;         // Blinn–Phong exponent
};

const float most_shininess = 8192.0;
