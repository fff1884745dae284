// Latency of an edit, to the end of the frame that shows it, against the number of objects. It writes build/edits.json,
// a study (docs/study_format.md), with the share of pixels that differ from the saved and reloaded scene as error.
#include <nlohmann/json.hpp>

#include "18_playground/playground.h"
#include "common/app/render.h"
#include "editor_fixture.h"

using namespace lightwalk;

namespace {

constexpr glm::uvec2 size{64, 36};
constexpr int moved = 1000;

/// A playground with cubes in a square, some pixels each: the picture costs little beside the edit.
struct Field {
    Gpu& gpu = check_device();
    Playground chapter;
    Frame frame{gpu};
    std::vector<EntryId> ids;
    Document& document = chapter.editor.document;

    explicit Field(int count) {
        chapter.name = "18_playground";
        load_scene(chapter, gpu, "models/cube.obj");
        const int side = static_cast<int>(std::ceil(std::sqrt(double(count))));
        document.begin("many");
        for (int i = 1; i < count; ++i) {
            SceneObject object = named(fmt::format("cube {}", i), "models/cube.obj");
            object.position = {2.0f * float(i % side), 0, -2.0f * float(i / side)};
            ids.push_back(document.add(root_entry, {.what = object}));
        }
        document.commit();
        picture();
    }

    void picture() { render(chapter, frame, {size, 0, 0, {}}); }

    void move(size_t most, int i) {
        document.begin("move");
        for (size_t at = 0; at < std::min(most, ids.size()); ++at)
            document.edit(ids[at * ids.size() / std::min(most, ids.size())]).object()->position.y = 0.1f * float(i + 1);
        document.commit();
    }

    void color(int i) {
        document.begin("colour");
        document.edit(ids[0]).object()->material.diffuse = glm::vec3(0.02f * float(i + 1));
        document.commit();
    }

    /// Share of the pixels that differ from the saved scene, loaded by another playground.
    double wrong_pixels() {
        const ImageRgb ours = render_linear(chapter, gpu, size);
        const FileFolder folder;
        write_file(folder.path / "saved.json", scene_text(exported(document).scene));
        Playground again;
        again.name = chapter.name;
        load_scene(again, gpu, folder.path / "saved.json");
        const ImageRgb theirs = render_linear(again, gpu, size);
        int wrong = 0;
        for (size_t i = 0; i < ours.pixels.size(); ++i) wrong += ours.pixels[i] != theirs.pixels[i];
        return double(wrong) / double(ours.pixels.size());
    }
};

/// A point of the study: milliseconds from the edit to the end of the frame that shows it, quartiles of several.
template <class Edit>
nlohmann::json measured(Field& field, const char* method, int count, const Edit& edit) {
    std::vector<double> times;
    for (int i = 0; i < (count > 10000 ? 7 : 15); ++i) {
        field.picture();  // work of the previous edit is done
        const double start = now_ms();
        edit(i);
        field.picture();
        times.push_back(now_ms() - start);
    }
    std::sort(times.begin(), times.end());
    const auto quartile = [&](size_t q) { return times[(times.size() - 1) * q / 4]; };
    const double wrong = field.wrong_pixels();
    fmt::print("{:>8} {:20} {:>9.2f} ms ({:.2f} to {:.2f})\n", count, method, quartile(2), quartile(1), quartile(3));
    CHECK(wrong == 0.0);
    return {{"scene", "cubes"},
            {"method", method},
            {"knobs", {{"objects", count}}},
            {"error", {{"wrong_pixels", wrong}}},
            {"time_ms",
             {{"median", quartile(2)},
              {"q1", quartile(1)},
              {"q3", quartile(3)},
              {"rounds", times.size()},
              {"per_pass", nlohmann::json::object()}}}};
}

}  // namespace

TEST_CASE("milliseconds from an edit to its picture, and of a frame without one", "[.latency]") {
    const DeviceInfo& device = check_device().device.info;
    nlohmann::json study{
        {"chapter", "18_playground"},
        {"title", "From an edit to the end of the frame that shows it, against the number of objects"},
        {"subject", "frame"},
        {"device", device.name},
        {"driver", device.driver},
        {"stage", "processor"},
        {"size", {size.x, size.y}},
        {"command", "build/tests/test_18_playground \"[.latency]\""},
        {"error_metric", "wrong_pixels"},
        {"metrics", {{"wrong_pixels", "share of wrong pixels"}}},
        {"charts",
         {{{"name", "main"}, {"x", "knob objects"}, {"y", "time"}, {"x_label", "objects"}, {"panel", "{scene}"}}}}};
    for (const int count : {100, 1000, 10000, 100000}) {
        Field field(count);
        const auto add = [&](const char* method, const auto& edit) {
            study["points"].push_back(measured(field, method, count, edit));
        };
        add("no edit", [](int) {});
        add("one object moved", [&](int i) { field.move(1, i); });
        add("1,000 moved", [&](int i) { field.move(moved, i); });
        add("one colour", [&](int i) { field.color(i); });
        add("one object more",
            [&](int i) { add_object(field.document, named(fmt::format("new {}", i), "models/cube.obj")); });
        add("undo of one more", [&](int) { field.document.undo(); });
        CHECK(field.chapter.scene.items.size() == static_cast<size_t>(count) + 1);  // a bare model stands on ground
    }
    write_file(course_root() / "build/edits.json", study.dump(1, '\t') + "\n");
}
