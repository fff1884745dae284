#include "01_obj/load_study.h"

#include <chrono>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "01_obj/load_bench.h"
#include "common/base/error.h"
#include "common/base/files.h"
#include "common/base/text.h"

namespace lightwalk {
namespace {

using nlohmann::json;

constexpr int rounds_to_choose = 3;

std::string processor_name() {
    std::ifstream in("/proc/cpuinfo");
    for (std::string line; std::getline(in, line);)
        if (line.rfind("model name", 0) == 0) return line.substr(line.find(": ") + 2);
    return "unknown processor";
}

}  // namespace

void LoaderSubject::measure(const json& study, json& result) {
    const unsigned threads = std::thread::hardware_concurrency();
    result = {{"subject", "loader"},
              {"device", processor_name()},
              {"driver", "CPU"},
              {"stage", fmt::format("{} threads", threads)},
              {"truth", {{"method", "strtof in the C locale"}, {"knobs", json::object()}, {"doubling_change", 0}}},
              {"error_metric", "ulp"},
              {"time_unit", "MB/s"},
              {"points", json::array()}};
    for (const json& file : study.at("scenes")) {
        const auto path = course_root() / file.get<std::string>();
        if (!std::filesystem::exists(path)) {
            warn("no {}; left out", path.string());
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

// Every .obj file of the scene, each once: its loaders' times add up, of their errors the largest counts.
json LoaderSubject::choose(double budget) {
    const auto start = std::chrono::steady_clock::now();
    struct Candidate {
        double ulps = 0, ms = 0;
        bool reads = true;
    };
    std::map<Loader, Candidate> candidates;
    std::set<std::filesystem::path> files;
    for (const SceneObject& object : scene.objects) {
        if (!is_obj(object.model) || !files.insert(object.model).second) continue;
        size_t bytes = 0;
        for (const LoaderFigures& f : measure_loaders(find_asset(object.model), rounds_to_choose, bytes)) {
            Candidate& c = candidates[f.loader];
            c.reads = c.reads && f.error.empty();
            if (!f.error.empty()) continue;
            c.ulps = std::max(c.ulps, static_cast<double>(f.largest_ulps));
            c.ms += f.quantile(0.5);
        }
    }
    json all = json::array();
    const json *fastest = nullptr, *most_accurate = nullptr;
    for (const auto& [which, c] : candidates)
        all.push_back({{"method", loader_name(which)},
                       {"knobs", json::object()},
                       {"error", c.reads ? json(c.ulps) : json()},
                       {"error_upper", c.reads ? json(c.ulps) : json()},
                       {"time_ms", c.ms},
                       {"enough", c.reads && c.ulps <= budget}});
    for (const json& c : all) {
        if (c["enough"] == true && (!fastest || c["time_ms"] < fastest->at("time_ms"))) fastest = &c;
        if (!c["error"].is_null() && (!most_accurate || c["error"] < most_accurate->at("error"))) most_accurate = &c;
    }
    const json* const best = fastest ? fastest : most_accurate;
    if (best) loader.set(best->at("method").get<std::string>());
    // A scene without an .obj file is read alike by all: the loader stays.
    const json as_it_is = {{"method", loader.text()}, {"knobs", json::object()}};
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
    return {{"budget", budget},
            {"error_metric", "ulp"},
            {"crops", 0},
            {"candidates", all},
            {"choice", best ? *best : as_it_is},
            {"none_would_do", !fastest && !all.empty()},
            {"choosing_ms", took.count()}};
}

}  // namespace lightwalk
