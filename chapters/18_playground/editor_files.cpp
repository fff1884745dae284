#include <GLFW/glfw3.h>

#include "18_playground/editor_part.h"
#include "18_playground/file_browser.h"
#include "18_playground/widgets.h"
#include "common/base/error.h"
#include "common/base/files.h"

namespace lightwalk {
namespace fs = std::filesystem;
namespace {

constexpr double autosave_every_s = 30.0;

}  // namespace

void SceneFiles::save(bool overwrite) {
    if (asks()) return;  // which is answered first
    editor.end_drag(true);
    const bool own = saves_own();
    try {
        if (!overwrite && (own ? editor.store.changed_on_disk() : file_exists(save_target()))) {
            asked_.what = Question::overwrite;
            view_.changed = true;
            return;
        }
        editor.save(view_.chapter, own ? fs::path() : save_target());
        remember_file(editor.store.path);
        log_event("saved " + fs::absolute(editor.store.path).string());
    } catch (const std::exception& e) {
        editor.notice = "not saved: " + std::string(e.what());
        log_event("not saved");
    }
    saves_as_ = false;
}

void SceneFiles::ask_name() {
    if (asks()) return;
    editor.end_drag(true);
    if (saves_own()) name = editor.store.path.filename().string();
    asked_ = {.what = Question::name, .key = 0, .begins = true};
    view_.changed = true;
}

void SceneFiles::save_as() {
    saves_as_ = true;
    save();
}

// The course's own scenes are not written over.
bool SceneFiles::saves_own() const {
    const fs::path& file = editor.store.path;
    return !saves_as_ && !file.empty() && !lies_below(file, course_root() / "assets");
}

fs::path SceneFiles::save_target() const {
    const fs::path named = name;
    return saves_own() ? editor.store.path : named.extension() == ".json" ? named : fs::path(named.string() + ".json");
}

// Beside the scene, where it has a folder of its own.
fs::path SceneFiles::export_target() const { return fs::absolute(save_target().replace_extension(".gltf")); }

void SceneFiles::ask_export() {
    const fs::path target = export_target();
    if (target != exported_ && file_exists(target))
        asked_.what = Question::export_over;
    else
        exports_ = true;
    view_.changed = true;
}

void SceneFiles::export_due() {
    if (!std::exchange(exports_, false)) return;
    const fs::path target = export_target();
    try {
        editor.export_to(scene, target);
        exported_ = target;
    } catch (const InputError& e) { editor.notice = "not exported: " + std::string(e.what()); }
    view_.changed = true;
}

void SceneFiles::check_recovery() {
    if (std::exchange(checked_, editor.store.path) == editor.store.path) return;
    Said said;
    if (editor.store.has_recovery(&said)) asked_.what = Question::recover;
    say(said);
}

void SceneFiles::draw_question() {
    const int pressed = std::exchange(asked_.key, 0);
    if (!asks()) return;
    if (!ImGui::IsPopupOpen("question")) ImGui::OpenPopup("question");
    const glm::vec2 middle = glm::vec2(view_.picture.corner) + 0.5f * glm::vec2(view_.picture.size);
    ImGui::SetNextWindowPos({middle.x, middle.y}, ImGuiCond_Always, {0.5f, 0.5f});
    if (!ImGui::BeginPopupModal("question", nullptr, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoTitleBar))
        return;
    const Question asked = asked_.what;
    ImGui::TextUnformatted(question_text(asked).c_str());
    if (asked == Question::name)
        draw_name(pressed);
    else
        draw_answers(asked, pressed);
    if (asked_.what == asked) return ImGui::EndPopup();
    view_.changed = true;
    ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

std::string SceneFiles::question_text(Question asked) const {
    const fs::path& own = editor.store.path;
    switch (asked) {
        case Question::name:
            return "Save the scene as";
        case Question::close:
            return "The scene has changes that are not saved.";
        case Question::overwrite:
            return save_target().string() + " is there already, or was written by somebody else.";
        case Question::export_over:
            return export_target().string() + " is there already.";
        default:
            return (own.empty() ? save_target() : own).string() + " was not saved when the program ended last.";
    }
}

// Enter saves, Escape leaves all as it is; in the field and outside of it.
void SceneFiles::draw_name(int pressed) {
    ImGui::SetNextItemWidth(TextWidth{420.0f});
    focus_next(asked_.begins);
    const ImGuiInputTextFlags flags = ImGuiInputTextFlags_AutoSelectAll | ImGuiInputTextFlags_EnterReturnsTrue;
    const bool enter = text_field("##scene name", name, "scene.json", true, flags);
    const bool escape = ImGui::IsItemDeactivated() && key_pressed(ImGuiKey_Escape);
    saves_as_ = true;
    ImGui::TextColored(quiet_color, "%s", fs::absolute(save_target()).c_str());
    saves_as_ = false;
    const bool saves =
        tool_button("save", "Enter") || enter || pressed == GLFW_KEY_ENTER || pressed == GLFW_KEY_KP_ENTER;
    ImGui::SameLine();
    const bool cancels =
        tool_button("cancel name", "Esc: nothing is saved", false, "cancel") || escape || pressed == GLFW_KEY_ESCAPE;
    if (cancels || (saves && !name.empty())) asked_.what = Question::nothing;
    if (saves && !cancels && !name.empty()) save_as();
}

// Enter is the first answer, Escape the one that leaves all as it is.
void SceneFiles::draw_answers(Question asked, int pressed) {
    const auto answer = [&](const char* label, int key = GLFW_KEY_UNKNOWN) {
        const bool by_key = pressed == key || (pressed == GLFW_KEY_KP_ENTER && key == GLFW_KEY_ENTER);
        const bool yes = ImGui::Button(label) || by_key;
        log_place(std::string("answer.") + label);
        ImGui::SameLine();
        if (yes) asked_.what = Question::nothing;
        return yes;
    };
    if (asked == Question::close) {
        if (answer("save", GLFW_KEY_ENTER)) {
            save();
            closes_ = !editor.store.has_unsaved(editor.document);
        }
        if (answer("discard")) {
            editor.store.forget_autosave();
            closes_ = true;
        }
        answer("stay", GLFW_KEY_ESCAPE);
    } else if (asked == Question::overwrite) {
        if (answer("overwrite", GLFW_KEY_ENTER)) save(true);
        if (answer("cancel", GLFW_KEY_ESCAPE)) saves_as_ = false;
    } else if (asked == Question::export_over) {
        if (answer("overwrite", GLFW_KEY_ENTER)) exports_ = true;
        answer("cancel", GLFW_KEY_ESCAPE);
    } else {
        if (answer("restore", GLFW_KEY_ENTER)) editor.recover(view_.chapter);
        if (answer("throw away")) editor.store.forget_recovery();
    }
}

bool SceneFiles::may_close() {
    if (closes_ || !editor.store.has_unsaved(editor.document)) {
        editor.store.forget_autosave();
        return true;
    }
    asked_.what = Question::close;
    view_.changed = true;
    return false;
}

void SceneFiles::keep_time() {
    check_recovery();
    if (now_s() < next_autosave_ || editor.drag) return;
    if (next_autosave_ != 0) try {
            Said said;
            if (editor.store.autosave(editor.document, &said)) log_event("autosaved");
            say(said);
        } catch (const InputError& e) { editor.notice = "not saved by itself: " + std::string(e.what()); }
    next_autosave_ = now_s() + autosave_every_s;
}

}  // namespace lightwalk
