#include "15_terrain_water/land.h"

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>

#include "01_obj/camera_view.h"
#include "15_terrain_water/sun_shadow.h"
#include "common/app/render.h"

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

Land::Land(Module& owner, std::string name, Ground& ground, const Atmosphere& atmosphere)
    : Drawing(owner, std::move(name), "land"), ground_(ground), atmosphere_(atmosphere) {}

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
    constexpr uint32_t no_chunks[] = {3 * chunk_triangles, 0, 0, 0, 0};
    if (!kept.draws) kept.draws = Buffer(frame.gpu.device, {.name = "chunk draws", .bytes = sizeof no_chunks});
    frame.transfer("chunk draws", {.reads = {}, .writes = {kept.draws}}, [&](VkCommandBuffer commands) {
        vkCmdUpdateBuffer(commands, kept.draws.handle, 0, sizeof no_chunks, no_chunks);
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

namespace {

std::vector<float> found_by(Chapter& chapter, const Land& land, Gpu& gpu, glm::uvec2 size) {
    Frame own(gpu);
    render(chapter, own, {.size = size});
    render(chapter, own, {.size = size});  // the number of chunks arrives a frame later
    const auto bytes = gpu.read_back(land.found());
    std::vector<float> found(bytes.size() / sizeof(float));
    std::memcpy(found.data(), bytes.data(), bytes.size());
    return found;
}

}  // namespace

void measure_land(Chapter& chapter, Land& land, Gpu& gpu, glm::uvec2 size, nlohmann::json& error) {
    chapter.samples.value = 1;
    land.count = true;
    const std::vector<float> found = found_by(chapter, land, gpu, size);
    error["triangles"] = land.triangles();
    land.count = false;
    land.method.set("rays");
    const std::vector<float> truth = found_by(chapter, land, gpu, size);
    if (found.size() != truth.size() || found.size() != size_t(size.x) * size.y) return;

    const View view = view_of(chapter.camera, size);
    const ViewRays rays = view_rays(view);
    const auto point = [&](uint32_t x, uint32_t y) {
        return truth[size_t(y) * size.x + x] * ray_through(rays, glm::vec2(x, y) + 0.5f);
    };
    std::vector<double> off;
    size_t misjudged = 0;
    for (uint32_t y = 0; y + 1 < size.y; ++y)
        for (uint32_t x = 0; x + 1 < size.x; ++x) {
            const size_t i = size_t(y) * size.x + x;
            if ((found[i] > 0) != (truth[i] > 0)) ++misjudged;
            if (found[i] <= 0 || truth[i] <= 0 || truth[i + 1] <= 0 || truth[i + size.x] <= 0) continue;
            const glm::vec3 here = point(x, y);
            const glm::vec3 normal = glm::cross(point(x + 1, y) - here, point(x, y + 1) - here);
            if (glm::length(normal) <= 0) continue;
            const glm::vec3 moved = (found[i] - truth[i]) * ray_through(rays, glm::vec2(x, y) + 0.5f);
            off.push_back(double(std::fabs(glm::dot(moved, glm::normalize(normal)))) /
                          double(glm::length(here) * view.pixel_rad()));
        }
    error["misjudged"] = double(misjudged) / double(found.size());
    if (off.empty()) return;
    double sum = 0;
    for (const double value : off) sum += value;
    error["screen_error_px"] = sum / double(off.size());
    const auto rank = off.begin() + static_cast<std::ptrdiff_t>(0.99 * double(off.size() - 1));
    std::nth_element(off.begin(), rank, off.end());
    error["screen_error_p99_px"] = *rank;
}

}  // namespace lightwalk
