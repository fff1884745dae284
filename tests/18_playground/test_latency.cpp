// How long an edit takes to the end of the frame that shows it, against the number of objects.
#include "18_playground/playground.h"
#include "common/app/render.h"
#include "editor_fixture.h"

using namespace lightwalk;

namespace {

double median(std::vector<double> times) {
    std::sort(times.begin(), times.end());
    return times.at(times.size() / 2);
}

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

    double picture() {
        const double start = now_ms();
        render(chapter, frame, {{64, 36}, 0, 0, {}});
        return now_ms() - start;
    }

    /// Milliseconds by which a frame is longer that shows the edit: medians of several.
    template <class Edit>
    double latency(int times, const Edit& edit) {
        std::vector<double> edited, still;
        for (int i = 0; i < times; ++i) {
            const double start = now_ms();
            edit(i);
            picture();
            edited.push_back(now_ms() - start);
            still.push_back(picture());
        }
        return median(edited) - median(still);
    }
};

}  // namespace

TEST_CASE("milliseconds from an edit to its picture, beyond those of a frame without one", "[.latency]") {
    fmt::print("{:>8} {:>10} {:>10} {:>10} {:>10} {:>10}\n", "objects", "one moved", "1000 moved", "one colour",
               "one more", "undo");
    for (const int count : {100, 1000, 10000, 100000}) {
        Field field(count);
        Document& document = field.document;
        const int times = count > 10000 ? 5 : 15;
        const auto move = [&](size_t most) {
            return field.latency(times, [&](int i) {
                document.begin("move");
                for (size_t at = 0; at < std::min(most, field.ids.size()); ++at)
                    document.edit(field.ids[at * field.ids.size() / std::min(most, field.ids.size())])
                        .object()
                        ->position.y = 0.1f * float(i + 1);
                document.commit();
            });
        };
        const double one = move(1), thousand = move(1000);
        const double color = field.latency(times, [&](int i) {
            document.begin("colour");
            document.edit(field.ids[0]).object()->material.diffuse = glm::vec3(0.02f * float(i + 1));
            document.commit();
        });
        const double more = field.latency(
            times, [&](int i) { add_object(document, named(fmt::format("new {}", i), "models/cube.obj")); });
        const double undo = field.latency(times, [&](int) { document.undo(); });
        fmt::print("{:>8} {:>10.2f} {:>10.2f} {:>10.2f} {:>10.2f} {:>10.2f}\n", count, one, thousand, color, more,
                   undo);
        CHECK(field.chapter.scene.items.size() == static_cast<size_t>(count));
    }
}
