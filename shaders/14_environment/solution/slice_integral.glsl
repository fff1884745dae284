// Solution of 14.slice_integral. J. Jimenez et al., SIGGRAPH course, 2016, equation 10.
float slice_integral(float before, float after, float tilt) {
    const float half_pi = 1.5707963;
    before = max(before, tilt - half_pi), after = min(after, tilt + half_pi);
    float sine = sin(tilt), cosine = cos(tilt);
    return 0.25 * (-cos(2.0 * before - tilt) + cosine + 2.0 * before * sine) +
           0.25 * (-cos(2.0 * after - tilt) + cosine + 2.0 * after * sine);
}
