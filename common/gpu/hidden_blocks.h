// Uniform blocks as elements of arrays, whose index no compiler knows: for a driver that follows uniforms too far.
//
// Mesa's lavapipe looks for conditions that uniforms alone decide and compiles the shader anew for their values: Mesa 22.3 for
// each draw or dispatch whose block was written, and it keeps every one. Where it comes upon a second block on its way through
// a condition it writes behind the end of a table and crashes, later and elsewhere (lvp_inline_uniforms.c). It follows only
// what stands at a place that is known when the pipeline is made.
#pragma once
#include <vulkan/vulkan.h>

#include <cstdint>
#include <vector>

namespace lightwalk {

/// The push constant that holds the index.
constexpr VkPushConstantRange hidden_index{VK_SHADER_STAGE_ALL, 0, 4};

/// Makes every uniform block of a SPIR-V module an array of one, and indexes it by a push constant of 4 bytes, which must be 0.
/// Offsets, sizes and binding numbers stay. Throws Failure where a block is read otherwise than member by member.
void hide_blocks(std::vector<uint32_t>& spirv);

}  // namespace lightwalk
