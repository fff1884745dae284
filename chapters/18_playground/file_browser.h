// The file browser: folders, files that can be opened, recent files, and a typed path.
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

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

/// Folders, and files that can be opened: scenes and models. `filter`: words that must be in the name, case aside.
Listing list_folder(const std::filesystem::path& folder, const std::string& filter);

/// Whether the editor opens it: .json, and the endings of models.
bool can_be_opened(const std::filesystem::path& file);

/// Recent files, the newest first, kept in $XDG_STATE_HOME; at most ten, each once, existing ones only.
std::vector<std::filesystem::path> recent_files();
void remember_file(const std::filesystem::path& file);

/// Large (2 functions, 10 members): a list, its filter and its marks.
class FileBrowser {
  public:
    bool shown = false;
    /// Called with the chosen file; the flag means adding it to the scene.
    std::function<void(const std::filesystem::path&, bool)> chosen;
    void draw(float scale, float left_px);
    Thumbnails thumbnails;

  private:
    void go(const std::filesystem::path& folder);
    Listing listing_;
    std::vector<std::filesystem::path> recent_;
    std::string filter_, typed_;
    int marked_ = 0;
    bool adds_ = true, fresh_ = false;
};

}  // namespace lightwalk
