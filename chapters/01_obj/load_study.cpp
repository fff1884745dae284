#include "01_obj/load_study.h"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "01_obj/load_bench.h"
#include "common/base/add_line.h"
#include "common/base/error.h"
#include "common/base/files.h"

namespace lightwalk {
namespace {

using nlohmann::json;

constexpr LoaderCost costs[] = {
    {Loader::textbook, 0.03, 30, 0}, {Loader::assimp, 1.6, 40, 1},     {Loader::tinyobjloader, 0.03, 130, 0},
    {Loader::scan, 0.03, 300, 0},    {Loader::parallel, 0.3, 1100, 0},
};

std::string processor_name() {
    std::ifstream in("/proc/cpuinfo");
    for (std::string line; std::getline(in, line);)
        if (line.rfind("model name", 0) == 0) return line.substr(line.find(": ") + 2);
    return "unknown processor";
}

}  // namespace

void study_loaders(const json& study, json& result) {
    const unsigned threads = std::thread::hardware_concurrency();
    result = {{"subject", "loader"},
              {"device", processor_name()},
              {"driver", "CPU"},
              {"stage", std::to_string(threads) + " threads"},
              {"truth", {{"method", "strtof in the C locale"}, {"knobs", json::object()}, {"doubling_change", 0}}},
              {"error_metric", "ulp"},
              {"time_unit", "MB/s"},
              {"points", json::array()}};
    for (const json& scene : study.at("scenes")) {
        const auto path = course_root() / scene.get<std::string>();
        if (!std::filesystem::exists(path)) {
            std::fprintf(stderr, "warning: no %s; left out\n", path.c_str());
            continue;
        }
        const int rounds = study.value("rounds", 5);
        size_t bytes = 0;
        for (const LoaderFigures& f : measure_loaders(path, rounds, bytes)) {
            if (!f.error.empty()) continue;
            const double megabytes = static_cast<double>(bytes) / 1e6;
            const auto rate = [&](double share) { return 1e3 * megabytes / f.quantile(share); };
            result["points"].push_back(
                {{"scene", path.stem().string()},
                 {"method", loader_name(f.loader)},
                 {"knobs", {{"megabytes", std::round(megabytes * 100) / 100}}},
                 {"error", {{"ulp", f.largest_ulps}, {"index_agreement", f.index_agreement}}},
                 {"mb_per_s", {{"median", rate(0.5)}, {"q1", rate(0.75)}, {"q3", rate(0.25)}, {"rounds", rounds}}}});
        }
    }
}

double megabytes(const SceneFile& scene) {
    std::set<std::filesystem::path> files;
    double sum = 0;
    for (const SceneObject& object : scene.objects)
        if (is_obj(object.model) && files.insert(object.model).second)
            sum += static_cast<double>(std::filesystem::file_size(find_asset(object.model))) / 1e6;
    return sum;
}

LoaderCost choose_loader(double megabytes, int loads, double budget, std::vector<std::string>& lines) {
    const LoaderCost* best = nullptr;
    add_line(lines, "file: %.3f MB, read %d times: %.3f MB in all", megabytes, loads, megabytes * loads);
    add_line(lines, "rule: loads x (start + size / rate) is least, among loaders with an error of at most %g ULP",
             budget);
    for (const LoaderCost& cost : costs) {
        add_line(lines, "%-14s %10.2f ms predicted, %g ULP", std::string(loader_name(cost.loader)).c_str(),
                 cost.total_ms(megabytes, loads), cost.ulp);
        if (cost.ulp <= budget && (!best || cost.total_ms(megabytes, loads) < best->total_ms(megabytes, loads)))
            best = &cost;
    }
    add_line(lines, "choice: loader=%s", std::string(loader_name(best->loader)).c_str());
    return *best;
}

}  // namespace lightwalk
