#include <fmt/core.h>

#include <cstdlib>
#include <string_view>

#include "18_playground/editor_part.h"
#include "18_playground/widgets.h"
#include "common/window/knob_sections.h"

namespace lightwalk {
namespace {

constexpr const char* memory = "18_playground.tour";

struct TourStep {
    const char *title, *text;
    bool (*is_done)(const Tour::Facts& begin, const Tour::Facts& now);
};

using Facts = Tour::Facts;
constexpr TourStep tour_steps[] = {
    {"Look around", "Drag in the picture to orbit. The wheel comes closer, the right button with WASD flies.",
     [](const Facts& begin, const Facts& now) { return now.camera != begin.camera; }},
    {"Select", "Click an object in the picture, or its name in the tree. Home brings the first view back.",
     [](const Facts&, const Facts& now) { return now.selected > 0; }},
    {"Move", "Drag one of the arrows. With Shift it goes in steps; the line below the picture says how far.",
     [](const Facts& begin, const Facts& now) { return now.done > begin.done; }},
    {"Undo", "Ctrl+Z takes the last step back, Ctrl+Y does it again. F4 lists all of them.",
     [](const Facts& begin, const Facts& now) { return now.done < begin.done; }},
    {"Turn and scale", "Press 2 for rings that turn, 3 for handles that scale, 1 for arrows again.",
     [](const Facts& begin, const Facts& now) { return now.tool != begin.tool; }},
    {"Add a lamp", "Point at a surface and press Shift+2, or click lamp above: a light lands there.",
     [](const Facts& begin, const Facts& now) { return now.lights > begin.lights; }},
    {"Add a model", "Ctrl+O shows the course's files. Drag one into the picture: it stands where you drop it.",
     [](const Facts& begin, const Facts& now) { return now.objects > begin.objects; }},
    {"A sky", "Choose sky in the tree and set air to sky: the sun, blue air and a horizon.",
     [](const Facts&, const Facts& now) { return now.sky; }},
    {"Water or fog", "Choose water or fog in the tree and give it a method. Level and density are below it.",
     [](const Facts&, const Facts& now) { return now.weather; }},
    {"Save", "Ctrl+S saves, with Shift under another name. Any chapter opens the file with --scene.",
     [](const Facts&, const Facts& now) { return now.saved; }}};

}  // namespace

Tour::Tour(EditorView& view) : EditorPart(view) {
    if (!read_panel_memory(memory)["left"]) step_ = 1;
}

void Tour::begin() { go_to(1); }

bool Tour::is_done(size_t step, const Facts& begin, const Facts& now) {
    return tour_steps[step - 1].is_done(begin, now);
}

Tour::Facts Tour::facts() const {
    const Workbench& bench = view_.chapter.bench;
    Facts now{.camera = view_.chapter.camera.position, .done = editor.document.done(), .tool = editor.tool};
    for (const EntryId id : editor.selection.ids) now.selected += id != root_entry;
    for (const EntryId id : editor.document.at(root_entry).children)
        ++(editor.document.at(id).light() ? now.lights : now.objects);
    now.sky = bench.air.is("sky");
    now.weather = !bench.water.method.is("none") || !bench.fog.method.is("none");
    now.saved = !editor.store.has_unsaved(editor.document);
    return now;
}

void Tour::go_to(size_t step) {
    if (step > std::size(tour_steps)) return leave();
    step_ = step;
    begin_ = facts();
    log_event(fmt::format("tour {}", step_));
}

void Tour::leave() {
    step_ = 0;
    write_panel_memory(memory, {{"left", true}});
    log_event("tour left");
    view_.changed = true;
}

void Tour::draw(float width_px, float scale) {
    if (!shown()) return;
    if (begin_.objects + begin_.lights == 0) begin_ = facts();  // the scene has arrived since
    const float high = height_px(scale);
    ImGui::SetNextWindowPos({0.0f, ImGui::GetIO().DisplaySize.y - high});
    ImGui::SetNextWindowSize({width_px, high});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, {0.12f, 0.17f, 0.24f, 1.0f});
    ImGui::Begin("tour", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
    const TourStep& step = tour_steps[step_ - 1];
    ImGui::TextColored(reference_color, "%zu of %zu", step_, std::size(tour_steps));
    ImGui::SameLine();
    ImGui::TextUnformatted(step.title);
    ImGui::PushTextWrapPos();
    ImGui::TextUnformatted(step.text);
    ImGui::PopTextWrapPos();
    ImGui::SetCursorPosY(high - ImGui::GetFrameHeight() - ImGui::GetStyle().WindowPadding.y);
    size_t next = step_;
    if (tool_button("back", "The step before") && step_ > 1) --next;
    ImGui::SameLine();
    if (tool_button("next", "The next step, whether this one is done or not")) ++next;
    ImGui::SameLine();
    if (tool_button("leave the tour", "It does not come again by itself; F1 begins it"))
        next = std::size(tour_steps) + 1;
    ImGui::End();
    if (next == step_ && !editor.drag && is_done(step_, begin_, facts())) ++next;
    if (next != step_) go_to(next);
}

}  // namespace lightwalk
