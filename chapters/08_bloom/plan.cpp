#include "08_bloom/plan.h"

#include <cmath>

#include "08_bloom/exercises.h"
#include "common/base/error.h"

namespace lightwalk {
namespace {

using Kind = Step::Kind;

constexpr int pingpong_rounds = 10;  // each horizontal and vertical: twenty passes
constexpr double widest_kawase = 2.15;

// Texels of a level beyond each border of the picture. A level spreads light by little more than a texel.
constexpr int level_apron = 4;

// Seven weights, for taps that lie `spacing` texels apart: ±3 are at 2.5 sigma.
std::vector<float> seven_weights() {
    const std::vector<float> all = gaussian_weights(1.2f, 2.5f);
    return {all.begin(), all.begin() + 4};
}

std::vector<glm::dvec2> both_sides(const std::vector<float>& weights, double spacing) {
    std::vector<glm::dvec2> taps;
    for (int k = 1 - static_cast<int>(weights.size()); k < static_cast<int>(weights.size()); ++k)
        taps.emplace_back(spacing * k, double(weights[static_cast<size_t>(std::abs(k))]));
    return taps;
}

// Three passes, each twice as wide as the one before.
double seven_tap_variance(double spacing) {
    const std::vector<float> weights = seven_weights();
    double sum = 0;
    for (const double wider : {1.0, 2.0, 4.0}) sum += tap_variance(both_sides(weights, wider * spacing), 0);
    return sum;
}

// The x at which a growing function has a value.
template <class Function>
double solve(double low, double high, double value, const Function& function) {
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (function(middle) < value ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

class Planner {
  public:
    explicit Planner(const BlurWish& wish) : wish_(wish) {
        plan_.sizes = {wish.size, wish.size};
        plan_.extents = {wish.size, wish.size};
        plan_.aprons = {0, 0};
        plan_.full_floats = wish.method == "exact";
    }

    Plan make() {
        if (wish_.method == "pyramid" || wish_.method == "copy") {
            pyramid();
        } else {
            plan_.sigmas_px = wish_.sum ? sum_of(wish_.sigma_px) : std::vector{wish_.sigma_px};
            for (const double sigma : plan_.sigmas_px) gaussian(sigma);
        }
        return std::move(plan_);
    }

    // Gaussians of a pyramid: each level's own, and the requested one at the end.
    static std::vector<double> sum_of(double sigma) {
        std::vector<double> sigmas;
        for (int level = 1; level < levels_for(sigma); ++level) sigmas.push_back(std::sqrt(pyramid_variance(level)));
        sigmas.push_back(sigma);
        return sigmas;
    }

  private:
    // So many as do not blur too much.
    static int levels_for(double sigma) {
        int levels = 0;
        while (pyramid_variance(levels + 1) <= sigma * sigma) ++levels;
        return levels;
    }

    int image(glm::vec2 extent, int apron = 0) {
        plan_.sizes.push_back(glm::uvec2(glm::ceil(extent)) + 2u * static_cast<uint32_t>(apron));
        plan_.extents.push_back(extent);
        plan_.aprons.push_back(apron);
        return static_cast<int>(plan_.sizes.size()) - 1;
    }
    // An image for the level below. Of an odd number of texels the last one lies half over the border.
    int half_of(int above) { return image(0.5f * plan_.extents[static_cast<size_t>(above)], level_apron); }
    int as_large_as(int other) {
        return image(plan_.extents[static_cast<size_t>(other)], plan_.aprons[static_cast<size_t>(other)]);
    }
    int between() { return between_ ? between_ : between_ = image(wish_.size); }
    int second() { return second_ ? second_ : second_ = image(wish_.size); }

    Step with_taps(Step step, const std::vector<glm::vec2>& taps) {
        step.first_tap = static_cast<uint32_t>(plan_.taps.size());
        step.taps = static_cast<uint32_t>(taps.size());
        plan_.taps.insert(plan_.taps.end(), taps.begin(), taps.end());
        return step;
    }

    // The last step of one of several Gaussians adds its share to the others.
    Step last(Step step) {
        step.into = 1;
        step.weight = 1.0f / static_cast<float>(plan_.sigmas_px.size());
        step.keep = started_ ? 1.0f : 0.0f;
        started_ = true;
        return step;
    }

    // Along x into `middle`, then along y.
    void two_lines(Step step, int middle, bool ends) {
        const int into = step.into;
        step.into = middle;
        plan_.steps.push_back(step);
        step.from = middle;
        step.into = into;
        step.direction = {0, 1};
        plan_.steps.push_back(ends ? last(step) : step);
    }

    static std::vector<glm::vec2> taps_of(const std::vector<float>& weights, double spacing) {
        std::vector<glm::vec2> taps;
        for (size_t k = 0; k < weights.size(); ++k) taps.emplace_back(spacing * static_cast<double>(k), weights[k]);
        return taps;
    }

    void gaussian(double sigma) {
        const std::string& method = wish_.method;
        const auto weights = [&](double of) {
            return gaussian_weights(static_cast<float>(of),
                                    static_cast<float>(plan_.full_floats ? 5 : wish_.truncation));
        };
        if (method == "separable" || method == "exact" || method == "shared") {
            const Kind kind = method == "shared" ? Kind::shared : Kind::line;
            two_lines(with_taps({.kind = kind, .linear = false}, taps_of(weights(sigma), 1)), between(), true);
        } else if (method == "paired") {
            two_lines(with_taps({}, pair_taps(weights(sigma))), between(), true);
        } else if (method == "window") {
            const std::vector<float> side = weights(sigma);
            if (side.size() > 65)
                throw InputError(
                    "bloom.method window at a sigma of {:.1f} px reads {} texels for each pixel; take at most 65 to a "
                    "side, or another method",
                    sigma, (2 * side.size() - 1) * (2 * side.size() - 1));
            plan_.steps.push_back(last(with_taps({.kind = Kind::window, .linear = false}, taps_of(side, 1))));
        } else if (method == "pingpong") {
            Step step = with_taps({.linear = false}, taps_of(weights(sigma / std::sqrt(pingpong_rounds)), 1));
            rounds(step, pingpong_rounds);
        } else if (method == "three_pass_7tap") {
            const double spacing = solve(0, 200, sigma * sigma, seven_tap_variance);
            for (int i = 0; i < 3; ++i) {
                const Step step = with_taps({.from = i == 0 ? 0 : second(), .into = second()},
                                            taps_of(seven_weights(), spacing * (1 << i)));
                two_lines(step, between(), i == 2);
            }
        } else if (method == "dual_kawase") {
            kawase(sigma);
        } else {
            throw InputError("bloom.method: there is no blur '{}'", method);
        }
    }

    void rounds(Step step, int count) {
        for (int i = 0; i < count; ++i) {
            step.from = i == 0 ? 0 : second();
            step.into = second();
            two_lines(step, between(), i == count - 1);
        }
    }

    // Only offsets of 1 keep each texel's position on average; others give a lamp a leaning halo with wrong light at a
    // border. The way up has the rest.
    void kawase(double sigma) {
        int levels = 1;
        while (kawase_variance(levels, widest_kawase) < sigma * sigma) ++levels;
        const auto spread = static_cast<float>(
            solve(0, widest_kawase, sigma * sigma, [&](double offset) { return kawase_variance(levels, offset); }));
        std::vector<int> chain{0};
        for (int level = 1; level <= levels; ++level) {
            chain.push_back(half_of(chain.back()));
            plan_.steps.push_back({.kind = Kind::kawase_down,
                                   .from = chain[chain.size() - 2],
                                   .into = chain.back(),
                                   .spread = kawase_down_offset(levels, spread)});
        }
        for (int level = levels; level > 0; --level) {
            const Step up{.kind = Kind::kawase_up,
                          .from = chain[size_t(level)],
                          .into = chain[size_t(level) - 1],
                          .spread = spread};
            plan_.steps.push_back(level == 1 ? last(up) : up);
        }
    }

    // [pyramid]
    // Takes levels until the next one would blur too much, adds the missing variance by a small Gaussian at the smallest
    // level, and goes up again, adding each level's own light if a sum of Gaussians is requested.
    void pyramid() {
        const double sigma = wish_.sigma_px;
        const int levels = levels_for(sigma);
        const bool copies = wish_.method == "copy";
        plan_.sigmas_px = wish_.sum ? sum_of(sigma) : std::vector{sigma};
        const float share = 1.0f / static_cast<float>(plan_.sigmas_px.size());

        std::vector<int> chain{0};
        for (int level = 1; level <= levels; ++level) {
            const int above = chain.back();
            chain.push_back(half_of(above));
            plan_.steps.push_back({.kind = copies ? Kind::copy : Kind::down,
                                   .from = above,
                                   .into = chain.back(),
                                   .spread = 2.0f,
                                   .karis = wish_.karis && level == 1});
        }
        const double missing_texels = std::sqrt(sigma * sigma - pyramid_variance(levels)) / std::pow(2.0, levels);
        const int smallest = levels == 0 ? 1 : chain.back();
        if (!copies || levels == 0) {
            const auto taps = taps_of(gaussian_weights(static_cast<float>(missing_texels), 3.0f), 1);
            const Kind kind = levels == 0 ? Kind::line : Kind::level_line;
            const Step blur =
                with_taps({.kind = kind, .from = chain.back(), .into = smallest, .linear = levels > 0}, taps);
            two_lines(blur, as_large_as(smallest), false);
        }
        for (int level = levels; level > 0; --level) {
            const bool first = level == levels, adds = wish_.sum && level > 1;
            plan_.steps.push_back({.kind = copies ? Kind::copy : Kind::up,
                                   .from = chain[size_t(level)],
                                   .into = level == 1 ? 1 : chain[size_t(level) - 1],
                                   .spread = 0.5f,
                                   .weight = first ? share : 1.0f,
                                   .keep = adds ? share : 0.0f});
        }
    }
    // [/pyramid]

    const BlurWish& wish_;
    Plan plan_;
    int between_ = 0, second_ = 0;
    bool started_ = false;
};

}  // namespace

double tap_variance(const std::vector<glm::dvec2>& offsets_and_weights, double phase) {
    double weight = 0, mean = 0, square = 0;
    for (const glm::dvec2& tap : offsets_and_weights) {
        const double at = phase + tap.x, f = at - std::floor(at);
        weight += tap.y;
        mean += tap.y * tap.x;
        square += tap.y * (tap.x * tap.x + f * (1 - f));  // a linear filter adds f (1 - f)
    }
    return square / weight - (mean / weight) * (mean / weight);
}

float kawase_down_offset(int levels, float offset) { return levels == 1 ? std::min(offset, 1.0f) : 1.0f; }

double pyramid_variance(int levels) { return 1.5 * (std::pow(4.0, levels) - 1); }

double kawase_variance(int levels, double offset) {
    // Down reads from where four texels meet, up from a quarter of a texel beside a texel's middle.
    const double corner = double(kawase_down_offset(levels, static_cast<float>(offset)));
    const double down = tap_variance({{0, 0.5}, {-corner, 0.25}, {corner, 0.25}}, 0.5);
    const double half = 0.5 * offset;
    const double up = tap_variance(
        {{-2 * half, 1.0 / 12}, {2 * half, 1.0 / 12}, {0, 2.0 / 12}, {-half, 4.0 / 12}, {half, 4.0 / 12}}, 0.25);
    return (down + 4 * up) * (std::pow(4.0, levels) - 1) / 3;
}

glm::uvec3 groups_of(const Step& step, const Plan& plan) {
    const glm::uvec2 size = plan.sizes[static_cast<size_t>(step.into)];
    if (step.kind != Kind::shared) return glm::uvec3((size + 15u) / 16u, 1);
    const bool across = step.direction.x != 0;  // 256 texels of a line each
    return {((across ? size.x : size.y) + 255u) / 256u, across ? size.y : size.x, 1};
}

Plan plan_blur(const BlurWish& wish) { return Planner(wish).make(); }

}  // namespace lightwalk
