// For 11.march: how a march ends, and the distances along the ray.
const int MARCH_MISS = 0;
const int MARCH_HIT = 1;
const int MARCH_CAPPED = 2;  // it was still on its way

struct March {
    float t;    // metres along the ray: of the hit, or how far it came
    int steps;  // distances that were asked for
    int ended;  // MARCH_...
};

#ifdef BALLS
// For checks: balls along a ray, each as (where its middle is along the ray, how far beside it, radius).
const vec3 balls[3] = vec3[](vec3(BALLS));
int march_asked = 0;      // how often
float march_astray = 0.0; // how far from where it should have gone back to it asked next, at most

float march_ball_distance(float t) {
    float nearest = 1e9;
    for (int i = 0; i < 3; ++i)
        if (balls[i].z > 0.0) nearest = min(nearest, length(vec2(t - balls[i].x, balls[i].y)) - balls[i].z);
    return max(nearest, 0.0);
}

float march_before, march_before_t;
bool march_leapt = false;
float distance_at(float t) {
    float distance = march_ball_distance(t), here = march_before_t + march_before;
    if (march_leapt) march_astray = max(march_astray, abs(t - here));
    march_leapt = march_asked > 0 && march_before + distance < t - march_before_t - 1e-4;
    if (!march_leapt) march_before = distance, march_before_t = t;
    ++march_asked;
    return distance;
}
#else
vec3 march_from, march_along;  // a ray: where it begins, and its direction, unit length

// At least so far it is from the ray's point at t metres to the set.
float distance_at(float t);
#endif
