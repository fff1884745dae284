// Exercise 05.sphere_shadow: the shadow of a sphere without a map.
// Starter: the sphere casts none.

// [sphere_shadow_hard]
// The visibility of the light from a point: 0 if a sphere is in the way, 1 otherwise.
// `to_center` is the vector from the point to the sphere's centre and `radius` the sphere's
// radius, both in metres; `to_light` is a unit vector. The sphere is in the way if the line
// towards the light passes the centre at less than the radius. A sphere that lies behind
// the point, away from the light, casts no shadow on it.
// [/sphere_shadow_hard]
float sphere_shadow_hard(vec3 to_center, float radius, vec3 to_light) {
    return 1.0;
}

// [sphere_shadow_power]
// The same with a soft edge whose width does not depend on the light's size. Let d be the
// depth of the line inside the sphere: the radius minus the distance at which the line
// passes the centre. The result is 1 where d is 0 or less or where the sphere lies behind
// the point, 1 - (d / width)^power inside the edge, and 0 where d is `width` or more.
// `width` (metres) and `power` are above 0.
// [/sphere_shadow_power]
float sphere_shadow_power(vec3 to_center, float radius, vec3 to_light, float width, float power) {
    return 1.0;
}
