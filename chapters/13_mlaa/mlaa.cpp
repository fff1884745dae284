#include "13_mlaa/mlaa.h"

#include <fmt/core.h>

#include "13_mlaa/tables.h"
#include "common/base/exercise.h"

namespace lightwalk {
namespace {

struct Step {
    glm::ivec2 directions[4];
    int reads, reach;
};

constexpr glm::ivec2 straight[4] = {{-1, 0}, {1, 0}, {0, -1}, {0, 1}};
constexpr glm::ivec2 diagonal[4] = {{-1, -1}, {1, 1}, {1, -1}, {-1, 1}};

}  // namespace

int Mlaa::passes() const {
    int passes = 0;
    for (int steps = 1; steps < reach - 1; steps *= reads.is("two") ? 2 : 4) ++passes;
    return passes;
}

Mlaa::Counts Mlaa::counts() const {
    const std::vector<uint32_t> words = counted_.as<uint32_t>();
    return words.size() < 5 ? Counts{} : Counts{words[3], words[4]};
}

std::vector<std::string> Mlaa::status() const {
    if (!count) return {};
    return {fmt::format("{} pixels beside an edge, {} mixed", counts().listed, counts().changed)};
}

// What the device keeps from frame to frame: for a picture of this size, and the tables.
void Mlaa::set_up(Frame& frame, glm::uvec2 size) {
    Device& device = frame.gpu.device;
    const auto fit = [&](Image& image, const char* name, VkFormat format = VK_FORMAT_R32_UINT) {
        const Image::Desc desc{.name = path() + name, .format = format, .size = size};
        image.fit(device, desc);
    };
    fit(mixed_, " mixed", VK_FORMAT_R16G16B16A16_SFLOAT);
    if (follows_edges()) fit(distances_[0], " distances"), fit(distances_[1], " longer distances");
    if (method.is("smaa_like")) fit(diagonals_[0], " staircases"), fit(diagonals_[1], " longer staircases");
    const VkDeviceSize pixels = VkDeviceSize(size.x) * size.y;
    for (Buffer* const work : {&work_, &next_work_})
        if (!*work) *work = frame.gpu.upload("mlaa work", std::vector<uint32_t>{0, 1, 1, 0, 0});
    std::swap(work_, next_work_);
    if (!list_ || list_.bytes != 4 * pixels) list_ = Buffer(device, {.name = "mlaa list", .bytes = 4 * pixels});
    if (std::exchange(toggles_, Exercises::version()) == Exercises::version()) return;
    const auto table = [&](Image& image, const char* name, uint32_t side, const std::vector<float>& values) {
        if (!image)
            image =
                Image(device, {.name = name, .format = VK_FORMAT_R32_SFLOAT, .size = glm::uvec2(side), .kept = true});
        frame.upload(name, image, std::as_bytes(std::span(values)));
    };
    table(areas_, "mlaa areas", longest_reach, area_table());
    table(crossings_, "mlaa crossings", 4, crossing_table());
}

// [propagate]
// Propagates distances up to `reach`, alternating between the two images for as many passes as needed. Returns the image
// that holds the result.
const Image* Mlaa::propagate(Compute& pass, const Image* from, const Image* into,
                             const glm::ivec2 (&directions)[4]) const {
    Step step{.directions = {}, .reads = reads.is("two") ? 2 : 4, .reach = reach};
    std::copy(std::begin(directions), std::end(directions), step.directions);
    for (int i = 0; i < passes(); ++i, std::swap(from, into)) {
        pass.use(propagate_).set("listed", list_).set("work", work_).set("pass_step", step);
        pass.set("from", *from, nearest_clamp).set("into", *into).dispatch_indirect(work_).wait();
    }
    return from;
}
// [/propagate]

// [record]
void Mlaa::record(Frame& frame, const Image& picture) {
    if (!is_filter()) return;
    set_up(frame, picture.desc.size);
    follows_edges() ? follow_edges(frame, picture) : search_by_luma(frame, picture);
    if (count) frame.read_back(work_, counted_);
}

void Mlaa::follow_edges(Frame& frame, const Image& picture) {
    const bool shapes = method.is("smaa_like");

    // 1. Edges, and the list of pixels beside them.
    ComputeAccess access{
        .reads = {picture, work_}, .writes = {distances_[0], distances_[1], list_, work_, next_work_}, .with = {*this}};
    if (shapes) access.writes.insert(access.writes.end(), {diagonals_[0], diagonals_[1]});
    frame.compute("mlaa edges", access, [&](Compute& pass) {
        pass.use(shapes ? edges_and_diagonals_ : edges_).set("picture", picture, nearest_clamp);
        pass.set("seeds", distances_[0]).set("next", distances_[1]).set("listed", list_).set("work", work_);
        pass.set("next_work", next_work_);
        if (shapes) pass.set("diagonal_seeds", diagonals_[0]).set("diagonal_next", diagonals_[1]);
        pass.dispatch_threads(picture.desc.size);
    });

    // 2. Line lengths. From here on only listed pixels are processed, by as many workgroups as they need.
    access.reads = {work_, list_, distances_[0], distances_[1]};
    access.writes = {distances_[0], distances_[1]};
    if (shapes)
        for (const Image& image : diagonals_) access.reads.push_back(image), access.writes.push_back(image);
    access.reads.push_back(picture);
    frame.compute("mlaa distances", access, [&](Compute& pass) {
        const auto over_list = [&](const Pipeline& pipeline, const Image& from, const Image& into) {
            pass.use(pipeline).set("distances", from, nearest_clamp).set("into", into);
            if (pass.wants("picture")) pass.set("picture", picture, nearest_clamp);
            pass.set("listed", list_).set("work", work_).dispatch_indirect(work_).wait();
        };
        const Image *edges = &distances_[0], *other = &distances_[1];
        if (shapes) {
            over_list(strong_edges_, *edges, *other);
            std::swap(edges, other);
            over_list(diagonal_seeds_, *edges, diagonals_[0]);
            staircases_ = propagate(pass, &diagonals_[0], &diagonals_[1], diagonal);
        }
        over_list(links_, *edges, *other);
        lengths_ = propagate(pass, other, edges, straight);
    });

    // 3. Weights, mixed light, and its copy into the picture.
    access = {.reads = {work_, list_, mixed_, picture, areas_, crossings_, distances()},
              .writes = {work_, mixed_, picture},
              .with = {*this}};
    if (shapes) access.reads.push_back(*staircases_);
    frame.compute("mlaa mix", access, [&](Compute& pass) {
        pass.use(shapes ? mix_shapes_ : mix_).set("picture", picture, nearest_clamp);
        pass.set("distances", distances(), nearest_clamp).set("areas", areas_, nearest_clamp);
        if (shapes) pass.set("diagonals", *staircases_, nearest_clamp).set("crossings", crossings_, nearest_clamp);
        pass.set("listed", list_).set("mixed", mixed_).set("work", work_).dispatch_indirect(work_).wait();
        put(pass, picture);
    });
}
// [/record]

void Mlaa::search_by_luma(Frame& frame, const Image& picture) {
    const ComputeAccess access{.reads = {picture, work_, list_, mixed_},
                               .writes = {picture, work_, next_work_, list_, mixed_},
                               .with = {*this}};
    frame.compute("fxaa", access, [&](Compute& pass) {
        pass.use(fxaa_).set("picture", picture, nearest_clamp).set("listed", list_).set("mixed", mixed_);
        pass.set("work", work_).set("next_work", next_work_).dispatch_threads(picture.desc.size).wait();
        put(pass, picture);
    });
}

void Mlaa::put(Compute& pass, const Image& picture) const {
    pass.use(put_).set("listed", list_).set("mixed", mixed_).set("work", work_).set("picture", picture);
    pass.dispatch_indirect(work_);
}

void Mlaa::show_edges(Frame& frame, const Image& picture, bool lengths) const {
    if (!follows_edges()) return;
    frame.compute("edges in color", {.reads = {distances(), picture}, .writes = {picture}}, [&](Compute& pass) {
        pass.use(lengths ? lengths_in_color_ : edges_in_color_).set("distances", distances(), nearest_clamp);
        pass.set("picture", picture).dispatch_threads(picture.desc.size);
    });
}

}  // namespace lightwalk
