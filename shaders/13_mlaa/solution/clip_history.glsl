// Solution of 13.clip_history.
vec3 clip_history(vec3 history, vec3 lowest, vec3 highest) {
    vec3 middle = 0.5 * (lowest + highest), half_size = 0.5 * (highest - lowest), away = history - middle;
    float most = 1.0;
    for (int i = 0; i < 3; ++i)
        if (abs(away[i]) > half_size[i]) most = min(most, half_size[i] / abs(away[i]));
    return middle + most * away;
}
