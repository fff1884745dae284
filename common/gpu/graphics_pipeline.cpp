#include <bit>

#include "common/base/error.h"
#include "common/gpu/pipeline.h"

namespace lightwalk {
namespace {

VkPipelineColorBlendAttachmentState blend_state(Blend blend, VkColorComponentFlags write) {
    VkPipelineColorBlendAttachmentState state{.blendEnable = blend != Blend::opaque, .colorWriteMask = write};
    const auto set = [&](VkBlendFactor source, VkBlendFactor target, VkBlendOp op = VK_BLEND_OP_ADD) {
        state.srcColorBlendFactor = state.srcAlphaBlendFactor = source;
        state.dstColorBlendFactor = state.dstAlphaBlendFactor = target;
        state.colorBlendOp = state.alphaBlendOp = op;
    };
    switch (blend) {
        case Blend::opaque:
            break;
        case Blend::alpha:
            set(VK_BLEND_FACTOR_ONE, VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA);
            state.srcColorBlendFactor = VK_BLEND_FACTOR_SRC_ALPHA;
            break;
        case Blend::premultiplied:
            set(VK_BLEND_FACTOR_ONE, VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA);
            break;
        case Blend::filtered:
            set(VK_BLEND_FACTOR_ONE, VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA);
            state.srcColorBlendFactor = VK_BLEND_FACTOR_SRC_ALPHA;
            state.dstColorBlendFactor = VK_BLEND_FACTOR_SRC1_COLOR;
            break;
        case Blend::add:
            set(VK_BLEND_FACTOR_ONE, VK_BLEND_FACTOR_ONE);
            break;
        case Blend::multiply:
            set(VK_BLEND_FACTOR_DST_COLOR, VK_BLEND_FACTOR_ZERO);
            break;
        case Blend::minimum:
            set(VK_BLEND_FACTOR_ONE, VK_BLEND_FACTOR_ONE, VK_BLEND_OP_MIN);
            break;
        case Blend::maximum:
            set(VK_BLEND_FACTOR_ONE, VK_BLEND_FACTOR_ONE, VK_BLEND_OP_MAX);
            break;
    }
    return state;
}

}  // namespace

std::string state_key(const Pipeline::Graphics& g, const TargetFormats& formats) {
    std::string key;
    const auto add = [&](auto value) { key += fmt::format("{},", value); };
    for (const int value : {int(g.cull), int(g.depth_test), int(g.depth_write), int(g.depth_compare),
                            int(g.depth_clamp), int(g.alpha_to_coverage), int(g.topology)})
        add(value);
    for (const float value : {g.depth_bias.constant, g.depth_bias.slope, g.depth_bias.clamp})
        add(std::bit_cast<uint32_t>(value));
    for (const Blend blend : g.blend.values()) add(int(blend));
    for (const VkColorComponentFlags write : g.color_write.values()) add(write + 100);
    for (const VkFormat format : formats.color) key += fmt::format(" {}", int(format));
    if (formats.blend_override) {
        key += fmt::format(" mixed {}", int(formats.blend_override->depth_write));
        for (const Blend blend : formats.blend_override->blend) key += fmt::format(",{}", int(blend));
    }
    return fmt::format("{} depth {} {}{}", key, int(formats.depth), formats.depth_read_only ? "read only " : "",
                       formats.samples);
}

VkPipeline create_graphics(Device& device, const Pipeline::Graphics& desc, const TargetFormats& formats,
                           const std::vector<VkPipelineShaderStageCreateInfo>& stages, VkPipelineLayout layout) {
    // Vertex pulling from a storage buffer: no vertex input.
    const VkPipelineVertexInputStateCreateInfo vertex_input{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
    const VkPipelineInputAssemblyStateCreateInfo assembly{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO, .topology = desc.topology};
    const VkPipelineViewportStateCreateInfo viewport{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO, .viewportCount = 1, .scissorCount = 1};
    const VkPipelineRasterizationStateCreateInfo raster{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO,
        .depthClampEnable = desc.depth_clamp,
        .polygonMode = VK_POLYGON_MODE_FILL,
        .cullMode = desc.cull,
        .frontFace = VK_FRONT_FACE_COUNTER_CLOCKWISE,
        .depthBiasEnable = static_cast<bool>(desc.depth_bias),
        .depthBiasConstantFactor = desc.depth_bias.constant,
        .depthBiasClamp = desc.depth_bias.clamp,
        .depthBiasSlopeFactor = desc.depth_bias.slope,
        .lineWidth = 1.0f};
    const VkPipelineMultisampleStateCreateInfo samples{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO,
        .rasterizationSamples = static_cast<VkSampleCountFlagBits>(formats.samples),
        .alphaToCoverageEnable = desc.alpha_to_coverage};
    const bool has_depth = formats.depth != VK_FORMAT_UNDEFINED;
    const VkPipelineDepthStencilStateCreateInfo depth{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO,
        .depthTestEnable = has_depth && desc.depth_test,
        .depthWriteEnable = has_depth && !formats.depth_read_only &&
                            (formats.blend_override ? formats.blend_override->depth_write : desc.depth_write),
        .depthCompareOp = compare_op(desc.depth_compare)};
    std::vector<VkPipelineColorBlendAttachmentState> blends;
    const PerTarget<Blend> by_target =
        formats.blend_override ? PerTarget<Blend>(formats.blend_override->blend) : desc.blend;
    for (size_t i = 0; i < formats.color.size(); ++i) {
        const bool absent = formats.color[i] == VK_FORMAT_UNDEFINED;
        blends.push_back(absent ? VkPipelineColorBlendAttachmentState{}
                                : blend_state(by_target[i], desc.color_write[i]));
    }
    const VkPipelineColorBlendStateCreateInfo blend{.sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO,
                                                    .attachmentCount = static_cast<uint32_t>(blends.size()),
                                                    .pAttachments = blends.data()};
    const VkDynamicState dynamic_states[] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR,
                                             VK_DYNAMIC_STATE_FRONT_FACE, VK_DYNAMIC_STATE_CULL_MODE};
    const VkPipelineDynamicStateCreateInfo dynamic{.sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO,
                                                   .dynamicStateCount = 4,
                                                   .pDynamicStates = dynamic_states};
    const VkPipelineRenderingCreateInfo rendering{.sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO,
                                                  .colorAttachmentCount = static_cast<uint32_t>(formats.color.size()),
                                                  .pColorAttachmentFormats = formats.color.data(),
                                                  .depthAttachmentFormat = formats.depth};
    const VkGraphicsPipelineCreateInfo info{.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO,
                                            .pNext = &rendering,
                                            .stageCount = static_cast<uint32_t>(stages.size()),
                                            .pStages = stages.data(),
                                            .pVertexInputState = &vertex_input,
                                            .pInputAssemblyState = &assembly,
                                            .pViewportState = &viewport,
                                            .pRasterizationState = &raster,
                                            .pMultisampleState = &samples,
                                            .pDepthStencilState = &depth,
                                            .pColorBlendState = &blend,
                                            .pDynamicState = &dynamic,
                                            .layout = layout};
    VkPipeline pipeline = VK_NULL_HANDLE;
    check(vkCreateGraphicsPipelines(device.handle, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline),
          fmt::format("{} + {}", desc.vertex, desc.fragment).c_str());
    return pipeline;
}

}  // namespace lightwalk
