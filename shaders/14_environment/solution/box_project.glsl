// Solution of 14.box_project.
// K. Bjorke, "Image-Based Lighting", GPU Gems, 2004, chapter 19; B. Czuba, "Box Projected Cubemap Environment Mapping", 2010.
vec3 box_project(vec3 position, vec3 direction, vec3 lower, vec3 upper, vec3 center) {
    vec3 farthest = vec3(1e30);
    for (int axis = 0; axis < 3; ++axis)
        if (direction[axis] != 0.0)
            farthest[axis] = ((direction[axis] > 0.0 ? upper[axis] : lower[axis]) - position[axis]) / direction[axis];
    float t = max(min(min(farthest.x, farthest.y), farthest.z), 0.0);
    vec3 hit = position + t * direction - center;
    return dot(hit, hit) > 0.0 ? hit : direction;
}
