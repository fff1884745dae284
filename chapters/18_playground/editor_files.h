// Files written by the editor: scene, export, autosave; and their confirmation questions.
#pragma once
#include "18_playground/editor_part.h"

namespace lightwalk {

class SceneFiles : public EditorPart {
  public:
    using EditorPart::EditorPart;

    void save(bool overwrite = false);
    void ask_name();  ///< saves to the file whose name is then typed
    void save_as();   ///< to the file that `name` says
    void ask_export();
    void export_due();  ///< when the scene matches the document: two keys may come in one frame
    bool may_close();
    bool closes() const { return closes_; }
    void keep_time();  ///< once per frame: looks for a crash's autosave, and saves every 30 s

    bool asks() const { return asked_.what != Question::nothing; }
    void answer(int key) { asked_.key = key; }  ///< GLFW_KEY_..., pressed since it was asked
    void draw_question();

    std::string name = "scene.json";  ///< of a scene that has none, or is not written over

  private:
    enum class Question { nothing, name, close, overwrite, recover, export_over };
    std::string question_text(Question asked) const;
    void draw_answers(Question asked, int pressed);
    void draw_name(int pressed);
    bool saves_own() const;
    std::filesystem::path save_target() const;
    std::filesystem::path export_target() const;
    void check_recovery();
    struct {
        Question what = Question::nothing;
        int key = 0;
        bool begins = false;  ///< the next frame puts the keyboard into its field
    } asked_;
    bool saves_as_ = false, exports_ = false, closes_ = false;
    std::filesystem::path exported_;                ///< last export, which may be overwritten
    std::optional<std::filesystem::path> checked_;  ///< the scene of which a crash may have left something
    double next_autosave_ = 0;
};

}  // namespace lightwalk
