#include "common/gpu/frame.h"

#include <utility>

#include "common/base/error.h"

namespace lightwalk {

Frame::Frame(Gpu& owner, const FrameWatch& watch) : gpu(owner), watch_(watch) {
    recordings_.push_back(std::make_unique<Recording>(gpu.device));
    const VkSemaphoreTypeCreateInfo type{.sType = VK_STRUCTURE_TYPE_SEMAPHORE_TYPE_CREATE_INFO,
                                         .semaphoreType = VK_SEMAPHORE_TYPE_TIMELINE};
    const VkSemaphoreCreateInfo semaphore_info{.sType = VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO, .pNext = &type};
    const VkDevice device = gpu.device.handle;
    check(vkCreateSemaphore(device, &semaphore_info, nullptr, timeline_.put(device)), "vkCreateSemaphore");
    gpu.device.set_name(VK_OBJECT_TYPE_SEMAPHORE, reinterpret_cast<uint64_t>(VkSemaphore(timeline_)), "frames ended");
}

Frame::~Frame() {
    if (!recording().ends_at) recording().passes.clear();  // recorded, but not to be submitted
    try {
        finish();
    } catch (const std::exception&) {  // device lost
        vkDeviceWaitIdle(gpu.device.handle);
    }
    for (const auto& one : recordings_)
        if (one->use) gpu.device.end_use(one->use);
}

void Frame::begin(glm::uvec2 size_in_pixels, float time_in_seconds) {
    Recording& abandoned = recording();  // recorded but not submitted
    if (abandoned.use && !abandoned.ends_at) gpu.device.end_use(std::exchange(abandoned.use, 0));
    if (gpu.device.is_recording()) throw Failure("a frame begins while another one is being recorded");
    if (size != size_in_pixels) {
        size = size_in_pixels;
        hdr = Image(gpu.device, {.name = "hdr", .format = VK_FORMAT_R16G16B16A16_SFLOAT, .size = size});
        depth = Image(gpu.device, {.name = "depth", .format = VK_FORMAT_D32_SFLOAT, .size = size});
        mean_ = Image();
        output = Image(gpu.device, {.name = "output", .format = VK_FORMAT_R8G8B8A8_UNORM, .size = size, .kept = true});
    }
    if (samples.count > 1 && !mean_)
        mean_ =
            Image(gpu.device, {.name = "mean", .format = VK_FORMAT_R32G32B32A32_SFLOAT, .size = size, .kept = true});
    time_s = time_in_seconds;
    outputs.clear();
    globals.clear();
    if (recordings_.size() == 1) times.clear();
    current_ = (current_ + 1) % recordings_.size();
    retire(recording());
    recording().read_backs.clear();
    recording().times.clear();
    recording().restart();
    recording().use = gpu.device.begin_use();
    ++begun;
}

// Splits frames with more passes than one submission can time, such as a thousand lens samples.
void Frame::make_room() {
    if (!recording().has_room()) finish();
}

VkCommandBuffer Frame::begin_pass(const std::string& name, const char* stage) {
    make_room();
    if (in_pass_) throw Failure("pass '{}' begins within pass '{}'", name, recording().passes.back().name);
    if (name.empty()) throw Failure("a pass has no name, by which timers and messages call it");
    in_pass_ = true;
    return recording().begin_pass(name, stage);
}

void Frame::end_pass() {
    in_pass_ = false;
    recording().end_pass();
}

// A pass that throws is still ended and submitted: the images' histories already include its barriers.
template <class Record, class End>
void Frame::record_and_end(const Record& record, const End& end) {
    try {
        record();
    } catch (...) {
        end();
        throw;
    }
    end();
}

void Frame::add_output(const std::string& name, const ImageView& view) {
    if (view && !view.is_volume() && view.image->desc.samples == 1) outputs.emplace_back(name, view);
}

void Frame::run_after_pass(size_t outputs_before) {
    if (!after_pass || outputs.size() == outputs_before) return;
    const auto function = std::exchange(after_pass, nullptr);  // no recursion
    function();
    after_pass = function;
}

namespace {

bool holds(const ImageView& view, uint64_t frame) {
    const Image& image = *view.image;
    return image.constant || image.desc.kept || image.written_in == frame;
}

}  // namespace

void Frame::check_reads(const std::string& pass, const std::vector<Stated>& stated, const Rendering* targets) const {
    // A resource in both lists may be written by an earlier dispatch of the same pass.
    const auto refuse = [&](const ImageView& view) {
        throw Failure("pass '{}' reads {}, which no pass of this frame wrote", pass, view.name());
    };
    for (const Stated& one : stated)
        if (one.read && !one.writable && one.resource.view && !holds(one.resource.view, number()))
            refuse(one.resource.view);
    if (!targets) return;
    for (const ImageView& view : targets->loaded)
        if (!holds(view, number())) refuse(view);
}

void Frame::note_writes(const std::vector<Stated>& stated, const Rendering* targets) const {
    for (const Stated& one : stated)
        if (one.writable && one.resource.view) one.resource.view.image->written_in = number();
    if (!targets) return;
    for (const auto& [view, access] : targets->accesses)
        if (access.writes) view.image->written_in = number();
}

void Frame::apply_tones(const std::string& who, const Image& image) const {
    if (image.shown_in == number())
        throw Failure("{} applies a tone curve to {}, which has had one in this frame: keep one of the two", who,
                      image.desc.name);
    image.shown_in = number();
}

void Frame::need_light(const std::string& who, const Image& image) const {
    if (image.shown_in == number())
        throw Failure("{} needs linear light, but {} has had its tone curve: record it before the tones", who,
                      image.desc.name);
}

void Frame::raster(const std::string& name, const RasterTargets& targets, FunctionRef<void(Raster&)> record,
                   SourceLocation where) {
    const size_t outputs_before = outputs.size();
    Rendering& rendering = lists_.rendering;
    VkCommandBuffer commands{};
    check_at(where, [&] {
        rendering.set(name, targets, size, watch_.shows_discarded);
        all_inputs(lists_.given, name, targets.with, root);
        with_inputs(lists_.reads, targets.reads, lists_.given);
        state(lists_.stated, name, lists_.reads, targets.writes, &targets);
        check_reads(name, lists_.stated, &rendering);
        commands = begin_pass(name, "raster");
    });
    add_barriers(lists_.barriers, false, lists_.stated);
    rendering.add_barriers(lists_.barriers);
    lists_.barriers.record(commands);
    for (const Attachment& target : targets.color)
        add_output(name, target.resolve_into ? target.resolve_into : target.view);
    if (targets.depth.load != Attachment::Load::read_only)
        add_output(name + " depth", targets.depth.resolve_into ? targets.depth.resolve_into : targets.depth.view);
    Raster pass(*this, name, commands, lists_, where);
    rendering.begin(commands);
    if (watch_.listener) watch_.listener->begins(name, targets);
    record_and_end([&] { record(pass), pass.check_ended(); },
                   [&] {
                       vkCmdEndRendering(commands);
                       end_pass();
                   });
    note_writes({}, &rendering);
    run_after_pass(outputs_before);
}

void Frame::compute(const std::string& name, const ComputeAccess& access, FunctionRef<void(Compute&)> record,
                    SourceLocation where) {
    const size_t outputs_before = outputs.size();
    VkCommandBuffer commands{};
    check_at(where, [&] {
        all_inputs(lists_.given, name, access.with, root);
        with_inputs(lists_.reads, access.reads, lists_.given);
        state(lists_.stated, name, lists_.reads, access.writes);
        check_reads(name, lists_.stated, nullptr);
        commands = begin_pass(name, "compute");
    });
    add_barriers(lists_.barriers, true, lists_.stated);
    lists_.barriers.record(commands);
    for (const Resource& written : access.writes) add_output(name, written.view);
    Compute pass(*this, name, commands, lists_, where);
    if (watch_.listener) watch_.listener->begins(name, access);
    record_and_end([&] { record(pass), pass.check_ended(); }, [&] { end_pass(); });
    run_after_pass(outputs_before);
}

void Frame::transfer(const std::string& name, const ComputeAccess& access, FunctionRef<void(VkCommandBuffer)> record,
                     SourceLocation where) {
    std::vector<Stated> stated;
    VkCommandBuffer commands{};
    check_at(where, [&] {
        state(stated, name, access.reads, access.writes);
        commands = begin_pass(name, "transfer");
    });
    note_writes(stated, nullptr);
    if (watch_.listener) watch_.listener->does_more("the transfer pass '" + name + "'");
    Barriers barriers;
    const auto add = [&](const Resource& r, const Access& next) {
        r.buffer ? barriers.add(*r.buffer, next) : barriers.add(r.view, next);
    };
    for (const Resource& r : access.reads) add(r, transfer_read);
    for (const Resource& w : access.writes) add(w, transfer_write);
    barriers.record(commands);
    record_and_end([&] { record(commands); },
                   [&] {
                       // Constant resources are bound without barriers, so they must keep the layout for reading.
                       for (const auto* list : {&access.reads, &access.writes})
                           for (const Resource& r : *list)
                               if (r.buffer ? r.buffer->constant : r.view.image->constant) add(r, any_read);
                       barriers.record(commands);
                       end_pass();
                   });
}

}  // namespace lightwalk
