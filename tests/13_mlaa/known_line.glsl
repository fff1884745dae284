// For the check of 13.propagate_distance: known distances along a line of pixels; the last number repeats. Too many
// queries return nonsense.
#pragma replaces "13_mlaa/known_distance.glsl"

const uint check_distances[] = uint[](KNOWN_DISTANCES);
uint check_asked = 0u;
uint known(uint steps) {
    if (++check_asked > MOST_READS) return 99u;
    return check_distances[min(steps, uint(check_distances.length() - 1))];
}
