#include "18_playground/ids.glsl"

// 0 stands for nothing.
uint id_of(uint item) { return item + 1u; }
uint item_of(uint id) { return id - 1u; }

// Rows from the top, pixels from the left: on ties the first one stays.
uint id_near(ivec2 pixel, int reach) {
    ivec2 size = ids_size();
    uint found = 0u;
    int nearest = reach * reach + 1;
    for (int y = max(pixel.y - reach, 0); y <= min(pixel.y + reach, size.y - 1); ++y)
        for (int x = max(pixel.x - reach, 0); x <= min(pixel.x + reach, size.x - 1); ++x) {
            ivec2 away = ivec2(x, y) - pixel;
            int far = away.x * away.x + away.y * away.y;
            if (far >= nearest) continue;
            uint id = id_at(ivec2(x, y));
            if (id == 0u) continue;
            found = id;
            nearest = far;
        }
    return found;
}
