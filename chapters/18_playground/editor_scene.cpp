// What the scene has once: its camera, its surroundings, its water and its fog, as entries of the tree.
#include "18_playground/editor_window.h"
#include "18_playground/widgets.h"
#include "common/base/error.h"
#include "common/base/files.h"
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
        for (KnobBase* knob : knobs) changed_ |= knob_widget(*knob, width, "", automatic);
    }
}
// [/facets]

void EditorWindow::set_settings(const std::string& what, const SceneSettings& settings) {
    editor.document.begin(what, editor.gesture);
    *editor.document.edit(root_entry).settings() = settings;
    if (const Said said = cannot_be_saved(editor.document.at(root_entry), editor.store.path); !said.empty()) {
        editor.document.cancel();
        return refuse(said);
    }
    editor.document.commit();
}

void EditorWindow::draw_settings() {
    if (!facet_.empty()) ImGui::TextUnformatted(facet_.c_str());
    if (facet_ == "environment" || facet_ == "camera") return draw_facet_settings();
    if (!facet_.empty()) return draw_facet();
    ImGui::TextUnformatted(editor.store.path.empty() ? "not saved yet" : editor.store.path.filename().c_str());
    SceneSettings settings = editor.document.settings();
    bool changed = color("ambient", "Light from all sides where there is no environment", settings.ambient, 1e4f);
    changed |= color("background", "Colour where nothing is drawn, linear", settings.background, 1e4f);
    ImGui::SetNextItemWidth(-color_label_px);
    text_field("##save as", save_name_, "scene.json");
    ImGui::SameLine();
    if (tool_button("save as", "Ctrl+Shift+S: saves to this file, which is edited from then on")) save_as();
    if (changed) set_settings("scene", settings);
}

// What a facet has beside knobs.
void EditorWindow::draw_facet_settings() {
    SceneSettings settings = editor.document.settings();
    bool changed = false;
    if (facet_ == "camera") {
        if (tool_button("take this view", "The scene's own camera becomes the one that is shown"))
            settings.camera = camera, changed = true;
        ImGui::SameLine();
        if (tool_button("go there", "The view becomes the scene's own")) camera = settings.camera, changed_ = true;
        Camera& own = settings.camera;
        changed |= numbers("position", "Position of the camera, in metres", own.position, 0.01f);
        changed |= numbers("target", "Point in the middle of the picture, in metres", own.target, 0.01f);
        float degrees = glm::degrees(own.fov_y_rad);
        if (number("field of view", "Vertical field of view, in degrees", degrees, 0.2f, 1.0f, 170.0f))
            own.fov_y_rad = glm::radians(degrees), changed = true;
        changed |= number("near", "Distance of the near plane, in metres", own.near_m, 0.001f, 1e-5f, 1e5f);
        changed |= number("far", "Distance of the far plane, in metres", own.far_m, 1.0f, 1e-4f, 1e9f);
    } else {
        std::string image = settings.environment.image.string();
        ImGui::SetNextItemWidth(-short_label_px);
        if (text_field("image", image, "none") && image != settings.environment.image) try {
                if (!image.empty()) find_asset(image);
                settings.environment.image = image, settings.environment.where = "environment", changed = true;
            } catch (const InputError& e) { editor.notice = e.what(); }
        changed |=
            number("brightness", "Factor of the image's light", settings.environment.intensity, 0.01f, 0.0f, 1e6f);
        changed |= number("turn", "Rotation about the vertical, in degrees", settings.environment.rotation_deg, 0.5f,
                          -360.0f, 360.0f);
    }
    if (changed) set_settings(facet_, settings);
    draw_facet();
}

}  // namespace lightwalk
