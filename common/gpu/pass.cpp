#include "common/gpu/pass.h"

#include <algorithm>
#include <cstring>

#include "common/base/error.h"
#include "common/gpu/frame.h"
#include "common/gpu/hidden_blocks.h"

namespace lightwalk {
namespace {

bool equal(const VkDescriptorBufferInfo& a, const VkDescriptorBufferInfo& b) {
    return a.buffer == b.buffer && a.offset == b.offset && a.range == b.range;
}

bool equal(const VkDescriptorImageInfo& a, const VkDescriptorImageInfo& b) {
    return a.sampler == b.sampler && a.imageView == b.imageView && a.imageLayout == b.imageLayout;
}

const char* shape(VkImageViewType type) {
    constexpr const char* names[] = {"1-D", "2-D", "3-D", "cube", "1-D array", "2-D array", "cube array"};
    return names[type];
}

const char* shape(const ImageView& view) {
    return view.is_volume() && view.type != VK_IMAGE_VIEW_TYPE_3D ? "a slice, which can be drawn into alone"
                                                                  : shape(view.type);
}

// Changes a view's type to the one the shader declares. False if its layers do not fit.
bool turn_into(ImageView& view, VkImageViewType wanted) {
    if (view.is_volume()) return wanted == VK_IMAGE_VIEW_TYPE_3D && view.type == wanted;
    const bool is_cube = view.image->desc.cube;
    const bool possible = wanted == VK_IMAGE_VIEW_TYPE_2D           ? view.layers == 1
                          : wanted == VK_IMAGE_VIEW_TYPE_CUBE       ? is_cube && view.layers == 6
                          : wanted == VK_IMAGE_VIEW_TYPE_CUBE_ARRAY ? is_cube && view.layers % 6 == 0
                                                                    : wanted == VK_IMAGE_VIEW_TYPE_2D_ARRAY;
    if (possible) view.type = wanted;
    return possible;
}

}  // namespace

Pass::Pass(Frame& owner, const std::string& pass_name, VkCommandBuffer frame_commands, PassLists& lists)
    : commands(frame_commands), frame(owner), name(pass_name), lists_(lists) {
    lists_.macros.clear();
    lists_.scopes.clear();
    for (const PassInputs* one : lists_.given) lists_.macros.push_back(one->macros());
    for (const Macros& macros : lists_.macros) lists_.scopes.push_back(&macros);
    lists_.scopes.push_back(nullptr);
}

Pass::Slot Pass::slot(const BindingName& binding) const {
    Slot result;
    const Binding* const found = pipeline_ ? pipeline_->find(binding) : nullptr;
    if (!found || !found->used) return result;
    result.pipeline_ = pipeline_;
    result.number_ = found->number;
    return result;
}

// Null if nothing is to be set: no pipeline, empty slot, or unused binding.
const Binding* Pass::find(const Name& binding) const {
    if (!pipeline_ || (binding.by_slot && !binding.slot)) return nullptr;
    if (binding.by_slot) {
        if (binding.slot.pipeline_ == pipeline_) return &pipeline_->bindings[binding.slot.number_];
        throw Failure("pass '{}' sets a slot of a pipeline that is not in use any more", name);
    }
    if (const Binding* found = pipeline_->find(binding.name)) return found->used ? found : nullptr;
    std::string known;
    for (const Binding& b : pipeline_->bindings) known += (known.empty() ? "" : ", ") + b.name;
    throw Failure("pass '{}': its shaders have no binding '{}'; they have: {}", name, binding.name.text, known);
}

void Pass::fail_unstated(std::string_view use, bool writes) const {
    throw Failure("pass '{}' binds '{}' without stating it in its {}", name, use, writes ? "writes" : "reads");
}

const Stated* Pass::stated(const ImageView& view, bool writes) const {
    for (const Stated& s : lists_.stated)
        if (s.resource.view && (s.writable || !writes) && s.resource.view.contains(view)) return &s;
    return nullptr;
}

void Pass::check_stated(std::string_view use, const Buffer& buffer, bool writes) const {
    if (buffer.constant && !writes) return;
    for (const Stated& s : lists_.stated)
        if (s.resource.buffer == &buffer && (s.writable || !writes)) return;
    fail_unstated(use, writes);
}

// Indirect commands of compute passes wait here: a wait for every buffer read costs 2.5 µs per pass on an H100.
void Pass::check_indirect(const Buffer& buffer) const {
    if (buffer.constant) return;
    for (const Stated& s : lists_.stated) {
        if (s.resource.buffer != &buffer || !s.read) continue;
        constexpr Access commands_read{VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT, VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT};
        if (s.writable) {  // an earlier dispatch of this pass writes it
            barrier(commands, {.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2,
                               .srcStageMask = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                               .srcAccessMask = VK_ACCESS_2_SHADER_WRITE_BIT,
                               .dstStageMask = commands_read.stages,
                               .dstAccessMask = commands_read.access});
            buffer.history.readers |= commands_read.stages;
        } else if (point_ == VK_PIPELINE_BIND_POINT_COMPUTE) {
            barrier(commands, buffer, commands_read);
        }
        return;
    }
    fail_unstated(buffer.name, false);
}

void Pass::bind(const Pipeline& wanted, const Macros& variant, const TargetFormats& formats,
                VkPipelineBindPoint point) {
    const std::pair used(wanted.id, variant.hash());
    if (pipeline_ && lists_.used == used) return;
    lists_.used = used;
    lists_.scopes.back() = &variant;
    const BuiltPipeline* const pipeline = frame.gpu.pipelines.get(wanted, formats, lists_.scopes);
    if (pipeline && pipeline == pipeline_) return;
    pipeline_ = pipeline;
    point_ = point;
    if (!pipeline) return;
    vkCmdBindPipeline(commands, point, pipeline->handle);
    if (frame.gpu.device.software_paths) {
        const uint32_t index = 0;
        vkCmdPushConstants(commands, pipeline->layout, hidden_index.stageFlags, 0, sizeof index, &index);
    }
    lists_.bound.assign(pipeline->bindings.size(), {});
    size_t bytes_in_all = 0;
    for (const Binding& binding : pipeline->bindings) {
        lists_.bound[binding.number].at = static_cast<uint32_t>(bytes_in_all);
        if (binding.used) bytes_in_all += binding.bytes;
    }
    lists_.bytes.resize(bytes_in_all);
    missing_ = static_cast<size_t>(std::ranges::count(pipeline->bindings, true, &Binding::used));
    dirty_ = true;
    lists_.image_infos.assign(pipeline->descriptors, {});
    lists_.buffer_infos.assign(pipeline->descriptors, {});
    if (listener()) listener()->uses(wanted, variant);
    modules_bind_ = true;
    for (const Binding& binding : pipeline->bindings) {
        if (!binding.used || binding.type != VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER) continue;
        if (const auto* bytes = frame.globals.find(binding)) {
            set_block(binding, *bytes);
            continue;
        }
        for (const PassInputs* given : lists_.given)
            if (const auto bytes = given->block(binding); !bytes.empty()) set_block(binding, bytes);
    }
    for (const PassInputs* given : lists_.given) given->bind(*this);
    modules_bind_ = false;
}

PassListener* Pass::listener() const { return modules_bind_ ? nullptr : frame.watch_.listener; }

template <class Info>
void Pass::store(const Binding& binding, uint32_t element, std::vector<Info>& infos, const Info& info) {
    Info& known = infos[binding.first + element];
    if (equal(known, info)) return;
    known = info;
    dirty_ = true;
}

VkDescriptorImageInfo Pass::image_info(const Binding& binding, ImageView view, const Sampler& sampler) const {
    const bool storage = binding.type == VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
    if (storage && view.mips > 1) view = view.mip(0);
    if (!turn_into(view, binding.view_type))
        throw Failure("pass '{}': '{}' is {} in the shader, and {} is {}", name, binding.name, shape(binding.view_type),
                      view.name(), shape(view));
    const VkFormat format = view.format == VK_FORMAT_UNDEFINED ? view.image->desc.format : view.format;
    if (binding.format != VK_FORMAT_UNDEFINED && binding.format != format)
        throw Failure("pass '{}': '{}' is {} in the shader, and {} is {}", name, binding.name, name_of(binding.format),
                      view.name(), name_of(format));
    const Stated* found = stated(view, storage);
    if (!found && (!view.image->constant || storage)) fail_unstated(binding.name, storage);
    if (found && !found->read && (!storage || binding.readable)) fail_unstated(binding.name, false);
    return {.sampler = storage ? VK_NULL_HANDLE : frame.gpu.samplers[sampler],
            .imageView = view.handle(),
            .imageLayout = found ? found->layout : VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
}

void Pass::set_images(const Name& name_in_shader, std::span<const ImageView> views, const Sampler& sampler) {
    const Binding* found = find(name_in_shader);
    if (!found) return;
    const Binding& binding = *found;
    if (listener()) listener()->sets(binding.name, views, sampler);
    if (binding.type != VK_DESCRIPTOR_TYPE_STORAGE_IMAGE && binding.type != VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER)
        throw Failure("pass '{}': '{}' is a buffer in the shader, not an image", name, binding.name);
    if (views.empty() || views.size() > binding.count)
        throw Failure("pass '{}': '{}' has {} elements in the shader and gets {}", name, binding.name, binding.count,
                      views.size());
    VkDescriptorImageInfo info{};
    for (uint32_t i = 0; i < binding.count; ++i) {
        if (i < views.size()) info = image_info(binding, views[i], sampler);
        store(binding, i, lists_.image_infos, info);
    }
    missing_ -= !std::exchange(lists_.bound[binding.number].set, true);
}

void Pass::set_buffer(const Name& name_in_shader, const Buffer& buffer) {
    const Binding* binding = find(name_in_shader);
    if (!binding) return;
    if (listener()) listener()->does_more("the buffer '" + binding->name + "'");
    if (binding->type != VK_DESCRIPTOR_TYPE_STORAGE_BUFFER)
        throw Failure("pass '{}': '{}' is not a storage buffer in the shader", name, binding->name);
    if (binding->count > 1)
        throw Failure("pass '{}': '{}' is an array of buffers, which passes do not bind", name, binding->name);
    check_stated(binding->name, buffer, binding->writable);
    store(*binding, 0, lists_.buffer_infos, {.buffer = buffer.handle, .offset = 0, .range = buffer.bytes});
    missing_ -= !std::exchange(lists_.bound[binding->number].set, true);
}

void Pass::set_bytes(const Name& name_in_shader, std::span<const std::byte> bytes) {
    if (const Binding* binding = find(name_in_shader)) set_block(*binding, bytes);
}

void Pass::set_block(const Binding& binding, std::span<const std::byte> bytes) {
    if (listener()) listener()->sets(binding.name, bytes);
    if (binding.type != VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER)
        throw Failure("pass '{}': '{}' is not a uniform block in the shader", name, binding.name);
    if (bytes.size() != binding.bytes)
        throw Failure("pass '{}': '{}' is {} bytes in C++ and {} in the shader", name, binding.name, bytes.size(),
                      binding.bytes);
    PassLists::Bound& bound = lists_.bound[binding.number];
    // Host copy for comparison: reading mapped device memory can be slow.
    std::byte* const known = lists_.bytes.data() + bound.at;
    if (!bound.set || std::memcmp(known, bytes.data(), bytes.size()) != 0) {
        std::memcpy(known, bytes.data(), bytes.size());
        store(binding, 0, lists_.buffer_infos, frame.copy_to_arena(bytes));
    }
    missing_ -= !std::exchange(bound.set, true);
}

bool Pass::flush() {
    if (!pipeline_) return false;
    if (missing_ > 0)
        for (const Binding& binding : pipeline_->bindings)
            if (binding.used && !lists_.bound[binding.number].set)
                throw Failure("pass '{}' draws or dispatches without '{}' being set", name, binding.name);
    if (!dirty_) return true;
    dirty_ = false;
    lists_.writes.clear();
    for (const Binding& binding : pipeline_->bindings)
        if (binding.used)
            lists_.writes.push_back({.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                     .dstBinding = binding.number,
                                     .descriptorCount = binding.count,
                                     .descriptorType = binding.type,
                                     .pImageInfo = &lists_.image_infos[binding.first],
                                     .pBufferInfo = &lists_.buffer_infos[binding.first]});
    const VkDescriptorSet set = frame.descriptor_set(*pipeline_, lists_.writes);
    vkCmdBindDescriptorSets(commands, point_, pipeline_->layout, 0, 1, &set, 0, nullptr);
    return true;
}

}  // namespace lightwalk
