// Pictures beside the picture: the material ball, and thumbnails of files, drawn by a playground of their own.
#pragma once
#include "18_playground/background_load.h"
#include "18_playground/playground.h"
#include "common/image/image.h"

namespace lightwalk {

/// Draws small pictures of scenes, between the frames of the window.
class Preview {
  public:
    /// Throws InputError where the scene cannot be loaded.
    Image8 draw(Gpu& gpu, const SceneFile& scene, glm::uvec2 size);
    /// For the next draw(), which then does not read it.
    void give(const Arrival& model) { model.give(chapter().scene); }
    void forget() { chapter_.reset(); }  ///< the models and textures that it has seen

  private:
    Playground& chapter();
    std::unique_ptr<Playground> chapter_;
    std::unique_ptr<Frame> frame_;
};

/// A ball of an object's material under chapter 14's light: the scene that shows it. `item`: one of the object's.
SceneFile material_ball(const SceneObject& object, const DrawItem& item);

/// Thumbnails of scenes and models by file, kept below $XDG_CACHE_HOME and drawn again when the file has changed.
class Thumbnails {
  public:
    static constexpr glm::uvec2 size{48, 30};

    /// Null where there is none yet: it is then drawn when its turn comes.
    const Image8* of(const std::filesystem::path& file);
    /// Between frames: continues requested previews. True if a picture arrived.
    bool carry_on(Gpu& gpu, Preview& preview);
    /// Another folder is shown: files that wait are not drawn, but for the one that has begun.
    void leave() { wanted_.erase(wanted_.begin(), wanted_.end() - (wanted_.empty() ? 0 : 1)); }
    bool busy() const { return !wanted_.empty(); }

  private:
    void begin(const std::filesystem::path& file);
    std::map<std::filesystem::path, Image8> pictures_;  ///< without pixels: there can be none
    std::vector<std::filesystem::path> wanted_;         ///< the last one is next: currently on the screen
    std::vector<std::filesystem::path> models_;         ///< that the next one still needs
    std::optional<SceneFile> scene_;
    int drawn_ = 0;
    BackgroundLoad loading_;
    std::unique_ptr<Arrival> arrival_;
};

/// A picture that a texture or an environment can be.
bool is_image(const std::filesystem::path& file);

/// Where a file's thumbnail is kept: by its path, size and time of writing. Empty where there is no such place.
std::filesystem::path thumbnail_file(const std::filesystem::path& file);

}  // namespace lightwalk
