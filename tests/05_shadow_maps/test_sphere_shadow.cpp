// Shadows between a sphere and its ring against solid angles in double precision, and where such formulas break.
#include <algorithm>
#include <cmath>

#include "05_shadow_maps/lit_stage.h"
#include "05_shadow_maps/ray_truth.h"
#include "catch.h"
#include "common/check/check.h"
#include "common/image/mip_levels.h"
#include "common/scene_fixture.h"

using namespace lightwalk;

namespace {

struct Place {
    glm::vec3 position, to_light;
};

constexpr double ring_alpha = 0.6, inner = 1.22, outer = 2.28;

/// planet_visibility() at each place; the ring hides `ring_alpha` everywhere, or (striped) all and nothing in turns.
std::vector<float> visibilities(const char* method, double sun_deg, const RingedPlanet& planet,
                                const std::vector<Place>& places, bool striped = false) {
    static const Pipeline pipeline = compute({.shader = "planet", .source = R"(
#include "05_shadow_maps/planet_shadow.glsl"
layout(local_size_x = 64) in;
struct Place { vec3 position, to_light; };
layout(scalar) readonly buffer PlaceBuffer { Place places[]; };
layout(scalar) writeonly buffer ResultBuffer { float results[]; };
void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i < places.length()) results[i] = planet_visibility(places[i].position, places[i].to_light);
}
)"});
    Gpu& gpu = check_device();
    NoChapter chapter;
    SphereShadow shadow(chapter, "sphere_shadow");
    shadow.method.set(method);
    shadow.sun_deg.set(std::to_string(sun_deg));
    shadow.planet = planet;
    Image ring(gpu.device, {.name = "ring", .format = VK_FORMAT_R8G8B8A8_UNORM, .size = {64, 1}, .mips = 7});
    std::vector<glm::u8vec4> texels;
    for (int i = 0; i < 64; ++i) texels.emplace_back(255, 255, 255, striped ? 255 * (i % 2) : int(255 * ring_alpha));
    gpu.upload(ring, mip_levels(ring.desc.format, ring.desc.size, std::as_bytes(std::span(texels))));
    shadow.ring = &ring;
    const Buffer in = gpu.upload("places", places);
    const Buffer out(gpu.device, {.name = "results", .bytes = std::max<size_t>(16, 4 * places.size())});
    Frame frame(gpu);
    frame.begin({4, 4}, 0);
    frame.compute("planet", {.writes = {out}, .with = {shadow}}, [&](Compute& pass) {
        pass.use(pipeline).set("places", in).set("results", out);
        pass.dispatch_threads(glm::uvec3(places.size(), 1, 1));
    });
    frame.end();
    const auto bytes = gpu.read_back(out);
    std::vector<float> result(places.size());
    std::memcpy(result.data(), bytes.data(), 4 * result.size());
    return result;
}

float visibility(const char* method, const RingedPlanet& planet, const Place& place, double sun_deg = 0.53) {
    return visibilities(method, sun_deg, planet, {place})[0];
}

const RingedPlanet sphere{.center = {0, 0, 0}, .radius = 1, .normal = {0, 1, 0}, .inner = 0, .outer = 0};
const RingedPlanet ringed{
    .center = {0, 0, 0}, .radius = 1, .normal = {0, 1, 0}, .inner = float(inner), .outer = float(outer)};

// The sphere's part in double precision.
double exact(const Place& place, double sun_deg) {
    const glm::dvec3 center(-place.position), light = glm::normalize(glm::dvec3(place.to_light));
    const double planet = std::asin(std::min(1.0, 1 / glm::length(center)));
    const double apart = std::atan2(glm::length(glm::cross(center, light)), glm::dot(center, light));
    return 1 - truth::hidden_solid_angle(glm::radians(0.5 * sun_deg), planet, apart);
}

}  // namespace

TEST_CASE("the truth of two discs is what their overlap adds up to, line by line") {
    for (const double radius : {0.3, 1.0, 2.0, 30.0})
        for (const double gap : {-1.2, -0.7, -0.25, 0.0, 0.4, 0.95}) {
            if (gap < -radius) continue;
            constexpr int lines = 200000;
            double sum = 0;
            for (int i = 0; i < lines; ++i) {
                const double y = (i + 0.5) / lines * 2 - 1, sun = std::sqrt(1 - y * y);
                if (std::fabs(y) >= radius) continue;
                const double half = std::sqrt(radius * radius - y * y), middle = radius + gap;
                sum += std::max(0.0, std::min(sun, middle + half) - std::max(-sun, middle - half)) * 2 / lines;
            }
            CHECK(truth::hidden_share(radius, gap) == Approx(sum / truth::pi).margin(1e-6));
        }
    // Far away nothing is curved.
    for (const double planet : {5e-4, 2e-3, 5e-3})
        for (const double apart : {0.0, 1e-3, 4.4e-3, 6e-3})
            CHECK(truth::hidden_solid_angle(1e-3, planet, apart) ==
                  Approx(truth::hidden_share(planet / 1e-3, (apart - planet) / 1e-3)).margin(3e-4));
}

TEST_CASE("the share of the sun that a sphere hides is that of solid angles") {
    Random random;
    for (const double sun_deg : {0.05, 0.53, 5.0}) {
        std::vector<Place> places;
        while (places.size() < 4000) {  // near the edge of the shadow, on its dark side; close by, and far off
            const glm::vec3 light = random.direction(), across = glm::normalize(glm::cross(light, random.direction()));
            const double behind = random.logarithmic(0.3, 300), soft = behind * glm::radians(sun_deg);
            const double off = 1 + soft * random.uniform(-1.2, 1.2);
            const glm::vec3 at = float(off) * across - float(behind) * light;
            if (off > 0 && glm::length(at) > 1.0f) places.push_back({at, light});
        }
        const auto got = visibilities("exact", sun_deg, sphere, places);
        double largest = 0;
        for (size_t i = 0; i < got.size(); ++i)
            largest = std::max(largest, std::fabs(double(got[i]) - exact(places[i], sun_deg)));
        WARN("a sun of " << sun_deg << " degrees: " << largest << " at most");
        // Flat discs instead of a sky, and rounding: it is a part of the sun's angle.
        CHECK(largest < 0.02 * glm::radians(sun_deg) + 2e-6 / glm::radians(sun_deg));
    }
}

TEST_CASE("what lies between the sun and the sphere is in no shadow, by any method") {
    for (const char* method : {"none", "hard", "power", "exact"})
        for (const glm::vec3 at :
             {glm::vec3(0, 0, 1.5), glm::vec3(0.5, 0.2, 30), glm::vec3(1.5, 0, 0), glm::vec3(0, 0, 300)})
            CHECK(visibility(method, sphere, {at, {0, 0, 1}}) == 1.0f);
    for (const char* method : {"hard", "power", "exact"})
        CHECK(visibility(method, sphere, {{0.1f, 0.2f, -1.5f}, {0, 0, 1}}) == 0.0f);
    CHECK(visibility("none", sphere, {{0.1f, 0.2f, -1.5f}, {0, 0, 1}}) == 1.0f);
    for (const char* method : {"hard", "power", "exact"})  // no planet, no shadow; its own middle is no NaN
        CHECK(visibility(method, {}, {{0, 0, -1.5f}, {0, 0, 1}}) == 1.0f);
    CHECK_FALSE(std::isnan(visibility("exact", sphere, {{0, 0, 0}, {0, 0, 1}})));
}

TEST_CASE("through the ring goes what its optical depth along the way lets through") {
    Random random;
    std::vector<Place> places;
    std::vector<double> expected;
    const double tau = -std::log(1 - ring_alpha);
    while (places.size() < 2000) {
        const glm::vec3 at = random.direction(), light = random.direction();
        if (glm::dot(at, light) < 0.05f) continue;  // the sphere's own night
        const double slope = double(light.y), t = -double(at.y) / slope;
        const double r = glm::length(glm::dvec3(at) + t * glm::dvec3(light));
        if (std::fabs(slope) < 0.01 || std::fabs(r - inner) < 1e-3 || std::fabs(r - outer) < 1e-3) continue;
        if (std::fabs(t) < 1e-3) continue;
        places.push_back({at, light});
        expected.push_back(truth::ring_transmittance(at, {0, 1, 0}, light, inner, outer, tau));
    }
    const auto got = visibilities("hard", 0.53, ringed, places);
    size_t through = 0;
    for (size_t i = 0; i < got.size(); ++i) {
        CHECK(double(got[i]) == Approx(expected[i]).margin(2e-5));
        through += expected[i] < 1;
    }
    CHECK(through > 100);
}

TEST_CASE("a sun that sees many of a ring's gaps at once shines through all of them a little") {
    std::vector<Place> places;
    for (int i = 0; i < 400; ++i)
        places.push_back({{0, -0.3f, 1.4f + 0.001f * float(i)}, glm::normalize(glm::vec3(0, 1, 0.5f))});
    const auto spread = [&](const char* method, double sun_deg) {
        const auto got = visibilities(method, sun_deg, ringed, places, true);
        return *std::max_element(got.begin(), got.end()) - *std::min_element(got.begin(), got.end());
    };
    CHECK(spread("hard", 20) > 0.95f);
    CHECK(spread("exact", 0.1) > 0.95f);
    CHECK(spread("exact", 20) < 0.05f);
}

TEST_CASE("a ring seen from the side, points in its plane, and a ring behind the point shadow nothing") {
    const auto lit = [](glm::vec3 at, glm::vec3 light) {
        return visibility("hard", ringed, {at, glm::normalize(light)});
    };
    CHECK(lit({0, 0.5f, 1}, {0, 0, 1}) == 1.0f);             // L·n = 0: infinitely thin
    CHECK(lit({0, 0, 1.7f}, {0, 0, 1}) == 1.0f);             // both at once
    CHECK(lit({0, -0.2f, 1}, {0, 1e-7f, 1}) == 1.0f);        // and nearly so
    CHECK(lit({0, -0.05f, 0.9987f}, {0, 0.1f, 1}) < 0.01f);  // along a long way through it almost nothing is left
    CHECK(lit({0, 0, 1.7f}, {0, 1, 0.2f}) == 1.0f);          // a point of the ring itself: t = 0
    CHECK(lit({0, 1e-6f, 1.7f}, {0, -1, 0.2f}) == 1.0f);     // rounding puts it a little above, light from below
    CHECK(lit({0, 0.5f, 1}, {0, 1, 1}) == 1.0f);             // t < 0: it is behind
    CHECK(lit({0, -0.5f, 1}, {0, 1, 1}) == Approx(std::pow(1 - ring_alpha, std::sqrt(2.0))).margin(1e-4));
    CHECK(lit({0, -0.5f, 1}, {0, 1, 0.1f}) == 1.0f);  // within the inner radius
}

TEST_CASE("the module finds the scene's planet and ring, one without the other, and neither") {
    Gpu& gpu = check_device();
    const auto loaded = [&](std::vector<SceneObject> objects) {
        auto scene = std::make_unique<Scene>();
        SceneFile file;
        file.objects = std::move(objects);
        scene->load(gpu, std::move(file), test_model);
        return scene;
    };
    SceneObject ball = object_at(ball_file, {1, 2, 3}, glm::vec3(2.0f)), ring = object_at(quad_file, {1, 2, 3});
    ball.name = "planet";
    ring.name = "ring";
    ring.rotation_deg = {0, 0, 90};
    NoChapter chapter;
    SphereShadow shadow(chapter, "sphere_shadow");
    const auto both = loaded({ball, ring}), one = loaded({ball}), none = loaded({object_at(ball_file, {0, 0, 0})});
    shadow.update(*both);
    CHECK(static_cast<bool>(shadow));
    CHECK(shadow.planet.center == glm::vec3(1, 2, 3));
    CHECK(double(shadow.planet.radius) == Approx(2).margin(1e-4));
    CHECK(double(std::fabs(shadow.planet.normal.x)) == Approx(1).margin(1e-4));
    CHECK(double(shadow.planet.outer) == Approx(std::sqrt(2.0)).margin(1e-4));
    shadow.update(*one);
    CHECK(static_cast<bool>(shadow));
    CHECK(shadow.planet.outer == 0.0f);
    CHECK(shadow.ring != nullptr);
    shadow.update(*none);
    CHECK_FALSE(static_cast<bool>(shadow));
}
