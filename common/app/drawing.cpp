#include "common/app/drawing.h"

#include <algorithm>
#include <utility>

namespace lightwalk {
namespace {

struct Surface {
    const Drawing* drawing;
    Drawing::Transparent what;
};

// Back to front by object. One pass holds as many as follow each other and are of one drawing.
void draw_transparent(Frame& frame, const View& view, Canvas& canvas, const Drawings& drawings) {
    std::vector<Surface> all;
    for (const Drawing& drawing : drawings)
        for (const Drawing::Transparent& one : drawing.transparent(view)) all.push_back({&drawing, one});
    std::stable_sort(all.begin(), all.end(),
                     [](const Surface& a, const Surface& b) { return a.what.distance_m > b.what.distance_m; });
    for (auto first = all.begin(), last = first; first != all.end(); first = last) {
        last = std::find_if(first, all.end(), [&](const Surface& s) { return s.drawing != first->drawing; });
        std::vector<Drawing::Transparent> run;
        std::transform(first, last, std::back_inserter(run), [](const Surface& s) { return s.what; });
        canvas.depth(frame);  // cleared where nothing opaque was drawn
        frame.raster("transparent",
                     {.color = {canvas.color_target()},
                      .depth = canvas.depth_read_only(),
                      .reads = first->drawing->transparent_reads(),
                      .with = first->drawing->transparent_with()},
                     [&](Raster& pass) { first->drawing->draw_transparent(pass, run, {}); });
    }
}

}  // namespace

Canvas& Canvas::multisampled(const ImageView& colors, const ImageView& depths) {
    colors_ = colors, depths_ = depths;
    return *this;
}

Attachment Canvas::color_target() {
    const ImageView& target = colors_ ? colors_ : color_;
    Attachment attachment = std::exchange(color_begun_, true) ? keep(target) : clear(target, background_);
    return colors_ ? resolve(attachment, color_) : attachment;
}

Attachment Canvas::depth_target() {
    const ImageView& target = depths_ ? depths_ : depth_;
    return std::exchange(depth_begun_, true) ? keep(target) : clear(target, 0.0f);
}

Attachment Canvas::depth_read_only() const { return read_only(depths_ ? depths_ : depth_); }

const ImageView& Canvas::color(Frame& frame) {
    if (!color_begun_) frame.raster("clear", {.color = {color_target()}}, [](Raster&) {});
    return color_;
}

const ImageView& Canvas::depth(Frame& frame) {
    if (!depth_begun_) frame.raster("clear depth", {.depth = depth_target()}, [](Raster&) {});
    return depth_;
}

const ImageView& Canvas::color_overwritten() {
    color_begun_ = true;
    return color_;
}

const ImageView& Canvas::depth_overwritten() {
    depth_begun_ = true;
    return depth_;
}

void Drawing::update_once(Frame& frame) {
    if (std::exchange(updated_, frame.number()) != frame.number()) update(frame);
}

void draw(Frame& frame, const View& view, Canvas& canvas, const Drawings& drawings) {
    const ViewScope scope(frame, view);
    for (Drawing& drawing : drawings) drawing.update_once(frame);
    for (Drawing& drawing : drawings) drawing.draw(frame, view, canvas);
    canvas.color(frame);
    draw_transparent(frame, view, canvas, drawings);
}

}  // namespace lightwalk
