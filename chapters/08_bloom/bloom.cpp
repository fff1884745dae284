#include "08_bloom/bloom.h"

#include <fmt/core.h>

#include "08_bloom/step_parameters.h"
#include "common/app/show_image.h"
#include "common/base/exercise.h"

namespace lightwalk {
namespace {

constexpr VkFormat half4 = VK_FORMAT_R16G16B16A16_SFLOAT, float4 = VK_FORMAT_R32G32B32A32_SFLOAT;

// Where a level that is mirrored is read, step.glsl finds.
Sampler sampler_for(const Choice& border, const Step& step) {
    const Filter filter = step.linear ? Filter::linear : Filter::nearest;
    const bool line =
        step.kind == Step::Kind::line || step.kind == Step::Kind::shared || step.kind == Step::Kind::window;
    const Wrap mirror = line ? Wrap::mirror : Wrap::clamp;
    const Wrap wrap = border.is("clamp") ? Wrap::clamp : border.is("mirror") ? mirror : Wrap::border;
    return {.filter = filter, .mip_filter = Filter::nearest, .wrap = wrap};
}

}  // namespace

Bloom::Bloom(Module& owner, std::string name) : Module(owner, std::move(name), "bloom") {}

BlurWish Bloom::wish(glm::uvec2 size) const {
    return {.method = method.text(),
            .sigma_px = static_cast<double>(sigma_px.value),
            .truncation = static_cast<double>(truncation.value),
            .sum = shape.is("sum"),
            .size = size,
            .karis = karis};
}

// The plan, its images and its parameters on the device.
void Bloom::set_up(Frame& frame, glm::uvec2 size) {
    if (plan_made_.is_current(size, epoch())) return;
    try {
        plan_ = plan_blur(wish(size));
    } catch (...) {
        plan_made_.forget();
        throw;
    }
    images_.resize(plan_.sizes.size());
    for (size_t i = 0; i < images_.size(); ++i) {
        const bool full = plan_.full_floats && i > 0;
        const Image::Desc desc{.name = fmt::format("{} {}", path(), i == 0 ? "cut out" : fmt::format("{}", i)),
                               .format = full ? float4 : half4,
                               .size = plan_.sizes[i]};
        images_[i].ensure(frame.gpu.device, desc);
    }
    std::vector<glm::uvec3> groups;
    for (const Step& step : plan_.steps) groups.push_back(groups_of(step, plan_));
    if (!groups_made_.is_current(groups)) {
        wanted_ = frame.gpu.upload("bloom workgroups", groups);
        dispatch_ = frame.gpu.upload("bloom dispatches", std::vector<glm::uvec3>(groups.size() + 1, glm::uvec3(0)));
    }
    std::vector<glm::vec2> taps = plan_.taps;
    if (taps.empty()) taps.emplace_back(0.0f);  // a buffer has something in it
    if (!taps_made_.is_current(taps)) taps_ = frame.gpu.upload("bloom taps", taps);
}

// Images after the bright pass are undefined if no blur ran: spreads_at() of dispatches.glsl tells.
void Bloom::show(Frame& frame, size_t image, float gain) const {
    const size_t i = std::min(image, images_.size() - 1);
    show_image(frame, images_[i],
               {.gain = glm::vec3(gain),
                .texels = {glm::vec2(static_cast<float>(plan_.aprons[i])), plan_.extents[i]},
                .words = &dispatch_,
                .gate = static_cast<uint32_t>(3 * plan_.steps.size() + 1)});
}

void Bloom::record(Frame& frame, const Image& hdr) {
    frame.need_light(path(), hdr);
    if (method.is("none")) return;
    set_up(frame, hdr.desc.size);

    // 1. Bright pass; the number of workgroups of each blur step, 0 if nothing is bright. The frame's number saves a pass
    // that would clear the word.
    const auto frame_now = static_cast<uint32_t>(frame.number());
    frame.compute("bloom cut", {.reads = {hdr, dispatch_}, .writes = {cut_out(), dispatch_}, .with = {*this}},
                  [&](Compute& pass) {
                      pass.use(bright_).set("dispatches", dispatch_).set("hdr", hdr, nearest_clamp);
                      pass.set("frame_now", frame_now).set("result", cut_out());
                      pass.dispatch_threads(hdr.desc.size).wait();
                      pass.use(decide_).set("dispatches", dispatch_).set("wanted", wanted_);
                      pass.set("frame_now", frame_now);
                      pass.dispatch_threads(glm::uvec2(static_cast<uint32_t>(3 * plan_.steps.size()), 1));
                  });

    // 2. The blur.
    record_blur(frame);

    // 3. Back into the picture.
    frame.compute("bloom combine", {.reads = {hdr, spread(), dispatch_}, .writes = {hdr}, .with = {*this}},
                  [&](Compute& pass) {
                      pass.use(combine_).set("dispatches", dispatch_).set("spread", spread(), nearest_clamp);
                      pass.set("hdr", hdr).dispatch_threads(hdr.desc.size);
                  });
}

const Pipeline& Bloom::pipeline_of(const Step& step) const {
    switch (step.kind) {
        case Step::Kind::line:
            return plan_.full_floats ? full_line_ : line_;
        case Step::Kind::level_line:
            return level_line_;
        case Step::Kind::shared:
            return shared_;
        case Step::Kind::window:
            return window_;
        case Step::Kind::down:
            return step.karis ? karis_down_ : down_;
        case Step::Kind::up:
            return up_;
        case Step::Kind::kawase_down:
            return kawase_down_;
        case Step::Kind::kawase_up:
            return kawase_up_;
        case Step::Kind::copy:
            break;
    }
    return copy_;
}

void Bloom::record_blur(Frame& frame) {
    ComputeAccess access{.reads = {dispatch_}, .with = {*this}};
    for (const Image& image : images_) {
        access.reads.push_back(image);
        access.writes.push_back(image);
    }
    frame.compute("bloom blur", access, [&](Compute& pass) {
        for (size_t i = 0; i < plan_.steps.size(); ++i) {
            const Step& step = plan_.steps[i];
            if (i > 0) pass.wait();  // for the step before
            pass.use(pipeline_of(step));
            if (pass.wants("taps")) pass.set("taps", taps_);
            pass.set("from", images_[static_cast<size_t>(step.from)], sampler_for(border, step));
            pass.set("into", images_[static_cast<size_t>(step.into)]);
            pass.set("step_now", StepParameters{.direction = step.direction,
                                                .first_tap = static_cast<int>(step.first_tap),
                                                .taps = static_cast<int>(step.taps),
                                                .extent = plan_.extents[static_cast<size_t>(step.from)],
                                                .from_apron = plan_.aprons[static_cast<size_t>(step.from)],
                                                .apron = plan_.aprons[static_cast<size_t>(step.into)],
                                                .mirrors = border.is("mirror") ? 1 : 0,
                                                .spread = step.spread,
                                                .weight = step.weight,
                                                .keep = step.keep});
            pass.dispatch_indirect(dispatch_, 12 * i);
        }
    });
}

}  // namespace lightwalk
