// For the check of 11.march: march() along known check_balls, and its queries.
#include "11_fractals/march_along.glsl"

// Each as (where its middle is along the ray, how far beside it, radius).
const vec3 check_balls[3] = vec3[](vec3(BALLS));
int check_march_asked = 0;      // how often
float check_march_astray = 0.0; // how far from where it should have gone back to it asked next, at most

float check_march_ball_distance(float t) {
    float nearest = 1e9;
    for (int i = 0; i < 3; ++i)
        if (check_balls[i].z > 0.0) nearest = min(nearest, length(vec2(t - check_balls[i].x, check_balls[i].y)) - check_balls[i].z);
    return max(nearest, 0.0);
}

float check_march_before, check_march_before_t;
bool check_march_leapt = false;
float distance_at(float t) {
    float distance = check_march_ball_distance(t), here = check_march_before_t + check_march_before;
    if (check_march_leapt) check_march_astray = max(check_march_astray, abs(t - here));
    check_march_leapt = check_march_asked > 0 && check_march_before + distance < t - check_march_before_t - 1e-4;
    if (!check_march_leapt) {
        check_march_before = distance;
        check_march_before_t = t;
    }
    ++check_march_asked;
    return distance;
}

#include "11_fractals/march.glsl"

struct CheckMarchCounted {
    March march;
    int asked;     // distances
    float astray;  // metres from where a leap was to be taken back to, at most
};

CheckMarchCounted check_march_counted(float start, float end, float epsilon, float slope, float relaxation, int most) {
    March march = march(start, end, epsilon, slope, relaxation, most);
    return CheckMarchCounted(march, check_march_asked, check_march_astray);
}
