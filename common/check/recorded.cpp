#include "common/check/recorded.h"

#include <algorithm>
#include <cstring>

#include "common/base/error.h"
#include "common/check/guard.h"

namespace lightwalk {
namespace {

using Kind = RecordedStep::Kind;

// Bound on untrusted input; exercises record a few dozen steps.
constexpr size_t most_steps = 10000;

template <class T>
const T& one_of(const std::vector<T>& list, size_t index, const char* what) {
    if (index >= list.size()) throw Failure("it names {} that the exercise was not given", what);
    return list[index];
}

template <class Enum>
void require(Enum value, Enum last) {
    if (value < Enum{} || value > last) throw Failure("it was recorded with a value that no option has");
}

ImageView view_of(const RecordedView& recorded, const Cast& cast) {
    if (recorded.image < 0) return {};
    ImageView view = *one_of(cast.images, static_cast<size_t>(recorded.image), "an image");
    const auto inside = [](uint32_t first, uint32_t count, uint32_t all) {
        return count > 0 && first < all && count <= all - first;
    };
    const ImageView whole = view.all_mips();
    require(recorded.type, VK_IMAGE_VIEW_TYPE_CUBE_ARRAY);
    const bool cube = recorded.type == VK_IMAGE_VIEW_TYPE_CUBE || recorded.type == VK_IMAGE_VIEW_TYPE_CUBE_ARRAY;
    if (!inside(recorded.first_mip, recorded.mips, whole.mips) ||
        !inside(recorded.first_layer, recorded.layers, whole.layers) || whole.is_volume() ||
        recorded.format != VK_FORMAT_UNDEFINED || (cube && recorded.type != whole.type) ||
        (recorded.type == VK_IMAGE_VIEW_TYPE_2D && recorded.layers != 1) || recorded.type == VK_IMAGE_VIEW_TYPE_1D ||
        recorded.type == VK_IMAGE_VIEW_TYPE_3D || recorded.type == VK_IMAGE_VIEW_TYPE_1D_ARRAY)
        throw Failure("it names a part of an image that is not there");
    view.first_mip = recorded.first_mip;
    view.mips = recorded.mips;
    view.first_layer = recorded.first_layer;
    view.layers = recorded.layers;
    view.type = recorded.type;
    return view;
}

std::vector<Resource> resources_of(const std::vector<RecordedView>& views, const Cast& cast) {
    std::vector<Resource> found;
    for (const RecordedView& view : views) found.emplace_back(view_of(view, cast));
    return found;
}

Attachment target_of(const RecordedTarget& recorded, const Cast& cast) {
    require(recorded.load, Attachment::Load::read_only);
    Attachment target(view_of(recorded.view, cast));
    target.load = recorded.load;
    target.color = recorded.color;
    target.depth = recorded.depth;
    target.resolve_into = view_of(recorded.resolve_into, cast);
    return target;
}

const Sampler& checked(const Sampler& sampler, const std::string& binding, std::span<const ImageView> views) {
    require(sampler.filter, Filter::linear);
    require(sampler.mip_filter, Filter::linear);
    require(sampler.compare, Compare::always);
    require(sampler.wrap, Wrap::border);
    require(sampler.border, Border::opaque_white);
    if (!(sampler.anisotropy >= 1 && sampler.anisotropy <= 16) || !(sampler.min_lod >= 0) ||
        !(sampler.max_lod >= sampler.min_lod) || !(std::abs(sampler.lod_bias) <= 15))
        throw Failure("a sampler has a number that no device takes");
    // Mesa 25 filters depth images, Mesa 22 does not.
    const auto is_depth = [](const ImageView& view) { return view.image && view.image->is_depth(); };
    if (sampler.filter == Filter::linear && sampler.compare == Compare::off && std::ranges::any_of(views, is_depth))
        throw Failure("'{}' is a depth image with a linear filter: many devices have none for it", binding);
    return sampler;
}

// Access to byte-based setters: typed set() needs compile-time sizes.
struct Setting : Pass {
    using Pass::set_bytes;
    using Pass::set_images;
};

template <class Any>
void step_again(Any& pass, const RecordedStep& step, const Cast& cast) {
    const auto set_bytes = &Setting::set_bytes;
    const auto set_images = &Setting::set_images;
    const glm::uvec3 n = step.counts;
    switch (step.kind) {
        case Kind::use:
            pass.use(*one_of(cast.pipelines, step.index, "a pipeline"));
            return;
        case Kind::set_views: {
            std::vector<ImageView> views;
            for (const RecordedView& view : step.views) views.push_back(view_of(view, cast));
            (pass.*set_images)(step.binding, views, checked(step.sampler, step.binding, views));
            return;
        }
        case Kind::set_bytes:
            (pass.*set_bytes)(step.binding, std::as_bytes(std::span(step.bytes)), BlockMember::Type::other);
            return;
        case Kind::wait:
            if constexpr (std::is_same_v<Any, Compute>) return void(pass.wait());
            break;
        case Kind::dispatch:
            if (std::max({n.x, n.y, n.z}) > 65535) throw Failure("it dispatches {} x {} x {} groups", n.x, n.y, n.z);
            if constexpr (std::is_same_v<Any, Compute>) return void(pass.dispatch(n));
            break;
        case Kind::draw:  // NOLINT(bugprone-branch-clone): a pass that computes has neither draws nor calls
            if constexpr (std::is_same_v<Any, Raster>) return void(pass.draw(n.x, n.y, n.z));
            break;
        case Kind::call:
            if constexpr (std::is_same_v<Any, Raster>) return one_of(cast.calls, step.index, "a function")(pass);
            break;
    }
    throw Failure("pass '{}' has a step that its kind of pass does not have", pass.name);
}

void pass_again(Frame& frame, const RecordedPass& pass, const Cast& cast) {
    const auto record = [&](auto& again) {
        for (const RecordedStep& step : pass.steps) step_again(again, step, cast);
    };
    std::vector<With> with;
    for (const uint32_t index : pass.with) with.emplace_back(*one_of(cast.given, index, "a module"));
    const std::vector<Resource> reads = resources_of(pass.reads, cast), writes = resources_of(pass.writes, cast);
    if (pass.is_compute) return frame.compute(pass.name, {reads, writes, with}, [&](Compute& again) { record(again); });
    RasterTargets targets{.reads = reads, .writes = writes, .with = with, .layers = pass.layers, .size = pass.size};
    if (pass.layers < 1 || pass.layers > 6 || pass.size.x > 4096 || pass.size.y > 4096)
        throw Failure("pass '{}' draws into more than there is", pass.name);
    for (const RecordedTarget& target : pass.color) targets.color.push_back(target_of(target, cast));
    targets.depth = target_of(pass.depth, cast);
    frame.raster(pass.name, targets, [&](Raster& again) { record(again); });
}

}  // namespace

RecordedFrame Recorder::listen(const Cast& cast, const std::string& name, const std::function<void()>& record) {
    cast_ = &cast;
    quiet_ = false;
    frame_ = {};
    std::string thrown;
    guard_call(name);
    try {
        record();
    } catch (const std::exception& e) { thrown = *e.what() ? e.what() : name + " threw an exception"; } catch (...) {
        thrown = name + " threw what is no std::exception";
    }
    guard_call("");
    if (frame_.error.empty()) frame_.error = thrown;
    cast_ = nullptr;
    return std::move(frame_);
}

std::function<void(Raster&)> Recorder::call(uint32_t i) {
    return [this, i](Raster& pass) {
        if (RecordedStep* step = add(Kind::call)) step->index = i;
        if (!cast_ || i >= cast_->calls.size()) return;
        quiet_ = true;
        cast_->calls[i](pass);
        quiet_ = false;
    };
}

RecordedView Recorder::view_of(const ImageView& view) const {
    if (!view) return {};
    const auto found = std::ranges::find(cast_->images, view.image);
    if (found == cast_->images.end())
        throw Failure("{} is an image of its own; the exercise works on those it is given", view.name());
    return {.image = static_cast<int32_t>(found - cast_->images.begin()),
            .first_mip = view.first_mip,
            .mips = view.mips,
            .first_layer = view.first_layer,
            .layers = view.layers,
            .type = view.type,
            .format = view.format};
}

RecordedTarget Recorder::target_of(const Attachment& target) const {
    return {.view = view_of(target.view),
            .load = target.load,
            .color = target.color,
            .depth = target.depth,
            .resolve_into = view_of(target.resolve_into)};
}

RecordedPass& Recorder::begin(const std::string& name, const std::vector<Resource>& reads,
                              const std::vector<Resource>& writes, const std::vector<With>& with) {
    RecordedPass& pass = frame_.passes.emplace_back();
    pass.name = name;
    const auto add_all = [&](const std::vector<Resource>& from, std::vector<RecordedView>& into) {
        for (const Resource& one : from)
            one.buffer ? does_more("the buffer '" + one.buffer->name + "'") : void(into.push_back(view_of(one.view)));
    };
    add_all(reads, pass.reads);
    add_all(writes, pass.writes);
    for (const PassInputs& one : with)
        pass.with.push_back(static_cast<uint32_t>(std::ranges::find(cast_->given, &one) - cast_->given.begin()));
    return pass;
}

void Recorder::begins(const std::string& pass, const RasterTargets& targets) {
    if (!cast_ || quiet_) return;
    RecordedPass& now = begin(pass, targets.reads, targets.writes, targets.with);
    for (const Attachment& target : targets.color) now.color.push_back(target_of(target));
    now.depth = target_of(targets.depth);
    now.layers = targets.layers;
    now.size = targets.size;
    if (targets.blend_override) does_more(".blend_override");
}

void Recorder::begins(const std::string& pass, const ComputeAccess& access) {
    if (cast_ && !quiet_) begin(pass, access.reads, access.writes, access.with).is_compute = true;
}

RecordedStep* Recorder::add(Kind kind) {
    if (!cast_ || quiet_ || frame_.passes.empty()) return nullptr;
    auto& steps = frame_.passes.back().steps;
    if (steps.size() >= most_steps)
        throw Failure("pass '{}' has more than {} steps", frame_.passes.back().name, most_steps);
    steps.emplace_back().kind = kind;
    return &steps.back();
}

void Recorder::uses(const Pipeline& pipeline, const Macros& variant) {
    RecordedStep* const step = add(Kind::use);
    if (!step) return;
    step->index = static_cast<uint32_t>(std::ranges::find(cast_->pipelines, &pipeline) - cast_->pipelines.begin());
    if (!variant.values().empty()) does_more("macros of its own");
}

void Recorder::sets(std::string_view binding, std::span<const ImageView> views, const Sampler& sampler) {
    RecordedStep* const step = add(Kind::set_views);
    if (!step) return;
    step->binding = binding;
    step->sampler = sampler;
    for (const ImageView& view : views) step->views.push_back(view_of(view));
}

void Recorder::sets(std::string_view binding, std::span<const std::byte> bytes) {
    RecordedStep* const step = add(Kind::set_bytes);
    if (!step) return;
    step->binding = binding;
    step->bytes.resize(bytes.size());
    if (!bytes.empty()) std::memcpy(step->bytes.data(), bytes.data(), bytes.size());
}

void Recorder::draws(uint32_t vertices, uint32_t instances, uint32_t first_instance) {
    if (RecordedStep* const step = add(Kind::draw)) step->counts = {vertices, instances, first_instance};
}

void Recorder::dispatches(glm::uvec3 groups) {
    if (RecordedStep* const step = add(Kind::dispatch)) step->counts = groups;
}

void Recorder::waits() { add(Kind::wait); }

void Recorder::does_more(std::string_view what) {
    if (cast_ && !quiet_ && frame_.error.empty())
        frame_.error = fmt::format("it records {}, which the exercise does not need and its check does not know", what);
}

std::string replay(Frame& frame, const RecordedFrame& recorded, const Cast& cast) {
    try {
        if (recorded.passes.size() > most_steps) throw Failure("it records {} passes", recorded.passes.size());
        for (const RecordedPass& pass : recorded.passes) pass_again(frame, pass, cast);
    } catch (const std::exception& e) { return recorded.error.empty() ? e.what() : recorded.error; }
    return recorded.error;
}

}  // namespace lightwalk
