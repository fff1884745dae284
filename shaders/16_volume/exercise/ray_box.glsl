// Exercise 16.ray_box: find the fault in where a ray is inside a box.
// Starter: a part of the scanned head is missing, and which part changes as the camera moves.

// [ray_box]
// A box is centred at the origin and has the half sizes `half_m`, in metres, above 0. A ray starts
// at `origin` and runs along `direction`, a vector of unit length of which two components may be 0.
// Returns (entry, exit), in metres along the ray, of the part of the ray that lies inside the box
// and in front of the start: a start inside the box has an entry of 0.
//
// If the ray misses the box, or the box lies behind the start, exit <= entry, both ordinary
// numbers. Right to 0.1 mm and to 1e-5 of the distance.
//
// The function below has one fault. Find it by its symptom, and mend it.
// [/ray_box]
vec2 ray_box(vec3 origin, vec3 direction, vec3 half_m) {
    vec3 safe = mix(direction, vec3(1e-12), lessThan(abs(direction), vec3(1e-12)));
    vec3 one = (-half_m - origin) / safe, other = (half_m - origin) / safe;
    bool forwards = direction.z > 0.0;  // which of the two planes comes first
    vec3 near = forwards ? one : other, far = forwards ? other : one;
    return vec2(max(max(near.x, near.y), max(near.z, 0.0)), min(far.x, min(far.y, far.z)));
}
