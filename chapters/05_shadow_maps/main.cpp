// Chapter 05: shadow maps, depth as seen from each light.
#include <array>
#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <nlohmann/json.hpp>

#include "01_obj/model_chapter.h"
#include "05_shadow_maps/lit_stage.h"
#include "05_shadow_maps/shadow_error.h"
#include "common/app/render.h"
#include "common/window/run.h"

using namespace lightwalk;

namespace {

// Percentages of surface pixels with acne, peter_panning, leak and edge (shadow_error.h). Alpha of `picture` (RGBA16F):
// 1 + kind of error, or 0 for the background.
void wrong_shares(Gpu& gpu, const Image& picture, nlohmann::json& error) {
    const std::vector<std::byte> texels = gpu.read_back(picture);
    std::array<size_t, 6> count{};
    for (size_t i = 6; i < texels.size(); i += 8) {
        uint16_t alpha = 0;
        std::memcpy(&alpha, texels.data() + i, 2);
        ++count.at(static_cast<size_t>(glm::unpackHalf1x16(alpha)));
    }
    const double surface = std::max(1.0, static_cast<double>(texels.size() / 8 - count[0]));
    const auto add = [&](const char* name, uint32_t kind) {
        error[name] = 100.0 * static_cast<double>(count.at(1 + kind)) / surface;
    };
    add("acne", SHADOW_ACNE);
    add("peter_panning", SHADOW_PETER_PANNING);
    add("leak", SHADOW_LEAK);
    add("edge", SHADOW_EDGE);
}

// RMS error of `shown` where `right` is partly visible, both as shares of `lit`; NaN where no pixel is.
double penumbra_error(const ImageRgb& shown, const ImageRgb& right, const ImageRgb& lit) {
    double squares = 0, count = 0;
    for (size_t i = 0; i < lit.pixels.size(); ++i) {
        const float share = right.pixels[i].g / lit.pixels[i].g;
        if (!(share > 0.01f && share < 0.99f)) continue;
        squares += std::pow(double(shown.pixels[i].g / lit.pixels[i].g) - double(share), 2);
        ++count;
    }
    return std::sqrt(squares / count);
}

double mib_of_maps(const Shadow& shadow) {
    const double texels = double(shadow.resolution) * shadow.resolution * shadow.views;
    double bytes = texels * texel_bytes(VK_FORMAT_D32_SFLOAT);
    if (shadow.has_moments()) bytes += texels * 4 / 3 * texel_bytes(shadow.moments().desc.format);  // with mips
    return shadow.method.is("none") ? 0 : bytes / (1 << 20);
}

double mib_of(const Bvh& bvh) { return double(bvh.nodes().size_bytes() + bvh.triangles().size_bytes()) / (1 << 20); }

}  // namespace

struct ShadowMaps : ModelChapter {
    LitStage world{*this};
    LitScene& objects = world.objects;
    SurfaceScene& surfaces = objects.surfaces;
    Maps& maps = objects.maps;
    Lights& lights = objects.lights;
    Shadow& shadow = objects.shadow;

    ShadowMaps() {
        shadow.method.preferred = true;  // --method is about shadows here
    }
    std::string default_scene() const override { return "scenes/colonnade_evening.json"; }

    // Shares of wrong shadows, error in penumbrae and MiB, from pictures a quarter as wide, since each pixel takes many rays.
    void measure(Gpu& gpu, glm::uvec2 size, nlohmann::json& error) override {
        const glm::uvec2 quarter = glm::max(size / 4u, 1u);
        const bool by_rays = world.visibility.is("rays");
        world.show.set("visibility");
        const ImageRgb shown = render_linear(*this, gpu, quarter);
        error["mib"] = by_rays ? mib_of(world.rays.bvh()) : mib_of_maps(shadow);
        if (!by_rays) {
            world.show.set("wrong");
            Frame own(gpu);
            render(*this, own, {quarter, 0.0f, 0, {}});
            wrong_shares(gpu, own.hdr, error);
            world.show.set("visibility");
        }
        shadow.method.set("none");
        const ImageRgb lit = render_linear(*this, gpu, quarter);
        shadow.method.set("hard");
        world.visibility.set("rays");
        world.rays.truth_samples.set("64");
        const double wrong = penumbra_error(shown, render_linear(*this, gpu, quarter), lit);
        if (std::isfinite(wrong)) error["penumbra"] = wrong;
    }

    // [frame]
    void frame(Frame& frame) override {
        const View view = set_view(frame, world);
        Canvas canvas(frame.hdr, frame.depth, world.background());

        // 1. Lights with scaled sizes, in a buffer (chapter 03); a hierarchy of triangles if rays are needed.
        lights.update(frame, scene, world.lamps());
        world.choose_shading(frame);
        const bool in_compute = objects.shades_in_compute(canvas);
        const std::vector<Batch> batches = surfaces.opaque_batches();

        // 2. Visibility buffer for shading in compute, or depth for tiled light lists; then light lists (chapter 03).
        if (in_compute)
            objects.visible.record(frame, scene, maps, batches, canvas);
        else if (lights.needs_depth())
            frame.raster("depth", {.depth = canvas.depth_target(), .reads = surfaces.shading.reads, .with = {maps}},
                         surfaces.by(surfaces.depth_pipelines()));
        lights.record(frame, scene, view, canvas.single_depth());

        // 3. Light views: one per spot light, six per point light, one per cascade of a directional light. Each lists
        // its casters; shaders read the views from a buffer.
        const Shadow::Casters casters = objects.casters(frame);
        shadow.find_maps(frame, scene, lights, view, casters);

        for (const Shadow::MapView& map : shadow.maps_to_draw()) {  // light or casters have changed
            // 4. Shadow map: depth of the casters from the light.
            {
                const ViewScope from_light(frame, map.view.view);
                frame.raster("shadow_map", {.depth = clear(shadow.depth_of(map), 0.0f), .with = casters.with},
                             [&](Raster& pass) { casters.draw(pass, map.casters); });
            }
            // 5. Transmittance of transparent casters: the first one's, and the product of all.
            if (shadow.has_passed()) shadow.draw_passed(frame, map, casters);

            // 6. Moments of the depths, blurred, for vsm, evsm and msm.
            if (shadow.has_moments()) shadow.filter(frame, map);
        }

        // 7. Shading of opaque surfaces, which reads and filters the shadow maps.
        const std::vector<With> with = surfaces.given();  // maps, lights, shadow, and rays if needed
        if (in_compute)
            objects.visible.shade(frame, scene, maps, batches, canvas, objects.compute_pipeline(), with,
                                  surfaces.shading.reads);
        else
            frame.raster("shade",
                         {.color = {canvas.color_target()},
                          .depth = canvas.depth_target(),
                          .reads = surfaces.shading.reads,
                          .with = with},
                         surfaces.by(surfaces.opaque_pipelines()));

        // 8. Transparent surfaces, back to front.
        draw_transparent(frame, view, canvas, world.drawings());

        // 9. Linear light, encoded as sRGB.
        encode_srgb(frame);
    }
    // [/frame]

    std::string why_not_finite() const override {
        return world.visibility.is("rays") ? world.rays.why_not_finite() : "";
    }
};

CHAPTER(ShadowMaps)
