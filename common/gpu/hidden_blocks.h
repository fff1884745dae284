// Driver workaround: uniform blocks as array elements whose index the compiler cannot know.
//
// Mesa's lavapipe recompiles a shader for the values of conditions that depend only on uniforms; Mesa 22.3 does so
// after every write to the block and keeps each result. If a condition involves a second block, it writes past the end
// of a table and crashes later (lvp_inline_uniforms.c). Only offsets known at pipeline creation are affected.
#pragma once
#include <vulkan/vulkan.h>

#include <cstdint>
#include <vector>

namespace lightwalk {

constexpr VkPushConstantRange hidden_index{VK_SHADER_STAGE_ALL, 0, 4};

/// Turns uniform blocks into arrays of one, indexed by a push constant of 0. Throws Failure for whole-block accesses.
void hide_blocks(std::vector<uint32_t>& spirv);

}  // namespace lightwalk
