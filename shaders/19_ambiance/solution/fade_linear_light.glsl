// Solution of 19.fade_linear_light.

vec3 fade_linear_light(vec3 light, float black, float white) {
    vec3 dark = light * pow(clamp(1.0 - black, 0.0, 1.0), 2.2);
    return max(dark, mix(dark, vec3(16.0), pow(clamp(white, 0.0, 1.0), 2.2)));
}
