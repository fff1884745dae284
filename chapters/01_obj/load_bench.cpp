#include "01_obj/load_bench.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <thread>

#include "01_obj/mapped_file.h"
#include "01_obj/truth.h"
#include "common/base/bytes.h"
#include "common/base/guarded.h"
#include "common/base/text.h"

namespace lightwalk {

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

}  // namespace

double LoaderFigures::quantile(double share) const {
    return ms[static_cast<size_t>(share * static_cast<double>(ms.size() - 1) + 0.5)];
}

std::vector<LoaderFigures> measure_loaders(const std::filesystem::path& path, int runs, size_t& bytes) {
    if (runs < 1) throw InputError("the load bench needs at least 1 run, got {}", runs);
    parse_obj(path, Loader::scan);  // reports errors in the file
    std::vector<LoaderFigures> results;
    for (const std::string_view name : loader_names()) results.emplace_back().loader = loader_from_name(name);
    {
        const MappedFile file(path);
        bytes = file.text().size();
        const ObjData expected = truth::parse(file.text());
        for (LoaderFigures& result : results) run_once(path, bytes, &expected, result);
    }
    for (int run = 0; run < runs; ++run)
        for (LoaderFigures& result : results)
            if (result.error.empty()) run_once(path, bytes, nullptr, result);
    for (LoaderFigures& result : results) std::sort(result.ms.begin(), result.ms.end());
    return results;
}

int run_load_bench(const std::filesystem::path& path, int runs) {
    size_t bytes = 0;
    const std::vector<LoaderFigures> results = measure_loaders(path, runs, bytes);
    print_table(path, bytes, runs, results);
    return 0;
}

}  // namespace lightwalk
