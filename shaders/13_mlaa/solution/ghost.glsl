// Solution of 13.ghost: depth is reversed, and the largest is the nearest.
ivec2 nearest_of_nine(mat3 depths) {
    ivec2 nearest = ivec2(0);
    float found = depths[1][1];
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            float depth = depths[x + 1][y + 1];
            if (depth > found) found = depth, nearest = ivec2(x, y);
        }
    return nearest;
}
