// How a list of commands names them.
#pragma once
#include <vulkan/vulkan.h>

namespace lightwalk {

enum class CommandCode {
    pipeline_barrier,
    memory_barrier,
    wait_for_all,
    set_event,
    write_timestamp,
    begin_label,
    end_label,
    bind_pipeline,
    push_constant,
    push_descriptors,
    bind_descriptor_set,
    begin_rendering,
    end_rendering,
    set_viewport,
    set_front_face,
    set_cull_mode,
    bind_index_buffer,
    draw,
    draw_indexed,
    draw_indirect,
    draw_indexed_indirect,
    dispatch,
    dispatch_indirect,
    copy_buffer,
    copy_buffer_to_image,
    copy_image_to_buffer,
    copy_image,
    clear_color_image,
    update_buffer
};

inline bool of_buffer(VkDescriptorType type) {
    return type == VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER || type == VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
}

}  // namespace lightwalk
