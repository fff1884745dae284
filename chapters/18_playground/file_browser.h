// The file browser: folders, files that can be opened, recent files, and a typed path.
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "18_playground/editor_part.h"
#include "18_playground/preview.h"

namespace lightwalk {

/// The browser's list, without a window.
struct Listing {
    std::filesystem::path folder;
    struct File {
        std::filesystem::path path;
        bool is_folder = false, is_scene = false;
        uintmax_t bytes = 0;
    };
    std::vector<File> files;  ///< folders first, each by name
    std::string error;        ///< why the folder cannot be read
};

/// Folders, and files that can be opened: scenes, models and images. `filter`: words of the name, in either case.
Listing list_folder(const std::filesystem::path& folder, const std::string& filter);

/// Whether the editor opens it: .json, and the endings of models.
bool can_be_opened(const std::filesystem::path& file);

/// Recent files, the newest first, kept in $XDG_STATE_HOME; at most ten, each once, existing ones only.
std::vector<std::filesystem::path> recent_files();
void remember_file(const std::filesystem::path& file);

class FileBrowser {
  public:
    bool shown = false;
    /// Called with the chosen file; the flag means adding it to the scene.
    std::function<void(const std::filesystem::path&, bool)> chosen;
    void draw(float scale);  ///< in the window that has begun

    /// Shows the images that `take` gets one of; `what` is it for.
    using Take = std::function<void(const std::filesystem::path&)>;
    void pick_image(const std::string& what, const Take& take);
    void close() {
        shown = false;
        take_image_ = nullptr;
    }

    /// The file that the mouse has dragged here and dropped in this frame.
    std::optional<std::filesystem::path> dropped() const;
    bool adds() const { return adds_; }
    Thumbnails thumbnails;

  private:
    void go(const std::filesystem::path& folder);
    bool draw_file(const Listing::File& file, bool marked, float scale);
    Listing listing_;
    std::vector<std::filesystem::path> recent_;
    std::string filter_, typed_;
    int marked_ = 0;
    bool adds_ = true;
    int drawn_in_ = -1;  ///< frame
    std::string image_for_;
    Take take_image_;  ///< none: a file is opened
};

/// Beside a field for an image's path: lets the person choose one, which `take` gets as a scene file names it.
void pick_button(EditorView& view, const std::string& what, const std::function<void(const std::string&)>& take);

}  // namespace lightwalk
