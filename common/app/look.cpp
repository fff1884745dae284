#include "common/app/look.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/base/error.h"
#include "common/look_parameters.h"

namespace lightwalk {
namespace {

Pipeline view_pipeline(const char* shape) {
    return compute({.shader = "common/view_image.comp", .macros = {{"SHAPE", shape}}});
}
const Pipeline plain = view_pipeline("0"), layered = view_pipeline("1"), cube = view_pipeline("2"),
               whole_numbers = view_pipeline("3");

std::string name_of(const std::pair<std::string, ImageView>& output) {
    return output.first + ": " + output.second.name();
}

size_t find(const Frame& frame, const std::string& wanted) {
    const auto& all = frame.outputs;
    auto found = std::find_if(all.begin(), all.end(), [&](const auto& one) { return name_of(one) == wanted; });
    if (found == all.end())
        found = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.first == wanted; });
    return static_cast<size_t>(found - all.begin());
}

const Pipeline& pipeline_for(const ImageView& view) {
    if (view.image->desc.format == VK_FORMAT_R32_UINT) return whole_numbers;
    return view.type == VK_IMAGE_VIEW_TYPE_CUBE ? cube : view.layers > 1 ? layered : plain;
}

int kind_of(const ImageView& view, const Frame& frame) {
    if (view.image == &frame.depth) return LOOK_DEPTH;
    switch (view.image->desc.format) {
        case VK_FORMAT_D32_SFLOAT:
        case VK_FORMAT_D16_UNORM:
        case VK_FORMAT_R8_UNORM:
        case VK_FORMAT_R16_UNORM:
        case VK_FORMAT_R16_SFLOAT:
        case VK_FORMAT_R32_SFLOAT:
        case VK_FORMAT_R32_UINT:
            return LOOK_NUMBER;
        case VK_FORMAT_R8G8B8A8_UNORM:
        case VK_FORMAT_R16G16B16A16_UNORM:
            return LOOK_ENCODED;
        default:
            return LOOK_LINEAR;
    }
}

}  // namespace

std::vector<std::string> Look::names(const Frame& frame) {
    std::vector<std::string> result;
    for (const auto& output : frame.outputs) result.push_back(name_of(output));
    return result;
}

void Look::attach(Frame& frame, Image& copy, const Camera& camera, const Bounds& bounds) const {
    frame.after_pass = nullptr;
    if (output.empty()) return;
    frame.after_pass = [this, &frame, &copy, camera, bounds, seen = size_t(0)]() mutable {
        const size_t end = frame.outputs.size();
        if (seen > end) seen = 0;
        for (; seen < end; ++seen) {
            const auto [pass, view] = frame.outputs[seen];
            if (name_of({pass, view}) == output || (pass == output && find(frame, output) == seen))
                record(frame, copy, view, camera, bounds);
        }
        frame.outputs.resize(end);
    };
}

void show_image(Frame& frame, const std::string& name, const ImageView& view, const Image& into, const Shown& shown,
                const Camera& camera, const Bounds& bounds) {
    const float radius = bounds.empty() ? 1.0f : 0.5f * glm::length(bounds.extent());
    const float middle = glm::distance(camera.position, bounds.empty() ? camera.target : bounds.center());
    const LookParameters parameters{.image_size = glm::uvec2(view.size()),
                                    .scale = std::exp2(shown.stops),
                                    .kind = kind_of(view, frame),
                                    .channel = shown.channel,
                                    .layers = static_cast<int>(view.layers),
                                    .near_m = camera.near_m,
                                    .far_m = camera.far_m,
                                    .bright_m = std::max(camera.near_m, middle - radius),
                                    .dark_m = middle + radius,
                                    .corner = shown.corner,
                                    .size = shown.size};
    frame.compute(name, {.reads = {view}, .writes = {into}}, [&](Compute& pass) {
        pass.use(pipeline_for(view)).set("source", view, nearest_clamp);
        pass.set("look", parameters).set("result", into).dispatch_threads(shown.size);
    });
}

void list_kept(Frame& frame, const std::string& name, const ImageView& view) {
    frame.outputs.emplace_back(name, view);
    if (const auto function = std::exchange(frame.after_pass, nullptr)) {  // no recursion
        function();
        frame.after_pass = function;
    }
}

void Look::record(Frame& frame, Image& copy, ImageView view, const Camera& camera, const Bounds& bounds) const {
    copy.ensure(frame.gpu.device,
                {.name = "look", .format = VK_FORMAT_R8G8B8A8_UNORM, .size = frame.size, .kept = true});
    show_image(frame, "look", view, copy, {{0, 0}, frame.size, stops, channel}, camera, bounds);
}

void Look::check(const Frame& frame) const {
    if (output.empty() || find(frame, output) < frame.outputs.size()) return;
    std::string all;
    for (const auto& [pass, view] : frame.outputs)
        if (all.find("'" + pass + "'") == std::string::npos) all += (all.empty() ? "'" : ", '") + pass + "'";
    throw InputError("--look: no pass '{}' wrote an image in this frame; there are {}", output, all);
}

const Image& Look::picture(const Frame& frame, const Image& copy) const {
    // a newly selected output has no copy yet
    const bool copied = copy && copy.desc.size == frame.size && find(frame, output) < frame.outputs.size();
    return copied ? copy : frame.output;
}

}  // namespace lightwalk
