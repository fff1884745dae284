#include "common/app/drawing.h"

#include <algorithm>
#include <utility>

#include "common/base/error.h"

namespace lightwalk {
namespace {

void draw_sorted(Frame& frame, Canvas& canvas, std::vector<TransparentSurface> all) {
    std::stable_sort(all.begin(), all.end(), [](const TransparentSurface& a, const TransparentSurface& b) {
        return a.what.distance_m > b.what.distance_m;
    });
    draw_surfaces(frame, "transparent", {.color = {canvas.color_target()}, .depth = canvas.depth_read_only()}, all);
}

}  // namespace

std::vector<TransparentSurface> transparent_surfaces(const View& view, const Drawings& drawings) {
    std::vector<TransparentSurface> all;
    for (const Drawing& drawing : drawings) {
        const TransparentSource* const part = drawing.transparent_source();
        if (!part) continue;
        for (const TransparentSource::Transparent& one : part->transparent(view)) all.push_back({part, one});
    }
    return all;
}

void draw_surfaces(Frame& frame, const std::string& pass, RasterTargets targets,
                   const std::vector<TransparentSurface>& surfaces) {
    const auto cleared = [](const Attachment& target) { return target.load == Attachment::Load::clear; };
    if (surfaces.empty() && std::any_of(targets.color.begin(), targets.color.end(), cleared))
        frame.raster(pass, targets, [](Raster&) {});
    for (auto first = surfaces.begin(), last = first; first != surfaces.end(); first = last) {
        const TransparentSource& source = *first->source;
        last = std::find_if(first, surfaces.end(), [&](const TransparentSurface& s) { return s.source != &source; });
        std::vector<TransparentSource::Transparent> run;
        std::transform(first, last, std::back_inserter(run), [](const TransparentSurface& s) { return s.what; });
        RasterTargets own = targets;
        for (const Resource& read : source.transparent_reads()) own.reads.push_back(read);
        for (const With& with : source.transparent_with()) own.with.push_back(with);
        frame.raster(pass, own, [&](Raster& raster) { source.draw_transparent(raster, run); });
        for (Attachment& target : targets.color)
            if (cleared(target)) target.load = Attachment::Load::keep;
        if (targets.depth.view && cleared(targets.depth)) targets.depth.load = Attachment::Load::keep;
    }
}

Drawings::Drawings(std::initializer_list<std::reference_wrapper<Drawing>> all, SourceLocation where)
    : std::vector<std::reference_wrapper<Drawing>>(all) {
    for (auto one = begin(); one != end(); ++one)
        if (std::any_of(begin(), one, [&](const Drawing& other) { return &other == &one->get(); }))
            throw Failure("{}: the drawing '{}' is given twice", place_of(where), one->get().path());
}

Canvas& Canvas::blended_by(TransparencyMethod* method) {
    transparency_method_ = method;
    return *this;
}

Canvas& Canvas::multisampled(const ImageView& colors, const ImageView& depths) {
    colors_ = colors;
    depths_ = depths;
    return *this;
}

const char* name_of(Phase phase) {
    constexpr const char* names[] = {"backdrop", "opaque", "sky", "water", "air", "fog"};
    return names[static_cast<size_t>(phase)];
}

void Canvas::enter(const Drawing& drawing) {
    const Phase phase = drawing.draw_phase();
    if (std::ranges::find(entered_, &drawing) != entered_.end())
        throw Failure("'{}' is drawn twice into one canvas", drawing.path());
    if (!entered_.empty() && phase < entered_.back()->draw_phase())
        throw Failure("'{}' ({}) is drawn after '{}' ({}): give both to one draw(), which orders them by phase",
                      drawing.path(), name_of(phase), entered_.back()->path(), name_of(entered_.back()->draw_phase()));
    entered_.push_back(&drawing);
}

// Cleared contents are linear light again.
void Canvas::begin_color() {
    if (!color_begun_) color_.image->shown_in = 0;
}

Attachment Canvas::color_target() {
    begin_color();
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
    begin_color();
    color_begun_ = true;
    return color_;
}

const ImageView& Canvas::depth_overwritten() {
    depth_begun_ = true;
    return depth_;
}

void Drawing::update_sun_once(const Frame& frame) {
    if (std::exchange(sun_updated_, frame.number()) != frame.number()) update_sun();
}

void Drawing::find_casters_once(const Frame& frame, const Drawings& all) {
    if (std::exchange(met_, frame.number()) != frame.number()) find_casters(all);
}

void Drawing::update_once(Frame& frame) {
    update_sun_once(frame);
    if (std::exchange(updated_, frame.number()) != frame.number()) update(frame);
}

void draw(Frame& frame, const View& view, Canvas& canvas, const Drawings& drawings, SourceLocation where) {
    draw_opaque(frame, view, canvas, drawings, where);
    draw_transparent(frame, view, canvas, drawings);
}

Drawings in_order(const Drawings& drawings) {
    Drawings all;
    all.reserve(drawings.size());
    const auto earlier = [](const Drawing& a, const Drawing& b) { return a.draw_phase() < b.draw_phase(); };
    for (Drawing& drawing : drawings)
        if (!drawing.in_use || drawing.in_use())
            all.insert(std::upper_bound(all.begin(), all.end(), drawing, earlier), drawing);
    return all;
}

Drawings of_phases(std::initializer_list<Phase> phases, const Drawings& drawings) {
    Drawings some;
    for (Drawing& drawing : drawings)
        if (std::find(phases.begin(), phases.end(), drawing.draw_phase()) != phases.end()) some.emplace_back(drawing);
    return some;
}

void update(Frame& frame, const Drawings& drawings) {
    for (Drawing& drawing : drawings) drawing.update_sun_once(frame);
    for (Drawing& drawing : drawings) drawing.find_casters_once(frame, drawings);
    for (Drawing& drawing : drawings) {
        if (const Drawing* light = drawing.sun_source(); light && !light->has_updated_sun(frame))
            throw Failure("'{}' is lit by '{}', which this frame does not draw: add it to the drawings", drawing.path(),
                          light->path());
        drawing.update_once(frame);
    }
}

void draw_opaque(Frame& frame, const View& view, Canvas& canvas, const Drawings& drawings, SourceLocation where) {
    const ViewScope scope(frame, view);
    const Drawings ordered = in_order(drawings);
    update(frame, ordered);
    for (Drawing& drawing : ordered) {
        check_at(where, [&] { canvas.enter(drawing); });
        drawing.draw(frame, view, canvas);
    }
    canvas.color(frame);
}

void draw_transparent(Frame& frame, const View& view, Canvas& canvas, const Drawings& drawings) {
    const ViewScope scope(frame, view);
    const std::vector<TransparentSurface> surfaces = transparent_surfaces(view, in_order(drawings));
    if (surfaces.empty()) return;
    canvas.depth(frame);  // clears depth if nothing opaque was drawn
    if (canvas.transparency_method())
        canvas.transparency_method()->record(frame, view, canvas, surfaces);
    else
        draw_sorted(frame, canvas, surfaces);
}

}  // namespace lightwalk
