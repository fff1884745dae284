// Shared by the tests of shadow maps: a scene with lights, and their visibility at points, asked as shaders ask.
#pragma once
#include "05_shadow_maps/shadow.h"
#include "catch.h"
#include "common/base/error.h"
#include "common/scene_fixture.h"

namespace lightwalk {

struct TestPoint {
    glm::vec3 position, facing;
    uint32_t light = 0;
};

struct ShadowScene : TestScene {
    NoChapter chapter;
    Lights lights{chapter, "lights"};
    Shadow shadow{chapter, "shadow"};
    Camera camera{.position = {0, 0, 5}, .target = {0, 0, 0}, .near_m = 0.1f, .far_m = 100};
    Pipeline pipeline = compute({.shader = "visibility", .source = R"(
#include "03_attenuation/lighting.glsl"
#include "05_shadow_maps/shadow.glsl"
struct Point { vec3 position, facing; uint light; };
layout(local_size_x = 64) in;
layout(scalar) readonly buffer PointBuffer { Point points[]; };
layout(scalar) writeonly buffer ResultBuffer { float result[]; };
void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= points.length()) return;
    Point p = points[i];
    vec3 to_light = arriving_light(lights_data[p.light], p.position, 1.0).to_light;
    result[i] = light_visibility(p.light, p.position, p.facing, p.facing, to_light).r;
}
)"});

    ShadowScene(std::vector<SceneObject> objects, std::vector<Light> all) : TestScene(std::move(objects)) {
        scene.file.lights = std::move(all);
        for (Light& light : scene.file.lights) light.shadow = true;
        lights.method.set("every_light");
        shadow.method.set("hard");
        unbiased();
    }

    /// No bias of any kind.
    void unbiased() {
        for (KnobBase* knob : std::initializer_list<KnobBase*>{&shadow.bias_m, &shadow.slope, &shadow.normal_offset})
            knob->set("0");
        shadow.receiver_plane.set("off");
    }

    void set(std::initializer_list<std::pair<const char*, const char*>> knobs) {
        for (const auto& [name, value] : knobs)
            find_knob(chapter.all_knobs(), std::string("shadow.") + name).set(value);
    }

    /// A frame that records the shadows of another view alone, from a camera moved by `by` (metres).
    void record_view(uint32_t id, glm::vec3 by) {
        Camera moved = camera;
        moved.position += by;
        moved.target += by;
        Frame frame(gpu);
        chapter.begin_frame(gpu, {4, 4});
        frame.begin({4, 4}, 0);
        lights.update(frame, scene, scene.file.lights);
        shadow.record(frame, scene, lights,
                      {.eye = moved.position, .camera = moved, .crop = {.whole = {64, 64}}, .id = id});
        frame.end();
    }

    /// 0 to 1 for each point.
    std::vector<float> visibility(const std::vector<TestPoint>& points) {
        Frame frame(gpu);
        chapter.begin_frame(gpu, {4, 4});
        frame.begin({4, 4}, 0);
        scene.upload_moved(frame);
        lights.update(frame, scene, scene.file.lights);
        shadow.record(frame, scene, lights, {.eye = camera.position, .camera = camera, .crop = {.whole = {64, 64}}});
        const Buffer out(gpu.device, {.name = "visibilities", .bytes = 4 * points.size()});
        const Buffer in = gpu.upload("points", points);
        frame.compute("ask", {.writes = {out}, .with = {lights, shadow}}, [&](Compute& pass) {
            pass.use(pipeline).set("points", in).set("result", out);
            pass.dispatch_threads(glm::uvec2(static_cast<uint32_t>(points.size()), 1));
        });
        frame.end();
        std::vector<float> result(points.size());
        const auto bytes = gpu.read_back(out);
        std::memcpy(result.data(), bytes.data(), 4 * points.size());
        return result;
    }
    float visibility(const TestPoint& point) { return visibility(std::vector<TestPoint>{point}).front(); }

    /// The share of the points that are darker than half.
    double dark(const std::vector<TestPoint>& points) {
        double count = 0;
        for (const float visible : visibility(points)) count += visible < 0.5f;
        return count / static_cast<double>(points.size());
    }
};

/// A sun at this angle to the normal of a surface facing +z.
inline Light sun_at(double degrees, double turn_deg = 45) {
    const double angle = glm::radians(degrees), turn = glm::radians(turn_deg);
    return {.kind = Light::Kind::directional,
            .direction = -glm::vec3(
                glm::dvec3(std::sin(angle) * std::cos(turn), std::sin(angle) * std::sin(turn), std::cos(angle)))};
}

/// Points of the square from -half to half in x and y, at z, facing +z.
inline std::vector<TestPoint> square(int count, float half, float z = 0, unsigned seed = 1) {
    Random random(seed);
    std::vector<TestPoint> points;
    for (int i = 0; i < count; ++i)
        points.push_back({{random.uniform(-half, half), random.uniform(-half, half), z}, {0, 0, 1}});
    return points;
}

}  // namespace lightwalk
