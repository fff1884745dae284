// wrong: numbers
uint mixed(uint h) { h ^= h >> 16; h *= 0x85ebca6bu; h ^= h >> 13; h *= 0xc2b2ae35u; return h ^ h >> 16; }
float film_grain(uvec2 pixel, uint frame) {
    uint h = mixed(pixel.x + mixed(pixel.y + mixed(frame)));
    float t = float(h >> 8) / 16777216.0, part = 0.3333 + 0.4884 * t;
    return (h & 1u) == 0u ? part : -part;
}
