#include "common/gpu/pass.h"

#include <cstring>

#include "common/base/error.h"
#include "common/gpu/frame.h"

namespace lightwalk {

std::vector<Resource> Given::reads() const { return {}; }

Pass::Pass(Frame& owner, std::string pass_name, VkCommandBuffer command_buffer, const std::vector<Resource>& reads,
           const std::vector<Resource>& writes, const std::vector<const Given*>& given)
    : commands(command_buffer), frame(owner), name(std::move(pass_name)), given_(given) {
    for (const Given* one : given_) macros_.push_back(one->macros());
    const auto key = [](const Resource& r) { return r.image ? static_cast<const void*>(r.image) : r.buffer; };
    for (const Resource& r : reads) readable_.insert(key(r));
    for (const Resource& w : writes) writable_.insert(key(w));
}

bool Pass::wants(const std::string& binding) const {
    if (!pipeline_) return false;
    for (const Binding& b : pipeline_->bindings)
        if (b.name == binding) return true;
    return false;
}

const Binding& Pass::find(const std::string& binding) const {
    std::string known;
    for (const Binding& b : pipeline_->bindings) {
        if (b.name == binding) return b;
        known += (known.empty() ? "" : ", ") + b.name;
    }
    throw Failure("pass '" + name + "': its shaders have no binding '" + binding + "'; they have: " + known);
}

void Pass::check_stated(const std::string& binding, const void* resource, bool constant, bool writes) const {
    if (writes ? writable_.count(resource) : constant || readable_.count(resource) || writable_.count(resource)) return;
    throw Failure("pass '" + name + "' binds '" + binding + "' without stating it in its " +
                  (writes ? "writes" : "reads"));
}

void Pass::bind(const Pipeline& pipeline, const Macros& variant, const TargetFormats& formats,
                VkPipelineBindPoint point) {
    std::vector<const Macros*> scopes;
    for (const Macros& macros : macros_) scopes.push_back(&macros);
    scopes.push_back(&variant);
    const BuiltPipeline* const built = frame.gpu.pipelines.get(pipeline, formats, scopes);
    if (built == pipeline_ && built) return;
    pipeline_ = built;
    point_ = point;
    bound_.clear();
    if (!pipeline_) return;
    vkCmdBindPipeline(commands, point, pipeline_->handle);
    for (const Binding& binding : pipeline_->bindings) {
        if (binding.type != VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER) continue;
        if (const auto it = frame.globals.find(binding.name); it != frame.globals.end()) {
            set_bytes(binding.name, it->second);
            continue;
        }
        for (const Given* given : given_)
            if (const auto bytes = given->block(binding); !bytes.empty()) set_bytes(binding.name, bytes);
    }
    for (const Given* given : given_) given->bind(*this);
}

void Pass::set_image(const std::string& name_in_shader, const Image& image, Sampling sampling, int mip) {
    if (!pipeline_) return;
    const Binding& binding = find(name_in_shader);
    const bool storage = binding.type == VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
    if (!storage && binding.type != VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER)
        throw Failure("pass '" + name + "': '" + name_in_shader + "' is a buffer in the shader, not an image");
    check_stated(name_in_shader, &image, image.constant, storage);
    Bound& bound = bound_[binding.number];
    bound.image = {.sampler = storage ? VK_NULL_HANDLE : frame.gpu.samplers[sampling],
                   .imageView = mip >= 0                         ? image.mip_view(static_cast<uint32_t>(mip))
                                : storage && image.desc.mips > 1 ? image.mip_view(0)
                                                                 : image.view,
                   .imageLayout = storage || writable_.count(&image) ? VK_IMAGE_LAYOUT_GENERAL
                                                                     : VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
    bound.dirty = true;
}

void Pass::set_buffer(const std::string& name_in_shader, const Buffer& buffer) {
    if (!pipeline_) return;
    const Binding& binding = find(name_in_shader);
    if (binding.type != VK_DESCRIPTOR_TYPE_STORAGE_BUFFER)
        throw Failure("pass '" + name + "': '" + name_in_shader + "' is not a storage buffer in the shader");
    check_stated(name_in_shader, &buffer, buffer.constant, binding.writable);
    bound_[binding.number] = {.buffer = {.buffer = buffer.handle, .range = VK_WHOLE_SIZE}, .dirty = true};
}

void Pass::set_bytes(const std::string& name_in_shader, std::span<const std::byte> bytes) {
    if (!pipeline_) return;
    const Binding& binding = find(name_in_shader);
    if (binding.type != VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER)
        throw Failure("pass '" + name + "': '" + name_in_shader + "' is not a uniform block in the shader");
    if (bytes.size() < binding.bytes)
        throw Failure("pass '" + name + "': '" + name_in_shader + "' is " + std::to_string(bytes.size()) +
                      " bytes in C++ and " + std::to_string(binding.bytes) + " in the shader");
    bound_[binding.number] = {.buffer = frame.copy_to_arena(bytes), .dirty = true};
}

bool Pass::flush() {
    if (!pipeline_) return false;
    std::vector<VkWriteDescriptorSet> writes;
    for (const Binding& binding : pipeline_->bindings) {
        const auto it = bound_.find(binding.number);
        if (it == bound_.end())
            throw Failure("pass '" + name + "' draws or dispatches without '" + binding.name + "' being set");
        if (!it->second.dirty) continue;
        it->second.dirty = false;
        writes.push_back({.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                          .dstBinding = binding.number,
                          .descriptorCount = 1,
                          .descriptorType = binding.type,
                          .pImageInfo = &it->second.image,
                          .pBufferInfo = &it->second.buffer});
    }
    if (!writes.empty())
        frame.gpu.device.push_descriptors(commands, point_, pipeline_->layout, 0, static_cast<uint32_t>(writes.size()),
                                          writes.data());
    return true;
}

Raster& Raster::use(const Pipeline& pipeline, const Macros& variant) {
    bind(pipeline, variant, formats, VK_PIPELINE_BIND_POINT_GRAPHICS);
    return mirrored(false);
}

Raster& Raster::mirrored(bool is_mirrored) {
    vkCmdSetFrontFace(commands, is_mirrored ? VK_FRONT_FACE_CLOCKWISE : VK_FRONT_FACE_COUNTER_CLOCKWISE);
    return *this;
}

Raster& Raster::draw(uint32_t vertices, uint32_t instances, uint32_t first_instance) {
    if (flush()) vkCmdDraw(commands, vertices, instances, 0, first_instance);
    return *this;
}

Raster& Raster::draw_indexed(const Buffer& indices, uint32_t first_index, uint32_t count, uint32_t instances,
                             uint32_t first_instance) {
    if (!flush()) return *this;
    vkCmdBindIndexBuffer(commands, indices.handle, 0, VK_INDEX_TYPE_UINT32);
    vkCmdDrawIndexed(commands, count, instances, first_index, 0, first_instance);
    return *this;
}

Raster& Raster::draw(const Drawable& drawable) {
    if (pipeline_) drawable.draw(*this);
    return *this;
}

Compute& Compute::use(const Pipeline& pipeline, const Macros& variant) {
    bind(pipeline, variant, {}, VK_PIPELINE_BIND_POINT_COMPUTE);
    return *this;
}

Compute& Compute::dispatch_threads(glm::uvec3 threads) {
    return pipeline_ ? dispatch((threads + pipeline_->local_size - 1u) / pipeline_->local_size) : *this;
}

Compute& Compute::dispatch(glm::uvec3 groups) {
    if (flush() && groups.x && groups.y && groups.z) vkCmdDispatch(commands, groups.x, groups.y, groups.z);
    return *this;
}

}  // namespace lightwalk
