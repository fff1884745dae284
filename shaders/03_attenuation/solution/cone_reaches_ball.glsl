// Solution of 03.cone_reaches_ball: beyond 90 degrees from the side the apex is nearest, not before.
bool cone_reaches_ball(vec3 center, float radius, vec3 axis, float cos_outer) {
    float along = dot(center, axis), across = length(cross(center, axis)), away = length(center);
    float ahead = along - away * cos_outer;
    if (ahead >= 0.0) return true;  // the ball's middle is in the cone
    // The distance times sine and cosine of the angle beyond the cone's side.
    float sin_outer = sqrt(max(1.0 - cos_outer * cos_outer, 0.0));
    float sine = across * cos_outer - along * sin_outer, cosine = along * cos_outer + across * sin_outer;
    return (cosine < 0.0 ? away : sine) <= radius;
}
