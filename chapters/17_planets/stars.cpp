#include "17_planets/stars.h"

#include <cmath>
#include <cstdlib>
#include <fstream>

#include "17_planets/star_data.h"
#include "common/base/error.h"
#include "common/base/shared_lock.h"
#include "common/scene/scene_file.h"

namespace lightwalk {

std::vector<Star> read_stars(const std::filesystem::path& file) {
    std::ifstream in(file);
    if (!in) throw InputError("{}: cannot be read", file.string());
    std::vector<Star> stars;
    std::string line;
    for (int number = 1; std::getline(in, line); ++number) {
        if (number == 1 || line.empty()) continue;
        double values[3];
        const char* at = line.c_str();
        for (int i = 0; i < 3; ++i) {
            char* end = nullptr;
            values[i] = std::strtod(at, &end);
            if (end == at || (i < 2 && *end != ',') || !std::isfinite(values[i]))
                throw InputError("{}:{}: '{}' is no star; a line is v_mag,ra_deg,dec_deg", file.string(), number, line);
            at = end + 1;
        }
        stars.push_back(
            {glm::vec3(direction_of(values[1], values[2])), static_cast<float>(std::pow(10.0, -0.4 * values[0]))});
    }
    if (stars.empty()) throw InputError("{}: no stars", file.string());
    return stars;
}

void Stars::prepare(Gpu& gpu, Scene&) {
    pool_ = std::make_unique<ImagePool>(gpu);
    map_ = pool_->load(find_asset("planets_2k/stars.jpg"), TextureKind::color);
    const std::vector<Star> stars = unlocked([] { return read_stars(find_asset("planets/bright_stars.csv")); });
    count_ = static_cast<uint32_t>(stars.size());
    stars_ = gpu.upload("stars", stars);
}

// [draw_stars]
void Stars::draw(Frame& frame, const View& view, Canvas& canvas) {
    const Planets::Outlook look = planets_.outlook(frame, view);
    const ImageView behind = canvas.color_overwritten();
    const glm::dmat3 to_world = glm::transpose(look.to_view);
    const StarsNow now{.rays = view_rays(view),
                       .to_galaxy = glm::mat3(world_to_galaxy() * to_world),
                       .to_view = glm::mat3(look.to_view),
                       .size = glm::vec2(view.size),
                       .sigma_px = sigma * static_cast<float>(view.crop.whole.y),
                       .brightness = brightness,
                       .milky_way = milky_way};
    frame.compute("milky way", {.writes = {behind}}, [&](Compute& pass) {
        pass.use(sky_).set("now", now).set("result", behind).set("star_map", *map_, Sampler{.wrap = Wrap::repeat});
        pass.dispatch_threads(view.size);
    });
    frame.raster("stars", {.color = {canvas.color_target()}},
                 [&](Raster& pass) { pass.use(points_).set("now", now).set("stars", stars_).draw(6, count_); });
}
// [/draw_stars]

}  // namespace lightwalk
