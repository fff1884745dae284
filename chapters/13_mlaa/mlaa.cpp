#include "13_mlaa/mlaa.h"

#include <fmt/core.h>

#include "13_mlaa/exercises.h"
#include "common/base/error.h"
#include "common/base/exercise.h"

namespace lightwalk {
namespace {

struct Step {
    glm::ivec2 directions[4];
    int reads, reach;
};

constexpr glm::ivec2 straight[4] = {{-1, 0}, {1, 0}, {0, -1}, {0, 1}};
constexpr glm::ivec2 diagonal[4] = {{-1, -1}, {1, 1}, {1, -1}, {-1, 1}};

constexpr int longest_reach = 255;  // limit of a byte

// [(to_other - 1) * longest_reach + to_end - 1]: the share of a pixel that lies `to_end` pixels from the end of a line at which
// the outline turns, and `to_other` pixels from its other end; itself counted both times. By exercise 13.area.
std::vector<float> area_table() {
    const auto area_of = area.function();
    std::vector<float> table;
    for (int to_other = 1; to_other <= longest_reach; ++to_other)
        for (int to_end = 1; to_end <= longest_reach; ++to_end)
            table.push_back(area_of(to_end - 1, to_end + to_other - 1));
    return table;
}

// [4 * at_other + at_end]: the side to which an outline turns at an end of a line: -1 the near one, 1 the far one, 0 none.
// Index: crossing edges there and at the other end: 0 nothing, 1 an edge on the near side, 2 on the far side, 3 both. With both,
// two outlines cross: each continues from one side of the line to the other.
std::vector<float> crossing_table() {
    const auto turn = [](int across) { return across == 1 ? -1.0f : across == 2 ? 1.0f : 0.0f; };
    std::vector<float> table;
    for (int at_other = 0; at_other < 4; ++at_other)
        for (int at_end = 0; at_end < 4; ++at_end) table.push_back(at_end == 3 ? -turn(at_other) : turn(at_end));
    return table;
}

}  // namespace

Taa::Taa(Module& owner, std::string name) : Module(owner, std::move(name), "taa") {}

Mlaa::Mlaa(Module& owner, std::string name) : Module(owner, std::move(name), "mlaa") {
    taa.in_use = [this] { return method.is("taa"); };
}

int Mlaa::passes() const {
    int passes = 0;
    if (!doubles()) return passes;
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

// Persistent resources: for a picture of this size, and the tables.
void Mlaa::set_up(Frame& frame, const Image& picture) {
    Device& device = frame.gpu.device;
    const glm::uvec2 size = picture.desc.size;
    const auto fit = [&](Image& image, const char* name, glm::uvec2 side) {
        image.ensure(device, {.name = path() + name, .format = VK_FORMAT_R32_UINT, .size = side});
    };
    for (Buffer* const work : {&work_, &next_work_})
        if (!*work) *work = frame.gpu.upload("mlaa work", std::vector<uint32_t>{0, 1, 1, 0, 0});
    std::swap(work_, next_work_);
    light_.ensure(device, picture.desc);
    if (!follows_edges()) return;

    const VkDeviceSize bytes = 4 * VkDeviceSize(size.x) * size.y;
    if (!list_ || list_.bytes != bytes) list_ = Buffer(device, {.name = "mlaa list", .bytes = bytes});
    fit(edge_rows_, " edges in rows", {(size.x + 15) / 16, size.y});
    fit(edge_columns_, " edges in columns", {size.x, (size.y + 15) / 16});
    if (doubles()) {
        fit(distances_[0], " distances", size);
        fit(distances_[1], " longer distances", size);
    }
    if (doubles() && method.is("smaa_like")) {
        fit(diagonals_[0], " staircases", size);
        fit(diagonals_[1], " longer staircases", size);
    }
    if (tables_made_.is_current(Exercises::epoch())) return;
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
        over_list(pass, propagate_).set("pass_step", step).set("from", *from, nearest_clamp).set("into", *into);
        pass.dispatch_indirect(work_).wait();
    }
    return from;
}
// [/propagate]

void Mlaa::set_edges(Compute& pass) const {
    pass.set("edge_rows", edge_rows_, nearest_clamp).set("edge_columns", edge_columns_, nearest_clamp);
}

Compute& Mlaa::over_list(Compute& pass, const Pipeline& pipeline) const {
    return pass.use(pipeline).set("listed", list_).set("work", work_);
}

// Links between neighbours, then distances that grow from pass to pass.
void Mlaa::measure_by_doubling(Compute& pass) {
    const auto grow = [&](const Pipeline& link, const Image(&images)[2], const glm::ivec2(&directions)[4]) {
        over_list(pass, link).set("into", images[0]);
        set_edges(pass);
        pass.dispatch_indirect(work_).wait();
        return propagate(pass, &images[0], &images[1], directions);
    };
    if (method.is("smaa_like")) staircases_ = grow(diagonal_seeds_, diagonals_, diagonal);
    lengths_ = grow(links_, distances_, straight);
}

void Mlaa::record(Frame& frame, Image& picture, const Seen& seen) {
    method.is("taa") ? taa.record(frame, picture, seen) : record(frame, picture);
}

void Mlaa::record(Frame& frame, Image& picture) {
    if (method.is("taa"))
        throw Failure("'{}': taa follows surfaces, and this picture comes without depth and view", method.path());
    if (!is_filter()) return;
    set_up(frame, picture);
    follows_edges() ? follow_edges(frame, picture) : search_by_luma(frame, picture);
    if (count) frame.read_back(work_, counted_);
}

void Mlaa::follow_edges(Frame& frame, const Image& picture) {
    const bool shapes = method.is("smaa_like");

    // 1. Edges as bits, the list of pixels beside them, and their light, since neighbours read it after it was mixed.
    ComputeAccess access{.reads = {picture, work_, list_, edge_rows_, edge_columns_},
                         .writes = {edge_rows_, edge_columns_, list_, light_, work_, next_work_},
                         .with = {*this}};
    frame.compute("mlaa edges", access, [&](Compute& pass) {
        pass.use(shapes ? seen_edges_ : edges_);
        pass.set("picture", picture, nearest_clamp).set("light_beside", light_);
        pass.set("row_words", edge_rows_).set("column_words", edge_columns_);
        pass.set("listed", list_).set("work", work_).set("next_work", next_work_).dispatch_threads(picture.desc.size);
    });

    // 2. Line lengths, unless words of edges tell them. From here on only listed pixels are processed, by as many
    // workgroups as they need.
    std::vector<Resource> lengths;
    if (doubles()) lengths.insert(lengths.end(), {distances_[0], distances_[1]});
    if (doubles() && shapes) lengths.insert(lengths.end(), {diagonals_[0], diagonals_[1]});
    access = {.reads = {work_, list_, edge_rows_, edge_columns_}, .writes = lengths, .with = {*this}};
    access.reads.insert(access.reads.end(), lengths.begin(), lengths.end());
    if (doubles()) frame.compute("mlaa distances", access, [&](Compute& pass) { measure_by_doubling(pass); });

    // 3. Weights, and mixed light.
    access.reads.insert(access.reads.end(), {light_, areas_, crossings_});
    access.writes = {work_, picture};
    frame.compute("mlaa mix", access, [&](Compute& pass) {
        over_list(pass, shapes ? mix_shapes_ : mix_).set("picture", light_, nearest_clamp).set("into", picture);
        pass.set("areas", areas_, nearest_clamp);
        if (doubles()) pass.set("distances", *lengths_, nearest_clamp);
        if (doubles() && shapes) pass.set("diagonals", *staircases_, nearest_clamp);
        if (shapes) pass.set("crossings", crossings_, nearest_clamp);
        set_edges(pass);
        pass.dispatch_indirect(work_);
    });
}

// A whole picture, with which the given one changes places: other pixels are read while some are mixed.
void Mlaa::search_by_luma(Frame& frame, Image& picture) {
    const ComputeAccess access{.reads = {picture, work_}, .writes = {light_, work_, next_work_}, .with = {*this}};
    frame.compute("fxaa", access, [&](Compute& pass) {
        pass.use(fxaa_).set("picture", picture, nearest_clamp).set("into", light_);
        const glm::uvec2 size = picture.desc.size;
        pass.set("work", work_).set("next_work", next_work_);
        pass.dispatch_threads(glm::uvec2(size.x, (size.y + 3) / 4));  // a thread has four pixels of a column
    });
    std::swap(picture, light_);
}

void Mlaa::show_edges(Frame& frame, const Image& picture, bool lengths) const {
    if (!follows_edges()) return;
    ComputeAccess access{.reads = {edge_rows_, edge_columns_, picture}, .writes = {picture}, .with = {*this}};
    if (doubles()) access.reads.push_back(*lengths_);
    frame.compute("edges in color", access, [&](Compute& pass) {
        pass.use(lengths ? lengths_in_color_ : edges_in_color_);
        set_edges(pass);
        if (doubles()) pass.set("distances", *lengths_, nearest_clamp);
        pass.set("picture", picture).dispatch_threads(picture.desc.size);
    });
}

}  // namespace lightwalk
