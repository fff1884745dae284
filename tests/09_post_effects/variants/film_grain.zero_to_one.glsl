// wrong: the mean
float film_grain(uvec2 pixel, uint frame) {
    uint h = pixel.x * 374761393u + pixel.y * 668265263u + frame * 2246822519u;
    h = (h ^ h >> 13) * 1274126177u; h = (h ^ h >> 16) * 2654435761u;
    return float(h >> 8) / 16777216.0;
}
