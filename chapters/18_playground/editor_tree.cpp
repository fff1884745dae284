#include <GLFW/glfw3.h>
#include <fmt/core.h>

#include <algorithm>

#include "18_playground/editor_part.h"
#include "18_playground/widgets.h"

namespace lightwalk {

namespace {

constexpr TextWidth eye_px{20.0f}, fold_px{20.0f};

const char* icon_of(const Entry& entry) {
    if (const SceneObject* object = entry.object()) return object->model.empty() ? icon::group : icon::object;
    return is_sun(entry) ? icon::sun : entry.light()->kind == Light::Kind::point ? icon::lamp : icon::spot;
}

}  // namespace

void TreePanel::draw() {
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
    const std::vector<TreeRow> rows = editor.tree.rows(editor.document);
    folds_ = std::any_of(rows.begin(), rows.end(), [](const TreeRow& row) { return row.has_children; });
    // As high as its rows, as long as the properties have the larger half.
    const float wanted =
        ImGui::GetTextLineHeightWithSpacing() * static_cast<float>(rows.size() + SettingsPanel::names().size() + 1);
    ImGui::BeginChild("tree", {0.0f, std::min(wanted, 0.5f * ImGui::GetContentRegionAvail().y)});
    if (ImGui::Selectable(with_icon(icon::scene, "scene").c_str(),
                          editor.selection.has(root_entry) && settings_.chosen.empty())) {
        editor.selection.set({root_entry});
        settings_.chosen.clear();
    }
    log_place("entry.scene");
    if (ImGui::BeginDragDropTarget()) {
        if (ImGui::AcceptDragDropPayload("entries")) say(reparent(editor.document, editor.selection.ids, root_entry));
        ImGui::EndDragDropTarget();
    }
    settings_.draw_rows();
    // Scrolls to an entry picked in the picture or by a key.
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

void TreePanel::draw_row(const TreeRow& row) {
    ImGui::PushID(static_cast<int>(row.id));
    ImGui::PushID(row.node);
    ImGui::Indent(TextWidth{12.0f} * static_cast<float>(row.depth) + 1.0f);
    if (row.node >= 0)
        ImGui::TextColored(quiet_color, "  node %d", row.node);
    else if (renaming_.id == row.id)
        draw_name_field(row.id);
    else
        draw_name(row);
    ImGui::Unindent(TextWidth{12.0f} * static_cast<float>(row.depth) + 1.0f);
    ImGui::PopID();
    ImGui::PopID();
}

void TreePanel::draw_name_field(EntryId id) {
    ImGui::SetNextItemWidth(-1.0f);
    focus_next(renaming_.begins);
    const bool named = text_field("##rename", renaming_.text, "", false, ImGuiInputTextFlags_AutoSelectAll);
    if (named || ImGui::IsItemDeactivated()) renaming_.id = no_entry;
    if (named) say(rename(editor.document, id, renaming_.text));
}

void TreePanel::draw_name(const TreeRow& row) {
    const Entry& entry = editor.document.at(row.id);
    const std::string shown_as = shown_name(entry);
    draw_fold(row);
    if (entry.hidden) ImGui::PushStyleColor(ImGuiCol_Text, quiet_color);
    const bool hidden = entry.hidden;
    const std::string locked = entry.locked ? "  " + std::string(icon_or(icon::lock, "(locked)")) : "";
    const ImVec2 room{ImGui::GetContentRegionAvail().x - eye_px, 0.0f};
    const std::string more = locked + (entry.included ? "  (included)" : "");
    const float beside = ImGui::CalcTextSize((with_icon(icon_of(entry), "") + more).c_str()).x;
    const std::string name = cut_text(shown_as, room.x - beside);
    const std::string label = with_icon(icon_of(entry), name) + more;
    if (ImGui::Selectable(label.c_str(), editor.selection.has(row.id), ImGuiSelectableFlags_AllowDoubleClick, room)) {
        choose(row.id);
        if (ImGui::IsMouseDoubleClicked(0)) begin_renaming(row.id);
    }
    if (hidden) ImGui::PopStyleColor();
    log_place("entry." + shown_as);
    if (name != shown_as) help_on_hover(shown_as.c_str());
    draw_menu(row.id);
    drag_and_drop(row.id, shown_as);
    draw_eye(row.id, hidden, shown_as);
}

// Names stand in one column, with a button before them or without.
void TreePanel::draw_fold(const TreeRow& row) {
    if (!folds_) return;
    const float left = ImGui::GetCursorPosX(), height = ImGui::GetTextLineHeight();
    const bool unfolded = editor.tree.is_unfolded(row.id);
    if (row.has_children) {
        ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0.0f, 0.0f});
        if (ImGui::Button(unfolded ? "-" : "+", {height, height})) editor.tree.unfold(row.id, !unfolded);
        ImGui::PopStyleVar();
        log_place("fold." + shown_name(editor.document.at(row.id)));
        ImGui::SameLine();
    }
    ImGui::SetCursorPosX(left + fold_px);
}

// At the right end of its row.
void TreePanel::draw_eye(EntryId id, bool hidden, const std::string& shown_as) {
    ImGui::SameLine(ImGui::GetContentRegionMax().x - eye_px);
    const bool clicked = ImGui::InvisibleButton("eye", {eye_px, ImGui::GetTextLineHeight()});
    log_place("eye." + shown_as);
    const ImVec2 corner = ImGui::GetItemRectMin();
    ImGui::GetWindowDrawList()->AddText(corner,
                                        ImGui::GetColorU32(ImGui::IsItemHovered() ? ImVec4{1, 1, 1, 1} : quiet_color),
                                        hidden ? icon_or(icon::hidden, "-") : icon_or(icon::eye, "o"));
    help_on_hover(hidden ? "Show it and its children" : "Hide it and its children");
    if (!clicked) return;
    ++editor.gesture;
    set_hidden(editor.document, {id}, !hidden);
}

// A range begins where no Shift was held, and stays there for the next one.
void TreePanel::choose(EntryId id) {
    const ImGuiIO& io = ImGui::GetIO();
    if (!editor.selection.has(last_clicked_)) last_clicked_ = editor.selection.active();
    const bool range = io.KeyShift && last_clicked_ > root_entry;
    if (range)
        editor.selection.set(editor.tree.between(last_clicked_, id));
    else if (io.KeyCtrl)
        editor.selection.toggle(id);
    else
        editor.selection.set({id});
    if (!range) last_clicked_ = id;
}

void TreePanel::drag_and_drop(EntryId id, const std::string& shown_as) {
    if (ImGui::BeginDragDropSource()) {
        if (!editor.selection.has(id)) editor.selection.set({id});
        ImGui::SetDragDropPayload("entries", &id, sizeof id);
        const size_t count = editor.selection.ids.size();
        ImGui::TextUnformatted((count == 1 ? shown_as : fmt::format("{} entries", count)).c_str());
        ImGui::EndDragDropSource();
    }
    if (ImGui::BeginDragDropTarget()) {
        if (ImGui::AcceptDragDropPayload("entries")) {
            say(reparent(editor.document, editor.selection.ids, id));
            editor.tree.unfold(id, true);  // shows newly added children
        }
        ImGui::EndDragDropTarget();
    }
}

void TreePanel::begin_renaming(EntryId id) {
    renaming_.id = id;
    renaming_.text = editor.document.at(id).name();
    renaming_.begins = true;
    editor.tree.show(editor.document, id);
    followed_ = no_entry;  // scrolls to its line, even during a search
    const std::vector<TreeRow>& rows = editor.tree.rows(editor.document);
    if (std::none_of(rows.begin(), rows.end(), [&](const TreeRow& row) { return row.id == id; })) {
        search_.clear();
        editor.tree.search("");
    }
}

// By the right button.
void TreePanel::draw_menu(EntryId id) {
    if (!ImGui::BeginPopupContextItem("menu")) return;
    if (!editor.selection.has(id)) editor.selection.set({id});
    const bool hidden = editor.document.at(id).hidden, locked = editor.document.at(id).locked;
    const auto item = [](const char* label, const char* key) {
        const bool chosen = ImGui::MenuItem(label, key);
        log_place(std::string("menu.") + label);
        return chosen;
    };
    if (item("rename", "Ctrl+R")) begin_renaming(id);
    if (item(hidden ? "show" : "hide", "Shift+H")) view_.press({'H', GLFW_MOD_SHIFT});
    if (item(locked ? "unlock" : "lock", "Shift+L")) view_.press({'L', GLFW_MOD_SHIFT});
    if (item("group", "Ctrl+G")) view_.press({'G', GLFW_MOD_CONTROL});
    if (item("duplicate", "Ctrl+D")) view_.press({'D', GLFW_MOD_CONTROL});
    if (item("frame", "F")) view_.press({'F', 0});
    if (item("delete", "Del")) { editor.remove_selected(); }
    ImGui::EndPopup();
}

// Scene-wide entries come first in the tree.
void TreePanel::walk(int by) {
    std::vector<EntryId> ids{root_entry};
    std::vector<std::string> names{""};
    for (const std::string& one : SettingsPanel::names()) {
        ids.push_back(root_entry);
        names.push_back(one);
    }
    for (const TreeRow& row : editor.tree.rows(editor.document))
        if (row.node < 0) {
            ids.push_back(row.id);
            names.emplace_back();
        }
    const EntryId active = editor.selection.active();
    int now = by < 0 ? static_cast<int>(ids.size()) : -1;
    for (size_t i = 0; i < ids.size(); ++i)
        if (ids[i] == active && (active != root_entry || names[i] == settings_.chosen)) now = static_cast<int>(i);
    const auto next = static_cast<size_t>(std::clamp(now + by, 0, static_cast<int>(ids.size()) - 1));
    editor.selection.set({ids[next]});
    settings_.chosen = names[next];
    last_clicked_ = ids[next];
}

void TreePanel::unfold_chosen(bool open) {
    if (const EntryId active = editor.selection.active(); active != no_entry) editor.tree.unfold(active, open);
}

void TreePanel::give_up_fields() {
    searches_ = renaming_.begins = false;
    renaming_.id = no_entry;
}

}  // namespace lightwalk
