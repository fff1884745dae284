// The film in a window: its timeline as a strip below the picture, and keys of cameras that are flown by hand.
#pragma once
#include "19_ambiance/ambiance.h"
#include "common/window/window_tool.h"

namespace lightwalk {

struct FilmWindow : Ambiance, WindowTool {
    bool on_mouse(const Input&, glm::vec2, bool) override { return false; }
    bool on_key(const KeyPress& key) override;
    void on_drop(const std::vector<std::filesystem::path>&) override {}
    bool draw_panels(const Area& picture, float dock_px, float scale) override;
    bool on_save() override;
    bool may_close() override { return true; }
    bool wants_to_close() override { return false; }
    bool is_busy() override { return false; }
    std::string take_notice() override { return std::exchange(notice_, ""); }
    void steer(WindowClock& clock) override;

  private:
    struct Bar;  ///< where times lie on the screen
    void draw_buttons();
    void draw_scenes(const Bar& bar) const;
    void draw_names(const Bar& bar) const;
    void draw_fades(const Bar& bar) const;
    void draw_music(const Bar& bar) const;
    void draw_keys(const Bar& bar) const;
    void draw_head(const Bar& bar) const;
    void scrub(const Bar& bar);

    double frame_s() const { return 1.0 / double(out.fps); }
    void set_time(double time_s, bool goes_on = false);
    void step(int frames);
    void go_to_scene(int by);
    void loop();
    void take_off();
    void land();
    void place_key();
    void remove_key();
    /// Replaces the text of the film and takes its cameras.
    template <class Edit>
    void edit(const char* what, const Edit& edit);

    WindowClock clock_;
    std::optional<WindowClock> wanted_;
    std::optional<size_t> looped_, flown_;  ///< scenes
    bool shown_ = true, scrubs_ = false, ran_ = false;
    double scrubbed_s_ = 0;
    std::string notice_;
};

}  // namespace lightwalk
