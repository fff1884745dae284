// Thousands of lights and of steps.
#include "18_playground/marks.h"
#include "driven_editor.h"

using namespace lightwalk;

TEST_CASE("10,000 lights are duplicated, deleted and back within a tenth of a second each; they hide nothing") {
    Driven editor;
    Document& document = editor.document();
    Selection selection;
    selection.set(scatter(document, {{-5, 0, -5}, {5, 2, 5}}, 10000, 1));
    std::vector<MarkLine> lines;
    add_lights(lines, document, selection, editor.window.view_now);
    CHECK(lines.size() > 10000);  // their symbols
    CHECK(lines.size() < 10000 * 6 + 1000);
    Selection few;
    few.set({selection.ids.begin(), selection.ids.begin() + 100});
    std::vector<MarkLine> shapes;
    add_lights(shapes, document, few, editor.window.view_now);
    CHECK(shapes.size() > lines.size() + 50 * 100);  // and of a few what they light
    const auto takes_ms = [](const auto& command) {
        const double start = processor_ms();
        command();
        return processor_ms() - start;
    };
    CHECK(takes_ms([&] { duplicate(document, selection.ids); }) < 100.0);
    CHECK(takes_ms([&] { remove(document, selection.ids); }) < 100.0);
    CHECK(takes_ms([&] { document.undo(); }) < 100.0);
    CHECK(document.size() == 20003);
}

TEST_CASE("the list of steps goes back over 5,000 of them and forward again at once, and says how many") {
    Driven editor;
    Document& document = editor.document();
    const EntryId left = editor.named("left");
    for (int i = 1; i <= 5000; ++i) {
        document.begin("move " + std::to_string(i));
        document.edit(left).object()->position.x = float(i);
        document.commit();
    }
    const double start = processor_ms();
    editor.window.editor.go_to(editor.window, 17);
    CHECK(editor.x_of("left") == 17.0f);
    CHECK(editor.window.take_notice() == "undone: 4983 steps");
    editor.window.editor.go_to(editor.window, 4000);
    CHECK(editor.x_of("left") == 4000.0f);
    CHECK(editor.window.take_notice() == "done again: 3983 steps");
    CHECK(processor_ms() - start < 200.0);
    editor.window.editor.go_to(editor.window, 4000);
    CHECK(editor.window.take_notice().empty());
    editor.window.editor.go_to(editor.window, 0);
    CHECK(editor.x_of("left") == 0.0f);
    CHECK_FALSE(editor.window.editor.undo(editor.window));
    editor.window.editor.go_to(editor.window, 9999);
    CHECK(editor.x_of("left") == 5000.0f);
}
