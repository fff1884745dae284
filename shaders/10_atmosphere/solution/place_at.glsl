// Solution of 10.place_at: the step along the path has a share of cos_angle towards the sun.
Place place_at(Path path, float t) {
    float height = height_at(path.height, path.slope, t);
    float sun = ((air.radius + path.height) * path.sun + t * path.cos_angle) / (air.radius + height);
    return Place(height, clamp(sun, -1.0, 1.0));
}
