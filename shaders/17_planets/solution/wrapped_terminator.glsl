// Solution of 17.wrapped_terminator.
float wrapped_terminator(float cosine, float w, float k) {
    float lit = (cosine + w) / (1.0 + w);
    return lit > 0.0 ? pow(lit, k) : 0.0;
}
