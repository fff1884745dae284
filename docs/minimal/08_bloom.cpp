// [minimal]
// Bloom by a pyramid: the light above a threshold is halved again and again, and added up on the way back. One line of
// a picture shows it: with pixels in two directions each step is done along rows, then along columns.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

using Line = std::vector<double>;  // linear light

// Half the resolution: the four texels around the middle of each with the weights 1 3 3 1. Beyond the ends the last
// texel is repeated.
Line halved(const Line& fine) {
    Line coarse(fine.size() / 2);
    const auto at = [&](long i) { return fine[size_t(std::clamp(i, 0L, long(fine.size()) - 1))]; };
    for (long i = 0; i < long(coarse.size()); ++i)
        coarse[size_t(i)] = (at(2 * i - 1) + 3 * at(2 * i) + 3 * at(2 * i + 1) + at(2 * i + 2)) / 8;
    return coarse;
}

// Twice the resolution: linear between the two nearest texels, with middles 1/4 and 3/4 of a texel away.
Line doubled(const Line& coarse) {
    Line fine(coarse.size() * 2);
    for (size_t i = 0; i < fine.size(); ++i) {
        const size_t own = i / 2, other = i % 2 ? std::min(own + 1, coarse.size() - 1) : own - (own > 0);
        fine[i] = 0.75 * coarse[own] + 0.25 * coarse[other];
    }
    return fine;
}

// Spread light: each level of the pyramid, from narrow to wide, with the same share.
Line bloom(const Line& light, double threshold, int levels) {
    Line bright = light;
    for (double& value : bright) value = std::max(value - threshold, 0.0);
    std::vector<Line> pyramid{bright};
    for (int i = 0; i < levels; ++i) pyramid.push_back(halved(pyramid.back()));
    Line sum = pyramid.back();
    for (int i = levels - 1; i >= 0; --i) {
        sum = doubled(sum);
        for (size_t k = 0; i > 0 && k < sum.size(); ++k) sum[k] += pyramid[size_t(i)][k];
    }
    for (double& value : sum) value /= levels;
    return sum;
}

int main() {
    Line light(1024, 0.5);                     // nothing above the threshold of 1 ...
    for (size_t i : {500, 501}) light[i] = 9;  // ... but a tube that is two pixels wide
    const Line spread = bloom(light, 1, 5);
    double energy = 0, mean = 0, variance = 0;
    for (size_t i = 0; i < spread.size(); ++i) energy += spread[i], mean += double(i) * spread[i] / 16;
    for (size_t i = 0; i < spread.size(); ++i) variance += std::pow(double(i) - mean, 2) * spread[i] / 16;
    // No light is made or lost: 16 go in, 16 come out. The width is the root of the mean of the levels' variances.
    std::printf("energy %.6f\nmiddle %.3f\nwidth %.3f\n", energy, mean, std::sqrt(variance));
    // The picture: its own light, and a share of the spread light. Twenty pixels off there was no light but the
    // wall's.
    std::printf("tube %.4f\nbeside %.4f\n", light[500] + 0.3 * spread[500], light[520] + 0.3 * spread[520]);
}
// [/minimal]
