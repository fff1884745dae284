// Places evenly spread over a disc of radius 1: H. Vogel, "A better way to construct the sunflower head", 1979.
vec2 on_disc(int i, int count, float turn) {
    float angle = float(i) * 2.39996323 + turn;
    return sqrt((float(i) + 0.5) / float(count)) * vec2(cos(angle), sin(angle));
}
