// Scene-wide entries of the tree: camera, surroundings, terrain, water, fog and effects.
#include "18_playground/commands.h"
#include "18_playground/editor_part.h"
#include "18_playground/file_browser.h"
#include "18_playground/widgets.h"
#include "common/base/error.h"
#include "common/base/files.h"
#include "common/window/knob_widgets.h"

namespace lightwalk {
namespace {

struct Facet {
    const char* name;
    const char* help;
    const char* icon;
    std::vector<std::string> modules;       ///< modules with its knobs
    std::vector<std::string> own_fields{};  ///< knobs that a field of the scene's own stands for
};

const std::vector<Facet>& facets() {
    static const std::vector<Facet> all{
        {"camera", "The scene's own view, which it is opened with", icon::camera, {}},
        {"environment",
         "Light from all around",
         icon::image,
         {"environment", "backdrop"},
         {"environment.intensity", "environment.turn_deg"}},
        {"sky", "Sun, air and planet", icon::cloud, {"atmosphere", "sky"}},
        {"terrain", "Ground of a height map, under a sky", icon::terrain, {"ground", "land", "sun_shadow"}},
        {"water", "A surface of waves", icon::water, {"water"}},
        {"fog", "Air that scatters light, below a height", icon::fog, {"fog"}},
        {"effects", "Bloom, anti-aliasing, tones and lens", icon::effects, {"bloom", "mlaa", "post"}}};
    return all;
}

}  // namespace

std::vector<std::string> SettingsPanel::names() {
    std::vector<std::string> names;
    for (const Facet& facet : facets()) names.emplace_back(facet.name);
    return names;
}

// Whether the picture has it now; absent ones are grey.
bool SettingsPanel::is_there(const std::string& facet) const {
    if (facet == "environment") return bool(scene.file.environment);
    if (facet == "sky") return view_.chapter.bench.air.is("sky");
    if (facet == "terrain") return terrain_of(editor.document) != no_entry;
    if (facet == "water") return !view_.chapter.bench.water.method.is("none");
    if (facet == "fog") return !view_.chapter.bench.fog.method.is("none");
    if (facet == "effects") return !view_.chapter.bloom.method.is("none") || !view_.chapter.antialias.method.is("none");
    return true;
}

void SettingsPanel::draw_rows() {
    for (const Facet& facet : facets()) {
        const bool there = is_there(facet.name), is_chosen = editor.selection.has(root_entry) && chosen == facet.name;
        ImGui::Indent(TextWidth{13.0f});
        if (!there) ImGui::PushStyleColor(ImGuiCol_Text, quiet_color);
        if (ImGui::Selectable(with_icon(facet.icon, facet.name).c_str(), is_chosen)) {
            editor.selection.set({root_entry});
            chosen = facet.name;
        }
        if (!there) ImGui::PopStyleColor();
        log_place(std::string("entry.") + facet.name);
        help_on_hover(facet.help);
        ImGui::Unindent(TextWidth{13.0f});
    }
}

// The knobs of its modules: the document records every change as a step.
void SettingsPanel::draw_knobs() {
    for (const Facet& facet : facets()) {
        if (chosen != facet.name) continue;
        KnobList knobs;
        if (chosen == "sky") knobs.push_back(&view_.chapter.bench.air);
        for (KnobBase* knob : view_.chapter.all_knobs()) {
            const std::string path = knob->owner.path();
            if (std::find(facet.own_fields.begin(), facet.own_fields.end(), knob->path()) != facet.own_fields.end())
                continue;
            for (const std::string& module : facet.modules)
                if (path == module || path.starts_with(module + ".")) knobs.push_back(knob);
        }
        const float width = std::max<float>(label_column(knobs), label_px);
        // Each module has a method: one must see of what. The title of an entry names a module, too.
        std::string module = facet.own_fields.empty() ? chosen : "";
        if (!knobs.empty() && knobs.front()->owner.path() == module) log_place("module." + module);
        for (KnobBase* knob : knobs) {
            if (const std::string path = knob->owner.path(); std::exchange(module, path) != path && !path.empty()) {
                ImGui::Separator();
                ImGui::TextColored(quiet_color, "%s", path.c_str());
                log_place("module." + path);
            }
            view_.changed |= knob_widget(*knob, width, "", view_.automatic);
        }
    }
}

void SettingsPanel::set(const std::string& what, const SceneSettings& settings) {
    editor.document.begin(what, editor.gesture);
    *editor.document.edit(root_entry).settings() = settings;
    if (const Said said = cannot_be_saved(editor.document.at(root_entry), editor.store.path); !said.empty()) {
        editor.document.cancel();
        return fields_.refuse(said);
    }
    editor.document.commit();
}

void SettingsPanel::draw() {
    SceneSettings settings = editor.document.settings();
    if (!chosen.empty()) {
        ImGui::TextUnformatted(chosen.c_str());
        const bool changed = chosen == "camera"        ? draw_camera(settings)
                             : chosen == "environment" ? draw_environment(settings)
                                                       : false;
        if (chosen == "terrain") draw_terrain();
        if (changed) set(chosen, settings);
        return draw_knobs();
    }
    ImGui::TextUnformatted(editor.store.path.empty() ? "not saved yet" : editor.store.path.filename().c_str());
    bool changed =
        fields_.color("ambient", "Light from all sides where there is no environment", settings.ambient, 1e4f);
    changed |= fields_.color("background", "Colour where nothing is drawn, linear", settings.background, 1e4f);
    if (tool_button("save as", "Ctrl+Shift+S: saves to another file, which is edited from then on")) files_.ask_name();
    if (changed) set("scene", settings);
}

// True: `settings` are others now.
bool SettingsPanel::draw_camera(SceneSettings& settings) {
    bool changed = false;
    if (tool_button("take this view", "The scene's own camera becomes the one that is shown")) {
        settings.camera = view_.chapter.camera;
        changed = true;
    }
    ImGui::SameLine();
    if (tool_button("go there", "The view becomes the scene's own")) {
        view_.chapter.camera = settings.camera;
        view_.changed = true;
    }
    draw_output_shape();
    Camera& own = settings.camera;
    changed |= fields_.numbers("position", "Position of the camera, in metres", own.position, 0.01f);
    changed |= fields_.numbers("target", "Point in the middle of the picture, in metres", own.target, 0.01f);
    float degrees = glm::degrees(own.fov_y_rad);
    if (fields_.number("field of view", "Vertical field of view, in degrees", degrees, 0.2f, 1.0f, 170.0f)) {
        own.fov_y_rad = glm::radians(degrees);
        changed = true;
    }
    changed |= fields_.number("near", "Distance of the near plane, in metres", own.near_m, 0.001f, 1e-5f, 1e5f);
    changed |= fields_.number("far", "Distance of the far plane, in metres; 1e9 is none", own.far_m, 0.01f * own.far_m,
                              1e-4f, 1e9f, false, "none");
    return changed;
}

// Of the window, not of the scene.
void SettingsPanel::draw_output_shape() {
    OutputFrame& output = view_.chapter.output_frame;
    label_left("output");
    ImGui::SetNextItemWidth(-beside_px());
    const bool open = ImGui::BeginCombo("##output", OutputFrame::names()[output.shape]);
    log_place("choice.output");
    help_on_hover("Frame of a picture of another shape, over this one");
    if (!open) return;
    for (size_t i = 0; i < OutputFrame::names().size(); ++i) {
        if (ImGui::Selectable(OutputFrame::names()[i], i == output.shape)) {
            output.shape = i;
            view_.changed = true;
        }
        log_place(std::string("option.") + OutputFrame::names()[i]);
    }
    ImGui::EndCombo();
}

bool SettingsPanel::draw_environment(SceneSettings& settings) {
    bool changed = false;
    std::string image = settings.environment.image.string();
    label_left("image");
    ImGui::SetNextItemWidth(-beside_px());
    const bool typed = text_field("##image", image, "none");
    pick_button(view_, "environment", [this](const std::string& file) { put_environment(file); });
    if (typed && image != settings.environment.image) put_environment(image);
    changed |=
        fields_.number("brightness", "Factor of the image's light", settings.environment.intensity, 0.01f, 0.0f, 1e6f);
    changed |= fields_.number("turn", "Rotation about the vertical, in degrees", settings.environment.rotation_deg,
                              0.5f, -360.0f, 360.0f);
    return changed;
}

void SettingsPanel::put_environment(const std::string& image) try {
    if (!image.empty()) find_asset(image);
    SceneSettings settings = editor.document.settings();
    settings.environment.image = image;
    settings.environment.where = "environment";
    set("environment", settings);
} catch (const InputError& e) { editor.notice = e.what(); }

void SettingsPanel::draw_terrain() {
    const EntryId now = terrain_of(editor.document);
    const std::string shown = now == no_entry ? "" : editor.document.at(now).object()->model.string();
    std::string file = shown;
    label_left("height map");
    ImGui::SetNextItemWidth(-beside_px());
    if (text_field("##height map", file, "none") && file != shown) put_terrain(file);
    pick_button(view_, "terrain", [this](const std::string& chosen_file) { put_terrain(chosen_file); });
}

// One step: the knobs that it turns belong to the same gesture.
void SettingsPanel::put_terrain(const std::string& file) try {
    const bool first = terrain_of(editor.document) == no_entry;
    if (file.empty()) return set_terrain(editor.document, "", 0.0f, editor.gesture);
    const HeightMap map = read_height_map(find_asset(file));
    const float reach_m = 4.0f * side_m(map);
    set_terrain(editor.document, file, reach_m, editor.gesture);
    Camera& camera = view_.chapter.camera;
    camera.far_m = std::max(camera.far_m, reach_m);
    view_.changed = true;
    if (!first) return;
    const auto knobs = terrain_knobs(map, scene.bounds);
    for (KnobBase* knob : view_.chapter.all_knobs())
        if (const auto found = knobs.find(knob->path()); found != knobs.end()) knob->set(found->second);
} catch (const InputError& e) { editor.notice = e.what(); }

}  // namespace lightwalk
