// Uniform blocks as elements of arrays with an index unknown to the compiler, for a driver that analyses uniforms too
// eagerly.
//
// Mesa's lavapipe searches for conditions that depend on uniforms alone and recompiles the shader for their values:
// Mesa 22.3 does so for each draw or dispatch after a write to the block, and keeps every result. If a condition
// involves a second block it writes past the end of a table and crashes, later and elsewhere (lvp_inline_uniforms.c).
// It follows only offsets known at pipeline creation.
#pragma once
#include <vulkan/vulkan.h>

#include <cstdint>
#include <vector>

namespace lightwalk {

/// The push constant that holds the index.
constexpr VkPushConstantRange hidden_index{VK_SHADER_STAGE_ALL, 0, 4};

/// Makes every uniform block of a SPIR-V module an array of one, and indexes it by a push constant of 4 bytes, which must be 0.
/// Offsets, sizes and binding numbers stay. Throws Failure if a block is read otherwise than member by member.
void hide_blocks(std::vector<uint32_t>& spirv);

}  // namespace lightwalk
