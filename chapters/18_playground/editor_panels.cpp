// The editor's panels: the tree on the left, and what is selected below it.
#include <fmt/core.h>

#include <algorithm>

#include "18_playground/editor_window.h"
#include "18_playground/widgets.h"
#include "common/base/error.h"

namespace lightwalk {

// Not in a window in which it would cover most of the picture, as the panel on the right.
float EditorWindow::covered_px(glm::uvec2 picture, float scale) const {
    const float wanted = 270.0f * scale;
    return wanted < 0.6f * static_cast<float>(picture.x) ? wanted : 0.0f;
}

bool EditorWindow::draw_panels(glm::uvec2 picture, float scale) {
    picture_ = picture, covered_px_ = covered_px(picture, scale);
    const bool changed = std::exchange(changed_, false);
    const uint64_t state = editor.document.state();
    const std::vector<EntryId> selected = editor.selection.ids;
    const auto handles = std::pair(editor.tool, editor.local);
    if (const float width = covered_px_; width > 0.0f) {
        ImGui::SetNextWindowPos({0.0f, 0.0f});
        ImGui::SetNextWindowSize({width, static_cast<float>(picture.y)});
        ImGui::SetNextWindowBgAlpha(0.88f);
        ImGui::Begin("editor", nullptr,
                     ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                         ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                         ImGuiWindowFlags_NoBringToFrontOnFocus);
        draw_toolbar();
        draw_tree();
        draw_properties();
        ImGui::End();
    } else {  // no field is there to wait for the keyboard
        types_ = searches_ = renaming_begins_ = false, renaming_ = no_entry;
    }
    browser_.draw(scale, covered_px_);
    draw_loading(scale);
    draw_steps(scale);
    draw_keys(scale);
    draw_question();
    carry_on_previews();
    return changed || state != editor.document.state() || selected != editor.selection.ids ||
           handles != std::pair(editor.tool, editor.local) || editor.document.in_step();
}

void EditorWindow::draw_toolbar() {
    if (tool_button("open", "Ctrl+O: files, to add or to open")) browser_.shown = !browser_.shown;
    ImGui::SameLine();
    if (tool_button("undo", "Ctrl+Z")) editor.undo(*this);
    ImGui::SameLine();
    if (tool_button("redo", "Ctrl+Y")) editor.redo(*this);
    ImGui::SameLine();
    if (tool_button("steps", "F4: all steps by name; a click goes back or forward to one", shows_steps_))
        shows_steps_ = !shows_steps_;
    ImGui::SameLine();
    if (tool_button("?", "F1: all keys", shows_keys_)) shows_keys_ = !shows_keys_;
    if (tool_button("move", "1: move along axes and planes; with Shift in steps", editor.tool == Tool::move))
        editor.tool = Tool::move;
    ImGui::SameLine();
    if (tool_button("turn", "2: rotate; with Shift by 15°", editor.tool == Tool::rotate)) editor.tool = Tool::rotate;
    ImGui::SameLine();
    if (tool_button("size", "3: scale", editor.tool == Tool::scale)) editor.tool = Tool::scale;
    ImGui::SameLine();
    if (tool_button(editor.local ? "local" : "world", "L: axes of the world or of the object"))
        editor.local = !editor.local;
    const char* const kinds[] = {"sun", "lamp", "spot"};
    for (int i = 0; i < 3; ++i) {
        if (i > 0) ImGui::SameLine();
        if (tool_button(kinds[i], "Add a light: directional, point, spot"))
            editor.add_light(*this, static_cast<Light::Kind>(i));
    }
    if (tool_button("scatter", "Point and spot lights over the scene, as many as the number says")) scatter_lights();
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1.0f);
    ImGui::DragInt("##scatter", &scatter_count_, 10.0f, 1, 100000, "%d lights");
    scatter_count_ = std::clamp(scatter_count_, 1, 100000);
    log_place("number.scatter");
    help_on_hover("Number of lights that are scattered, up to 100,000");
}

void EditorWindow::scatter_lights() {
    editor.selection.set(scatter(editor.document, scene.bounds, scatter_count_, unsigned(editor.document.size())));
}

// [tree]
void EditorWindow::draw_tree() {
    ImGui::SetNextItemWidth(-1.0f);
    focus_next(searches_);
    if (text_field("##search", search_, "search the tree", true)) editor.tree.search(search_);
    help_on_hover("Search: words that must be in the name");
    editor.tree.node_count = [this](EntryId id) -> size_t {
        const SceneObject* object = editor.document.at(id).object();
        if (!object || object->model.empty()) return 0;
        for (const DrawItem& item : scene.items)
            if (editor.live.entry_of(item.object) == id) return item.model->model.nodes.size();
        return 0;
    };
    if (editor.document.size() > 2000) editor.tree.node_count = nullptr;  // every item would be asked for every entry
    begin_padded_child("tree", {0.0f, ImGui::GetContentRegionAvail().y * 0.45f});
    if (ImGui::Selectable("scene", editor.selection.has(root_entry) && facet_.empty()))
        editor.selection.set({root_entry}), facet_.clear();
    log_place("entry.scene");
    if (ImGui::BeginDragDropTarget()) {
        if (ImGui::AcceptDragDropPayload("entries")) say(reparent(editor.document, editor.selection.ids, root_entry));
        ImGui::EndDragDropTarget();
    }
    draw_facets();
    const std::vector<TreeRow> rows = editor.tree.rows(editor.document);
    // What was picked in the picture, or by a key, comes into sight.
    if (const EntryId active = editor.selection.active(); std::exchange(followed_, active) != active) {
        const auto row = std::find_if(rows.begin(), rows.end(), [&](const TreeRow& one) { return one.id == active; });
        if (row != rows.end()) scroll_to_row(static_cast<size_t>(row - rows.begin()));
    }
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(rows.size()));
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
            if (editor.document.find(rows[static_cast<size_t>(i)].id)) draw_row(rows[static_cast<size_t>(i)]);
    ImGui::EndChild();
}

void EditorWindow::draw_row(const TreeRow& row) {
    const Entry& entry = editor.document.at(row.id);
    const std::string shown_as = shown_name(entry);
    ImGui::PushID(static_cast<int>(row.id));
    ImGui::PushID(row.node);
    ImGui::Indent(12.0f * static_cast<float>(row.depth) + 1.0f);
    if (row.node >= 0) {
        ImGui::TextColored(quiet_color, "  node %d", row.node);
    } else if (renaming_ == row.id) {
        ImGui::SetNextItemWidth(-1.0f);
        focus_next(renaming_begins_);
        const bool named = text_field("##rename", renaming_text_, "", false, ImGuiInputTextFlags_AutoSelectAll);
        if (named || ImGui::IsItemDeactivated()) renaming_ = no_entry;
        if (named) say(rename(editor.document, row.id, renaming_text_));
    } else {
        if (row.has_children && ImGui::SmallButton(editor.tree.is_unfolded(row.id) ? "-" : "+"))
            editor.tree.unfold(row.id, !editor.tree.is_unfolded(row.id));
        if (row.has_children) ImGui::SameLine();
        if (entry.hidden) ImGui::PushStyleColor(ImGuiCol_Text, quiet_color);
        const std::string label =
            shown_as + (entry.locked ? "  (locked)" : "") + (entry.included ? "  (included)" : "");
        if (ImGui::Selectable(label.c_str(), editor.selection.has(row.id), ImGuiSelectableFlags_AllowDoubleClick)) {
            const ImGuiIO& io = ImGui::GetIO();
            // A range begins where no Shift was held, and stays there for the next one.
            if (!editor.selection.has(last_clicked_)) last_clicked_ = editor.selection.active();
            const bool range = io.KeyShift && last_clicked_ > root_entry;
            if (range)
                editor.selection.set(editor.tree.between(last_clicked_, row.id));
            else if (io.KeyCtrl)
                editor.selection.toggle(row.id);
            else
                editor.selection.set({row.id});
            if (!range) last_clicked_ = row.id;
            if (ImGui::IsMouseDoubleClicked(0)) begin_renaming(row.id);
        }
        if (entry.hidden) ImGui::PopStyleColor();
        log_place("entry." + shown_as);
        draw_row_menu(row.id);
        if (ImGui::BeginDragDropSource()) {
            if (!editor.selection.has(row.id)) editor.selection.set({row.id});
            ImGui::SetDragDropPayload("entries", &row.id, sizeof row.id);
            const size_t count = editor.selection.ids.size();
            ImGui::TextUnformatted((count == 1 ? shown_as : fmt::format("{} entries", count)).c_str());
            ImGui::EndDragDropSource();
        }
        if (ImGui::BeginDragDropTarget()) {
            if (ImGui::AcceptDragDropPayload("entries")) {
                say(reparent(editor.document, editor.selection.ids, row.id));
                editor.tree.unfold(row.id, true);  // it shows what has come
            }
            ImGui::EndDragDropTarget();
        }
    }
    ImGui::Unindent(12.0f * static_cast<float>(row.depth) + 1.0f);
    ImGui::PopID();
    ImGui::PopID();
}
// [/tree]

void EditorWindow::begin_renaming(EntryId id) {
    renaming_ = id, renaming_text_ = editor.document.at(id).name(), renaming_begins_ = true;
    editor.tree.show(editor.document, id);
    followed_ = no_entry;  // its line comes into sight, whatever is being searched
    const std::vector<TreeRow>& rows = editor.tree.rows(editor.document);
    if (std::none_of(rows.begin(), rows.end(), [&](const TreeRow& row) { return row.id == id; }))
        search_.clear(), editor.tree.search("");
}

// By the right button.
void EditorWindow::draw_row_menu(EntryId id) {
    if (!ImGui::BeginPopupContextItem("menu")) return;
    if (!editor.selection.has(id)) editor.selection.set({id});
    const bool hidden = editor.document.at(id).hidden, locked = editor.document.at(id).locked;
    const auto item = [](const char* label, const char* key) {
        const bool chosen = ImGui::MenuItem(label, key);
        log_place(std::string("menu.") + label);
        return chosen;
    };
    if (item("rename", "Ctrl+R")) begin_renaming(id);
    if (item(hidden ? "show" : "hide", "Shift+H")) on_shift_key('H');
    if (item(locked ? "unlock" : "lock", "Shift+L")) on_shift_key('L');
    if (item("group", "Ctrl+G")) on_control_key({'G', 0});
    if (item("duplicate", "Ctrl+D")) on_control_key({'D', 0});
    if (item("frame", "F")) frame_selected();
    if (item("delete", "Del")) {
        say(remove(editor.document, editor.selection.ids));
        editor.selection.drop_missing(editor.document);
    }
    ImGui::EndPopup();
}

void EditorWindow::draw_keys(float scale) {
    if (!shows_keys_) return;
    ImGui::SetNextWindowPos({covered_px_ + 10.0f * scale, 60.0f * scale}, ImGuiCond_FirstUseEver);
    if (ImGui::Begin("keys", &shows_keys_, ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize)) {
        static constexpr const char* keys[][2] = {
            {"click, Shift and click", "select; add to the selection"},
            {"drag a handle", "move, rotate, scale; with Shift in steps"},
            {"1, 2, 3, L", "move, rotate, scale; world or local axes"},
            {"F", "frame what is selected"},
            {"Up, Down, Left, Right", "the tree: select another entry; fold, unfold"},
            {"Enter, Tab", "type numbers of what is selected; the next one"},
            {"properties of several", "what is typed is set in all; a dash: they differ"},
            {"Ctrl+F, Ctrl+R", "search the tree; rename, as by a double click"},
            {"Shift+H, Shift+L", "hide or show; lock or unlock"},
            {"Shift+1, 2, 3, 4", "add a sun, a lamp, a spot; scatter lights"},
            {"Ctrl+Z, Ctrl+Y, F4", "undo, redo; the list of all steps"},
            {"Ctrl+D, Ctrl+G, Del", "duplicate, group, delete"},
            {"Ctrl+O, Ctrl+S, Ctrl+E", "files, save (with Shift: as), export to glTF"},
            {"Ctrl+A, Esc", "select all; nothing, then close"},
            {"F12, F1, H", "picture; these keys; the knobs"},
            {"F2, F3, F5", "switch all exercises, mine beside reference, reload"},
            {"drag, wheel, right button", "orbit, come closer, look and fly"},
            {"right button in the tree", "what can be done with an entry"}};
        for (const auto& [key, help] : keys) {
            ImGui::TextColored(reference_color, "%-28s", key);
            ImGui::SameLine(220.0f * scale);
            ImGui::TextUnformatted(help);
        }
    }
    ImGui::End();
}

}  // namespace lightwalk
