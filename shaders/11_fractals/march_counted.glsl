// For the check: march() along balls that are known, and what it asked.
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
