// Exercise 03.cone_reaches_ball: find the fault in the test of a spot light against a cell.
// Starter: cones end in squares where they should end in a curve.

// [cone_reaches_ball]
// A spot light is at the origin. Its cone begins there and goes on without an end along `axis`,
// which has unit length; `cos_outer` is the cosine of the angle between the axis and the cone's
// side, an angle of 0 to pi. A ball has its middle at `center` and `radius` metres, above 0.
//
// Returns whether the ball and the cone have a point in common. Where the gap between them, or
// the depth by which they overlap, is below 0.1% of the distance to the ball's middle, either
// answer will do.
//
// The function below has one fault. Find it by its symptom, and mend it.
// [/cone_reaches_ball]
bool cone_reaches_ball(vec3 center, float radius, vec3 axis, float cos_outer) {
    float along = dot(center, axis), across = length(cross(center, axis)), away = length(center);
    float ahead = along - away * cos_outer;
    if (ahead >= 0.0) return true;  // the ball's middle is in the cone
    // The distance times sine and cosine of the angle beyond the cone's side.
    float sin_outer = sqrt(max(1.0 - cos_outer * cos_outer, 0.0));
    float sine = across * cos_outer - along * sin_outer, cosine = along * cos_outer + across * sin_outer;
    return (cosine > 0.0 ? away : sine) <= radius;
}
