// Solution of 05.chebyshev (W. Donnelly and A. Lauritzen, "Variance Shadow Maps", I3D 2006, equation 5).

float chebyshev(vec2 moments, float depth, float least) {
    if (depth <= moments.x) return 1.0;
    float variance = max(moments.y - moments.x * moments.x, least);
    float behind = depth - moments.x;
    return variance / (variance + behind * behind);
}
