// right, in its pictures too
float film_grain(uvec2 pixel, uint frame) {
    uint h = frame + 374761393u + pixel.x * 3266489917u;
    h = 668265263u * (h << 17 | h >> 15);
    h += pixel.y * 3266489917u;
    h = 668265263u * (h << 17 | h >> 15);
    h = 2246822519u * (h ^ h >> 15);
    h = 3266489917u * (h ^ h >> 13);
    return float((h ^ h >> 16) >> 8) * (2.0 / 16777216.0) - 1.0;
}
