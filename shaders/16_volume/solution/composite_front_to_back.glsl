// Solution of 16.composite_front_to_back.

// T. Porter and T. Duff, "Compositing Digital Images", SIGGRAPH 1984: "over", from the front.
vec4 composite_front_to_back(vec4 so_far, vec3 radiance, float opacity) {
    return vec4(so_far.rgb + so_far.a * opacity * radiance, so_far.a * (1.0 - opacity));
}

bool is_finished(float transmittance, float brightest, float threshold) { return transmittance * brightest <= threshold; }
