// Access history of a resource, from which barriers are derived.
#pragma once
#include <vulkan/vulkan.h>

#include <vector>

namespace lightwalk {

/// Stages, access mask and layout of one use of a resource.
struct Access {
    VkPipelineStageFlags2 stages = VK_PIPELINE_STAGE_2_NONE;
    VkAccessFlags2 access = VK_ACCESS_2_NONE;
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
    bool writes = false;
    bool operator==(const Access&) const = default;
};

struct AccessHistory {
    Access last_write;
    VkPipelineStageFlags2 readers = VK_PIPELINE_STAGE_2_NONE;
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
    bool operator==(const AccessHistory&) const = default;
};

/// History of an image: one entry while all subresources share it.
struct ImageHistory {
    AccessHistory all;
    std::vector<AccessHistory> each;  ///< mip-major, then layer; empty: `all` applies
};

constexpr Access transfer_read{VK_PIPELINE_STAGE_2_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_READ_BIT,
                               VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, false};
constexpr Access transfer_write{VK_PIPELINE_STAGE_2_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                                VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, true};
/// Shader reads of uploaded data, in any stage.
constexpr Access any_read{VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_READ_BIT,
                          VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, false};
constexpr Access host_read{VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT, VK_IMAGE_LAYOUT_UNDEFINED, false};

}  // namespace lightwalk
