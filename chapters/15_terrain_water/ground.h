// Ground module: a height map on the device, with its slopes, bounds and errors by level.
#pragma once
#include <optional>

#include "15_terrain_water/height_map.h"
#include "15_terrain_water/land_data.h"
#include "common/app/module.h"
#include "common/base/epoch.h"
#include "common/gpu/frame.h"
#include "common/scene/pick.h"
#include "common/scene/scene.h"

namespace lightwalk {

/// Made from the scene's object with a height map as model. A pass that states it in `.with` includes
/// 15_terrain_water/ground.glsl and queries heights and normals. Level 0 is sea level or a lake's level: datum_m.
struct Ground : Module {
    Ground(Module& owner, std::string name);

    Knob<int> levels{*this,
                     "levels",
                     10,
                     {5, 12},
                     "Resolution of the ground: 2^levels cells along a side of the map, and one more sample"};
    Knob<float> span_km{*this, "span_km", 0.0f, {0.0f, 1e4f}, "Side of the map; 0: the source's shorter side", "km"};
    Knob<float> center_x_km{
        *this, "center_x_km", 0.0f, {-1e4f, 1e4f}, "Middle of the map, eastwards of the source's middle", "km"};
    Knob<float> center_z_km{
        *this, "center_z_km", 0.0f, {-1e4f, 1e4f}, "Middle of the map, southwards of the source's middle", "km"};
    Knob<float> datum_m{*this, "datum_m", 0.0f, {-12000.0f, 12000.0f}, "Elevation that becomes height 0", "m"};
    Knob<float> height_scale{
        *this, "height_scale", 1.0f, {0.0f, 100.0f}, "Vertical exaggeration: scale factor for heights"};
    Knob<float> detail_m{
        *this, "detail_m", 0.0f, {0.0f, 1000.0f}, "Height of gullies and ribs that the source is too coarse to show",
        "m"};
    Knob<float> cliffs{*this, "cliffs", 0.0f, {0.0f, 1.0f}, "Share of the slopes that break into cliffs"};
    Knob<float> cliff_m{*this, "cliff_m", 120.0f, {1.0f, 1e4f}, "Height from one cliff to the next", "m"};
    Knob<float> edge_km{*this,
                        "edge_km",
                        0.0f,
                        {0.0f, 1e3f},
                        "Width of the coast around the map, where it sinks below height 0; 0: none",
                        "km"};
    Knob<glm::vec3> plain_km{*this,
                             "plain_km",
                             glm::vec3(0.0f),
                             {glm::vec3(-1e4f), glm::vec3(1e4f)},
                             "Levelled ground: east and south of the source's middle, and its radius; radius 0: none",
                             "km"};
    Knob<float> plain_m{*this, "plain_m", 4.0f, {-1e4f, 1e4f}, "Height of the levelled ground", "m"};
    Choice precision{*this, "precision", {"8", "12", "16", "float"}, "float", "Bits of a height before it is used"};

    /// Reads the height map. Throws InputError.
    bool load_proxy(const std::filesystem::path& file, Model&) const override { return is_height_map_file(file); }
    void prepare(Gpu& gpu, Scene& scene) override;
    std::string load_key() const override { return precision.text(); }
    /// prepare(), where the scene has another height map than the one that is shown.
    void follow(Gpu& gpu, Scene& scene);

    /// Updates everything that changed since the last frame; does nothing without a height map.
    void record(Frame& frame, bool with_errors);
    bool exists() const { return source_.width > 0; }
    const LandMap& map() const { return map_; }
    const HeightMap& source() const { return source_; }

    void bind(Pass& pass) const override;
    std::vector<Resource> reads() const override;

    const Image& heights() const { return heights_; }  ///< R32F, metres
    const Image& slopes() const { return slopes_; }    ///< RGBA16F with all levels: along x, along z, mean height
    const Image& bounds() const { return bounds_; }    ///< RG32F: least and greatest height of 2^level cells
    const Image& errors() const { return errors_; }    ///< R32F: of each chunk, by level

  private:
    LandSource land_source() const;
    void make_images(Device& device);
    void make_heights(Frame& frame, const LandSource& from);
    void make_errors(Frame& frame);
    HeightMap source_;
    std::filesystem::path file_;  ///< of the scene's object
    Image texels_, heights_, slopes_, bounds_, errors_;
    LandMap map_{};
    Fingerprint made_;
    bool errors_made_ = false;
    Pipeline make_heights_ = compute({.shader = "15_terrain_water/make_heights.comp"});
    Pipeline make_slopes_ = compute({.shader = "15_terrain_water/make_slopes.comp"});
    Pipeline make_mip_ = compute({.shader = "15_terrain_water/make_mip.comp"});
    Pipeline make_bounds_ = compute({.shader = "15_terrain_water/make_bounds.comp"});
    Pipeline make_errors_ = compute({.shader = "15_terrain_water/make_errors.comp"});
};

/// For pipelines in passes with SunShadow's maps.
inline Macros shadowed_by_houses() {
    return Macros().replace_file("15_terrain_water/no_sun_shadow.glsl", "15_terrain_water/sun_shadow.glsl");
}

struct GroundHeights {
    LandMap map{};
    std::vector<float> heights_m{};  ///< row by row; none: there is no ground

    /// Height at world x and z, linear between samples; nothing beside the map.
    std::optional<float> height_at(const glm::dvec2& place) const;
    struct Met {
        float distance_m;
        glm::vec3 normal;
    };
    /// Where the ray enters the ground from above, within `most_m`: found in steps of half a sample, then by bisection.
    std::optional<Met> met_by(const PickRay& ray, float most_m) const;
};

/// The heights as the device has made them. Waits: not within a frame.
GroundHeights read_heights(Gpu& gpu, const Ground& ground);

}  // namespace lightwalk
