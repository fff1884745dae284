#include "common/window/swapchain.h"

#include <algorithm>

#include "common/base/error.h"
#include "common/base/shared_lock.h"

namespace lightwalk {
namespace {

VkSemaphore make_semaphore(VkDevice device) {
    const VkSemaphoreCreateInfo info{.sType = VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO};
    VkSemaphore semaphore = VK_NULL_HANDLE;
    check(vkCreateSemaphore(device, &info, nullptr, &semaphore), "vkCreateSemaphore");
    return semaphore;
}

// Long enough for a slow display, short enough that a window which nobody shows does not stop the program.
constexpr uint64_t acquire_timeout_ns = 500'000'000;

}  // namespace

Swapchain::Swapchain(Gpu& gpu, Display& display) : gpu_(gpu), display_(display) {
    surface_ = display.make_surface(gpu.device.instance);
    VkBool32 supported = VK_FALSE;
    vkGetPhysicalDeviceSurfaceSupportKHR(gpu.device.physical, gpu.device.queue_family, surface_, &supported);
    if (!supported) {
        vkDestroySurfaceKHR(gpu.device.instance, surface_, nullptr);
        throw InputError(gpu.device.info.name +
                         " cannot draw into this window; leave --device out to have one that can; " + display.without);
    }
    choose_format();
    for (VkSemaphore& one : acquired_) one = make_semaphore(gpu.device.handle);
}

Swapchain::~Swapchain() {
    vkDeviceWaitIdle(gpu_.device.handle);
    destroy_images();
    vkDestroySwapchainKHR(gpu_.device.handle, handle_, nullptr);
    for (const VkSemaphore one : acquired_) vkDestroySemaphore(gpu_.device.handle, one, nullptr);
    vkDestroySurfaceKHR(gpu_.device.instance, surface_, nullptr);
}

void Swapchain::choose_format() {
    uint32_t count = 0;
    vkGetPhysicalDeviceSurfaceFormatsKHR(gpu_.device.physical, surface_, &count, nullptr);
    std::vector<VkSurfaceFormatKHR> all(count);
    vkGetPhysicalDeviceSurfaceFormatsKHR(gpu_.device.physical, surface_, &count, all.data());
    if (all.empty())
        throw InputError("{} has no picture format for this screen, of 16 bits a pixel perhaps; {}",
                         gpu_.device.info.name, display_.without);
    // The picture is sRGB-encoded already, so a format that would encode once more is the last choice.
    const auto rank = [](const VkSurfaceFormatKHR& f) {
        return f.format == VK_FORMAT_B8G8R8A8_UNORM ? 0 : f.format == VK_FORMAT_R8G8B8A8_UNORM ? 1 : 2;
    };
    surface_format_ =
        *std::min_element(all.begin(), all.end(), [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
    format = surface_format_.format;
}

bool Swapchain::is_outdated() const { return outdated_ || display_.framebuffer_size() != size; }

bool Swapchain::ready() {
    const glm::uvec2 framebuffer = display_.framebuffer_size();
    if (display_.is_minimised() || framebuffer.x == 0 || framebuffer.y == 0) return false;
    if (!outdated_ && framebuffer == size) return true;
    VkSurfaceCapabilitiesKHR surface{};
    check(vkGetPhysicalDeviceSurfaceCapabilitiesKHR(gpu_.device.physical, surface_, &surface), "the window's surface");
    glm::uvec2 wanted(surface.currentExtent.width, surface.currentExtent.height);
    if (wanted.x == UINT32_MAX)  // the window takes the size of its images
        wanted = glm::clamp(framebuffer, {surface.minImageExtent.width, surface.minImageExtent.height},
                            {surface.maxImageExtent.width, surface.maxImageExtent.height});
    if (wanted.x == 0 || wanted.y == 0) return false;
    make(surface, wanted);
    return true;
}

void Swapchain::make(VkSurfaceCapabilitiesKHR surface, glm::uvec2 wanted) {
    const VkDevice device = gpu_.device.handle;
    vkDeviceWaitIdle(device);
    destroy_images();
    uint32_t count = surface.minImageCount + 1;
    if (surface.maxImageCount) count = std::min(count, surface.maxImageCount);
    const VkSwapchainCreateInfoKHR info{
        .sType = VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR,
        .surface = surface_,
        .minImageCount = count,
        .imageFormat = surface_format_.format,
        .imageColorSpace = surface_format_.colorSpace,
        .imageExtent = {wanted.x, wanted.y},
        .imageArrayLayers = 1,
        .imageUsage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT,
        .imageSharingMode = VK_SHARING_MODE_EXCLUSIVE,
        .preTransform = surface.currentTransform,
        .compositeAlpha = surface.supportedCompositeAlpha & VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR
                              ? VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR
                              : VK_COMPOSITE_ALPHA_INHERIT_BIT_KHR,
        .presentMode = VK_PRESENT_MODE_FIFO_KHR,
        .clipped = VK_TRUE,
        .oldSwapchain = handle_};
    VkSwapchainKHR made = VK_NULL_HANDLE;
    check(vkCreateSwapchainKHR(device, &info, nullptr, &made), "vkCreateSwapchainKHR");
    vkDestroySwapchainKHR(device, handle_, nullptr);
    handle_ = made;
    size = wanted;
    vkGetSwapchainImagesKHR(device, handle_, &count, nullptr);
    std::vector<VkImage> handles(count);
    vkGetSwapchainImagesKHR(device, handle_, &count, handles.data());
    for (const VkImage handle : handles) {
        images_.push_back(Image::borrowed(gpu_.device, handle, {.name = "window", .format = format, .size = size}));
        views.push_back(ImageView(images_.back()).handle());
        rendered_.push_back(make_semaphore(device));
    }
    outdated_ = false;
    ++generation_;
}

void Swapchain::destroy_images() {
    for (const VkSemaphore semaphore : rendered_) vkDestroySemaphore(gpu_.device.handle, semaphore, nullptr);
    views.clear();
    rendered_.clear();
    images_.clear();
}

const Image* Swapchain::acquire() {
    const size_t next = (turn_ + 1) % acquired_.size();
    const VkResult result = unlocked([&] {
        return vkAcquireNextImageKHR(gpu_.device.handle, handle_, acquire_timeout_ns, acquired_[next], VK_NULL_HANDLE,
                                     &index_);
    });
    if (result == VK_TIMEOUT || result == VK_NOT_READY) return nullptr;
    if (result == VK_ERROR_OUT_OF_DATE_KHR) {
        outdated_ = true;
        return nullptr;
    }
    if (result != VK_SUBOPTIMAL_KHR) check(result, "vkAcquireNextImageKHR");
    turn_ = next;
    outdated_ = result == VK_SUBOPTIMAL_KHR;
    // Contents are discarded; writing has to wait for the semaphore, which Frame::end awaits with all stages.
    images_[index_].history = {.all = {.last_write = {.stages = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT}}, .each = {}};
    return &images_[index_];
}

void Swapchain::present() {
    const VkSemaphore wait = rendered();
    const VkPresentInfoKHR info{.sType = VK_STRUCTURE_TYPE_PRESENT_INFO_KHR,
                                .waitSemaphoreCount = 1,
                                .pWaitSemaphores = &wait,
                                .swapchainCount = 1,
                                .pSwapchains = &handle_,
                                .pImageIndices = &index_};
    const VkResult result = vkQueuePresentKHR(gpu_.device.queue, &info);
    if (result == VK_ERROR_OUT_OF_DATE_KHR || result == VK_SUBOPTIMAL_KHR)
        outdated_ = true;
    else
        check(result, "vkQueuePresentKHR");
}

}  // namespace lightwalk
