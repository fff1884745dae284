// The window of 00_vulkan.cpp: a swapchain, two frames in flight, and changes of the window's size.
// clang-format off
constexpr size_t frames_in_flight = 2;
constexpr Use presented{VK_PIPELINE_STAGE_2_NONE, 0, VK_IMAGE_LAYOUT_PRESENT_SRC_KHR};

void open_window() {
    if (!glfwInit()) throw std::runtime_error("no display");
    glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
    window = glfwCreateWindow(640, 480, "A triangle", nullptr, nullptr);
    if (!window) throw std::runtime_error("no window");
    cleanup.push_back(glfwTerminate);
}

void make_surface() {
    check(glfwCreateWindowSurface(instance, window, nullptr, &surface), "glfwCreateWindowSurface");
    cleanup.push_back([] { vkDestroySurfaceKHR(instance, surface, nullptr); });
}

VkSemaphore make_semaphore() {
    const VkSemaphoreCreateInfo info{.sType = VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO};
    VkSemaphore semaphore;
    check(vkCreateSemaphore(device, &info, nullptr, &semaphore), "vkCreateSemaphore");
    return semaphore;
}

VkFence make_fence(VkFenceCreateFlags flags) {
    const VkFenceCreateInfo info{.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO, .flags = flags};
    VkFence fence;
    check(vkCreateFence(device, &info, nullptr, &fence), "vkCreateFence");
    cleanup.push_back([=] { vkDestroyFence(device, fence, nullptr); });
    return fence;
}

// [swapchain]
struct Swapchain {
    VkSwapchainKHR handle = VK_NULL_HANDLE;
    VkExtent2D size{};
    std::vector<VkImage> images;
    std::vector<VkImageView> views;
    std::vector<VkSemaphore> drawn;  // one for each image: signalled when it may be shown

    void make(VkSurfaceFormatKHR format) {
        vkDeviceWaitIdle(device);
        VkSurfaceCapabilitiesKHR can;
        check(vkGetPhysicalDeviceSurfaceCapabilitiesKHR(physical, surface, &can), "the surface's capabilities");
        size = can.currentExtent.width == UINT32_MAX ? VkExtent2D{640, 480} : can.currentExtent;
        const uint32_t wanted = can.minImageCount + 1;
        const VkSwapchainCreateInfoKHR info{.sType = VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR, .surface = surface,
            .minImageCount = can.maxImageCount ? std::min(wanted, can.maxImageCount) : wanted,
            .imageFormat = format.format, .imageColorSpace = format.colorSpace, .imageExtent = size,
            .imageArrayLayers = 1, .imageUsage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT,
            .preTransform = can.currentTransform, .compositeAlpha = VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR,
            .presentMode = VK_PRESENT_MODE_FIFO_KHR, .clipped = VK_TRUE, .oldSwapchain = handle};
        VkSwapchainKHR made;
        check(vkCreateSwapchainKHR(device, &info, nullptr, &made), "vkCreateSwapchainKHR");
        destroy();
        handle = made;
        uint32_t count = 0;
        check(vkGetSwapchainImagesKHR(device, handle, &count, nullptr), "vkGetSwapchainImagesKHR");
        images.resize(count);
        check(vkGetSwapchainImagesKHR(device, handle, &count, images.data()), "vkGetSwapchainImagesKHR");
        for (const VkImage image : images) {
            views.push_back(make_view(image, format.format));
            drawn.push_back(make_semaphore());
        }
    }

    void destroy() {
        for (const VkImageView view : views) vkDestroyImageView(device, view, nullptr);
        for (const VkSemaphore semaphore : drawn) vkDestroySemaphore(device, semaphore, nullptr);
        views.clear();
        drawn.clear();
        vkDestroySwapchainKHR(device, handle, nullptr);
    }
};
// [/swapchain]

VkSurfaceFormatKHR surface_format() {  // one that encodes linear light as sRGB, where there is one
    uint32_t count = 0;
    check(vkGetPhysicalDeviceSurfaceFormatsKHR(physical, surface, &count, nullptr), "the surface's formats");
    std::vector<VkSurfaceFormatKHR> all(count);
    check(vkGetPhysicalDeviceSurfaceFormatsKHR(physical, surface, &count, all.data()), "the surface's formats");
    for (const VkSurfaceFormatKHR& one : all)
        if (one.format == VK_FORMAT_B8G8R8A8_SRGB || one.format == VK_FORMAT_R8G8B8A8_SRGB) return one;
    return all.at(0);
}

// [frames]
struct InFlight {
    VkCommandBuffer commands = make_commands();
    VkFence ended = make_fence(VK_FENCE_CREATE_SIGNALED_BIT);  // the first frame waits for nothing
    VkSemaphore acquired = make_semaphore();
};

void show_window(const std::string& shaders, VkBuffer vertices, int last_frame) {
    const VkSurfaceFormatKHR format = surface_format();
    const Pipeline pipeline = make_pipeline(shaders, format.format);
    InFlight frames[frames_in_flight];
    Swapchain swapchain;
    swapchain.make(format);
    cleanup.push_back([=] {
        for (const InFlight& frame : frames) vkDestroySemaphore(device, frame.acquired, nullptr);
    });
    for (int i = 0; !glfwWindowShouldClose(window) && (last_frame == 0 || i < last_frame); ++i) {
        glfwPollEvents();
        const InFlight& frame = frames[i % frames_in_flight];
        check(vkWaitForFences(device, 1, &frame.ended, VK_TRUE, UINT64_MAX), "vkWaitForFences");

        uint32_t index = 0;
        const VkResult got =
            vkAcquireNextImageKHR(device, swapchain.handle, UINT64_MAX, frame.acquired, VK_NULL_HANDLE, &index);
        if (got == VK_ERROR_OUT_OF_DATE_KHR) {  // the window has another size
            swapchain.make(format);
            continue;
        }
        if (got != VK_SUBOPTIMAL_KHR) check(got, "vkAcquireNextImageKHR");
        check(vkResetFences(device, 1, &frame.ended), "vkResetFences");  // only now: something will signal it

        begin(frame.commands);
        barrier(frame.commands, swapchain.images[index], new_image, drawn_into);
        const float angle_rad = static_cast<float>(glfwGetTime());
        draw(frame.commands, pipeline, vertices, swapchain.views[index], swapchain.size, angle_rad);
        barrier(frame.commands, swapchain.images[index], drawn_into, presented);
        check(vkEndCommandBuffer(frame.commands), "vkEndCommandBuffer");
        submit(frame.commands, frame.acquired, swapchain.drawn[index], frame.ended);

        const VkPresentInfoKHR info{.sType = VK_STRUCTURE_TYPE_PRESENT_INFO_KHR, .waitSemaphoreCount = 1,
            .pWaitSemaphores = &swapchain.drawn[index], .swapchainCount = 1, .pSwapchains = &swapchain.handle,
            .pImageIndices = &index};
        const VkResult shown = vkQueuePresentKHR(queue, &info);
        if (shown == VK_ERROR_OUT_OF_DATE_KHR || shown == VK_SUBOPTIMAL_KHR) swapchain.make(format);
        else check(shown, "vkQueuePresentKHR");
    }
    vkDeviceWaitIdle(device);
    swapchain.destroy();
}
// [/frames]
