// A frame's commands as a list, from which its command buffer is made, or known to be the one made before.
#pragma once
#include <vulkan/vulkan.h>

#include <algorithm>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

namespace lightwalk {

class Device;

/// Numbers in a row, in memory that is kept: none is set twice.
class CommandWords {
  public:
    uint64_t* take(size_t count);  ///< the next ones, to be set
    std::span<const uint64_t> all() const { return std::span(words_).first(used_); }
    void clear() { used_ = 0; }

  private:
    std::vector<uint64_t> words_;
    size_t used_ = 0;
};

// [commands]
/// Commands with Vulkan's names and arguments, as numbers in the order of recording. Comparing two lists is faster than a
/// driver's recording, and most frames differ from the one before only in the contents of buffers.
/// Large (34 functions, 1 members): one function for each command.
class Commands {
  public:
    void pipeline_barrier(std::span<const VkImageMemoryBarrier2> images,
                          std::span<const VkBufferMemoryBarrier2> buffers);  ///< of whole buffers
    void pipeline_barrier(const VkMemoryBarrier2& memory);
    void wait_for_all();            ///< a barrier without resources
    void set_event(VkEvent event);  ///< after all commands
    void write_timestamp(VkQueryPool pool, uint32_t query);
    void begin_label(const Device& device, const std::string& name);
    void end_label(const Device& device);
    // [/commands]

    void bind_pipeline(VkPipelineBindPoint point, VkPipeline pipeline);
    void push_constant(VkPipelineLayout layout, VkShaderStageFlags stages, uint32_t value);
    void push_descriptors(VkPipelineBindPoint point, VkPipelineLayout layout,
                          std::span<const VkWriteDescriptorSet> writes);
    void bind_descriptor_set(VkPipelineBindPoint point, VkPipelineLayout layout, VkDescriptorSet set);

    void begin_rendering(const VkRenderingInfo& info);
    void end_rendering();
    void set_viewport(uint32_t width, uint32_t height);  ///< and the scissor
    void set_front_face(VkFrontFace face);
    void set_cull_mode(VkCullModeFlags mode);
    void bind_index_buffer(VkBuffer buffer);  ///< 32-bit indices
    void draw(uint32_t vertices, uint32_t instances, uint32_t first_instance);
    void draw_indexed(uint32_t count, uint32_t instances, uint32_t first_index, uint32_t first_instance);
    void draw_indirect(VkBuffer buffer, VkDeviceSize offset, uint32_t count, uint32_t stride);
    void draw_indexed_indirect(VkBuffer buffer, VkDeviceSize offset, uint32_t count, uint32_t stride);
    void dispatch(glm::uvec3 groups);
    void dispatch_indirect(VkBuffer buffer, VkDeviceSize offset);

    void copy_buffer(VkBuffer from, VkBuffer to, const VkBufferCopy& region);
    void copy_buffer_to_image(VkBuffer from, VkImage to, const VkBufferImageCopy& region);
    void copy_image_to_buffer(VkImage from, VkBuffer to, const VkBufferImageCopy& region);
    void copy_image(VkImage from, VkImage to, const VkImageCopy& region);
    void clear_color_image(VkImage image, const VkClearColorValue& color);
    void update_buffer(VkBuffer buffer, std::span<const uint32_t> contents);

    bool empty() const { return size() == 0; }
    size_t size() const { return words_.all().size(); }  ///< numbers
    void clear() { words_.clear(); }
    bool operator==(const Commands& other) const { return std::ranges::equal(words_.all(), other.words_.all()); }

    /// Records all of them.
    void record(const Device& device, VkCommandBuffer into) const;

  private:
    CommandWords words_;
};

}  // namespace lightwalk
