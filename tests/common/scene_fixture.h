// Shared by the tests of scenes: models made here, a view along -z without perspective, and its picture.
#pragma once
#include <cstring>
#include <glm/gtc/packing.hpp>

#include "common/base/files.h"
#include "common/check/check.h"
#include "common/scene/import.h"
#include "common/scene/scene.h"
#include "file_fixture.h"
#include "module_fixture.h"

namespace lightwalk {

/// The error for this text of a scene file; empty if there is none.
inline std::string error_of(const std::string& text) {
    return refusal_of([&] { parse_scene(text, "scene.json"); });
}

/// Names of existing files; test_model() replaces their contents.
inline const char* const quad_file = "models/cube.obj";    ///< from -1 to 1, facing +z
inline const char* const other_file = "models/plane.obj";  ///< the same as another mesh
inline const char* const pair_file = "models/column.obj";  ///< two quads; the second one is mirrored after 1 s
inline const char* const ball_file = "models/sphere.obj";  ///< of radius 1

inline Mesh quad_mesh() {
    Mesh mesh;
    for (const glm::vec2 p : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)})
        mesh.vertices.push_back({glm::vec3(p, 0.0f), {0, 0, 1}, p});
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

inline Mesh ball_mesh() {
    Mesh mesh;
    constexpr uint32_t rows = 24, columns = 48;
    for (uint32_t row = 0; row <= rows; ++row)
        for (uint32_t column = 0; column <= columns; ++column) {
            const float polar = 3.14159265f * float(row) / rows, around = 6.2831853f * float(column) / columns;
            const glm::vec3 p(std::sin(polar) * std::sin(around), std::cos(polar), std::sin(polar) * std::cos(around));
            mesh.vertices.push_back({p, p, {}});
            const uint32_t i = row * (columns + 1) + column, below = i + columns + 1;
            if (row < rows && column < columns)
                for (const uint32_t k : {i, below, below + 1, i, below + 1, i + 1}) mesh.indices.push_back(k);
        }
    return mesh;
}

inline Model test_model(const std::filesystem::path& file) {
    if (file.extension() == ".gltf") return import_model(file);
    Model model;
    model.materials.emplace_back();
    Mesh& mesh = model.meshes.emplace_back(file.filename() == "sphere.obj" ? ball_mesh() : quad_mesh());
    mesh.parts = {{0, static_cast<uint32_t>(mesh.indices.size()), 0}};
    for (const Vertex& v : mesh.vertices) mesh.bounds.add(v.position);
    model.nodes.push_back({.name = "root", .meshes = {0}});
    if (file.filename() == "column.obj") {
        model.nodes.push_back({.name = "turns", .parent = 0, .meshes = {0}});
        NodeMotion& turn = model.motions.emplace_back();
        turn.node = 1;
        turn.position = {{0, {2.5f, 0, 0}}};
        turn.rotation = {{0, {1, 0, 0, 0}}};
        turn.scale = {{0, {1, 1, 1}}, {1, {-1, 1, 1}}};
        model.motions_s = 3;
    }
    return model;
}

inline SceneObject object_at(const char* file, glm::vec3 position, glm::vec3 scale = glm::vec3(1.0f)) {
    SceneObject object;
    object.model = file;
    object.position = position;
    object.scale = scale;
    return object;
}

struct TestScene {
    Gpu& gpu = check_device();
    Scene scene;
    Pipeline pipeline =
        graphics({.vertex = "../tests/common/data/scene.vert", .fragment = "../tests/common/data/scene.frag"});
    explicit TestScene(std::vector<SceneObject> objects) {
        SceneFile file;
        file.objects = std::move(objects);
        scene.load(gpu, std::move(file), test_model);
    }

    /// Starts the frame: from here passes can be recorded; `x` and `y` from -4 to 4 are visible, greater z is in
    /// front.
    static void begin(Frame& frame) {
        frame.begin({32, 32}, 0);
        glm::mat4 matrix(1.0f);
        matrix[0][0] = 0.25f;
        matrix[1][1] = -0.25f;
        matrix[2][2] = 0.01f;
        matrix[3][2] = 0.5f;
        const CameraView view{.view_projection = matrix, .eye = {0, 0, 50}, .time_s = 0, .size = frame.size, .seed = 0};
        const auto bytes = std::as_bytes(std::span(&view, 1));
        frame.globals["view"].assign(bytes.begin(), bytes.end());
    }

    void draw(Frame& frame, const Drawable& what) {
        frame.raster("draw", {.color = {clear(frame.hdr, glm::vec4(0.0f))}, .depth = frame.depth},
                     [&](Raster& pass) { pass.use(pipeline).draw(what); });
    }

    /// The output of scene.frag at these points; 0 for background.
    std::vector<glm::vec4> seen(const Drawable& what, const std::vector<glm::vec2>& places) {
        Frame frame(gpu);
        begin(frame);
        scene.upload_moved(frame);
        draw(frame, what);
        frame.end();
        const auto bytes = gpu.read_back(frame.hdr);
        std::vector<glm::vec4> result;
        for (const glm::vec2 p : places) {
            const auto x = static_cast<size_t>((p.x + 4) * 4), y = static_cast<size_t>((4 - p.y) * 4);
            uint64_t texel = 0;
            std::memcpy(&texel, &bytes[8 * (y * 32 + x)], 8);
            result.push_back(glm::unpackHalf4x16(texel));
        }
        return result;
    }

    /// Instances as the device has them.
    std::vector<Instance> on_device() {
        const auto bytes = gpu.read_back(scene.instances);
        std::vector<Instance> result(bytes.size() / sizeof(Instance));
        std::memcpy(result.data(), bytes.data(), result.size() * sizeof(Instance));
        return result;
    }
};

}  // namespace lightwalk
