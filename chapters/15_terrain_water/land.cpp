#include "15_terrain_water/land.h"

#include <cstring>

#include "15_terrain_water/ground_textures.h"
#include "15_terrain_water/sun_shadow.h"

namespace lightwalk {
namespace {

constexpr uint32_t chunk_triangles = 2u * CHUNK_CELLS * CHUNK_CELLS;

struct ChunkView {
    glm::mat4 to_clip;
    glm::vec3 from;
    float metres_per_m;
    int fixed_level;
};

uint32_t chunks_in_all(const LandMap& map) { return ((1u << (2 * (map.top + 1))) - 1) / 3; }

}  // namespace

void Land::prepare(Gpu& gpu, Scene&) {
    if (materials_) return;
    make_ground_textures(gpu, materials_, bumps_);
    std::vector<uint32_t> indices;
    add_grid_cells(indices, CHUNK_CELLS, false);
    chunk_indices_ = gpu.upload("chunk indices", indices);
    none_ = gpu.upload("no chunks", std::vector<uint32_t>{3 * chunk_triangles, 0, 0, 0, 0});
}

uint64_t Land::triangles() const {
    const uint64_t side = uint64_t(ground_.map().samples - 1) >> grid_level;
    if (method.is("grid")) return 2 * side * side;
    if (method.is("rings")) return rings_.triangles(ring_count_);
    if (method.is("rays") || !counted_) return 0;
    uint32_t chunks = 0;
    std::memcpy(&chunks, counted_.bytes().data() + 4, 4);
    return uint64_t(chunks) * chunk_triangles;
}

// [draw]
void Land::draw(Frame& frame, const View& view, Canvas& canvas) {
    if (!ground_.exists()) return;
    PerView& kept = views_[view.id];
    kept.found.ensure(frame.gpu.device, {.name = path() + " found", .format = VK_FORMAT_R32_SFLOAT, .size = view.size});
    found_last_ = &kept.found;
    const ViewScope scope(frame, view);
    if (method.is("rays"))
        draw_rays(frame, view, canvas, kept);
    else if (method.is("rings"))
        draw_rings(frame, view, canvas, kept);
    else
        draw_chunks(frame, view, canvas, kept);
    shade(frame, view, canvas, kept);
}

// Which chunks are drawn, as a list and the command that draws it: the processor never hears of it.
void Land::cull(Frame& frame, const View& view, PerView& kept) {
    const VkDeviceSize bytes = sizeof(Chunk) * chunks_in_all(ground_.map());
    if (!kept.list || kept.list.bytes != bytes)
        kept.list = Buffer(frame.gpu.device, {.name = "chunk list", .bytes = bytes});
    constexpr uint32_t none[] = {3 * chunk_triangles, 0, 0, 0, 0};
    if (!kept.draws) kept.draws = Buffer(frame.gpu.device, {.name = "chunk draws", .bytes = sizeof none});
    frame.transfer("chunk draws", {.reads = {}, .writes = {kept.draws}}, [&](VkCommandBuffer commands) {
        vkCmdUpdateBuffer(commands, kept.draws.handle, 0, sizeof none, none);
    });
    frame.compute(
        "chunk levels", {.reads = {kept.list, kept.draws}, .writes = {kept.list, kept.draws}, .with = {ground_}},
        [&](Compute& pass) {
            pass.use(cull_).set("chunk_list", kept.list).set("chunk_draw", kept.draws);
            pass.set("chunk_view", ChunkView{view.view_projection, view.eye, error_px * view.pixel_rad(), -1});
            pass.dispatch_threads(glm::uvec2(chunks_in_all(ground_.map()), 1));
        });
    if (count) frame.read_back(kept.draws, counted_);
}
// [/draw]

void Land::draw_chunks(Frame& frame, const View& view, Canvas& canvas, PerView& kept) {
    const bool grid = method.is("grid");
    if (!grid) cull(frame, view, kept);
    const LandMap& map = ground_.map();
    const int level = grid ? std::min(grid_level.value, map.top) : -1;
    RasterTargets targets{
        .color = {clear(kept.found, glm::vec4(0.0f))}, .depth = canvas.depth_target(), .reads = {}, .with = {ground_}};
    if (!grid) targets.reads = {kept.list, kept.draws};
    frame.raster("land", targets, [&](Raster& pass) {
        pass.use(chunk_).set("chunk_view",
                             ChunkView{view.view_projection, view.eye, error_px * view.pixel_rad(), level});
        pass.set("chunk_list", grid ? none_ : kept.list);
        if (grid)
            pass.draw_indexed(chunk_indices_, 0, 3 * chunk_triangles, 1u << (2 * (map.top - level)));
        else
            pass.draw_indexed_indirect(chunk_indices_, kept.draws);
    });
}

void Land::draw_rings(Frame& frame, const View& view, Canvas& canvas, const PerView& kept) {
    struct Rings {
        glm::ivec2 middle;
        int cells, rings;
    } now{};
    const LandMap& map = ground_.map();
    now.cells = std::max(8, ring_cells / 4 * 4);
    for (now.rings = 1; (now.cells << now.rings) < 4 * map.samples; ++now.rings) {}
    const glm::vec2 place = (glm::vec2(view.eye.x, view.eye.z) - map.corner) / map.spacing_m;
    now.middle = glm::ivec2(glm::round(glm::clamp(place, 0.0f, float(map.samples - 1)) / 8.0f)) * 8;
    rings_.ensure(frame.gpu, static_cast<uint32_t>(now.cells));
    ring_count_ = static_cast<uint32_t>(now.rings);
    frame.raster("land",
                 {.color = {clear(kept.found, glm::vec4(0.0f))}, .depth = canvas.depth_target(), .with = {ground_}},
                 [&](Raster& pass) {
                     pass.use(ring_).set("land_rings", now);
                     rings_.draw(pass, ring_count_);
                 });
}

void Land::draw_rays(Frame& frame, const View& view, Canvas& canvas, const PerView& kept) {
    frame.raster("land",
                 {.color = {clear(kept.found, glm::vec4(0.0f))}, .depth = canvas.depth_target(), .with = {ground_}},
                 [&](Raster& pass) { pass.use(ray_).set("rays", view_rays(view)).draw(3); });
}

void Land::bind(Pass& pass) const {
    if (materials_) {
        pass.set_if_present("materials", materials_);
        pass.set_if_present("material_bumps", bumps_);
    }
    if (ground_.exists()) pass.set_if_present("heights_between", ground_.heights(), linear_clamp);
}

void Land::shade(Frame& frame, const View& view, Canvas& canvas, const PerView& kept) {
    const ImageView color = canvas.color(frame);
    std::vector<With> with{ground_, atmosphere_, *this};
    const Pipeline& shader = add_shadow(shadowed_by, with) ? shade_shadowed_ : shade_;
    frame.compute("land shade", {.reads = {kept.found, color}, .writes = {color}, .with = with}, [&](Compute& pass) {
        pass.use(shader).set("found", kept.found, nearest_clamp).set("result", color);
        pass.set("rays", view_rays(view));
        if (pass.wants("chunk_view"))
            pass.set("chunk_view", ChunkView{view.view_projection, view.eye, error_px * view.pixel_rad(), -1});
        pass.dispatch_threads(view.size);
    });
}

}  // namespace lightwalk
