// Shared by the tests of transparency: rectangles as transparent surfaces before a background.
#pragma once
#include "../common/module_fixture.h"
#include "01_obj/camera_view.h"
#include "15_terrain_water/transparency.h"
#include "15_terrain_water/transparency_truth.h"

namespace lightwalk {

struct Pane {
    glm::vec3 corners[4];
    glm::vec4 color;
    glm::vec3 tint{1.0f};
    glm::vec3 middle() const { return 0.25f * (corners[0] + corners[1] + corners[2] + corners[3]); }
};

struct Quads : Drawing, TransparentSource {
    Quads(Module& owner, std::string name) : Drawing(owner, std::move(name)) {}
    std::vector<Pane> quads;
    Buffer buffer;

    void update(Frame& frame) override { frame.upload("quads", buffer, quads); }
    uint32_t solid = 0;  ///< of the last ones: how many are opaque
    void draw(Frame& frame, const View&, Canvas& canvas) override {
        if (solid == 0) return;
        const auto first = static_cast<uint32_t>(quads.size()) - solid;
        frame.raster("solid", {.color = {canvas.color_target()}, .depth = canvas.depth_target()},
                     [&](Raster& pass) { pass.use(opaque).set("quads", buffer).draw(6, solid, first); });
    }
    const TransparentSource* transparent_source() const override { return this; }
    std::vector<Transparent> transparent(const View& view) const override {
        std::vector<Transparent> all;
        for (uint32_t i = 0; i + solid < quads.size(); ++i)
            all.push_back({glm::length(quads[i].middle() - view.eye), i, quads[i].middle()});
        return all;
    }
    void draw_transparent(Raster& pass, std::span<const Transparent> items) const override {
        pass.use(pipeline).set("quads", buffer);
        for (const Transparent& item : items) pass.draw(6, 1, item.item);
    }
    std::vector<TransparentTriangle> transparent_triangles(const View& view) const override {
        std::vector<TransparentTriangle> all;
        for (uint32_t i = 0; i + solid < quads.size(); ++i) {
            const auto& c = quads[i].corners;
            all.push_back({glm::length((c[0] + c[1] + c[2]) / 3.0f - view.eye), i, {0, 1, 2}});
            all.push_back({glm::length((c[0] + c[2] + c[3]) / 3.0f - view.eye), i, {3, 4, 5}});
        }
        return all;
    }
    void draw_transparent_triangles(Raster& pass, uint32_t item, const Buffer& indices, uint32_t first,
                                    uint32_t count) const override {
        pass.use(pipeline).set("quads", buffer).draw_indexed(indices, first, count, 1, item);
    }

    Pipeline opaque = graphics({.vertex = "../tests/15_terrain_water/quads.vert",
                                .fragment = "../tests/15_terrain_water/quads.frag",
                                .cull = VK_CULL_MODE_NONE});
    Pipeline pipeline = graphics({.vertex = "../tests/15_terrain_water/quads.vert",
                                  .fragment = "../tests/15_terrain_water/quads.frag",
                                  .cull = VK_CULL_MODE_NONE,
                                  .depth_write = false,
                                  .blend = Blend::filtered,
                                  .macros = {{"TRANSPARENT", "1"}}});
};

/// The camera stands in the origin and looks along -z; its picture is square, 2 z wide at a distance z.
struct OnTransparency : OnModules {
    Quads drawing{owner, "quads"};
    Transparency transparency{owner, "transparency"};
    Camera camera{.position = {0, 0, 0},
                  .target = {0, 0, -1},
                  .fov_y_rad = 1.5707963f,
                  .near_m = 0.1f,
                  .far_m = std::numeric_limits<float>::infinity()};
    glm::uvec2 size{64, 64};

    /// A rectangle across the view from `from` to `to`, parts of the picture from -1 to 1, y up.
    void add(glm::vec2 from, glm::vec2 to, float z_m, glm::vec4 color, glm::vec3 tint = glm::vec3(1)) {
        const auto at = [&](float x, float y) { return z_m * glm::vec3(x, y, -1.0f); };
        drawing.quads.push_back(
            {{at(from.x, from.y), at(to.x, from.y), at(to.x, to.y), at(from.x, to.y)}, color, tint});
    }
    void add(float z_m, glm::vec4 color, glm::vec3 tint = glm::vec3(1)) { add({-1, -1}, {1, 1}, z_m, color, tint); }

    ImageRgb picture(const std::string& method, glm::vec3 background = glm::vec3(0)) {
        transparency.method.set(method);
        const View view = view_of(camera, size);
        begin(size);
        Canvas canvas(frame.hdr, frame.depth, glm::vec4(background, 1.0f));
        canvas.blended_by(&transparency);
        lightwalk::draw(frame, view, canvas, {drawing});
        frame.end();
        return read_linear(gpu, frame.hdr);
    }
    glm::vec3 middle(const std::string& method, glm::vec3 background = glm::vec3(0)) {
        const ImageRgb seen = picture(method, background);
        return seen.pixels[seen.pixels.size() / 2 + size.x / 2];
    }
};

inline const char* const every_transparency[] = {"unsorted", "sorted", "sorted_triangles", "wboit", "moments",
                                                 "moments6", "lists",  "peeling"};

}  // namespace lightwalk
