#include "15_terrain_water/city.h"

#include <cmath>
#include <cstring>
#include <random>

#include "15_terrain_water/sun_shadow.h"

namespace lightwalk {
namespace {

constexpr float street_m = 16, block_x_m = 110, block_z_m = 70, city_yaw = 0.35f;

glm::ivec2 most_cells(const CityPlan& plan) {
    return glm::ivec2(plan.radius_m / (glm::vec2(block_x_m, block_z_m) + street_m)) + 1;
}

/// Random numbers of one block, independent of earlier blocks.
class Dice {
  public:
    Dice(int seed, int x, int z) : random_(static_cast<uint32_t>(seed * 7919 + x * 131071 + z * 524287)) {}
    float between(float low, float high) {
        return low + (high - low) * static_cast<float>(random_() >> 8) / 16777216.0f;
    }
    uint32_t number() { return static_cast<uint32_t>(random_()); }

  private:
    std::mt19937 random_;
};

void add_house(std::vector<CityBox>& boxes, Dice& dice, glm::vec2 middle, glm::vec2 half, float yaw, float height) {
    const uint32_t number = dice.number(), kind = height > 30 ? CITY_TOWER : CITY_HOUSE;
    const float foot = height > 45 ? dice.between(0.35f, 0.7f) * height : height;
    boxes.push_back({middle, yaw, {half.x, 0.5f * foot + 2, half.y}, -4, kind, number});
    if (foot < height) {  // a narrower upper part, and sometimes a third one
        const float third = dice.between(0, 1) < 0.4f ? 0.25f * (height - foot) : 0.0f;
        boxes.push_back(
            {middle, yaw, {0.72f * half.x, 0.5f * (height - foot - third), 0.72f * half.y}, foot, kind, number + 1});
        if (third > 0)
            boxes.push_back(
                {middle, yaw, {0.4f * half.x, 0.5f * third, 0.4f * half.y}, height - third, kind, number + 2});
    } else if (dice.between(0, 1) < 0.3f) {  // stairs and machines on the roof
        boxes.push_back({middle, yaw, {2.5f, 1.4f, 2}, foot, kind, number + 1});
    }
}

}  // namespace

City::City(Module& owner, std::string name, const Ground& ground, const Atmosphere& atmosphere)
    : Drawing(owner, std::move(name), "city"), ground_(ground), atmosphere_(atmosphere) {}

std::vector<CityBlock> plan_city(const CityPlan& plan, std::vector<CityBox>& boxes) {
    std::vector<CityBlock> blocks;
    boxes.clear();
    if (plan.most_boxes <= 0) return blocks;
    const float yaw = city_yaw, c = std::cos(yaw), s = std::sin(yaw);
    const auto world = [&](glm::vec2 p) { return plan.middle_m + glm::vec2(c * p.x + s * p.y, -s * p.x + c * p.y); };
    const glm::ivec2 most = most_cells(plan);
    for (int bz = -most.y; bz <= most.y; ++bz)
        for (int bx = -most.x; bx <= most.x; ++bx) {
            const glm::vec2 middle = glm::vec2(bx, bz) * glm::vec2(block_x_m + street_m, block_z_m + street_m);
            const float away = glm::length(middle) / plan.radius_m;
            if (away > 1) continue;
            Dice dice(plan.seed, bx, bz);
            CityBlock block{world(middle), {bx, bz}, 90, static_cast<uint32_t>(boxes.size()), 0};
            const int lots_x = away < 0.35f ? 3 : 5, lots_z = 2;
            const glm::vec2 lot = glm::vec2(block_x_m, block_z_m) / glm::vec2(lots_x, lots_z);
            const bool park = dice.between(0, 1) < 0.06f;
            for (int i = 0; i < lots_x * lots_z && !park; ++i) {
                const glm::vec2 at =
                    middle - 0.5f * glm::vec2(block_x_m, block_z_m) + (glm::vec2(i % lots_x, i / lots_x) + 0.5f) * lot;
                const float centre = std::exp(-7.0f * away * away), luck = dice.between(0, 1);
                const float height = 7 + 11 * dice.between(0, 1) + plan.towers_m * centre * luck * luck * luck;
                const glm::vec2 half = 0.5f * lot * glm::vec2(dice.between(0.7f, 0.96f), dice.between(0.7f, 0.96f));
                if (dice.between(0, 1) > 0.25f * away) add_house(boxes, dice, world(at), half, yaw, height);
            }
            for (int i = 0; i < 3; ++i)  // lamps along the street north of the block
                boxes.push_back({world(middle + glm::vec2((float(i) - 1) * 38, -0.5f * block_z_m - 3)),
                                 yaw,
                                 {0.7f, 0.35f, 0.7f},
                                 8,
                                 CITY_LAMP,
                                 dice.number()});
            block.count = static_cast<uint32_t>(boxes.size()) - block.first;
            blocks.push_back(block);
            if (boxes.size() < static_cast<size_t>(plan.most_boxes)) continue;
            boxes.resize(static_cast<size_t>(plan.most_boxes));
            blocks.back().count = static_cast<uint32_t>(boxes.size()) - blocks.back().first;
            return blocks;
        }
    return blocks;
}

void City::update(Frame& frame) {
    const CityPlan plan{.middle_m = 1000.0f * glm::vec2(x_km.value, z_km.value),
                        .radius_m = 1000.0f * radius_km,
                        .towers_m = towers_m,
                        .most_boxes = most_boxes,
                        .seed = plan_seed};
    if (made_.is_current(plan)) return;
    plan_ = plan;
    ++placed_;
    blocks_ = plan_city(plan, boxes_);
    if (boxes_.empty()) return;
    buffer_ = frame.gpu.upload("city", boxes_);
    grid_ = {.middle = plan.middle_m,
             .yaw = city_yaw,
             .pitch = glm::vec2(block_x_m, block_z_m) + street_m,
             .most = most_cells(plan),
             .highest = 0};
    for (const CityBox& box : boxes_) grid_.highest = std::max(grid_.highest, box.base_m + 2 * box.half_size.y);
    const glm::ivec2 side = 2 * grid_.most + 1;
    std::vector<glm::uvec2> cells(static_cast<size_t>(side.x * side.y), glm::uvec2(0));
    for (const CityBlock& block : blocks_) {
        const glm::ivec2 at = block.cell + grid_.most;
        cells[static_cast<size_t>(at.y * side.x + at.x)] = {block.first, block.count};
    }
    cells_ = frame.gpu.upload("city cells", cells);
}

Bounds City::bounds() const {
    Bounds all;
    if (boxes_.empty() || !ground_.exists()) return all;
    const float reach = plan_.radius_m + block_x_m;
    all.add(glm::vec3(plan_.middle_m.x - reach, -10.0f, plan_.middle_m.y - reach));
    all.add(glm::vec3(plan_.middle_m.x + reach, ground_.map().highest_m + grid_.highest, plan_.middle_m.y + reach));
    return all;
}

std::vector<With> City::shadow_modules() const { return {ground_}; }

void City::cast(Raster& pass, const View& light) const {
    pass.use(cast_).set("city_boxes", buffer_).set("city_light", glm::vec2(0.0f));
    draw_visible(pass, light);
}

void City::bind(Pass& pass) const {
    if (boxes_.empty()) return;
    pass.set_if_present("city_boxes", buffer_);
    pass.set_if_present("city_cells", cells_);
    pass.set_if_present("city_grid", grid_);
}

// Blocks in a row that the view may see are one draw.
void City::draw_visible(Raster& pass, const View& view) const {
    const glm::mat4 rows = glm::transpose(view.view_projection);
    uint32_t first = 0, count = 0;
    const auto flush = [&] {
        if (count > 0) pass.draw(30, count, first);
        count = 0;
    };
    for (const CityBlock& block : blocks_) {
        const glm::vec4 middle(block.middle_m.x, 0.0f, block.middle_m.y, 1.0f);
        const float reach = 3 * (block.reach_m + towers_m);
        const auto beyond = [&](const glm::vec4& plane) {
            return glm::dot(plane, middle) < -reach * glm::length(glm::vec3(plane));
        };
        if (beyond(rows[3] + rows[0]) || beyond(rows[3] - rows[0]) || beyond(rows[3] + rows[1]) ||
            beyond(rows[3] - rows[1])) {
            flush();
            continue;
        }
        if (count == 0) first = block.first;
        count += block.count;
    }
    flush();
}

void City::draw(Frame& frame, const View& view, Canvas& canvas) {
    if (boxes_.empty() || !ground_.exists()) return;
    const ViewScope scope(frame, view);
    RasterTargets targets{.color = {canvas.color_target()},
                          .depth = canvas.depth_target(),
                          .reads = {},
                          .with = {ground_, atmosphere_, *this}};
    const Pipeline& shader = add_shadow(shadowed_by, targets.with) ? draw_shadowed_ : draw_;
    frame.raster("city", targets, [&](Raster& pass) {
        pass.use(shader).set("city_light", light_of(view));
        draw_visible(pass, view);
    });
}

}  // namespace lightwalk
