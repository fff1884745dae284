// A spot light's cone against the ball around something.

// [cone_reaches_ball]
// Whether a ball meets a cone that goes on for ever. `center` is seen from the apex, `axis` has unit length.
bool cone_reaches_ball(vec3 center, float radius, vec3 axis, float cos_outer) {
    float along = dot(center, axis), across = length(cross(center, axis)), away = length(center);
    if (along >= away * cos_outer) return true;  // the ball's middle is in the cone
    // The way to it times sine and cosine of its angle to the cone's side. Beyond 90 degrees the apex is nearest.
    float sin_outer = sqrt(max(1.0 - cos_outer * cos_outer, 0.0));
    float sine = across * cos_outer - along * sin_outer, cosine = along * cos_outer + across * sin_outer;
    return (cosine < 0.0 ? away : sine) <= radius;
}
// [/cone_reaches_ball]
