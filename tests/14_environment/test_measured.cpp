// Measured BRDFs: their files, what the device reads of them, random walks against closed forms, and the fit.
#include <fmt/core.h>

#include "../common/file_fixture.h"
#include "../common/module_fixture.h"
#include "14_environment/paint_error.h"
#include "14_environment/paint_walk.h"
#include "14_environment/truth.h"
#include "common/base/files.h"

using namespace lightwalk;

namespace {

constexpr double half_turn = 0.5 * truth::around;  // pi

std::string bytes_of(glm::ivec3 cells, const std::vector<double>& numbers) {
    std::string bytes(reinterpret_cast<const char*>(&cells), sizeof cells);
    return bytes.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double));
}

glm::dvec3 direction(double cosine, double azimuth) {
    const double sine = std::sqrt(1 - cosine * cosine);
    return {sine * std::cos(azimuth), sine * std::sin(azimuth), cosine};
}

/// Pairs of directions above the surface, some of them at the horizon.
std::vector<LightAndView> pairs() {
    std::vector<LightAndView> all;
    for (const double l : {0.02, 0.3, 0.7, 0.999})
        for (const double v : {0.03, 0.35, 0.75, 0.98})
            for (const double azimuth : {0.1, 0.8, 1.7, 2.4, 3.0})
                all.push_back({direction(l, 0), direction(v, azimuth)});
    return all;
}

MeasuredBrdf table_of(glm::ivec3 cells, const std::function<glm::dvec3(const LightAndView&)>& brdf) {
    MeasuredBrdf table{cells, {}};
    each_cell(cells, [&](glm::ivec3 cell) {
        const LightAndView seen = directions_of(cells, cell);
        table.values.push_back(seen.above() ? brdf(seen) : glm::dvec3(-1));
    });
    return table;
}

struct OnMeasured : OnModules {
    CarPaint paint{owner, "paint"};
    FileFolder folder;
    Scene scene;

    void load(const MeasuredBrdf& brdf) {
        write_file(folder / "paint.binary", measured_bytes(brdf));
        SceneFile file;
        file.objects = {SceneObject{.name = "paint", .parent = {}, .model = folder / "paint.binary"}};
        scene.load(gpu, file, [](const auto&) -> Model { return {}; });
        owner.prepare_all(gpu, scene);
    }
    std::vector<glm::vec3> shown(const std::string& method, const std::vector<LightAndView>& all) {
        paint.method.set(method);
        owner.begin_frame(gpu, {4, 4});
        std::vector<glm::vec3> cosines;
        for (const LightAndView& one : all)
            cosines.emplace_back(one.to_light.z, one.to_eye.z, glm::dot(one.to_light, one.to_eye));
        return looked_up(gpu, paint, cosines);
    }
};

double passed_coat(double cosine) { return 0.96 * (1 - std::pow(1 - cosine, 5)); }

}  // namespace

TEST_CASE("a measured BRDF is read from bytes, planes of red, green and blue with a scale each", "[14.measured]") {
    std::vector<double> numbers;
    for (const double scale : {1500.0, 1500 / 1.15, 1500 / 1.66})
        for (int i = 0; i < 6; ++i) numbers.push_back(scale * (i + 1));
    const std::string bytes = bytes_of({1, 2, 3}, numbers);
    const MeasuredBrdf brdf = parse_measured(bytes, "file");
    CHECK(brdf.cells == glm::ivec3(1, 2, 3));
    for (int d = 0; d < 2; ++d)
        for (int p = 0; p < 3; ++p)
            for (int c = 0; c < 3; ++c) CHECK(brdf.at({0, d, p})[c] == Approx(3 * d + p + 1).epsilon(1e-14));
    const MeasuredBrdf again = parse_measured(measured_bytes(brdf), "file");
    for (size_t i = 0; i < 6; ++i) CHECK(glm::length(again.values[i] - brdf.values[i]) < 1e-14);
    CHECK(measured_bytes(brdf).size() == bytes.size());
}

TEST_CASE("a damaged file of a measured BRDF is refused in one line", "[14.measured]") {
    const std::vector<double> numbers(36, 1.0);
    const std::string good = bytes_of({2, 2, 3}, numbers);
    CHECK(refusal_of([&] { parse_measured(good, "f.binary"); }).empty());
    const auto with = [&](size_t at, double value) {
        std::vector<double> other = numbers;
        other[at] = value;
        return bytes_of({2, 2, 3}, other);
    };
    const std::vector<std::pair<std::string, std::string>> all = {
        {"", "0 bytes: expected three integers"},
        {good.substr(0, 11), "11 bytes"},
        {good.substr(0, 12), "0 bytes behind the dimensions: 2 x 2 x 3 cells of three doubles need 288"},
        {good.substr(0, good.size() - 1), "287 bytes"},
        {good + '\0', "289 bytes"},
        {bytes_of({2, 0, 3}, numbers), "2 x 0 x 3 cells: expected 1 to 256"},
        {bytes_of({-2, -2, 3}, numbers), "-2 x -2 x 3 cells: expected 1 to 256"},
        {bytes_of({2, 2, 257}, numbers), "257 cells: expected 1 to 256"},
        {bytes_of(glm::ivec3(2147483647), numbers), "2147483647 cells: expected 1 to 256"},
        {with(20, NAN), "number 21 of 36 is nan"},
        {with(35, INFINITY), "number 36 of 36 is inf"},
        {bytes_of({2, 2, 3}, std::vector<double>(36, -1.0)), "all numbers are negative"}};
    for (const auto& [bytes, part] : all) {
        const std::string text = refusal_of([&, &b = bytes] { parse_measured(b, "f.binary"); });
        INFO(part << ": " << text);
        CHECK(text.starts_with("f.binary: "));
        CHECK(has_part(text, part));
    }
    size_t files = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(course_root() / "tests/14_environment/corpus/measured"))
        ++files, refusal_of([&] { read_measured(entry.path()); });
    CHECK(files > 3);
}

TEST_CASE_METHOD(OnMeasured,
                 "measured Lambertian paint is albedo over pi in every direction, as a volume and as a mean",
                 "[14.measured]") {
    const glm::dvec3 albedo(0.2, 0.5, 0.8);
    load(table_of({9, 7, 12}, [&](const LightAndView&) { return albedo / half_turn; }));
    for (const char* method : {"measured", "averaged"})
        for (const glm::vec3 found : shown(method, pairs()))
            for (int c = 0; c < 3; ++c) CHECK(double(found[c]) == Approx(albedo[c] / half_turn).epsilon(1e-3));
}

TEST_CASE_METHOD(OnMeasured, "a light reads a measured BRDF at the angles of half vector and difference vector",
                 "[14.measured]") {
    // What is linear in a cell's coordinates is interpolated exactly.
    MeasuredBrdf table{{20, 20, 20}, {}};
    each_cell(table.cells, [&](glm::ivec3 cell) { table.values.push_back((glm::dvec3(cell) + 0.5) / 20.0); });
    load(table);
    const std::vector<LightAndView> all = pairs();
    const std::vector<glm::vec3> found = shown("measured", all);
    size_t inside = 0;
    for (size_t i = 0; i < all.size(); ++i) {
        const glm::dvec3 half = glm::normalize(all[i].to_light + all[i].to_eye);
        const double turn = std::atan2(half.y, half.x), h = std::acos(half.z);
        // The light, turned about z by -turn and about y by -h.
        const glm::dvec3 l = all[i].to_light;
        const double x = l.x * std::cos(turn) + l.y * std::sin(turn), y = l.y * std::cos(turn) - l.x * std::sin(turn);
        const glm::dvec3 d(x * std::cos(h) - l.z * std::sin(h), y, x * std::sin(h) + l.z * std::cos(h));
        const glm::dvec3 at(std::sqrt(h / (half_turn / 2)), std::acos(d.z) / (half_turn / 2),
                            std::abs(std::atan2(d.y, d.x)) / half_turn);
        CAPTURE(l.z, all[i].to_eye.z, at.x, at.y, at.z);
        for (int c = 0; c < 3; ++c) {
            if (at[c] < 0.03 || at[c] > 0.97) continue;
            ++inside;
            CHECK(double(found[i][c]) == Approx(at[c]).margin(2e-3));
        }
    }
    CHECK(inside > 150);
}

TEST_CASE_METHOD(OnMeasured, "the measured paint is that of its walks, and light and camera can be exchanged",
                 "[14.measured]") {
    const MeasuredBrdf brdf = read_measured(find_asset("tables/flakes.binary"));
    REQUIRE(brdf.cells == glm::ivec3(30, 30, 60));
    for (const glm::ivec3 cell :
         {glm::ivec3(0), glm::ivec3(5, 10, 20), glm::ivec3(15, 4, 29), glm::ivec3(20, 12, 31)}) {
        const glm::ivec3 first(cell.x, cell.y, std::min(cell.z, 59 - cell.z));
        const glm::dvec3 walked = walked_brdf({}, directions_of(brdf.cells, first), 1024);
        for (int c = 0; c < 3; ++c) CHECK(brdf.at(cell)[c] == Approx(walked[c]).epsilon(1e-6));
    }
    load(brdf);
    std::vector<LightAndView> all = pairs();
    const std::vector<glm::vec3> there = shown("measured", all);
    for (LightAndView& one : all) std::swap(one.to_light, one.to_eye);
    const std::vector<glm::vec3> back = shown("measured", all);
    for (size_t i = 0; i < all.size(); ++i) CHECK(glm::length(there[i] - back[i]) < 2e-3f * glm::length(there[i]));
    // The small table has the mean over the azimuth.
    std::vector<LightAndView> turned;
    for (int i = 0; i < 256; ++i)
        turned.push_back({direction(40 / 63.0, 0), direction(20 / 63.0, (i + 0.5) / 256 * half_turn)});
    glm::vec3 mean(0);
    for (const glm::vec3 one : shown("measured", turned)) mean += one / 256.0f;
    CHECK(glm::length(shown("averaged", turned)[0] - mean) < 2e-3f * glm::length(mean));
    for (const char* method : {"averaged", "fit", "measured"}) {
        paint.method.set(method);
        fmt::print("{}: {:.3f} over directions, {} bytes\n", method, direction_error(gpu, paint), paint.bytes());
    }
    CHECK(direction_error(gpu, paint) < 0.03);
}

TEST_CASE("random walks: isotropic particles as Chandrasekhar's H functions have them", "[14.measured]") {
    WalkedPaint paint{.pigment = {0.9, 0.5, 0.2}, .flakes = 0, .index = 1};
    constexpr int nodes = 400;
    for (int c = 0; c < 3; ++c) {
        // S. Chandrasekhar, Radiative Transfer, 1950: H by iteration over its own integral.
        const double a = paint.pigment[c];
        std::vector<double> h(nodes, 1);
        const auto next = [&](double mu) {
            double sum = 0;
            for (int i = 0; i < nodes; ++i) sum += (i + 0.5) / nodes * h[size_t(i)] / (mu + (i + 0.5) / nodes) / nodes;
            return 1 / (std::sqrt(1 - a) + 0.5 * a * sum);
        };
        for (int round = 0; round < 30; ++round) {
            std::vector<double> better(nodes);
            for (int i = 0; i < nodes; ++i) better[size_t(i)] = next((i + 0.5) / nodes);
            h = better;
        }
        for (const auto& [l, v] : {std::pair(1.0, 0.8), std::pair(0.3, 0.7), std::pair(0.15, 0.2)}) {
            const double right = a / (4 * half_turn) * next(l) * next(v) / (l + v);
            CAPTURE(a, l, v);
            CHECK(walked_brdf(paint, {direction(l, 0), direction(v, 1.9)}, 40000)[c] == Approx(right).epsilon(0.02));
        }
    }
}

TEST_CASE("random walks: one collision in closed form, and light and camera can be exchanged", "[14.measured]") {
    WalkedPaint dark{.pigment = glm::dvec3(1e-4), .flake = glm::dvec3(2e-4), .flakes = 0.4, .alpha = 0.3};
    for (const auto& [l, v] : {std::pair(0.9, 0.8), std::pair(0.3, 0.7), std::pair(0.2, 0.15)}) {
        const LightAndView seen{direction(l, 0), direction(v, 2.2)};
        const auto below = [&](glm::dvec3 w) {
            return glm::dvec3(w.x / 1.5, w.y / 1.5, std::sqrt(1 - (1 - w.z * w.z) / 2.25));
        };
        const auto passed = [](double c) {
            const double t = std::sqrt(1 - (1 - c * c) / 2.25), s = (c - 1.5 * t) / (c + 1.5 * t);
            const double p = (t - 1.5 * c) / (t + 1.5 * c);
            return 1 - 0.5 * (s * s + p * p);
        };
        const auto density = [](glm::dvec3 w) { return 0.6 + 0.4 * std::sqrt(0.09 * (1 - w.z * w.z) + w.z * w.z); };
        const glm::dvec3 in = below(seen.to_light), out = below(seen.to_eye), m = glm::normalize(in + out);
        const double normals = 1 / (half_turn * 0.09 * std::pow((1 - m.z * m.z) / 0.09 + m.z * m.z, 2));
        const double right = passed(l) * passed(v) / 2.25 * (0.6 * 1e-4 / (4 * half_turn) + 0.4 * 2e-4 * normals / 4) /
                             (density(in) * out.z + density(out) * in.z);
        CAPTURE(l, v);
        CHECK(walked_brdf(dark, seen, 40000).r == Approx(right).epsilon(0.01));
        const glm::dvec3 there = walked_brdf({}, seen, 100000),
                         back = walked_brdf({}, {seen.to_eye, seen.to_light}, 100000);
        for (int c = 0; c < 3; ++c) CHECK(there[c] == Approx(back[c]).epsilon(0.02));
    }
}

TEST_CASE_METHOD(OnMeasured, "the fit finds the layers that a table was made from, and the device draws them",
                 "[14.measured]") {
    const glm::dvec3 color(0.4, 0.2, 0.1), edge(0.1, 0.05, 0.2), flakes(0.3, 0.6, 0.9);
    const double a2 = std::pow(0.55, 4);
    const MeasuredBrdf table = table_of({30, 24, 36}, [&](const LightAndView& seen) {
        const double n_dot_l = seen.to_light.z, n_dot_v = seen.to_eye.z;
        const auto refracted = [](glm::dvec3 w) {
            return glm::dvec3(w.x / 1.5, w.y / 1.5, std::sqrt(1 - (1 - w.z * w.z) / 2.25));
        };
        const glm::dvec3 l = refracted(seen.to_light), v = refracted(seen.to_eye), h = glm::normalize(l + v);
        const double way = std::clamp(3 * (0.5 / l.z + 0.5 / v.z - 1), 0.0, 1.0);
        const double lobe = a2 / (half_turn * std::pow(h.z * h.z * (a2 - 1) + 1, 2)) *
                            truth::ggx_visibility(l.z, v.z, std::sqrt(a2)) / 2.25;
        return passed_coat(n_dot_l) * passed_coat(n_dot_v) *
               (0.5 * glm::mix(color, edge, way) / half_turn + 0.5 * flakes * lobe);
    });
    const PaintFit fit = fit_paint(table);
    CHECK(fit.flake_roughness == Approx(0.55));
    for (int c = 0; c < 3; ++c) {
        CHECK(double(fit.color[c]) == Approx(color[c]).margin(1e-3));
        CHECK(double(fit.edge_color[c]) == Approx(edge[c]).margin(1e-3));
        CHECK(double(fit.flake_color[c]) == Approx(flakes[c]).margin(1e-3));
    }
    load(table);
    std::vector<LightAndView> all;
    std::vector<glm::dvec3> right;
    each_cell(table.cells, [&](glm::ivec3 cell) {
        const LightAndView seen = directions_of(table.cells, cell);
        if (seen.above()) all.push_back(seen), right.push_back(table.at(cell));
    });
    const std::vector<glm::vec3> found = shown("fit", all);
    for (size_t i = 0; i < all.size(); i += 97)
        CHECK(glm::length(glm::dvec3(found[i]) - right[i]) < 0.01 * glm::length(right[i]));
}
