// Draw and dispatch commands of passes.
#include "common/base/error.h"
#include "common/gpu/frame.h"

namespace lightwalk {

Raster& Raster::use(const Pipeline& pipeline, const Macros& variant, SourceLocation where) {
    bind(pipeline, variant, formats(), VK_PIPELINE_BIND_POINT_GRAPHICS, where);
    two_sided_ = false;
    vkCmdSetCullMode(commands, cull_ = pipeline.graphics.cull);
    return mirrored(false);
}

Raster& Raster::two_sided(bool both) {
    if (both != two_sided_) vkCmdSetCullMode(commands, both ? VkCullModeFlags{VK_CULL_MODE_NONE} : cull_);
    two_sided_ = both;
    return *this;
}

Raster& Raster::mirrored(bool mirrors) {
    if (mirrors && listener()) listener()->does_more("mirrored(true)");
    if (mirrors != mirrored_)
        vkCmdSetFrontFace(commands, mirrors ? VK_FRONT_FACE_CLOCKWISE : VK_FRONT_FACE_COUNTER_CLOCKWISE);
    mirrored_ = mirrors;
    return *this;
}

Raster& Raster::draw(uint32_t vertices, uint32_t instances, uint32_t first_instance) {
    if (listener()) listener()->draws(vertices, instances, first_instance);
    if (vertices == 0) fail(where_, " draws 0 vertices");
    if (flush()) vkCmdDraw(commands, vertices, instances, 0, first_instance);
    return *this;
}

void Raster::bind_indices(const Buffer& indices) {
    if (listener()) listener()->does_more("the indices '" + indices.name + "'");
    if (indices.handle == indices_) return;
    check_indirect(indices);
    vkCmdBindIndexBuffer(commands, indices.handle, 0, VK_INDEX_TYPE_UINT32);
    indices_ = indices.handle;
}

Raster& Raster::draw_indexed(const Buffer& indices, uint32_t first_index, uint32_t count, uint32_t instances,
                             uint32_t first_instance) {
    if (!flush()) return *this;
    bind_indices(indices);
    vkCmdDrawIndexed(commands, count, instances, first_index, 0, first_instance);
    return *this;
}

void Raster::check_draws(const Buffer& draws, uint32_t count, VkDeviceSize offset, uint32_t stride) const {
    if (listener()) listener()->does_more("the indirect draw '" + draws.name + "'");
    check_indirect(draws);
    if (count == 0) fail(where_, " draws 0 times from '{}'", draws.name);
    if (offset % 4 || offset + VkDeviceSize(count) * stride > draws.bytes)
        fail(where_, ": {} indirect draws from byte {} on are not in '{}'", count, offset, draws.name);
}

Raster& Raster::draw_indirect(const Buffer& draws, uint32_t count, VkDeviceSize offset) {
    if (!flush()) return *this;
    constexpr uint32_t stride = sizeof(VkDrawIndirectCommand);
    check_draws(draws, count, offset, stride);
    vkCmdDrawIndirect(commands, draws.handle, offset, count, stride);
    return *this;
}

Raster& Raster::draw_indexed_indirect(const Buffer& indices, const Buffer& draws, uint32_t count, VkDeviceSize offset) {
    if (!flush()) return *this;
    bind_indices(indices);
    constexpr uint32_t stride = sizeof(VkDrawIndexedIndirectCommand);
    check_draws(draws, count, offset, stride);
    vkCmdDrawIndexedIndirect(commands, draws.handle, offset, count, stride);
    return *this;
}

Raster& Raster::draw(const Drawable& drawable) {
    check_used();
    if (pipeline_) drawable.draw(*this);
    values_are_read();
    return *this;
}

Compute& Compute::use(const Pipeline& pipeline, const Macros& variant, SourceLocation where) {
    bind(pipeline, variant, {}, VK_PIPELINE_BIND_POINT_COMPUTE, where);
    return *this;
}

Compute& Compute::dispatch_threads(glm::uvec3 threads) {
    check_used();
    return pipeline_ ? dispatch((threads + pipeline_->local_size - 1u) / pipeline_->local_size) : *this;
}

Compute& Compute::dispatch(glm::uvec3 groups) {
    if (listener()) listener()->dispatches(groups);
    if (!groups.x || !groups.y || !groups.z)
        fail(where_, " dispatches {}×{}×{} workgroups", groups.x, groups.y, groups.z);
    if (!flush()) return *this;
    check_workgroups(groups);
    vkCmdDispatch(commands, groups.x, groups.y, groups.z);
    return *this;
}

Compute& Compute::dispatch_indirect(const Buffer& groups, VkDeviceSize offset) {
    if (!flush()) return *this;
    if (listener()) listener()->does_more("the indirect dispatch '" + groups.name + "'");
    check_indirect(groups);
    if (offset % 4 || offset + sizeof(VkDispatchIndirectCommand) > groups.bytes)
        fail(where_, ": no dispatch at byte {} of '{}'", offset, groups.name);
    vkCmdDispatchIndirect(commands, groups.handle, offset);
    return *this;
}

Compute& Compute::wait() {
    if (listener()) listener()->waits();
    barrier(commands, {.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2,
                       .srcStageMask = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                       .srcAccessMask = VK_ACCESS_2_SHADER_WRITE_BIT,
                       .dstStageMask = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                       .dstAccessMask = VK_ACCESS_2_SHADER_READ_BIT | VK_ACCESS_2_SHADER_WRITE_BIT});
    return *this;
}

}  // namespace lightwalk
