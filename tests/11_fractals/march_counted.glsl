// For the check of 11.march: march() along known balls, and its queries.
#include "11_fractals/march_along.glsl"

// Each as (where its middle is along the ray, how far beside it, radius).
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
    if (!march_leapt) {
        march_before = distance;
        march_before_t = t;
    }
    ++march_asked;
    return distance;
}

#include "11_fractals/march.glsl"

struct MarchCounted {
    March march;
    int asked;     // distances
    float astray;  // metres from where a leap was to be taken back to, at most
};

MarchCounted march_counted(float start, float end, float epsilon, float slope, float relaxation, int most) {
    March march = march(start, end, epsilon, slope, relaxation, most);
    return MarchCounted(march, march_asked, march_astray);
}
