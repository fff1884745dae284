// Files that the editor writes: the scene, its export, and what a crash has left; and what is asked before.
#include <GLFW/glfw3.h>
#include <fmt/core.h>

#include "18_playground/editor_window.h"
#include "18_playground/widgets.h"
#include "common/base/error.h"
#include "common/base/files.h"

namespace lightwalk {
namespace fs = std::filesystem;

bool EditorWindow::on_save() {
    if (question_ != Question::nothing) return true;  // which is answered first
    editor.end_drag(true);
    const bool overwrites = std::exchange(overwrites_, false), own = saves_own();
    try {
        if (!overwrites && (own ? editor.store.changed_on_disk() : file_exists(save_target()))) {
            question_ = Question::overwrite;
            changed_ = true;
            return true;
        }
        editor.save(*this, own ? fs::path() : save_target());
        remember_file(editor.store.path);
        log_event("saved " + fs::absolute(editor.store.path).string());
    } catch (const std::exception& e) {
        editor.notice = "not saved: " + std::string(e.what());
        log_event("not saved");
    }
    saves_as_ = false;
    return true;
}

// The course's own scenes are not written over.
bool EditorWindow::saves_own() const {
    const fs::path& file = editor.store.path;
    return !saves_as_ && !file.empty() && !lies_below(file, course_root() / "assets");
}

fs::path EditorWindow::save_target() const {
    const fs::path named = save_name_;
    return saves_own() ? editor.store.path : named.extension() == ".json" ? named : fs::path(named.string() + ".json");
}

// Called like the scene, and beside it.
fs::path EditorWindow::export_target() const { return fs::absolute(save_target().replace_extension(".gltf")); }

void EditorWindow::on_export() {
    const fs::path target = export_target();
    if (target != exported_ && file_exists(target))
        question_ = Question::export_over;
    else
        exports_ = true;
    changed_ = true;
}

// When the scene shows what the document has: two keys may come in one frame.
void EditorWindow::export_now() {
    const fs::path target = export_target();
    try {
        editor.export_to(scene, target);
        exported_ = target;
    } catch (const InputError& e) { editor.notice = "not exported: " + std::string(e.what()); }
    changed_ = true;
}

void EditorWindow::check_recovery() {
    if (std::exchange(checked_, editor.store.path) == editor.store.path) return;
    browser_.chosen = [this](const fs::path& file, bool adds) { want(file, adds); };
    Said said;
    if (editor.store.has_recovery(&said)) question_ = Question::recover;
    say(said);
}

void EditorWindow::draw_question() {
    const int pressed = std::exchange(answer_key_, 0);
    if (question_ == Question::nothing) return;
    if (!ImGui::IsPopupOpen("question")) ImGui::OpenPopup("question");
    if (!ImGui::BeginPopupModal("question", nullptr, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoTitleBar))
        return;
    const Question asked = question_;
    const bool to_target = asked == Question::overwrite || editor.store.path.empty();
    const std::string file = (asked == Question::export_over ? export_target()
                              : to_target                    ? save_target()
                                                             : editor.store.path)
                                 .string();
    // Enter is the first answer, Escape the one that leaves all as it is.
    const auto answer = [&](const char* label, int key = GLFW_KEY_UNKNOWN) {
        const bool by_key = pressed == key || (pressed == GLFW_KEY_KP_ENTER && key == GLFW_KEY_ENTER);
        const bool yes = ImGui::Button(label) || by_key;
        log_place(std::string("answer.") + label);
        ImGui::SameLine();
        if (yes) question_ = Question::nothing;
        return yes;
    };
    if (asked == Question::close) {
        ImGui::Text("The scene has changes that are not saved.");
        if (answer("save", GLFW_KEY_ENTER)) on_save(), closes_ = !editor.store.has_unsaved(editor.document);
        if (answer("discard")) editor.store.forget_autosave(), closes_ = true;
        answer("stay", GLFW_KEY_ESCAPE);
    } else if (asked == Question::overwrite) {
        ImGui::Text("%s is there already, or was written by somebody else.", file.c_str());
        if (answer("overwrite", GLFW_KEY_ENTER)) overwrites_ = true, on_save();
        if (answer("cancel", GLFW_KEY_ESCAPE)) saves_as_ = false;
    } else if (asked == Question::export_over) {
        ImGui::Text("%s is there already.", file.c_str());
        if (answer("overwrite", GLFW_KEY_ENTER)) exports_ = true;
        answer("cancel", GLFW_KEY_ESCAPE);
    } else {
        ImGui::Text("%s was not saved when the program ended last.", file.c_str());
        if (answer("restore", GLFW_KEY_ENTER)) editor.recover(*this);
        if (answer("throw away")) editor.store.forget_recovery();
    }
    if (question_ == asked) return ImGui::EndPopup();
    changed_ = true;
    ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace lightwalk
