// One level from the one above by a wider filter, a sinc cut off by Kaiser's window (J. F. Kaiser
// and R. W. Schafer, 1980). Beyond the edges the last texel is repeated.
#include "07_mipmaps/level.glsl"

const float reach = 2.0;      // texels of the new level, to each side
const float sharpness = 4.0;  // the window's parameter
const int most_taps = 15;     // 3 texels become one at most: 2 * reach * 3, and both ends

// The modified Bessel function of order 0: its power series, for x up to `sharpness` exact to 1e-6.
float bessel_i0(float x) {
    float term = 1.0, sum = 1.0, half_squared = 0.25 * x * x;
    for (int k = 1; k <= 12; ++k) {
        term *= half_squared / float(k * k);
        sum += term;
    }
    return sum;
}

// x in texels of the new level.
float kaiser(float x) {
    if (abs(x) >= reach) return 0.0;
    float turn = 3.14159265 * x, share = x / reach;
    float sinc = abs(turn) < 1e-4 ? 1.0 : sin(turn) / turn;
    return sinc * bessel_i0(sharpness * sqrt(1.0 - share * share));
}

// The weights of the texels from the first on, along one side; they add up to 1.
void weigh(int i, int from, int to, out float weights[most_taps], out int first, out int count) {
    float ratio = float(from) / float(to), middle = (float(i) + 0.5) * ratio;
    first = int(ceil(middle - reach * ratio - 0.5));
    count = min(int(floor(middle + reach * ratio - 0.5)) - first + 1, most_taps);
    float sum = 0.0;
    for (int k = 0; k < count; ++k) sum += weights[k] = kaiser((float(first + k) + 0.5 - middle) / ratio);
    for (int k = 0; k < count; ++k) weights[k] /= sum;
}

void main() {
    ivec2 at;
    if (!begin(at)) return;
    ivec2 from = source_size(), to = imageSize(level).xy, first, count;
    float across[most_taps], down[most_taps];
    weigh(at.x, from.x, to.x, across, first.x, count.x);
    weigh(at.y, from.y, to.y, down, first.y, count.y);
    vec4 mean = vec4(0.0);
    // One loop, not two: a compiler that unrolls both makes a shader of 225 lookups.
    for (int i = 0; i < count.x * count.y; ++i) {
        ivec2 k = ivec2(i % count.x, i / count.x);
        mean += across[k.x] * down[k.y] * texel(clamp(first + k, ivec2(0), from - 1));
    }
    end(at, mean);
}
