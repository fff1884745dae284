// For 11.march: how a march ends, and the distances along the ray.
const int MARCH_MISS = 0;
const int MARCH_HIT = 1;
const int MARCH_CAPPED = 2;  // it was still on its way

struct March {
    float t;    // metres along the ray: of the hit, or how far it came
    int steps;  // distances that were asked for
    int ended;  // MARCH_...
};

vec3 march_from, march_along;  // a ray: where it begins, and its direction, unit length

// At least so far it is from the ray's point at t metres to the set.
float distance_at(float t);
