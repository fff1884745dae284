// Solution of 02.lambert (J. H. Lambert, Photometria, 1760).

float lambert(vec3 normal, vec3 to_light) {
    return max(dot(normal, to_light), 0.0);
}
