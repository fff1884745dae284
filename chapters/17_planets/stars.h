// Stars module: the sky behind everything, as photographs have it.
#pragma once
#include "17_planets/planets.h"

namespace lightwalk {

// [stars]
/// Draws before all others: it overwrites the whole canvas. 8,777 stars of a catalogue as points, each of the same light
/// however many pixels the picture has, over the Milky Way of a map.
struct Stars : Drawing {
    Stars(Module& owner, std::string name, const Planets& planets)
        : Drawing(owner, std::move(name), "stars"), planets_(planets) {}

    Knob<float> brightness{
        *this, "brightness", 6.0f, {0.0f, 1e4f}, "Radiance in the middle of a star of magnitude 0; 0: no stars"};
    Knob<float> sigma{*this,
                      "sigma",
                      0.0013f,
                      {1e-5f, 0.1f},
                      "Standard deviation of a star's image, as a fraction of the picture's height"};
    Knob<float> milky_way{*this, "milky_way", 0.5f, {0.0f, 1e3f}, "Scale factor for the map of the Milky Way"};
    // [/stars]

    void prepare(Gpu& gpu, Scene&) override;
    Phase draw_phase() const override { return Phase::backdrop; }
    std::vector<const Module*> dependencies() const override { return {this, &planets_}; }
    void draw(Frame& frame, const View& view, Canvas& canvas) override;

  private:
    const Planets& planets_;
    std::unique_ptr<ImagePool> pool_;
    std::shared_ptr<Image> map_;
    Buffer stars_;
    uint32_t count_ = 0;
    Pipeline sky_ = compute({.shader = "17_planets/milky_way.comp"});
    Pipeline points_ = graphics({.vertex = "17_planets/star.vert",
                                 .fragment = "17_planets/star.frag",
                                 .cull = VK_CULL_MODE_NONE,
                                 .depth_test = false,
                                 .depth_write = false,
                                 .blend = Blend::add});
};

/// A star as shaders read it: a unit vector of the world, and its light over that of a star of magnitude 0.
struct Star {
    glm::vec3 direction;
    float light;
};

/// Lines of `v_mag,ra_deg,dec_deg` after a line of names. Throws InputError: file:line: message.
std::vector<Star> read_stars(const std::filesystem::path& file);

}  // namespace lightwalk
