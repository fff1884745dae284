// Exercise 13.ghost, find the fault: this function runs, and one thing in it is wrong.
// Starter: objects that move in front of a background leave a fringe behind them.

// [ghost]
// A silhouette is mixed from two surfaces, and moves as the one in front does. So each
// pixel follows the nearest of the nine surfaces in and around it.
//
// `depths` are those of the 3x3 pixels: depths[x + 1][y + 1] at the step (x, y) from the
// pixel itself, x to the right, y down, each -1 to 1. Depth is 1 at the near plane and 0
// at infinity.
//
// Returns the step to the pixel whose surface is nearest to the camera. Where no other one
// is nearer than the pixel's own, that is (0, 0); otherwise any of those equally near.
// [/ghost]
ivec2 nearest_of_nine(mat3 depths) {
    ivec2 nearest = ivec2(0);
    float found = depths[1][1];
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            float depth = depths[x + 1][y + 1];
            if (depth < found) found = depth, nearest = ivec2(x, y);
        }
    return nearest;
}
