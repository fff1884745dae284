// Solution of 06.pyramid_level.

int pyramid_level(ivec2 low, ivec2 high) {
    int level = 0;
    while (any(greaterThan((high >> level) - (low >> level), ivec2(1)))) ++level;
    return level;
}
