// Lamps on microfacets: their tables, the energy of all scattering, and the shapes of lamps.
#include <fmt/core.h>

#include <random>

#include "../common/module_fixture.h"
#include "03_attenuation/lights.h"
#include "04_surface_maps/maps.h"
#include "04_surface_maps/truth.h"

using namespace lightwalk;

namespace {

constexpr double half_turn = 3.14159265358979323846;

/// A surface at a point, its normal up along z.
struct LitRow {
    glm::vec3 to_eye, f0, body;
    float alpha;
    glm::vec3 to_light{0, 0, 1};  ///< for what is summed over views
    uint32_t has_metalness = 0;
};

struct OnSurface : OnModules {
    SurfaceModel surface{owner, "surface"};
    LampShapes shapes{owner, "lamps"};
    Lights lights{owner, "lights"};
    Pipeline look;

    OnSurface()
        : look(compute_pipeline("look at lit surfaces", R"(
#include "04_surface_maps/coat.glsl"
#include "03_attenuation/unshadowed.glsl"
layout(local_size_x = 64) in;
struct LitRow { vec3 to_eye, f0, body; float alpha; vec3 to_light; uint has_metalness; };
layout(scalar) readonly buffer RowBuffer { LitRow rows[]; };
layout(scalar) writeonly buffer LitBuffer { vec3 lit[]; };
layout(scalar) uniform FurnaceBlock { int furnace; };  // 0 lights, 1 lamps all around, 2 views all around, 3 one BRDF
const int steps = 300, turns = 128;  // lavapipe ends loops after 65,535 iterations
void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= uint(rows.length())) return;
    Surface surface = Surface(vec3(0.0, 0.0, 1.0), rows[i].to_eye, shininess_of(0.0, rows[i].alpha), vec3(0.0, 0.0, 1.0));
    coat_surface(surface, rows[i].f0, rows[i].body, rows[i].has_metalness == 1u);
    vec3 diffuse = vec3(0.0), specular = vec3(0.0);
    Reflected pair = reflect_light(surface, rows[i].to_light);
    if (furnace == 3) {
        diffuse = pair.diffuse / rows[i].to_light.z;
        specular = pair.specular / rows[i].to_light.z;
    }
    if (furnace == 0) {
        Lit all = light_surface(surface, surface.normal, vec3(0.0), 0u, vec4(0.0));
        diffuse = all.diffuse;
        specular = all.specular;
    }
    // Lamps of radiance 1 from everywhere, dense about the mirrored direction.
    vec3 from = furnace == 2 ? rows[i].to_light : surface.to_eye;
    vec3 mirrored = reflect(-from, surface.normal), side = vec3(0.0, 1.0, 0.0), up = cross(mirrored, side);
    for (int s = 0; s < (furnace % 3 == 0 ? 0 : steps); ++s) {
        float at = (float(s) + 0.5) / float(steps), angle = pi * at * at * at;
        float ring = sin(angle) * 3.0 * pi * at * at / float(steps) * 2.0 / float(turns);
        for (int t = 0; t < turns; ++t) {
            float turn = 2.0 * pi * (float(t) + 0.5) / float(turns);
            vec3 to_light = cos(angle) * mirrored + sin(angle) * (cos(turn) * side + sin(turn) * up);
            float weight = ring;
            if (furnace == 2) {  // that direction is the view
                if (to_light.z <= 0.0) continue;
                weight = ring * to_light.z / rows[i].to_light.z;
                surface.to_eye = to_light;
                coat_surface(surface, rows[i].f0, rows[i].body, rows[i].has_metalness == 1u);
                to_light = rows[i].to_light;
            }
            Reflected one = reflect_light(surface, to_light);
            diffuse += weight * one.diffuse;
            specular += weight * one.specular;
        }
    }
    lit[i] = rows[i].body * diffuse + specular_factor(rows[i].f0) * specular;
})")) {
        lights.method.set("every_light");
        lights.falloff.set("inverse_square");
    }

    std::vector<glm::vec3> lit(const std::vector<LitRow>& rows, const std::vector<Light>& lamps, int furnace = 0) {
        begin({4, 4});
        Scene scene;
        surface.prepare(gpu, scene);
        lights.update(frame, scene, lamps);
        const Buffer in = gpu.upload("rows", rows), out(gpu.device, {.name = "lit", .bytes = 12 * rows.size()});
        frame.compute("look", {.reads = {in}, .writes = {out}, .with = {surface, shapes, lights}}, [&](Compute& pass) {
            pass.use(look, {{"SURFACE_GGX", "1"}}).set("rows", in).set("lit", out).set("furnace", furnace);
            pass.dispatch_threads(glm::uvec2(static_cast<uint32_t>(rows.size()), 1));
        });
        frame.end();
        return read<glm::vec3>(out);
    }
};

glm::vec3 seen_at(double n_dot_v) { return {std::sqrt(1 - n_dot_v * n_dot_v), 0, n_dot_v}; }

/// White light that leaves after one microfacet, by its direction; interpolated between integrals.
struct Albedo {
    std::vector<double> at;
    double mean = 0;

    explicit Albedo(double alpha) {
        for (int i = 0; i <= 64; ++i) at.push_back(truth::white_reflection(std::max(i / 64.0, 1e-3), alpha, 1));
        for (int i = 0; i < 64; ++i) mean += (i + 0.5) / 32 / 64 * 0.5 * (at[i] + at[i + 1]);
    }
    double of(double cosine) const {
        const double x = 64 * std::clamp(cosine, 0.0, 1.0);
        const int i = std::min(int(x), 63);
        return at[i] + (x - i) * (at[i + 1] - at[i]);
    }
    /// BRDF times pi of light that leaves after several microfacets: C. Kulla and A. Conty, SIGGRAPH course, 2017.
    double several(double l, double v, double f0) const {
        const double f = f0 + (1 - f0) / 21;
        return f * f * mean / (1 - f * (1 - mean)) * (1 - of(l)) * (1 - of(v)) / (1 - mean);
    }
};

/// Radiance of a metal under a lamp that is a disc facing the point or a strip, by a sum over its area; 1 for a white matt
/// surface that faces its middle.
double under_lamp(const Light& lamp, double n_dot_v, double alpha, double f0, const Albedo& albedo) {
    const glm::dvec3 middle(lamp.position), v(seen_at(n_dot_v)), tube(lamp.tube_m);
    const bool is_tube = glm::length(tube) > 0;
    const double radius = 0.5 * double(lamp.size_m), away = glm::dot(middle, middle);
    const glm::dvec3 axis = is_tube                                      ? tube
                            : std::abs(middle.y) < 0.9 * std::sqrt(away) ? glm::dvec3(0, 1, 0)
                                                                         : glm::dvec3(1, 0, 0);
    const glm::dvec3 x = radius * glm::normalize(glm::cross(middle, axis));
    const glm::dvec3 y = is_tube ? 0.5 * tube : radius * glm::normalize(glm::cross(x, middle));
    const double area = is_tube ? 4 * radius * glm::length(y) : half_turn * radius * radius;
    const double radiance = double(lamp.intensity) * half_turn / area * (is_tube ? 1 : 1 + radius * radius / away);
    const glm::dvec3 facing = glm::normalize(glm::cross(x, y));
    double sum = 0;
    const int side = 400;
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j) {
            const double a = 2 * (i + 0.5) / side - 1, b = 2 * (j + 0.5) / side - 1;
            if (!is_tube && a * a + b * b > 1) continue;
            const glm::dvec3 to = middle + a * x + b * y, l = glm::normalize(to);
            const double angle = 4 * glm::length(x) * glm::length(y) / (double(side) * side) *
                                 std::abs(glm::dot(facing, l)) / glm::dot(to, to);
            if (l.z <= 0) continue;
            sum += angle * (truth::ggx(l, v, alpha, f0) + albedo.several(l.z, n_dot_v, f0) / half_turn * l.z);
        }
    return radiance * sum;
}

Light disc(glm::vec3 position, float size_m) {
    return {.kind = Light::Kind::point, .position = position, .size_m = size_m};
}

}  // namespace

TEST_CASE_METHOD(OnSurface, "the table of GGX holds the split sum, by integrals apart from its fit", "[04.ggx_table]") {
    const ImageRgb table = read_pfm(find_asset("tables/ggx.pfm"));
    for (const int row : {20, 32, 45, 63})
        for (const int column : {1, 4, 12, 30, 50, 63}) {
            const double alpha = std::pow(row / 63.0, 2), n_dot_v = 1 - std::pow(1 - column / 63.0, 2);
            const double both = truth::white_reflection(n_dot_v, alpha, 1),
                         b = truth::white_reflection(n_dot_v, alpha, 0);
            INFO("alpha " << alpha << ", n.v " << n_dot_v);
            const glm::vec3 found = table.at(column, 64 + row);
            CHECK(double(found.y) == Approx(both - b).margin(4e-3));
            CHECK(double(found.z) == Approx(b).margin(4e-3));
        }
}

// Light that leaves over all lamps' directions: all of it, from a coat that absorbs none over a white body.
TEST_CASE_METHOD(OnSurface, "in a furnace of lamps nothing is lost and nothing is made", "[04.lamp_furnace]") {
    std::vector<LitRow> rows;
    for (const double alpha : {0.04, 0.25, 0.64, 1.0})
        for (const double n_dot_v : {0.1, 0.5, 0.99})
            for (const float f0 : {0.04f, 0.5f, 1.0f})
                rows.push_back({seen_at(n_dot_v), glm::vec3(f0), glm::vec3(1), float(alpha)});
    for (const char* body : {"lambert", "oren_nayar"}) {
        surface.body.set(body);
        const auto found = lit(rows, {}, 1);
        for (size_t i = 0; i < rows.size(); ++i) {
            INFO(body << ", alpha " << rows[i].alpha << ", n.v " << rows[i].to_eye.z << ", f0 " << rows[i].f0.x);
            CHECK(double(found[i].x) == Approx(1).margin(0.012));
        }
    }
    // Gold over black, and a grey rough body without a coat worth the name.
    surface.body.set("oren_nayar");
    const auto found = lit({{seen_at(0.3), {1, 0.71f, 0.29f}, glm::vec3(0), 0.64f}}, {}, 1);
    const Albedo albedo(0.64);
    const double f = 0.71 + 0.29 / 21,
                 several = f * f * albedo.mean / (1 - f * (1 - albedo.mean)) * (1 - albedo.of(0.3));
    CHECK(double(found[0].y) == Approx(truth::white_reflection(0.3, 0.64, 0.71) + several).epsilon(0.01));
}

// glTF 2.0, appendix B: the light of the metal and of the plastic, each of the base colour, by their shares.
TEST_CASE_METHOD(OnSurface, "metalness blends the light of metal and plastic: white returns all of a furnace's light",
                 "[04.metalness]") {
    const auto mixed = [](glm::vec3 base, float metalness, double n_dot_v, float alpha) {
        return LitRow{.to_eye = seen_at(n_dot_v),
                      .f0 = 0.04f * (1 - metalness) + metalness * base,
                      .body = (1 - metalness) * base,
                      .alpha = alpha,
                      .has_metalness = 1};
    };
    for (const float alpha : {0.04f, 0.25f, 1.0f})
        for (const double n_dot_v : {0.1, 0.5, 0.99}) {
            const glm::vec3 base(0.9f, 0.5f, 0.03f);
            const auto ends = lit({mixed(base, 0, n_dot_v, alpha), mixed(base, 1, n_dot_v, alpha)}, {}, 1);
            for (const float metalness : {0.0f, 0.1f, 0.5f, 0.9f, 1.0f}) {
                INFO("alpha " << alpha << ", n.v " << n_dot_v << ", metalness " << metalness);
                const auto found = lit(
                    {mixed(glm::vec3(1), metalness, n_dot_v, alpha), mixed(base, metalness, n_dot_v, alpha)}, {}, 1);
                CHECK(double(found[0].x) == Approx(1).margin(0.012));
                for (int i = 0; i < 3; ++i)
                    CHECK(double(found[1][i]) ==
                          Approx(double(glm::mix(ends[0], ends[1], metalness)[i])).margin(0.002));
            }
        }
}

TEST_CASE_METHOD(OnSurface, "one lamp: no more light leaves than arrives, and lamp and camera can be exchanged",
                 "[04.one_lamp]") {
    std::vector<LitRow> rows, swapped;
    for (const double roughness : {0.15, 0.5, 1.0})
        for (const double degrees : {0.0, 60.0, 85.0, 88.0})
            for (const float f0 : {0.04f, 1.0f})
                rows.push_back({.to_eye = seen_at(0.5),
                                .f0 = glm::vec3(f0),
                                .body = glm::vec3(f0 < 1 ? 1 : 0),
                                .alpha = float(roughness * roughness),
                                .to_light = seen_at(std::cos(degrees * half_turn / 180))});
    for (const LitRow& row : rows) {
        swapped.push_back(row);
        std::swap(swapped.back().to_eye, swapped.back().to_light);
    }
    for (const char* body : {"lambert", "oren_nayar"}) {
        surface.body.set(body);
        const auto leaves = lit(rows, {}, 2), one = lit(rows, {}, 3), other = lit(swapped, {}, 3);
        double most = 0, least = 1;
        for (size_t i = 0; i < rows.size(); ++i) {
            INFO(body << ", alpha " << rows[i].alpha << ", n.l " << rows[i].to_light.z << ", f0 " << rows[i].f0.x);
            CHECK(leaves[i].x < 1.01f);
            CHECK(one[i].x == Approx(double(other[i].x)).epsilon(0.002).margin(1e-5));
            most = std::max(most, double(leaves[i].x));
            least = std::min(least, double(leaves[i].x));
        }
        fmt::print("{}: {:.3f} to {:.3f} of one lamp's light leaves\n", body, least, most);
    }
}

TEST_CASE_METHOD(OnSurface, "lamps with a size against sums over their area", "[04.lamp_shapes]") {
    const std::vector<Light> lamps{
        disc({-1.2f, 0, 1.6f}, 0.6f),
        disc({-1.5f, 0.3f, 0.4f}, 1.2f),
        disc({0.4f, 0.9f, 1.1f}, 2.0f),
        {.kind = Light::Kind::point, .position = {-1.2f, 0, 1.6f}, .size_m = 0.1f, .tube_m = {0.3f, 1.5f, 0}}};
    shapes.samples.value = 4096;
    double off[3] = {}, sum = 0;
    for (const double alpha : {0.04, 0.25, 0.64}) {
        const Albedo albedo(alpha);
        for (const Light& lamp : lamps)
            for (const double n_dot_v : {0.3, 0.8}) {
                const double expected = under_lamp(lamp, n_dot_v, alpha, 0.9, albedo);
                sum += expected;
                for (int method = 0; method < 3; ++method) {
                    shapes.method.index = size_t(method) + 1;
                    const double found =
                        lit({{seen_at(n_dot_v), glm::vec3(0.9f), glm::vec3(0), float(alpha)}}, {lamp})[0].x;
                    off[method] += std::abs(found - expected);
                    UNSCOPED_INFO(shapes.method.text() << " " << lamp.position.z << " " << n_dot_v << " " << alpha
                                                       << ": " << found << " for " << expected);
                }
            }
    }
    CAPTURE(sum, off[0] / sum, off[1] / sum, off[2] / sum);
    CHECK(off[2] < 0.005 * sum);
    CHECK(off[1] < 0.05 * sum);
    CHECK(off[0] > 3 * off[1]);
}

// A sum over several lamps hides what a single one may err by, beside the lobe most of all.
TEST_CASE_METHOD(OnSurface, "ltc for single random discs: a quarter of the light in the median, half of it at worst",
                 "[04.random_lamps][figures]") {
    std::mt19937 random(4);
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * (double(random()) / 4294967296.0);
    };
    const double alphas[] = {0.04, 0.25, 0.64};
    const Albedo albedos[] = {Albedo(alphas[0]), Albedo(alphas[1]), Albedo(alphas[2])};
    shapes.samples.value = 4096;
    std::vector<double> off[2];  // ltc, sampled
    double difference = 0, sum = 0;
    for (int i = 0; i < 40; ++i) {
        const double up = uniform(0.15, 1), turn = uniform(0, 2 * half_turn), away = uniform(1, 3),
                     n_dot_v = uniform(0.2, 0.95), across = std::sqrt(1 - up * up);
        const Light lamp = disc(glm::vec3(away * glm::dvec3(across * std::cos(turn), across * std::sin(turn), up)),
                                float(uniform(0.2, 1.5)));
        const double expected = under_lamp(lamp, n_dot_v, alphas[i % 3], 0.9, albedos[i % 3]);
        for (const int method : {0, 1}) {
            shapes.method.set(method == 0 ? "ltc" : "sampled");
            const double found =
                lit({{seen_at(n_dot_v), glm::vec3(0.9f), glm::vec3(0), float(alphas[i % 3])}}, {lamp})[0].x;
            off[method].push_back(std::abs(found / expected - 1));
            if (method == 0) difference += std::abs(found - expected);
        }
        sum += expected;
    }
    for (const int method : {0, 1}) {
        std::sort(off[method].begin(), off[method].end());
        fmt::print("{}, 40 random discs: median {:.3f}, worst {:.3f}\n", method == 0 ? "ltc" : "sampled",
                   off[method][20], off[method][39]);
    }
    fmt::print("ltc, sum of the differences over the sum of the light: {:.3f}\n", difference / sum);
    CHECK(off[1][20] < 0.005);
    CHECK(off[0][20] < 0.3);
    CHECK(off[0][39] < 0.7);
}

TEST_CASE_METHOD(OnSurface, "a lamp's shape at its limits", "[04.lamp_limits]") {
    const LitRow row{seen_at(0.6), glm::vec3(0.5f), glm::vec3(0.4f), 0.25f};
    const auto by = [&](const char* method, const LitRow& at, const Light& lamp) {
        shapes.method.set(method);
        return double(lit({at}, {lamp})[0].x);
    };
    for (const char* method : {"representative", "ltc", "sampled"}) {
        INFO(method);
        // No size: a point, to the bit. A small one: nearly.
        CHECK(by(method, row, disc({-0.8f, 0, 0.6f}, 0)) == by("point", row, disc({-0.8f, 0, 0.6f}, 0)));
        CHECK(by(method, row, disc({-8, 0, 6}, 0.05f)) ==
              Approx(by("point", row, disc({-8, 0, 6}, 0.05f))).epsilon(0.03));
        // Matt white that faces any disc shows the light's own radiance.
        const LitRow matt{seen_at(1), glm::vec3(0), glm::vec3(1), 1.0f};
        const double flat = by("point", matt, disc({0, 0, 1}, 0));
        CHECK(by(method, matt, disc({0, 0, 1}, 1.5f)) ==
              Approx(flat).epsilon(std::string(method) == "representative" ? 0.1 : 0.02));
        // At grazing angles, the smoothest surface, a tube that points at the surface: numbers.
        for (const float alpha : {1e-6f, 1.0f})
            for (const double n_dot_v : {0.0, 1e-4, 1.0})
                for (const glm::vec3 tube : {glm::vec3(0), glm::vec3(0, 0, 1), glm::vec3(1, 0, 0)}) {
                    Light lamp = disc({0, 0, 1}, 0.2f);
                    lamp.tube_m = tube;
                    const double found = by(method, {seen_at(n_dot_v), glm::vec3(0.5f), glm::vec3(0.5f), alpha}, lamp);
                    CHECK((std::isfinite(found) && found >= 0));
                }
    }
    // The middle is below the horizon and part of the disc above it: a point is dark, the shapes are not.
    const Light low = disc({-1, 0, -0.1f}, 1.0f);
    CHECK(by("point", row, low) == 0);
    CHECK(by("ltc", row, low) == Approx(by("sampled", row, low)).epsilon(0.6));  // at grazing angles cosines are poor
    CHECK(by("ltc", row, low) > 0.01);
    // A matt surface has the cosine lobe itself: what is left of a lamp that sinks is exact.
    const LitRow matt{seen_at(0.6), glm::vec3(0), glm::vec3(1), 1.0f};
    for (const float height : {-0.3f, -0.1f, 0.05f, 0.2f, 0.45f}) {
        INFO(height);
        const Light sinking = disc({-1, 0, height}, 1.0f);
        CHECK(by("ltc", matt, sinking) == Approx(by("sampled", matt, sinking)).epsilon(0.03));
    }
}
