// Where the methods of chapter 04 fail: a bound where they hold, the size of the failure where they do not.
#include "03_attenuation/lights.h"
#include "04_surface_maps/exercises.h"
#include "04_surface_maps/height_field.h"
#include "04_surface_maps/levels.h"
#include "04_surface_maps/maps.h"
#include "04_surface_maps/tangents.h"
#include "04_surface_maps/truth.h"
#include "catch.h"
#include "common/base/files.h"
#include "common/check/check.h"
#include "common/image/image.h"

using namespace lightwalk;

namespace {

Table run(const std::string& file, const std::string& signature, Table inputs, size_t outputs, Macros macros = {}) {
    return run_probe(
        check_device(),
        {.include = file, .signature = signature, .inputs = std::move(inputs), .macros = std::move(macros)}, outputs);
}

// The share of rays at this angle to the normal that should meet a spike one texel wide, and do not.
double missed_spikes(int steps, double angle_deg) {
    const double shift = 0.05 * std::tan(glm::radians(angle_deg));  // 5 cm deep, a texture 1 m wide
    Random random;
    Table rays;
    for (int i = 0; i < 4000; ++i)
        rays.push_back({0.5 + random.uniform(0.002, shift - 0.002), 0.5, shift, 0, double(steps)});
    const Table hits = run("../tests/04_surface_maps/known_field.glsl",
                           "float first_layer_below(vec2 uv, vec2 shift, int steps)", rays, 1, {{"FIELD", "3"}});
    double missed = 0;
    for (const Row& hit : hits) missed += hit[0] >= 0.9999;  // the floor behind
    return missed / static_cast<double>(rays.size());
}

Mesh mesh_of(std::vector<Vertex> vertices, std::vector<uint32_t> indices) {
    Mesh mesh;
    mesh.vertices = std::move(vertices);
    mesh.indices = std::move(indices);
    return mesh;
}

}  // namespace

TEST_CASE("a spike one texel wide is skipped by layers that are further apart: three rays of four at 85 degrees",
          "[04.spike]") {
    // The ray is above the spike for 1/256 of 0.57 m: for less than one layer in 146.
    CHECK(missed_spikes(32, 85) == Approx(1 - 32 / 146.3).margin(0.03));
    CHECK(missed_spikes(64, 85) == Approx(1 - 64 / 146.3).margin(0.03));
    CHECK(missed_spikes(256, 85) == 0);
    CHECK(missed_spikes(32, 45) == 0);  // there the ray crosses 26 texels: 32 layers will do
}

TEST_CASE("exact traversal finds what 200,000 steps find") {
    Random random;
    std::vector<float> heights;
    for (int i = 0; i < 32 * 32; ++i) heights.push_back(static_cast<float>(random.uniform(0, 1)));
    const HeightField field({32, 32}, heights);
    for (int i = 0; i < 300; ++i) {
        const glm::dvec2 start(random.uniform(0, 32), random.uniform(0, 32));
        const glm::dvec2 along(random.uniform(-30, 30), random.uniform(-30, 30));
        CHECK(field.exact(start, along) == Approx(field.hit("relief", 200000, start, along)).margin(1e-6));
    }
    CHECK(field.exact({3, 3}, {0, 0}) == Approx(field.depth({3, 3})));  // straight down, on a texel's middle
    CHECK(field.exact({3, 3}, {5, 5}) == Approx(field.hit("relief", 200000, {3, 3}, {5, 5})).margin(1e-6));  // corners
}

TEST_CASE("where the texture is mirrored a shared vertex gets two frames") {
    // Two triangles on a wall, u growing away from the seam x = 0 on both sides.
    const glm::vec3 z(0, 0, 1);
    const Mesh mesh =
        mesh_of({{{0, 0, 0}, z, {0, 0}}, {{0, 1, 0}, z, {0, 1}}, {{1, 0, 0}, z, {1, 0}}, {{-1, 0, 0}, z, {1, 0}}},
                {0, 2, 1, 0, 1, 3});
    const FramedMesh framed = frame_mesh(mesh);
    REQUIRE(framed.vertices.size() == 6);  // the two on the seam twice
    for (size_t i = 0; i < framed.indices.size(); ++i) {
        const TangentFrame& frame = framed.frames[framed.indices[i]];
        CHECK(frame.handedness == (i < 3 ? 1.0f : -1.0f));
        CHECK(frame.tangent.x == Approx(i < 3 ? 1.0f : -1.0f));
        CHECK(framed.vertices[framed.indices[i]].position == mesh.vertices[mesh.indices[i]].position);
    }
    CHECK(frame_mesh(mesh_of(framed.vertices, framed.indices)).vertices.size() == 6);  // once is enough
}

TEST_CASE("where the texture is sheared a ray moves along u and v as the surface's own map says", "[04.sheared]") {
    Random random;
    std::vector<double> missed, missed_without;
    for (int i = 0; i < 500; ++i) {
        // uv = m * (x, z) on a floor: turned by 28.6 degrees, then stretched unequally; some mirrored.
        const double angle = glm::radians(28.6), stretch_u = random.uniform(0.3, 3), stretch_v = random.uniform(0.3, 3);
        const glm::dmat2 turned(std::cos(angle), std::sin(angle), -std::sin(angle), std::cos(angle));
        const glm::dmat2 m = glm::dmat2(stretch_u, 0, 0, i % 4 ? stretch_v : -stretch_v) * turned *
                             glm::dmat2(1, 0, 0, random.uniform(0.5, 2));
        const auto at = [&](double x, double z) {
            return Vertex{{x, 0, z}, {0, 1, 0}, glm::vec2(m * glm::dvec2(x, z))};
        };
        const TangentFrame f = frame_mesh(mesh_of({at(0, 0), at(0, 1), at(1, 0)}, {0, 1, 2})).frames[0];
        // The eye 80 degrees from the normal; the height field 5 cm deep.
        const double around = random.uniform(0, 6.28), tangent_80 = std::tan(glm::radians(80.0));
        const glm::vec3 normal(0, 1, 0), across = f.handedness * glm::cross(normal, f.tangent);
        const glm::vec3 to_eye(glm::dvec3(std::cos(around) * tangent_80, 1, std::sin(around) * tangent_80));
        const glm::vec3 in_frame(glm::dot(to_eye, f.tangent), glm::dot(to_eye, across), glm::dot(to_eye, normal));
        const glm::dvec2 truth = m * (0.05 * glm::dvec2(to_eye.x, to_eye.z));
        const auto miss = [&](glm::vec3 v) {  // in texels of a map of 512
            return 512 * glm::length(glm::dvec2(0.05f / f.metres_per_uv * glm::vec2(v.x, v.y) / v.z) - truth);
        };
        missed.push_back(miss(along_uv(in_frame, f.cos_uv)));
        missed_without.push_back(miss(in_frame));
    }
    std::sort(missed.begin(), missed.end());
    std::sort(missed_without.begin(), missed_without.end());
    INFO("as if u and v were perpendicular: " << missed_without[250] << " texels in the median");
    CHECK(missed.back() < 0.01);
    CHECK(missed_without[250] > 10);
}

TEST_CASE("a vertex without texture coordinates, or without area, has a frame of unit length and moves nothing") {
    const glm::vec3 n = glm::normalize(glm::vec3(1, 2, 3));
    const Mesh mesh = mesh_of(
        {{{0, 0, 0}, n, {0.5f, 0.5f}}, {{1, 0, 0}, n, {0.5f, 0.5f}}, {{0, 1, 0}, n, {0.5f, 0.5f}}}, {0, 1, 2, 0, 0, 0});
    for (const TangentFrame& frame : frame_mesh(mesh).frames) {
        CHECK(glm::length(frame.tangent) == Approx(1).margin(1e-5));
        CHECK(std::fabs(glm::dot(frame.tangent, n)) < 1e-5f);
        CHECK(1.0f / frame.metres_per_uv.x < 1e-6f);
    }
}

TEST_CASE("frames of a finely cut sphere are its derivatives") {
    // u around the y axis, v from the south to the north pole: dP/du and dP/dv are known.
    const int columns = 96, rows = 48;
    std::vector<Vertex> vertices;
    std::vector<uint32_t> indices;
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i) {
            const float u = float(i) / columns, v = float(j) / rows, a = 6.2831853f * u, b = 3.1415927f * v;
            const glm::vec3 p(std::sin(b) * std::sin(a), -std::cos(b), std::sin(b) * std::cos(a));
            vertices.push_back({p, p, {u, v}});
            if (i == columns || j == rows) continue;
            const auto at = [&](int x, int y) { return static_cast<uint32_t>(y * (columns + 1) + x); };
            indices.insert(indices.end(),
                           {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    const FramedMesh framed = frame_mesh(mesh_of(vertices, indices));
    REQUIRE(framed.vertices.size() == vertices.size());
    for (size_t k = 0; k < vertices.size(); ++k) {
        const double a = 6.283185307 * double(vertices[k].uv.x), b = 3.141592654 * double(vertices[k].uv.y);
        if (std::sin(b) < 0.2) continue;  // near the poles u has no direction
        const glm::dvec3 east(std::cos(a), 0, -std::sin(a));
        const TangentFrame& frame = framed.frames[k];
        const bool rim = vertices[k].uv.x == 0 || vertices[k].uv.x == 1;  // half of its triangles are at the other side
        CHECK(glm::dot(glm::dvec3(frame.tangent), east) > (rim ? 0.999 : 0.9999));
        CHECK(frame.handedness == 1);
        CHECK(double(frame.metres_per_uv.x) == Approx(6.283185 * std::sin(b)).epsilon(0.05));
        CHECK(double(frame.metres_per_uv.y) == Approx(3.141593).epsilon(0.01));
    }
}

TEST_CASE("normals that cancel have a mean of length 0 and point up; those that agree keep length 1") {
    const auto code = [](float x, float y) { return glm::vec4(0.5f + 0.5f * x, 0.5f + 0.5f * y, 0.5f, 1); };
    const Level opposed{{2, 2}, {code(1, 0), code(-1, 0), code(0, 1), code(0, -1)}};
    const Level last = normal_levels(opposed).back();
    CHECK(glm::length(glm::vec3(last.texels[0]) - glm::vec3(0.5f, 0.5f, 1)) < 1e-4f);
    CHECK(last.texels[0].a == Approx(1).margin(1e-4));  // the root of all that is missing
    const Level agreed{{2, 2}, {code(0.6f, 0), code(0.6f, 0), code(0.6f, 0), code(0.6f, 0)}};
    for (const Level& level : normal_levels(agreed)) {
        CHECK(level.texels[0].a == Approx(0).margin(1e-3));
        CHECK(level.texels[0].x == Approx(0.8).margin(1e-4));
    }
}

TEST_CASE("a cutout keeps its coverage down the levels, and loses it where alpha is only averaged") {
    const TexelImage grass = read_texels(course_root() / "assets/textures/grass_cutout.png", false);
    Level blades{{grass.width, grass.height}, {}};
    for (size_t i = 0; i < grass.bytes.size(); i += 4)
        blades.texels.push_back(
            glm::vec4(0.2f, 0.6f, 0.1f, static_cast<float>(std::to_integer<int>(grass.bytes[i + 3])) / 255.0f));
    const double wanted = coverage(blades, 0.5f);
    const auto kept = cutout_levels(check_device(), blades, 0.5f),
               averaged = cutout_levels(check_device(), blades, -1.0f);
    REQUIRE(kept.size() == 10);
    for (size_t i = 1; i < 10; ++i) {  // down to 1x1
        CHECK(coverage(kept[i], 0.5f) == Approx(wanted).margin(0.5 / double(kept[i].texels.size()) + 0.004));
        for (const glm::vec4& texel : kept[i].texels)  // and no dark seams
            if (texel.a > 0) CHECK(glm::length(glm::vec3(texel) - glm::vec3(0.2f, 0.6f, 0.1f)) < 1e-3f);
    }
    std::string shares;
    for (size_t i = 0; i < 10; ++i) shares += " " + std::to_string(coverage(averaged[i], 0.5f));
    INFO("averaged, of 512, 256, ... 1 texels a side:" << shares);
    CHECK(coverage(averaged[5], 0.5f) < 0.85 * wanted);  // 16 texels a side
    CHECK(coverage(averaged[8], 0.5f) == 0);
    const Level none{{4, 4}, std::vector<glm::vec4>(16, glm::vec4(1, 1, 1, 0))};
    for (const Level& level : cutout_levels(check_device(), none, 0.5f)) CHECK(coverage(level, 0.5f) == 0);
}

TEST_CASE("a map that is off or missing is not in the shader", "[04.map_off]") {
    const Pipeline pipeline =
        graphics({.vertex = "04_surface_maps/surface.vert", .fragment = "04_surface_maps/surface.frag"});
    struct Owner : Module {
    } chapter;
    const Maps maps(chapter, "maps");
    const Lights lights(chapter, "lights");
    constexpr const char* slots[] = {"DIFFUSE", "SPECULAR",  "EMISSIVE", "OPACITY",       "NORMAL",      "HEIGHT",
                                     "ORM",     "OCCLUSION", "GLOSS",    "DETAIL_NORMAL", "DISPLACEMENT"};
    const auto words = [&](std::string_view left_out) {
        Macros macros{{"SHOW", "0"}, {"SHOW_HIT_ERROR", "1"}, {"SHOW_SWIM", "2"}, {"SHOW_NORMAL", "3"}};
        macros.add(lights.macros());
        macros.add(maps.macros());
        macros.add(maps.surface.macros());
        for (const std::string slot : slots)
            if (left_out == slot || left_out == "all") macros.set("MAPS_" + slot, "0");
        return compile_stages(pipeline, flatten_stages(pipeline, macros)).spirv[1].size();
    };
    const size_t all = words("");
    for (const char* slot : slots) CHECK(words(slot) < all);
    const size_t none = words("all");
    WARN("SPIR-V words of surface.frag: " << all << " with every map, " << none << " with none");
    CHECK(double(none) < 0.8 * double(all));
}
