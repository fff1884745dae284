// Shared by the tests of studies: a chapter of one grey, a study of it, and that study's error message.
#pragma once
#include "common/app/read_picture.h"
#include "common/app/render.h"
#include "common/app/target.h"
#include "common/base/files.h"
#include "common/check/check.h"
#include "common/scene/json_lines.h"
#include "common/study/study.h"
#include "common/study/study_plan.h"
#include "file_fixture.h"

namespace lightwalk {

/// A picture of one grey: `light`, too bright by 1 / (8 looks) where the method is coarse.
struct GreyStudy : Chapter {
    Choice method{*this, "method", {"exact", "coarse"}, "exact", "how"};
    Knob<float> light{*this, "light", 0.25f, {0.0f, 4.0f}, "how bright"};
    Knob<int> looks{*this, "looks", 1, {1, 1024}, "how many"};
    std::vector<std::pair<std::string, float>> prepared;  // scene and light, in order
    std::string fails_at;                                 // a scene
    bool measures = false, rude = false;
    bool codes = false;    // the encoded picture is judged
    bool gathers = false;  // adds the previous value
    float a_seed = 0;      // added for each seed
    History past{*this, {.name = "past", .size = {1, 1}}};

    GreyStudy() { name = "99_grey"; }
    std::string default_scene() const override { return ""; }
    Model load_model(const std::filesystem::path&) override { return {}; }
    void prepare(Gpu&, Scene&) override {
        const std::string file = scene.file.file.stem().string();
        if (file == fails_at) throw Failure("interrupted");
        prepared.emplace_back(file, light.value);
    }
    void frame(Frame& frame) override {
        const float before = gathers && past.valid() ? 0.125f : 0.0f;
        frame.raster("past", {.color = {past.now()}}, [](Raster&) {});
        const float grey = before + light + a_seed * float(frame.seed) +
                           (method.is("coarse") ? 0.125f / static_cast<float>(looks.value) : 0.0f);
        frame.raster("fill", {.color = {clear(frame.hdr, glm::vec4(glm::vec3(grey), 1))}}, [](Raster&) {});
        encode_srgb(frame);
    }
    ImageView judged(const Frame& frame) const override { return codes ? frame.output : frame.linear(); }
    void measure(Gpu& gpu, glm::uvec2 size, nlohmann::json& error) override {
        if (!measures) return;
        if (rude) error["rmse"] = 1;
        Frame further(gpu);
        looks.value = 512;
        render(*this, further, {size, 0, 0, {}});
        error["missing"] = double(light) - double(read_linear(gpu, further.hdr).at(0, 0).x);
        error["width"] = size.x;
    }
};

struct StudyFolder : FileFolder {
    StudyFolder() {
        for (const char* scene : {"a", "b"})
            write_file(path / (std::string(scene) + ".json"), R"({"knobs": {"light": 0.5}})");
    }
    std::string scene(const char* name) const { return (path / name).string() + ".json"; }
};

struct StudyTest {
    StudyFolder folder;
    GreyStudy chapter;
    Options options;
    nlohmann::json study = {
        {"title", "Greys"},
        {"error_metric", "max"},
        {"stage", "fragment"},
        {"size", {16, 8}},
        {"rounds", 1},
        {"truth", {{"set", {{"method", "exact"}}}, {"exact", true}}},
        {"scenes", {folder.scene("a"), {{"scene", folder.scene("b")}, {"set", {{"light", 1}}}, {"label", "bright"}}}},
        {"curves", {{{"method", "exact"}}, {{"method", "coarse"}, {"set", {{"looks", {1, 2}}}}}}}};

    StudyTest() { options.study = (folder.path / "out.json").string(); }
    nlohmann::json measure() {
        nlohmann::json result = resume();
        std::filesystem::remove(options.study + ".partial");
        return result;
    }
    nlohmann::json resume() { return measure_study(study.dump(1), "study.json", options, chapter, check_device()); }
    /// Its error message; empty if it is usable.
    std::string refusal() {
        return refusal_of([&] { read_study(parse_json(study.dump(1), "study.json"), chapter.all_knobs()); });
    }
};

}  // namespace lightwalk
