// Program compare A B: error metrics and heat map. Exit codes: 0, 1 (limit exceeded), 2 (invalid input).
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <iostream>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "common/base/error.h"
#include "common/base/files.h"
#include "common/base/text.h"
#include "common/measure/flip.h"
#include "common/measure/metrics.h"

namespace lightwalk {
namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();

struct Options {
    std::string reference, test, heatmap;
    bool json = false, hdr = false;
    std::vector<float> exposures;
    float per_degree = default_pixels_per_degree;
    double max_mean = no_limit, max_p99 = no_limit, max_diff = no_limit;
};

struct Comparison {
    ErrorMap map;
    ErrorSummary flip;
    Difference difference;
    StepDifference steps;
    std::optional<ExposureRange> exposures;
    bool constant_reference = false, constant_test = false;
};

Comparison compare(const Options& options) {
    Comparison c;
    const bool hdr = options.hdr || is_hdr_name(options.reference) || is_hdr_name(options.test);
    ImageRgb reference, test;
    Image8 reference8, test8;
    if (hdr) {
        reference = read_image_linear(options.reference);
        test = read_image_linear(options.test);
        reference8 = to_srgb8(reference);
        test8 = to_srgb8(test);
    } else {
        reference8 = read_image8(options.reference);
        test8 = read_image8(options.test);
        reference = to_linear(reference8);
        test = to_linear(test8);
    }
    c.difference = difference(reference, test);
    c.steps = max_step_difference(reference8, test8);
    c.constant_reference = is_nearly_constant(reference8);
    c.constant_test = is_nearly_constant(test8);
    if (hdr) {
        c.exposures = options.exposures.empty() ? automatic_exposures(reference)
                                                : exposure_range(options.exposures[0], options.exposures[1]);
        c.map = flip_hdr(reference, test, c.exposures, options.per_degree);
    } else {
        c.map = flip_ldr(reference, test, options.per_degree);
    }
    c.flip = summarize(c.map);
    return c;
}

nlohmann::ordered_json as_json(const Options& options, const Comparison& c) {
    nlohmann::ordered_json j = {
        {"reference", options.reference},
        {"test", options.test},
        {"width", c.map.width},
        {"height", c.map.height},
        {"pixels_per_degree", options.per_degree},
        {"flip",
         {{"kind", c.exposures ? "hdr" : "ldr"},
          {"mean", c.flip.mean},
          {"p99", c.flip.p99},
          {"max", c.flip.max},
          {"weighted_quartile1", c.flip.weighted_quartile1},
          {"weighted_median", c.flip.weighted_median},
          {"weighted_quartile3", c.flip.weighted_quartile3}}},
        {"rmse", c.difference.rmse},
        {"relative_rmse", c.difference.relative_rmse},
        {"relative_epsilon", relative_epsilon},
        {"max", c.difference.max},
        {"psnr_db", psnr_db(c.difference.mse)},
        {"max_diff", {{"steps", c.steps.steps}, {"x", c.steps.x}, {"y", c.steps.y}, {"pixels", c.steps.pixels}}},
        {"nearly_constant", {{"reference", c.constant_reference}, {"test", c.constant_test}}},
        {"nan", {{"reference", c.difference.reference.nan}, {"test", c.difference.test.nan}}},
        {"inf", {{"reference", c.difference.reference.inf}, {"test", c.difference.test.inf}}}};
    if (c.exposures)
        j["flip"]["exposures"] = {
            {"start", c.exposures->start}, {"stop", c.exposures->stop}, {"count", c.exposures->count}};
    return j;
}

void print(const Comparison& c) {
    std::printf("FLIP mean         %.6f\n", c.flip.mean);
    std::printf("FLIP p99          %.6f\n", c.flip.p99);
    std::printf("FLIP max          %.6f\n", c.flip.max);
    if (c.exposures)
        std::printf("exposures         %.4f to %.4f stops, %d of them\n", static_cast<double>(c.exposures->start),
                    static_cast<double>(c.exposures->stop), c.exposures->count);
    std::printf("RMSE              %.6g  (linear light)\n", c.difference.rmse);
    std::printf("relative RMSE     %.6g\n", c.difference.relative_rmse);
    std::printf("max error         %.6g  (linear light)\n", c.difference.max);
    std::printf("largest step      %d of 255 at (%d, %d); %zu pixels differ\n", c.steps.steps, c.steps.x, c.steps.y,
                c.steps.pixels);
    std::printf("NaN / Inf pixels  %zu / %zu in the reference, %zu / %zu in the test\n", c.difference.reference.nan,
                c.difference.reference.inf, c.difference.test.nan, c.difference.test.inf);
}

// Prints exceeded limits on stderr. With any limit set, non-finite pixels exceed it.
bool within_limits(const Options& options, const Comparison& c) {
    std::string over;
    const auto check = [&](const char* what, double value, double limit) {
        if (value <= limit || limit == no_limit) return;
        over += fmt::format("{}{} {:.6g}, at most {:.6g}", over.empty() ? "" : "; ", what, value, limit);
    };
    check("FLIP mean", c.flip.mean, options.max_mean);
    check("FLIP p99", c.flip.p99, options.max_p99);
    check("largest step", c.steps.steps, options.max_diff);
    if (options.max_mean < no_limit || options.max_p99 < no_limit || options.max_diff < no_limit)
        check("pixels with NaN or Inf", double(c.difference.reference.total() + c.difference.test.total()), 0.0);
    if (!over.empty()) std::cerr << options.test << " differs from " << options.reference << ": " << over << "\n";
    return over.empty();
}

Comparison compared(const Options& options) {
    if (!options.heatmap.empty()) check_writable(options.heatmap);
    Comparison comparison = compare(options);
    if (!options.heatmap.empty()) write_png(options.heatmap, heat_map(comparison.map));
    return comparison;
}

void print_json(const nlohmann::ordered_json& json, int indent) {
    std::cout << json.dump(indent, ' ', false, nlohmann::json::error_handler_t::replace) << std::endl;
}

// Compares ["EXPECTED", "ACTUAL"] or ["EXPECTED", "ACTUAL", "--heatmap", "FILE"] per line of stdin, printing JSON.
void compare_pairs() {
    for (std::string line; std::getline(std::cin, line);) {
        try {
            const auto words = nlohmann::json::parse(line).get<std::vector<std::string>>();
            if (words.size() != 2 && (words.size() != 4 || words[2] != "--heatmap"))
                throw InputError("{} is no pair of pictures", line);
            const Options options{
                .reference = words[0], .test = words[1], .heatmap = words.size() == 4 ? words[3] : ""};
            print_json(as_json(options, compared(options)), -1);
        } catch (const std::exception& error) { print_json({{"error", error.what()}}, -1); }
    }
}

int run(int argc, char** argv) {
    CLI::App app(
        "How far an image is from another: FLIP (LDR, or HDR for .hdr and .pfm), RMSE in linear light, largest\n"
        "difference. Exit codes: 0; 1 a limit is exceeded; 2 bad input.",
        "compare");
    Options options;
    bool pairs = false;
    app.add_option("reference", options.reference, "the expected image: PNG, JPEG, .hdr or .pfm");
    app.add_option("test", options.test, "the image to judge");
    app.add_flag("--json", options.json, "print JSON");
    app.add_flag("--pairs", pairs, "compare the pairs that standard input names, a JSON array of words a line");
    app.add_flag("--hdr", options.hdr, "compare as HDR whatever the names say");
    app.add_option("--heatmap", options.heatmap, "write the FLIP map here, as PNG");
    app.add_option("--exposures", options.exposures,
                   "HDR: first and last exposure in stops (default: from the reference)")
        ->expected(2);
    app.add_option("--ppd", options.per_degree, "pixels per degree of visual angle")->check(CLI::Range(1e-3, 1e3));
    app.add_option("--max-mean", options.max_mean, "limit of the FLIP mean")->check(CLI::Range(0.0, 1.0));
    app.add_option("--max-p99", options.max_p99, "limit of FLIP's 99th percentile")->check(CLI::Range(0.0, 1.0));
    app.add_option("--max-diff", options.max_diff, "limit of the largest difference, 8-bit steps")
        ->check(CLI::Range(0.0, 255.0));
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success&) {
        std::cout << app.help();
        return 0;
    } catch (const CLI::ParseError& error) { throw InputError("{} (try --help)", error.what()); }
    if (pairs) {
        compare_pairs();
        return 0;
    }
    if (options.test.empty()) throw InputError("two images are needed (try --help)");
    const Comparison comparison = compared(options);
    if (options.json)
        print_json(as_json(options, comparison), 2);
    else
        print(comparison);
    std::fflush(stdout);
    return within_limits(options, comparison) ? 0 : 1;
}

}  // namespace
}  // namespace lightwalk

int main(int argc, char** argv) {
    try {
        return lightwalk::run(argc, argv);
    } catch (const std::exception& error) { return lightwalk::report_exception(error, "compare"); }
}
