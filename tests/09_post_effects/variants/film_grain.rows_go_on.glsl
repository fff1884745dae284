// wrong: with itself 1024 pixels to the right, of the row below
uint mixed(uint h) { h ^= h >> 16; h *= 0x85ebca6bu; h ^= h >> 13; h *= 0xc2b2ae35u; return h ^ h >> 16; }
float film_grain(uvec2 pixel, uint frame) {
    uint h = mixed(pixel.x - 1024u * pixel.y + mixed(frame));
    return float(h >> 8) * (2.0 / 16777216.0) - 1.0;
}
