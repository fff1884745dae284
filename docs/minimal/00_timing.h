// Part of 00_vulkan.cpp: how long the GPU takes for passes that each clear the picture and draw the triangle.
// clang-format off
#pragma once

// [timing]
void time_passes(const std::string& shaders, VkBuffer vertices, int passes) {
    const VkQueryPoolCreateInfo two{.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO,
        .queryType = VK_QUERY_TYPE_TIMESTAMP, .queryCount = 2};
    VkQueryPool times;
    check(vkCreateQueryPool(device, &two, nullptr, &times), "vkCreateQueryPool");
    cleanup.push_back([=] { vkDestroyQueryPool(device, times, nullptr); });
    VkPhysicalDeviceProperties about;
    vkGetPhysicalDeviceProperties(physical, &about);
    const VkImage image = make_picture();
    const VkImageView view = make_view(image, picture_format);
    cleanup.push_back([=] { vkDestroyImageView(device, view, nullptr); });
    const Pipeline pipeline = make_pipeline(shaders, picture_format);
    const VkCommandBuffer commands = make_commands();

    std::vector<double> taken_us;
    for (int frame = 0; frame < 60; ++frame) {
        begin(commands);
        vkCmdResetQueryPool(commands, times, 0, 2);
        vkCmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_TOP_OF_PIPE_BIT, times, 0);
        for (int i = 0; i < passes; ++i) {
            barrier(commands, image, i == 0 ? new_image : drawn_into, drawn_into);
            draw(commands, pipeline, vertices, view, picture_size, 0);
        }
        vkCmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, times, 1);
        check(vkEndCommandBuffer(commands), "vkEndCommandBuffer");
        submit(commands);
        check(vkQueueWaitIdle(queue), "vkQueueWaitIdle");
        uint64_t counts[2];
        check(vkGetQueryPoolResults(device, times, 0, 2, sizeof counts, counts, sizeof counts[0],
                                    VK_QUERY_RESULT_64_BIT), "vkGetQueryPoolResults");
        const double us = 1e-3 * about.limits.timestampPeriod * static_cast<double>(counts[1] - counts[0]);
        if (frame >= 10) taken_us.push_back(us);  // the first frames warm up
    }
    std::sort(taken_us.begin(), taken_us.end());
    std::printf("%s, %d passes: median %.1f us, quartiles %.1f and %.1f us\n", about.deviceName, passes, taken_us[25],
                taken_us[12], taken_us[37]);
}
// [/timing]
