// [minimal]
// Skin: light that enters at one place leaves around it, red the farthest. The irradiance is blurred by six Gaussians
// for each colour (E. d'Eon and D. Luebke, GPU Gems 3, 2007). Here on one line across the edge of a shadow: with texels
// in two directions each blur runs along rows, then along columns.
#include <cmath>
#include <cstdio>
#include <numeric>
#include <vector>

struct Gaussian {
    double variance_mm2, weight[3];  // of red, green, blue; the weights of a colour add up to 1
};
const Gaussian skin[6] = {{0.0064, {0.233, 0.455, 0.649}}, {0.0484, {0.100, 0.336, 0.344}},
                          {0.187, {0.118, 0.198, 0.000}},  {0.567, {0.113, 0.007, 0.007}},
                          {1.99, {0.358, 0.004, 0.000}},   {7.41, {0.078, 0.000, 0.000}}};
constexpr int texels = 2000;
constexpr double texel_mm = 0.02;

std::vector<double> blurred(const std::vector<double>& light, double variance_mm2) {
    // Far enough that less than one part in 10,000 is left out.
    const int reach = int(std::ceil(4 * std::sqrt(variance_mm2) / texel_mm));
    std::vector<double> weights, result(light.size());
    for (int i = -reach; i <= reach; ++i) weights.push_back(std::exp(-0.5 * std::pow(i * texel_mm, 2) / variance_mm2));
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    for (int x = 0; x < texels; ++x)
        for (int i = -reach; i <= reach; ++i) {
            const int from = x + i < 0 ? 0 : x + i >= texels ? texels - 1 : x + i;
            result[x] += light[from] * weights[i + reach] / sum;
        }
    return result;
}

int main() {
    // 1. The light that arrives: a shadow on the left half. The albedo comes later, else it would be blurred too.
    std::vector<double> irradiance(texels);
    for (int x = 0; x < texels; ++x) irradiance[x] = x < texels / 2 ? 0 : 1;
    // 2. The light that leaves: each blur, weighted for each colour.
    std::vector<double> leaves[3];
    for (auto& channel : leaves) channel.assign(texels, 0);
    for (const Gaussian& gaussian : skin) {
        const std::vector<double> spread = blurred(irradiance, gaussian.variance_mm2);
        for (int c = 0; c < 3; ++c)
            for (int x = 0; x < texels; ++x) leaves[c][x] += gaussian.weight[c] * spread[x];
    }
    // 3. Against the truth, which is known for a straight edge: error functions.
    const char* const names[3] = {"red", "green", "blue"};
    for (int c = 0; c < 3; ++c) {
        double worst = 0;
        for (int x = 0; x < texels; ++x) {
            double exact = 0, right_mm = (x + 0.5 - texels / 2) * texel_mm;
            for (const Gaussian& g : skin)
                exact += g.weight[c] * 0.5 * std::erfc(-right_mm / std::sqrt(2 * g.variance_mm2));
            worst = std::fmax(worst, std::fabs(leaves[c][x] - exact));
        }
        // 1 mm into the shadow: the red edge that skin has and plaster has not.
        std::printf("%s %.4f error %.4f\n", names[c], leaves[c][texels / 2 - 50], worst);
    }
}
// [/minimal]
