// The module Rays over scenes: it follows motion, and rays go through holes.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "04_surface_maps/levels.h"
#include "04_surface_maps/maps.h"
#include "05_shadow_maps/rays.h"
#include "catch.h"
#include "common/base/error.h"
#include "common/base/files.h"
#include "common/image/image.h"
#include "common/scene_fixture.h"

using namespace lightwalk;

namespace {

// Alpha as a sampler reads it: bilinear, repeating, v = 0 in the bottom row.
double alpha_at(const Level& level, double u, double v) {
    const glm::ivec2 size(level.size);
    const double x = u * size.x - 0.5, y = (1 - v) * size.y - 0.5;
    double sum = 0;
    for (const int j : {0, 1})
        for (const int i : {0, 1}) {
            const int column = (int(std::floor(x)) + i + size.x) % size.x,
                      row = (int(std::floor(y)) + j + size.y) % size.y;
            const double weight = (1 - std::fabs(x - std::floor(x) - i)) * (1 - std::fabs(y - std::floor(y) - j));
            sum += weight * double(level.texels[static_cast<size_t>(row * size.x + column)].a);
        }
    return sum;
}

struct RayScene : TestScene {
    NoChapter chapter;
    Rays rays{chapter, "rays"};
    Maps maps{chapter, "maps"};
    float time_s = 0;
    Pipeline pipeline = compute({.shader = "downwards", .source = R"(
#include "05_shadow_maps/bvh.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(scalar) writeonly buffer ResultBuffer { uint blocked[]; };
const uint side = 256u;
void main() {
    uvec2 at = gl_GlobalInvocationID.xy;
    vec2 place = (vec2(at) + 0.5) / float(side) * 2.0 - 1.0;
    blocked[at.y * side + at.x] = uint(any_hit(Ray(vec3(place, 9.0), 0.0, vec3(0.0, 0.0, -1.0), 1e13)));
}
)"});
    explicit RayScene(std::vector<SceneObject> objects) : TestScene(std::move(objects)) { rays.build(gpu, scene); }

    /// Whether each of 256×256 points of the square from -1 to 1 in x and y is blocked, seen along -z, row by row from
    /// y = -1.
    std::vector<bool> blocked_points() {
        Frame frame(gpu);
        frame.begin({4, 4}, time_s);
        rays.record(frame, scene, &maps);
        const Buffer out(gpu.device, {.name = "blocked", .bytes = 4 * 256 * 256});
        frame.compute("look", {.writes = {out}, .with = {rays}}, [&](Compute& pass) {
            pass.use(pipeline).set("blocked", out).dispatch_threads({256, 256});
        });
        frame.end();
        std::vector<bool> points;
        const auto bytes = gpu.read_back(out);
        for (size_t i = 0; i < bytes.size(); i += 4) points.push_back(bytes[i] != std::byte(0));
        return points;
    }

    double blocked() {
        const auto points = blocked_points();
        return double(std::count(points.begin(), points.end(), true)) / double(points.size());
    }
};

}  // namespace

TEST_CASE("rays meet what is placed where it is now, mirrored and from either side") {
    SceneObject mover = object_at(quad_file, {-0.5, 0, 0}, {0.5f, 1.0f, 1.0f});
    mover.motion.path = {{.time_s = 0, .position = {-0.5, 0, 0}, .scale = mover.scale},
                         {.time_s = 1, .position = {1.0, 0, 0}, .scale = mover.scale}};
    SceneObject mirrored = object_at(quad_file, {0.5, 0.75, 1}, {-0.5f, 0.25f, 1.0f});
    SceneObject glass = object_at(quad_file, {0, 0, 2});
    glass.material.opacity = 0.5f;
    glass.material.maps["diffuse"] = "textures/grass_cutout.png";
    RayScene test({mover, mirrored, glass});
    CHECK(test.rays.bvh().triangles().size() == 4);  // transparent surfaces cast no shadow
    CHECK(test.blocked() == Approx(0.5 + 0.125).margin(0.01));
    animate(test.scene, 1);
    CHECK(test.blocked() == Approx(0.25 + 0.125 - 0.0625).margin(0.01));
    animate(test.scene, 0);
    CHECK(test.blocked() == Approx(0.5 + 0.125).margin(0.01));
    const uint64_t before = test.gpu.uploaded_bytes;
    test.blocked();
    CHECK(test.gpu.uploaded_bytes == before);
}

TEST_CASE("rays meet skins and morphs where they are by now") {
    RayScene morph({object_at("conformance/moving_morph_weights.gltf", {0, 0, 0})});
    CHECK(morph.blocked() == 1);  // a square from -1 to 1, which moves to the right by 2 m in 1 s
    animate(morph.scene, morph.time_s = 0.5f);
    CHECK(morph.blocked() == Approx(0.5).margin(0.01));
    RayScene skin({object_at("conformance/moving_skin.gltf", {0, 0, 0})});
    CHECK(skin.blocked() == Approx(0.5).margin(0.01));  // its upper edge is 2 m to the right, then above the lower one
    animate(skin.scene, skin.time_s = 0.5f);
    CHECK(skin.blocked() == Approx(1).margin(0.01));
}

// KHR_texture_transform: uv times the scale, plus the offset. The texture's left half is opaque: with a scale of a half one
// half of it is seen. The second coordinates are half of the first.
TEST_CASE("rays go through a texture's holes where its transform and its coordinates place them", "[05.placed_holes]") {
    const FileFolder folder;
    Image8 half(2, 1);
    half.pixels = {glm::u8vec4(255), glm::u8vec4(255, 255, 255, 0)};
    write_png(folder / "half.png", half);
    const std::array<float, 28> numbers{-1, -1, 0,    1, -1,   0, 1, 1, 0, -1, 1, 0,  // positions
                                        0,  1,  1,    1, 1,    0, 0, 0,               // first coordinates
                                        0,  1,  0.5f, 1, 0.5f, 0, 0, 0};              // second ones
    write_file(folder / "quad.bin", std::string_view(reinterpret_cast<const char*>(numbers.data()), sizeof numbers));
    const auto blocked = [&](const std::string& how) {
        write_file(folder / "quad.gltf",
                   R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
            "buffers": [{"byteLength": 112, "uri": "quad.bin"}], "bufferViews": [{"buffer": 0, "byteLength": 48},
                {"buffer": 0, "byteOffset": 48, "byteLength": 32}, {"buffer": 0, "byteOffset": 80, "byteLength": 32}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
                {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2"},
                {"bufferView": 2, "componentType": 5126, "count": 4, "type": "VEC2"}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1, "TEXCOORD_1": 2}, "material": 0,
                "mode": 6}]}], "images": [{"uri": "half.png"}], "textures": [{"source": 0}],
            "materials": [{"alphaMode": "MASK", "pbrMetallicRoughness": {"baseColorTexture": {"index": 0)" +
                       how + "}}}]}");
        return RayScene({object_at((folder / "quad.gltf").c_str(), {0, 0, 0})}).blocked();
    };
    const std::string transform = R"(, "extensions": {"KHR_texture_transform": {"scale": [0.5, 1])";
    CHECK(blocked("") == Approx(0.5).margin(0.01));
    CHECK(blocked(transform + "}}") == 1);
    CHECK(blocked(transform + R"(, "offset": [0.5, 0]}})") == 0);
    CHECK(blocked(R"(, "texCoord": 1)") == 1);
}

// glTF 2.0, 3.9.3: alpha is the product of texture, factor and the vertices' colour; what is below the cutoff is not there.
TEST_CASE("rays go through what a factor or vertex colours cut out", "[05.untextured_holes]") {
    const FileFolder folder;
    const auto blocked = [&](const char* alpha, const char* color) {
        // A triangle of half a square metre, whose first twelve bytes, its colours, are 0.
        write_file(folder / "triangle.gltf",
                   fmt::format(R"({{"asset": {{"version": "2.0"}}, "scenes": [{{"nodes": [0]}}],
            "nodes": [{{"mesh": 0}}], "buffers": [{{"byteLength": 36, "uri":
            "data:;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}}],
            "bufferViews": [{{"buffer": 0, "byteLength": 36}}, {{"buffer": 0, "byteLength": 12}}],
            "accessors": [{{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}},
                          {{"bufferView": 1, "componentType": 5121, "normalized": true, "count": 3, "type": "VEC4"}}],
            "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0{}}}, "material": 0}}]}}],
            "materials": [{{"alphaMode": "MASK", "pbrMetallicRoughness": {{"baseColorFactor": [1, 1, 1, {}]}}}}]}})",
                               color, alpha));
        return RayScene({object_at((folder / "triangle.gltf").c_str(), {0, 0, 0})}).blocked();
    };
    CHECK(blocked("0.6", "") == Approx(0.125).margin(0.01));
    CHECK(blocked("0.4", "") == 0);
    CHECK(blocked("1", R"(, "COLOR_0": 1)") == 0);
}

TEST_CASE("an empty scene stops no ray") {
    RayScene test({});
    CHECK(test.blocked() == 0);
    CHECK(test.rays.offset_m() >= 0);
}

TEST_CASE("rays go through what a texture cuts out, and not where the knob says that all is whole") {
    SceneObject leaf = object_at(quad_file, {0, 0, 0});
    leaf.material.maps["diffuse"] = "textures/grass_cutout.png";
    RayScene test({leaf});
    const Level level = read_level(test.gpu, test.scene.texture(test.scene.items[0], MapSlot::diffuse));
    const double share = coverage(level, 0.5f);
    CHECK(share > 0.05);
    CHECK(share < 0.95);
    CHECK(test.blocked() == Approx(share).margin(0.01));
    // Each point, where rounding does not decide. The quad's texture coordinates are its places; then these move.
    for (const auto& [wobble, scroll, cutoff, time_s] : {std::array{0.0f, 0.0f, 0.5f, 0.0f},
                                                         {0.0f, 0.3f, 0.5f, 2.0f},
                                                         {0.1f, -0.2f, 0.5f, 1.5f},
                                                         {0.0f, 0.0f, 0.2f, 3.0f}}) {
        test.maps.wobble.value = wobble;
        test.maps.scroll.value = scroll;
        test.maps.cutoff.value = cutoff;
        test.time_s = time_s;
        const auto points = test.blocked_points();
        size_t wrong = 0, sure = 0;
        for (size_t i = 0; i < points.size(); ++i) {
            const glm::vec2 place((double(i % 256) + 0.5) / 128 - 1, (double(i / 256) + 0.5) / 128 - 1);
            const glm::vec2 uv = glm::fract(moving_uv(place, wobble, scroll, time_s));
            const double alpha = alpha_at(level, double(uv.x), double(uv.y));
            if (std::fabs(alpha - double(cutoff)) < 0.02) continue;
            ++sure;
            wrong += points[i] != (alpha > double(cutoff));
        }
        INFO(wobble << " " << scroll << " " << cutoff << " " << time_s);
        CHECK(sure > 50000);
        CHECK(wrong == 0);
    }
    test.maps.cutoff.value = 0.5f;
    test.maps.diffuse.set("off");
    CHECK(test.blocked() == 1);
    test.maps.diffuse.set("on");
    test.rays.cutouts.set("off");
    CHECK(test.blocked() == 1);
    test.rays.cutouts.set("on");
    test.maps.cutoff.value = 0;  // nothing has less alpha than that
    CHECK(test.blocked() == 1);
}
