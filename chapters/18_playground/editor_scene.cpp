// What the scene has once: its camera, its surroundings, its water and its fog, as entries of the tree.
#include "18_playground/editor_window.h"
#include "18_playground/widgets.h"
#include "common/window/knob_widgets.h"

namespace lightwalk {
namespace {

struct Facet {
    const char* name;
    const char* help;
    std::vector<std::string> modules;  ///< whose knobs it has
};

const std::vector<Facet>& facets() {
    static const std::vector<Facet> all{{"camera", "The scene's own view, which it is opened with", {}},
                                        {"environment", "Light from all around", {"environment", "backdrop"}},
                                        {"sky", "Sun, air and planet", {"atmosphere", "sky"}},
                                        {"water", "A surface of waves", {"water"}},
                                        {"fog", "Air that scatters light, below a height", {"fog"}}};
    return all;
}

}  // namespace

std::vector<std::string> EditorWindow::facet_names() {
    std::vector<std::string> names;
    for (const Facet& facet : facets()) names.emplace_back(facet.name);
    return names;
}

// Whether the picture has it now; what it has not is grey.
bool EditorWindow::has_facet(const std::string& facet) const {
    if (facet == "environment") return bool(scene.file.environment);
    if (facet == "sky") return air.is("sky");
    if (facet == "water") return !water.method.is("none");
    if (facet == "fog") return !fog.method.is("none");
    return true;
}

// [facets]
void EditorWindow::draw_facets() {
    for (const Facet& facet : facets()) {
        const bool there = has_facet(facet.name), chosen = editor.selection.has(root_entry) && facet_ == facet.name;
        ImGui::Indent(13.0f);
        if (!there) ImGui::PushStyleColor(ImGuiCol_Text, quiet_color);
        if (ImGui::Selectable(facet.name, chosen)) editor.selection.set({root_entry}), facet_ = facet.name;
        if (!there) ImGui::PopStyleColor();
        log_place(std::string("entry.") + facet.name);
        help_on_hover(facet.help);
        ImGui::Unindent(13.0f);
    }
}

// The knobs of the modules that make it: the steps of the document follow them, whoever turns them.
void EditorWindow::draw_facet() {
    for (const Facet& facet : facets()) {
        if (facet_ != facet.name) continue;
        KnobList knobs;
        if (facet_ == "sky") knobs.push_back(&air);
        for (KnobBase* knob : all_knobs()) {
            const std::string path = knob->owner.path();
            for (const std::string& module : facet.modules)
                if (path == module || path.starts_with(module + ".")) knobs.push_back(knob);
        }
        const float width = label_column(knobs);
        for (KnobBase* knob : knobs) changed_ |= knob_widget(*knob, width, "");
    }
}
// [/facets]

}  // namespace lightwalk
