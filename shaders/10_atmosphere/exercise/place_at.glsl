// Exercise 10.place_at: find the fault in the sun's height along a path.
// Starter: after sunset the sky is alike on all sides, and from orbit no dawn is seen.

// [place_at]
// A path through the air is straight. At its start, path.height is the height above the ground in
// metres, path.slope the cosine of the angle between the path and straight up, path.sun the cosine
// of the angle between the direction to the sun and straight up, and path.cos_angle the cosine of
// the angle between the path and the direction to the sun.
//
// `air.radius` is the planet's radius in metres. height_at(height, slope, t) is right: it returns
// the height after t metres, exactly even far from the planet.
//
// Returns the place that is `t` metres along the path (0 or more): its height, and the cosine of
// the angle between the direction to the sun and straight up *there*, from -1 to 1. The sun is
// so far away that its direction is the same everywhere; straight up is not. Right to 1e-5.
//
// The function below has one fault. Find it by its symptom, and mend it.
// [/place_at]
Place place_at(Path path, float t) {
    float height = height_at(path.height, path.slope, t);
    float sun = ((air.radius + path.height) * path.sun + t * path.slope) / (air.radius + height);
    return Place(height, clamp(sun, -1.0, 1.0));
}
