// Where the methods of chapter 06 fail: a bound where they hold, the size of the failure where they do not.
#include <glm/gtc/packing.hpp>

#include "03_attenuation/lights.h"
#include "06_deferred/deferred_lights.h"
#include "06_deferred/gbuffer.h"
#include "06_deferred/truth.h"
#include "catch.h"
#include "common/check/check.h"

using namespace lightwalk;

namespace {

// Evenly over the sphere (Fibonacci's spiral).
std::vector<glm::dvec3> sphere(int count) {
    std::vector<glm::dvec3> all;
    for (int i = 0; i < count; ++i) {
        const double z = 1.0 - (2.0 * i + 1.0) / count, r = std::sqrt(1.0 - z * z), a = 2.399963229728653 * i;
        all.emplace_back(r * std::cos(a), r * std::sin(a), z);
    }
    return all;
}

struct Error {
    double mean = 0, most = 0;
};

template <class Through>
Error error_of(const Through& through) {
    static const std::vector<glm::dvec3> all = sphere(200000);
    Error error;
    for (const glm::dvec3& n : all) {
        const double deg = truth::angle_deg(through(n), n);
        error.mean += deg / static_cast<double>(all.size());
        error.most = std::max(error.most, deg);
    }
    return error;
}

glm::dvec2 unorm(glm::dvec2 v, double most) { return glm::round((0.5 + 0.5 * v) * most) / most * 2.0 - 1.0; }
glm::dvec3 unorm(glm::dvec3 v, double most) { return glm::round((0.5 + 0.5 * v) * most) / most * 2.0 - 1.0; }

double half_of(double x) { return double(glm::unpackHalf1x16(glm::packHalf1x16(static_cast<float>(x)))); }

constexpr double near_m = 0.1, far_m = 1000;

// The greatest relative error of z within 5 % of `z`, which of 16 bits has several steps, where depth(z) is stored by
// `store` and z_of() takes it back.
template <class Depth, class Store, class Back>
double worst_z(double z, const Depth& depth, const Store& store, const Back& z_of) {
    double most = 0;
    for (int i = 0; i < 10000; ++i) {
        const double at = z * (0.95 + 0.1 * i / 10000);
        most = std::max(most, std::fabs(z_of(store(depth(at))) - at) / at);
    }
    return most;
}

double standard(double z) { return far_m * (z - near_m) / (z * (far_m - near_m)); }
double from_standard(double d) { return far_m * near_m / (far_m - d * (far_m - near_m)); }
double reversed(double z) { return near_m * (far_m - z) / (z * (far_m - near_m)); }
double from_reversed(double d) { return far_m * near_m / (near_m + d * (far_m - near_m)); }
double as_float(double x) { return double(static_cast<float>(x)); }
double as_16_bits(double x) { return std::round(x * 65535) / 65535; }

}  // namespace

TEST_CASE("what normals lose in each encoding, over the whole sphere", "[06.normal_error]") {
    const auto octahedral = [](int bits) {
        return [bits](glm::dvec3 n) { return truth::decode_normal(truth::quantised(truth::encode_normal(n), bits)); };
    };
    struct Known {
        const char* name;
        Error found;
        double mean, most;  // degrees
    };
    const Known all[] = {
        {"octahedral 8 + 8", error_of(octahedral(8)), 0.337, 0.94},
        {"octahedral 12 + 12", error_of(octahedral(12)), 0.021, 0.058},
        {"octahedral 16 + 16", error_of(octahedral(16)), 0.0013, 0.0036},
        {"octahedral 4 + 4", error_of(octahedral(4)), 6.1, 17.4},
        {"octahedral 5 + 5", error_of(octahedral(5)), 2.85, 8.0},
        {"xyz in 8 bits", error_of([](glm::dvec3 n) { return glm::normalize(unorm(n, 255)); }), 0.169, 0.38},
        {"xyz in 10 bits", error_of([](glm::dvec3 n) { return glm::normalize(unorm(n, 1023)); }), 0.042, 0.094},
        {"xyz as halves",
         error_of([](glm::dvec3 n) { return glm::normalize(glm::dvec3(half_of(n.x), half_of(n.y), half_of(n.z))); }),
         0.006, 0.023},
        {"spheremap 8 + 8", error_of([](glm::dvec3 n) {
             // M. Mittring, "A bit more Deferred", 2009: the direction of x and y, as long as the root of (1 + z) / 2.
             const glm::dvec2 xy = glm::normalize(glm::dvec2(n)) * std::sqrt(0.5 - 0.5 * n.z), e = unorm(xy, 255);
             const double z = 1 - 2 * glm::dot(e, e), across = std::sqrt(std::max(0.0, 1 - z * z));
             return glm::normalize(glm::dvec3(across * e / std::max(glm::length(e), 1e-12), z));
         }),
         0.49, 11.4}};
    for (const Known& k : all) {
        INFO(k.name << ": mean " << k.found.mean << ", most " << k.found.most << " degrees");
        CHECK(k.found.mean == Approx(k.mean).epsilon(0.06));
        CHECK(k.found.most == Approx(k.most).epsilon(0.1));
        WARN(k.name << ": mean " << k.found.mean << ", most " << k.found.most << " degrees");
    }
    // x and y alone, z by the root, have no room for z below 0.
    const Error upper = error_of([](glm::dvec3 n) {
        if (n.z < 0) return n;
        const glm::dvec2 e = unorm(glm::dvec2(n), 255);
        return glm::normalize(glm::dvec3(e, std::sqrt(std::max(0.0, 1 - glm::dot(e, e)))));
    });
    WARN("x and y in 8 bits, z above 0: mean " << 2 * upper.mean << ", most " << upper.most << " degrees");
    CHECK(upper.most > 4);
}

TEST_CASE("what depth buffers know of z, from 0.1 m to 1000 m", "[06.depth_error]") {
    struct Known {
        const char* name;
        double found[3], most[3];  // relative, at 10, 100 and 500 m
    };
    Known all[] = {{"D16", {}, {8e-4, 8e-3, 4e-2}},
                   {"D32F standard", {}, {3e-6, 3e-5, 1.5e-4}},
                   {"D32F reversed", {}, {6e-8, 6e-8, 6e-8}},
                   {"R16F, z itself", {}, {5e-4, 5e-4, 5e-4}}};
    const double at[] = {10, 100, 500};
    for (int i = 0; i < 3; ++i) {
        all[0].found[i] = worst_z(at[i], standard, as_16_bits, from_standard);
        all[1].found[i] = worst_z(at[i], standard, as_float, from_standard);
        all[2].found[i] = worst_z(at[i], reversed, as_float, from_reversed);
        all[3].found[i] = worst_z(
            at[i], [](double z) { return z; }, half_of, [](double z) { return z; });
    }
    for (const Known& k : all)
        for (int i = 0; i < 3; ++i) {
            WARN(k.name << " at " << at[i] << " m: " << k.found[i]);
            CHECK(k.found[i] <= 1.25 * k.most[i]);
            CHECK(k.found[i] >= 0.2 * k.most[i]);
        }
    // The matrix in single precision adds its own rounding: relative to the eye it is small, in the world it grows with
    // how far the eye is from the origin.
    CHECK(all[2].found[2] < 1e-3 * all[1].found[2]);
}

TEST_CASE("positions from depth are exact to a millionth of the distance, and to what the eye's own position is") {
    for (const float away_m : {0.0f, 1000.0f, 100000.0f}) {
        const Camera camera{.position = {away_m, 2, 0}, .target = {away_m, 2, -1}, .near_m = 0.1f, .far_m = 1000};
        glm::dmat4 projection(0.0), move(1.0);
        const double f = 1 / std::tan(0.4);
        projection[0][0] = f;
        projection[1][1] = -f;
        projection[2][2] = near_m / (far_m - near_m);
        projection[2][3] = -1;
        projection[3][2] = near_m * far_m / (far_m - near_m);
        move[3] = glm::dvec4(-glm::dvec3(camera.position), 1);
        const glm::mat4 whole(projection * move);
        const glm::mat4 back = clip_to_offset(whole, camera.position);
        for (const double z : {0.2, 10.0, 100.0, 500.0}) {
            const float depth = static_cast<float>(reversed(z));
            const glm::vec4 h = back * glm::vec4(0.3f, -0.2f, depth, 1.0f);
            const glm::dvec3 found = glm::dvec3(glm::vec3(h)) / double(h.w);
            const glm::dvec3 right(0.3 * z / f, 0.2 * z / f, -z);
            INFO(away_m << " m from the origin, z " << z);
            CHECK(glm::distance(found, right) < 1e-6 * z + 1e-7 * double(away_m));
        }
    }
}

TEST_CASE("the sign of the area on the screen is wrong where a corner is behind the eye, and n.p never is",
          "[06.back_faces]") {
    Random random;
    int behind = 0, wrong = 0;
    for (int i = 0; i < 20000; ++i) {
        const auto point = [&] {
            return glm::dvec3(random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-6, 2));
        };
        const glm::dvec3 a = point(), b = point(), c = point();
        const int corners = (a.z > 0) + (b.z > 0) + (c.z > 0);
        if (corners == 0 || corners == 3) continue;
        ++behind;
        const auto screen = [](glm::dvec3 p) { return glm::dvec2(p) / -p.z; };
        const glm::dvec2 e = screen(b) - screen(a), f = screen(c) - screen(a);
        wrong += (e.x * f.y - e.y * f.x < 0) != (truth::faces_away(a, b, c, false) > 0);
    }
    WARN("of " << behind << " triangles with one or two corners behind the eye the area turns " << wrong << " around");
    CHECK(wrong > 0.3 * behind);
}

TEST_CASE("light volumes hold what their light reaches, and little more") {
    for (const auto shape : {LightVolume::Shape::sphere, LightVolume::Shape::cone}) {
        const std::vector<glm::vec3> mesh = volume_mesh(shape);
        double volume = 0, nearest = 1e9;
        for (size_t i = 0; i < mesh.size(); i += 3) {
            const glm::dvec3 a(mesh[i]), b(mesh[i + 1]), c(mesh[i + 2]);
            volume += glm::dot(a, glm::cross(b, c)) / 6;
            if (shape == LightVolume::Shape::sphere)
                nearest = std::min(nearest, glm::dot(a, glm::normalize(glm::cross(b - a, c - a))));
        }
        const double ideal = shape == LightVolume::Shape::sphere ? 4.18879 : 1.04720;
        CHECK(volume > ideal);  // counter-clockwise from outside, and around the ideal
        CHECK(volume < 1.2 * ideal);
        if (shape == LightVolume::Shape::sphere) CHECK(nearest >= 1.0);
    }
}
