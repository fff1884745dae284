#include "01_obj/load_bench.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "01_obj/truth.h"
#include "common/base/bytes.h"
#include "common/base/error.h"
#include "common/base/files.h"
#include "common/base/guarded.h"
#include "common/base/text.h"
#include "common/study/cheapest.h"

namespace lightwalk {

// Measurements of one loader on a file.
struct LoaderFigures {
    Loader loader = Loader::textbook;
    std::string error;       // why it cannot read the file; empty: it can
    std::vector<double> ms;  // of each run, ascending
    uint64_t largest_ulps = 0;
    size_t floats_wrong = 0, floats_compared = 0, triangles = 0;
    double index_agreement = 0.0;  // share of triangles that are the truth's
    double quantile(double share) const {
        return ms[static_cast<size_t>(share * static_cast<double>(ms.size() - 1) + 0.5)];
    }
};

template <class Bytes>
void fields(Bytes& bytes, LoaderFigures& f) {
    bytes(f.loader, f.error, f.ms, f.largest_ulps, f.floats_wrong, f.floats_compared, f.triangles, f.index_agreement);
}

namespace {

void compare_floats(const float* a, const float* b, size_t count, LoaderFigures& result) {
    for (size_t i = 0; i < count; ++i) {
        const uint64_t distance = truth::ulps(a[i], b[i]);
        result.largest_ulps = std::max(result.largest_ulps, distance);
        result.floats_wrong += distance > 0;
    }
    result.floats_compared += count;
}

// Loaders that keep the file's order are compared float by float and index by index.
void compare_in_order(const ObjData& data, const ObjData& expected, LoaderFigures& result) {
    compare_floats(data.positions.data(), expected.positions.data(), expected.positions.size(), result);
    compare_floats(data.uvs.data(), expected.uvs.data(), expected.uvs.size(), result);
    compare_floats(data.normals.data(), expected.normals.data(), expected.normals.size(), result);
    size_t same = 0;
    for (size_t i = 0; i + 2 < std::min(data.corners.size(), expected.corners.size()); i += 3)
        same += std::equal(&data.corners[i], &data.corners[i] + 3, &expected.corners[i]);
    result.index_agreement = static_cast<double>(same) / static_cast<double>(expected.triangles());
}

// Others (Assimp renumbers) corner by corner: a corner agrees where its position is the expected one but for rounding.
void compare_by_corner(const ObjData& data, const ObjData& expected, LoaderFigures& result) {
    constexpr uint64_t rounding = 64;
    size_t same = 0;
    for (size_t i = 0; i + 2 < std::min(data.corners.size(), expected.corners.size()); i += 3) {
        bool agrees = true;
        for (size_t k = i; k < i + 3; ++k)
            for (size_t axis = 0; axis < 3; ++axis)
                agrees &= truth::ulps(data.positions[3 * size_t{data.corners[k].position} + axis],
                                      expected.positions[3 * size_t{expected.corners[k].position} + axis]) <= rounding;
        same += agrees;
        for (size_t k = i; agrees && k < i + 3; ++k)
            compare_floats(&data.positions[3 * size_t{data.corners[k].position}],
                           &expected.positions[3 * size_t{expected.corners[k].position}], 3, result);
    }
    result.index_agreement = static_cast<double>(same) / static_cast<double>(expected.triangles());
}

void run_here(const std::filesystem::path& path, const ObjData* expected, LoaderFigures& result) {
    try {
        const auto start = std::chrono::steady_clock::now();
        const ObjData data = parse_obj(path, result.loader);
        const auto stop = std::chrono::steady_clock::now();
        if (!expected) {
            result.ms.push_back(std::chrono::duration<double, std::milli>(stop - start).count());
            return;
        }
        result.triangles = data.triangles();
        const bool in_order = data.positions.size() == expected->positions.size() &&
                              data.uvs.size() == expected->uvs.size() &&
                              data.normals.size() == expected->normals.size() && result.loader != Loader::assimp;
        in_order ? compare_in_order(data, *expected, result) : compare_by_corner(data, *expected, result);
    } catch (const InputError& error) { result.error = error.what(); }
}

// The public parsers are timed inside their guarded process, without the guard's overhead.
void run_once(const std::filesystem::path& path, size_t bytes, const ObjData* expected, LoaderFigures& result) {
    if (result.loader != Loader::tinyobjloader && result.loader != Loader::assimp)
        return run_here(path, expected, result);
    try {
        const std::string figures =
            run_guarded(path.string(), std::string(loader_name(result.loader)), limits_for(bytes), [&] {
                run_here(path, expected, result);
                ByteWriter writer;
                writer(result);
                return std::move(writer.bytes);
            });
        ByteReader{figures}(result);
    } catch (const InputError& error) { result.error = error.what(); }
}

void print_table(const std::filesystem::path& path, size_t bytes, int runs, const std::vector<LoaderFigures>& results) {
    std::printf("%s, %.1f MB, median of %d, %u threads\n", printable(path.string()).c_str(),
                static_cast<double>(bytes) / 1e6, runs, std::thread::hardware_concurrency());
    std::printf("%-14s %10s %8s %8s %14s %10s\n", "loader", "ms", "MB/s", "max ULP", "floats wrong", "indices");
    for (const LoaderFigures& r : results) {
        const std::string name(loader_name(r.loader));
        if (!r.error.empty())
            std::printf("%-14s %s\n", name.c_str(), printable(r.error).c_str());
        else
            std::printf("%-14s %10.2f %8.1f %8llu %13.3f%% %9.3f%%\n", name.c_str(), r.quantile(0.5),
                        static_cast<double>(bytes) / 1e3 / r.quantile(0.5),
                        static_cast<unsigned long long>(r.largest_ulps),
                        100.0 * static_cast<double>(r.floats_wrong) /
                            static_cast<double>(std::max<size_t>(r.floats_compared, 1)),
                        100.0 * r.index_agreement);
    }
}

// Reads the file `runs` times with every loader in turn (A B C A B C ...) after one round that is not counted but
// compared with the truth. `bytes` becomes the file's size. Throws InputError where the reference cannot read it.
std::vector<LoaderFigures> measure_loaders(const std::filesystem::path& path, int runs, size_t& bytes) {
    if (runs < 1) throw InputError("the load bench needs at least 1 run, got {}", runs);
    parse_obj(path, Loader::scan);  // reports errors in the file
    std::vector<LoaderFigures> results;
    for (const std::string_view name : loader_names()) results.emplace_back().loader = loader_from_name(name);
    {
        const std::string text = read_file(path);
        bytes = text.size();
        const ObjData expected = truth::parse(text);
        for (LoaderFigures& result : results) run_once(path, bytes, &expected, result);
    }
    for (int run = 0; run < runs; ++run)
        for (LoaderFigures& result : results)
            if (result.error.empty()) run_once(path, bytes, nullptr, result);
    for (LoaderFigures& result : results) std::sort(result.ms.begin(), result.ms.end());
    return results;
}

}  // namespace

int run_load_bench(const std::filesystem::path& path, int runs) {
    size_t bytes = 0;
    const std::vector<LoaderFigures> results = measure_loaders(path, runs, bytes);
    print_table(path, bytes, runs, results);
    return 0;
}

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
    std::map<Loader, Measured> candidates;
    std::set<std::filesystem::path> files;
    for (const SceneObject& object : scene.objects) {
        if (!is_obj(object.model) || !files.insert(object.model).second) continue;
        size_t bytes = 0;
        for (const LoaderFigures& f : measure_loaders(find_asset(object.model), rounds_to_choose, bytes)) {
            Measured& c = candidates[f.loader];
            c.error = std::max(c.error, f.error.empty() ? static_cast<double>(f.largest_ulps) : INFINITY);
            c.time_ms += f.error.empty() ? f.quantile(0.5) : 0;
        }
    }
    json all = json::array();
    std::vector<Measured> measured;
    for (auto& [which, c] : candidates) {
        c.enough = c.error <= budget;
        const json error = std::isfinite(c.error) ? json(c.error) : json();
        measured.push_back(c);
        all.push_back({{"method", loader_name(which)},
                       {"knobs", json::object()},
                       {"error", error},
                       {"error_upper", error},
                       {"time_ms", c.time_ms},
                       {"enough", c.enough}});
    }
    // A scene without an .obj file is read alike by all: the loader stays.
    json choice = {{"method", loader.text()}, {"knobs", json::object()}};
    if (!all.empty()) choice = all[cheapest(measured)];
    loader.set(choice["method"].get<std::string>());
    const bool any = std::ranges::any_of(measured, [](const Measured& c) { return c.enough; });
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
    return {{"budget", budget},           {"error_metric", "ulp"}, {"crops", 0},
            {"candidates", all},          {"choice", choice},      {"none_would_do", !any && !all.empty()},
            {"choosing_ms", took.count()}};
}

namespace {

using Json = nlohmann::ordered_json;

Json array(const glm::vec3& v) { return {v.x, v.y, v.z}; }

uint64_t hash_floats(const float* values, size_t count, uint64_t seed) {
    static_assert(std::endian::native == std::endian::little);
    return hash_bytes({reinterpret_cast<const char*>(values), count * sizeof(float)}, seed);
}

}  // namespace

void dump_mesh(const std::filesystem::path& path, Loader loader) {
    const Model model = load_model(path, loader);
    Json out = {{"file", path.string()}, {"loader", is_obj(path) ? loader_name(loader) : "assimp"}};
    uint64_t checksum = hash_bytes({});
    size_t vertices = 0, triangles = 0, positions = 0;
    for (const Mesh& mesh : model.meshes) {
        vertices += mesh.vertices.size();
        triangles += mesh.indices.size() / 3;
    }
    if (is_obj(path)) {
        const ObjData data = parse_obj(path, loader);
        checksum = hash_floats(data.positions.data(), data.positions.size(), checksum);
        positions = data.positions.size() / 3;
        out["uvs"] = data.uvs.size() / 2;
        out["normals"] = data.normals.size() / 3;
    } else {
        for (const Mesh& mesh : model.meshes)
            for (const Vertex& v : mesh.vertices) checksum = hash_floats(&v.position.x, 3, checksum);
        positions = vertices;
    }
    const Bounds bounds = model_bounds(model);
    out["positions"] = positions;
    out["vertices"] = vertices;
    out["triangles"] = triangles;
    out["meshes"] = model.meshes.size();
    out["nodes"] = model.nodes.size();
    out["bounds"] = {{"lower", array(bounds.lower)}, {"upper", array(bounds.upper)}};
    out["materials"] = Json::array();
    for (const Material& m : model.materials) out["materials"].push_back(m.name);
    out["positions_fnv1a64"] = fmt::format("{:016x}", checksum);
    std::printf("%s\n", out.dump(2, ' ', false, Json::error_handler_t::replace).c_str());
}

}  // namespace lightwalk
