// Titles over the picture.
#pragma once
#include <glm/glm.hpp>
#include <map>
#include <string>
#include <vector>

#include "19_ambiance/glyph.h"
#include "19_ambiance/timeline.h"
#include "common/app/module.h"
#include "common/base/epoch.h"
#include "common/gpu/frame.h"
#include "common/gpu/gpu.h"

namespace lightwalk {

/// Inter Semi Bold, from assets/fonts.
class Typeface {
  public:
    /// Reads the font and draws its letters, for line(). They take a third of a second, and are drawn once in a program.
    /// Throws InputError.
    void read();
    /// Reads it and uploads distances().
    void load(Gpu& gpu);

    /// Letters of one line, from (0, 0) to the right, in heights of a capital; a gap for missing ones. `width`: where
    /// the next letter would stand.
    std::vector<Glyph> line(const std::string& text, float& width) const;

    const Image& distances() const { return distances_; }  ///< R8: 0.5 at the outline, more within

  private:
    struct Letter {
        Glyph drawn;  ///< at the pen's place; no size: a blank
        float advance;
    };
    struct Letters {
        std::map<char, Letter> by_sign;
        std::map<std::pair<char, char>, float> kerning;
        std::vector<unsigned char> texels;
    };
    static Letters drawn();
    const Letters* letters_ = nullptr;
    Image distances_;
};

/// Draws what a film's titles say at a time over the picture of RGBA16F, 0 to 1 in linear light.
class Titles {
  public:
    void record(Frame& frame, const Image& picture, const Timeline& film, double time_s);

    /// Reads the typeface, if the film has titles: no frame waits for it.
    void prepare(Gpu& gpu, const Timeline& film) {
        if (!film.titles.empty()) face_.load(gpu);
    }

  private:
    Typeface face_;
    Buffer glyphs_;
    Fingerprint glyphs_made_;
    Pipeline draw_ = compute({.shader = "19_ambiance/title.comp"});
};

}  // namespace lightwalk
