// wrong: takes element 3 of 3
float lambert(vec3 normal, vec3 to_light) {
    float sum = 0.0;
    for (int i = 0; i <= 3; ++i) sum += i < 3 ? normal[i] * to_light[i] : 0.0 * normal[i];
    return max(sum, 0.0);
}
