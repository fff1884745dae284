// Files that were asked for: read beside the picture, one after the other, and shown when all of them is there.
#pragma once
#include <deque>

#include "18_playground/background_load.h"
#include "18_playground/editor_part.h"

namespace lightwalk {

class LoadingPanel : public EditorPart {
  public:
    using EditorPart::EditorPart;

    void want(const std::filesystem::path& file, bool adds);
    bool loads() const { return !wanted_.empty(); }
    void cancel();
    /// Once per frame, also of those in which the window draws its panels only.
    void carry_on();
    void draw();
    void was_shown();  ///< this frame shows the loaded model

  private:
    /// A file that was asked for, and the models that it still needs.
    struct Wanted {
        std::filesystem::path file;
        bool adds = false;
        PickRay ray;  ///< to where it is placed
        std::vector<std::filesystem::path> models;
        std::vector<std::unique_ptr<Arrival>> arrived;
    };
    /// Cost of loading for frames drawn meanwhile, up to the first complete one.
    struct Pace {
        double since = 0, last = 0, longest_s = 0, own_longest_s = 0;
        int frames = 0;
        bool shown = false;  ///< the previous frame showed the loaded model
    };
    void carry_on_loading(Gpu& gpu);
    void stop(const std::string& why);
    Bounds box_of(const Wanted& wanted) const;
    void note_pace(double start, double own_s);
    std::deque<Wanted> wanted_;
    std::optional<Pace> pace_;
    BackgroundLoad loading_;
};

}  // namespace lightwalk
