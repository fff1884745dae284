// Checks of 04.alpha_scale: levels from a table, in several orders of the invocations.
#include <algorithm>
#include <bit>

#include "common/check/barriers.h"
#include "common/check/check.h"
#include "common/check/guard.h"
#include "common/check/workgroup.h"

using namespace lightwalk;

namespace {

constexpr uint32_t most_texels = 1500, stride = 3 + most_texels;

struct Leaves {
    std::string words;
    std::vector<float> alphas;
    float cutoff, wanted;

    double count() const { return double(wanted) * double(alphas.size()); }
    size_t kept(float scale) const {
        return static_cast<size_t>(std::count_if(alphas.begin(), alphas.end(), [&](float alpha) {
            return std::round(255.0f * std::min(alpha * scale, 1.0f)) / 255.0f >= cutoff;
        }));
    }
    /// How near to the count a scale can come, alphas that are alike taken together.
    double least() const {
        double best = count();
        for (const float alpha : alphas)
            if (alpha > 0) best = std::min(best, std::fabs(double(kept(1.001f * cutoff / alpha)) - count()));
        return best;
    }
    /// How many more than one are as good as at the border with this scale.
    double alike(float scale) const {
        const float border = cutoff / std::max(scale, 1e-20f);
        const auto near = [&](float a) { return std::fabs(a - border) <= 0.004f * a; };
        return std::max(double(std::count_if(alphas.begin(), alphas.end(), near)) - 1, 0.0);
    }
};

std::vector<Leaves> levels() {
    Random random(5);
    const auto some = [&](size_t count, double lower, double upper) {
        std::vector<float> alphas(count);
        for (float& alpha : alphas) alpha = static_cast<float>(random.uniform(lower, upper));
        return alphas;
    };
    return {{"one texel of alpha 0.284, of which 28.4 % are wanted", {0.284f}, 0.5f, 0.284f},
            {"one texel of alpha 0.7, of which 70 % are wanted", {0.7f}, 0.5f, 0.7f},
            {"2x2 texels, 5 % wanted", {0.05f, 0.06f, 0.04f, 0.05f}, 0.5f, 0.05f},
            {"2x2 texels, 50 % wanted", {0.3f, 0.2f, 0.1f, 0.05f}, 0.5f, 0.5f},
            {"4x4 texels of small alphas, 20 % wanted", some(16, 0.005, 0.05), 0.5f, 0.2f},
            {"64 texels without alpha, none wanted", std::vector<float>(64, 0.0f), 0.5f, 0.0f},
            {"64 texels, all wanted", some(64, 0.1, 1), 0.5f, 1.0f},
            {"300 texels, 30 % wanted, cutoff 0.25", some(300, 0, 1), 0.25f, 0.3f},
            {"1500 texels, 60 % wanted, cutoff 0.9", some(1500, 0, 1), 0.9f, 0.6f},
            {"1024 texels, 2 % wanted", some(1024, 0, 0.2), 0.5f, 0.02f}};
}

WorkgroupRun run_of(const std::vector<Leaves>& all) {
    const std::string given = "given[case_index * " + std::to_string(stride) + "u + ";
    WorkgroupRun run{
        .include = "04_surface_maps/alpha_scale.glsl",
        .before =
            "const uint LEVEL_INVOCATIONS = 256u;\n"
            "uint level_texels() { return " +
            given + "0u]; }\nfloat level_alpha(uint p) { return p < level_texels() ? uintBitsToFloat(" + given +
            "3u + p]) : 1.0; }\nbool is_kept(float alpha) { return round(255.0 * min(alpha, 1.0)) / 255.0 "
            ">= uintBitsToFloat(" +
            given + "1u]); }\n",
        .call = "float scale = alpha_scale(local, uintBitsToFloat(" + given + "1u]), uintBitsToFloat(" + given +
                "2u]));\nuint kept_by_it = 0u;\n"
                "for (uint p = 0u; local == 0u && p < level_texels(); ++p)\n"
                "    if (is_kept(level_alpha(p) * scale)) ++kept_by_it;\n"
                "put(0u, floatBitsToUint(scale));\nput(1u, kept_by_it);\n",
        .given = {},
        .cases = static_cast<uint32_t>(all.size()),
        .puts = 2};
    for (const Leaves& one : all) {
        run.given.push_back(static_cast<uint32_t>(one.alphas.size()));
        for (const float value : {one.cutoff, one.wanted}) run.given.push_back(std::bit_cast<uint32_t>(value));
        for (uint32_t i = 0; i < most_texels; ++i)
            run.given.push_back(std::bit_cast<uint32_t>(i < one.alphas.size() ? one.alphas[i] : 0.0f));
    }
    return run;
}

}  // namespace

CHECK_EXERCISE("04.alpha_scale",
               "count the texels that one scale keeps, with all invocations; halve the interval of scales; at the end "
               "take the end whose count is nearer to the number wanted") {
    const std::vector<Leaves> all = levels();
    guard_call("alpha_scale.glsl, as a workgroup of 256");
    const WorkgroupResults seen(check_device(), run_of(all));
    guard_call("");
    for (uint32_t i = 0; i < all.size(); ++i) {
        const auto scale_of = [&](uint32_t order, uint32_t local) {
            return std::bit_cast<float>(seen.at(i, order, local, 0));
        };
        const float first = scale_of(0, 0);
        for (uint32_t order = 0; order < workgroup_orders; ++order)
            for (uint32_t local = 0; local < workgroup_size; ++local) {
                const float scale = scale_of(order, local);
                check.expect(
                    std::bit_cast<uint32_t>(scale) == std::bit_cast<uint32_t>(first),
                    all[i].words + ": alpha_scale gave " + number_text(double(first)) + " to invocation 0 and " +
                        number_text(double(scale)) + " to invocation " + std::to_string(local) +
                        (order ? ", when they ran in another order" : "") + ": a barrier is missing",
                    "set, barrier, add, barrier, read, barrier: between any two of them another invocation may "
                    "still be at the one before");
            }
        const bool is_number = std::isfinite(first) && first >= 0;
        const double least = all[i].least(), kept = seen.at(i, 0, 0, 1);
        check.expect(is_number && std::fabs(kept - all[i].count()) <= least + all[i].alike(first) + 1e-3,
                     all[i].words + ": alpha_scale gave " + number_text(double(first)) + ", with which " +
                         number_text(kept) + " of " + std::to_string(all[i].alphas.size()) + " are kept; wanted are " +
                         number_text(all[i].count()) + ", and a scale can come as near as " + number_text(least));
    }
    const std::string wrong = seen.barriers();
    check.expect(wrong.empty(), "alpha_scale: " + wrong, barrier_hint);
}
