// Skin module: subsurface scattering.
#pragma once
#include <string>

#include "04_surface_maps/maps.h"
#include "05_shadow_maps/rays.h"
#include "05_shadow_maps/visibility_buffer.h"
#include "12_skin/exercises.h"
#include "12_skin/screen_kernel.h"
#include "common/app/drawing.h"
#include "common/base/epoch.h"

namespace lightwalk {

/// Position and contents of each texel of a square map over one item of a scene. Charts, the connected pieces of the
/// layout, are numbered and grow by two texels. Unused texels have a position with w = 0.
class Unwrapped {
  public:
    Image position;   ///< metres, world space; w: the chart, from 1
    Image normal;     ///< unit length, world space; w: roughness
    Image albedo;     ///< linear; w: scale of the specular reflection
    Image stretch;    ///< texels per mm along u and v, mm² of the texel, curvature in 1/mm
    Image occlusion;  ///< x: share of the sky that is seen, 0 to 1; none before trace_sky()

    /// Records it where size (texels of a side), item or placement have changed; true if so.
    bool record(Frame& frame, const Scene& scene, const Maps& maps, const DrawItem& item, uint32_t size);

    /// Ambient occlusion by rays from each texel; slow, and to be done once.
    void trace_sky(Frame& frame, const SceneRays& rays, uint32_t rays_per_texel);

    void forget() { made_.forget(); }

  private:
    Fingerprint made_;
    Image raw_position_, raw_normal_, raw_albedo_, raw_stretch_, noisy_;
    Pipeline unwrap_ = graphics({.vertex = "12_skin/unwrap.vert",
                                 .fragment = "12_skin/unwrap.frag",
                                 .cull = VK_CULL_MODE_NONE,
                                 .depth_test = false,
                                 .depth_write = false});
    Pipeline dilate_ = compute({.shader = "12_skin/dilate.comp"});
    Pipeline stretch_ = compute({.shader = "12_skin/stretch.comp"});
    Pipeline occlusion_ = compute({.shader = "12_skin/occlusion.comp"});
    Pipeline smooth_ = compute({.shader = "12_skin/smooth_occlusion.comp"});
};

/// For each vertex of a mesh the number of its chart, from 0: vertices that triangles connect have one.
std::vector<uint32_t> charts_of(const Mesh& mesh);

/// How many mm of the item's surface a unit of its texture coordinates is: the root of the areas' ratio; 0 for none.
double mm_per_uv(const DrawItem& item);

/// Gives every model of the scene its charts, as the vertex attribute `charts`. After Maps::prepare().
void add_charts(Gpu& gpu, const Scene& scene);

class Spread {
  public:
    /// Maps of one size: the light that enters, with the number of its chart in alpha (0: none); texels per mm along u
    /// and v and a texel's mm²; where it lies in metres, with the chart again.
    struct Maps {
        const Image &irradiance, &stretch, &position;
    };

    /// Records the light that leaves, as a sum of 1, 2, 3, 4 or 6 Gaussians; 0: every texel from every texel, in 32
    /// bits.
    void record(Frame& frame, const Maps& maps, int gaussians);

    /// Of the last record(): none before it. Levels are a sum's Gaussians, narrow ones first.
    const Image& result() const { return exactly_ ? exact_ : sum_; }
    const Image& level(size_t i) const { return levels_.at(std::min(i, levels_.size() - 1)); }

  private:
    void record_exactly(Frame& frame, const Maps& maps);
    bool exactly_ = false;
    Image between_, sum_, exact_;
    std::vector<Image> levels_;
    Pipeline line_ = compute({.shader = "12_skin/blur.comp", .macros = {{"PER_CHANNEL", "0"}}});
    Pipeline line_per_channel_ = compute({.shader = "12_skin/blur.comp", .macros = {{"PER_CHANNEL", "1"}}});
    Pipeline add_up_ = compute({.shader = "12_skin/sum.comp"});
    Pipeline every_texel_ = compute({.shader = "12_skin/exact.comp"});
};

/// J. Jimenez et al., "Separable Subsurface Scattering", Computer Graphics Forum 34(6), 2015, with the profile's own
/// weights along a line: an edge that runs along the picture's rows or columns on a surface that faces the eye comes
/// out exactly.
class PictureBlur {
  public:
    Image light;  ///< image to blur; a: distance in metres, 0 for none
    Image after;  ///< factor applied afterwards

    /// Before something is drawn into the two.
    void ensure(Device& device, glm::uvec2 size);

    /// Blurs `light` along both directions, and adds it to the picture.
    void record(Frame& frame, const View& view, Canvas& canvas);

  private:
    Image half_;
    Buffer kernel_;
    Pipeline line_ = compute({.shader = "12_skin/separable.comp"});
    Pipeline add_ = compute({.shader = "12_skin/add_screen.comp"});
};

/// Draws the items of a scene: those with the role of skin, an eye or a cornea as such, others as matt.
/// In each frame record(), then draw() into a canvas, then finish(). Without any skin the first item is it.
struct Skin : Module {
    Skin(Module& owner, std::string name);

    Choice method{*this,
                  "method",
                  {"lambert", "wrapped", "preintegrated", "separable", "gaussians_1", "gaussians_2", "gaussians_3",
                   "gaussians_4", "gaussians_6", "exact"},
                  "gaussians_6",
                  "Spreading of light in skin: none; wrapped lighting; a preintegrated table; a blur of the picture; "
                  "1, 2, 3, 4 or 6 Gaussians on the texture; the exact convolution (reference)"};
    Choice specular{
        *this, "specular", {"closed", "tables"}, "closed", "Specular terms: computed, or read from tables of 8 bits"};
    Choice shaded{
        *this,
        "shaded",
        {"raster", "visibility"},
        "raster",
        "Shading of what is opaque: as it is drawn, by fragment shaders (raster, and always for separable), or "
        "in compute, once for each pixel of a visibility buffer"};
    Knob<float> before{
        *this, "before", 0.5f, {0.0f, 1.0f}, "Share of the albedo that is applied before the blur, as an exponent"};
    Knob<float> roughness{*this, "roughness", 1.0f, {0.01f, 4.0f}, "Scale factor for the roughness of the map"};
    Knob<float> specular_scale{*this, "specular_scale", 1.0f, {0.0f, 4.0f}, "Scale factor for the specular reflection"};
    Knob<float> f0{*this, "f0", 0.028f, {0.0f, 1.0f}, "Reflectance F0 of skin at normal incidence"};
    Knob<float> wrap{*this, "wrap", 0.1f, {0.0f, 1.0f}, "Wrap of red light around the surface (method wrapped)"};
    Knob<float> inwards_mm{
        *this, "inwards_mm", 1.0f, {0.0f, 20.0f}, "Inward offset of the point at which the thickness is measured",
        "mm"};
    Knob<float> translucency{
        *this, "translucency", 3.0f, {0.01f, 100.0f}, "Scale factor for the width of the transmission profile"};
    Knob<int> map_size{
        *this, "map_size", 0, {0, 4096}, "Side of the light map; 0 chooses it by the size on the screen", "texels"};
    Knob<float> density{*this, "density", 1.0f, {0.1f, 8.0f}, "Density of the light map: texels per pixel width"};
    Knob<int> sky_size{*this, "sky_size", 128, {16, 2048}, "Side of the ambient occlusion map", "texels"};
    Knob<int> sky_rays{*this, "sky_rays", 32, {1, 1024}, "Number of ambient occlusion rays from each texel"};

    void prepare(Gpu& gpu, Scene& scene) override;

    /// Its lighting: modules for 03's lights, 05's shadows and rays, and the surroundings.
    struct Lit {
        const Maps& maps;
        const SceneRays& rays;
        std::vector<With> with;
    };
    void record(Frame& frame, const Scene& scene, const View& view, const Lit& lit);
    enum class Shown { all, specular, thickness, seams };
    void draw(Frame& frame, const Scene& scene, Canvas& canvas, const Lit& lit, Shown shown = Shown::all);
    void finish(Frame& frame, const View& view, Canvas& canvas);

    void bind(Pass& pass) const override;
    std::vector<Resource> reads() const override;
    std::vector<std::string> status() const override;

    /// Of the last frame recorded, for viewing: light that enters, a level of the blur, light that leaves.
    const Image& irradiance() const { return irradiance_; }
    const Image& occlusion() const { return coarse_.occlusion; }
    const Image& level(size_t i) const { return spread_.level(i); }
    const Image& diffused() const { return spread_.result(); }
    const Unwrapped& layout() const { return on_map() ? fine_ : coarse_; }
    /// One of those, "stretch" or "occlusion" by its name; null: it has none of that name for this method.
    const Image* map(std::string_view name, size_t of_level) const;
    const DrawItem* skin_of(const Scene& scene) const { return part(scene, Role::skin, true); }

    /// A side of the map that the screen needs: the power of two at which a texel is about as wide as a pixel, 64 to
    /// 2048.
    uint32_t size_for(const DrawItem& item, const Camera& camera, uint32_t screen_height) const;

    /// The standard deviation of the widest Gaussian in pixels of a picture so many pixels high, for skin so far away.
    static double widest_px(float away_m, const Camera& camera, uint32_t screen_height);

    mutable uint64_t measured = 0;  ///< times that the surface's triangles were measured for size_for()

    bool on_map() const { return method.is("exact") || sum_count() > 0; }
    bool empty() const { return empty_; }  ///< the scene of the frame recorded last had nothing to draw
    int sum_count() const;                 ///< of Gaussians; 0 for other methods

  private:
    static const DrawItem* part(const Scene& scene, Role role, bool any = false);
    double scale_of(const DrawItem& item) const;
    void make_tables(Frame& frame);
    void light_map(Frame& frame, const Lit& lit);
    void draw_visible(Frame& frame, const Scene& scene, Canvas& canvas, const Lit& lit, const std::vector<With>& with);

    Unwrapped coarse_, fine_, eye_;
    PictureBlur screen_;
    Spread spread_;
    Image irradiance_;
    Image facets_, reflected_, preintegrated_;
    bool empty_ = true, spread_out_ = false;  ///< in this frame
    int shown_ = -1;  ///< image shown by draw() instead of the picture, numbered as in skin.frag
    Fingerprint tables_made_;
    int sky_rays_ = 0;
    mutable Fingerprint scale_made_;
    mutable double mm_per_uv_ = 0;
    Pipeline facets_table_ = compute({.shader = "12_skin/facets.comp"});
    Pipeline reflected_table_ = compute({.shader = "12_skin/reflected.comp"});
    Pipeline preintegrated_table_ = compute({.shader = "12_skin/preintegrated.comp"});
    // A texel of the skin's map is in no tile and no cluster.
    const Macros all_lights_{{"LIGHTS_METHOD", "LIGHTS_METHOD_EVERY_LIGHT"}};
    Pipeline irradiance_pass_ = compute({.shader = "12_skin/irradiance.comp", .macros = all_lights_});
    static Pipeline shading(const char* fragment, Macros macros, Blend blend = Blend::opaque) {
        macros.set("LIGHTS_METHOD", "LIGHTS_METHOD_EVERY_LIGHT");
        return graphics({.vertex = "04_surface_maps/surface.vert",
                         .fragment = fragment,
                         .depth_write = blend == Blend::opaque,
                         .blend = blend,
                         .macros = std::move(macros)});
    }
    Pipeline seen(const char* shader, Macros macros) const {
        macros.add(all_lights_);
        return compute({.shader = shader, .macros = std::move(macros)});
    }
    static Pipeline skin_pass(const char* diffuse, const char* views) {
        return shading("12_skin/skin.frag", {{"DIFFUSE", diffuse}, {"VIEWS", views}});
    }
    Pipeline by_lambert_ = skin_pass("0", "0"), by_wrap_ = skin_pass("1", "0"), by_table_ = skin_pass("2", "0");
    Pipeline by_screen_ = skin_pass("3", "0"), by_map_ = skin_pass("4", "0"), views_ = skin_pass("0", "1");
    Pipeline matt_ = shading("12_skin/matt.frag", {{"EYE", "0"}}),
             eye_pass_ = shading("12_skin/matt.frag", {{"EYE", "1"}}),
             cornea_ = shading("12_skin/cornea.frag", {}, Blend::add);
    VisibilityBuffer visibility_;
    Pipeline seen_lambert_ = seen("12_skin/skin_seen.comp", {{"DIFFUSE", "0"}, {"VIEWS", "0"}}),
             seen_wrap_ = seen("12_skin/skin_seen.comp", {{"DIFFUSE", "1"}, {"VIEWS", "0"}}),
             seen_table_ = seen("12_skin/skin_seen.comp", {{"DIFFUSE", "2"}, {"VIEWS", "0"}}),
             seen_map_ = seen("12_skin/skin_seen.comp", {{"DIFFUSE", "4"}, {"VIEWS", "0"}}),
             matt_seen_ = seen("12_skin/matt_seen.comp", {{"EYE", "0"}}),
             eye_seen_ = seen("12_skin/matt_seen.comp", {{"EYE", "1"}});
};

}  // namespace lightwalk
