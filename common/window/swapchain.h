// The images that the window shows in turn.
#pragma once
#include <array>
#include <vector>

#include "common/gpu/gpu.h"
#include "common/window/display.h"

namespace lightwalk {

/// Recreated when the window's size has changed; no frame may be in flight then.
class Swapchain {
  public:
    Swapchain(Gpu& gpu, Display& display);
    ~Swapchain();
    Swapchain(const Swapchain&) = delete;

    VkFormat format = VK_FORMAT_UNDEFINED;
    glm::uvec2 size{0};              ///< pixels
    std::vector<VkImageView> views;  ///< of its images, which own them

    /// The next ready() recreates it.
    bool is_outdated() const;

    /// Brings the size up to date. False if there is nothing to draw on: minimised.
    bool ready();

    /// The next image, or null if the window changed meanwhile. `acquired()` is signalled when it may be written.
    const Image* acquire();
    uint32_t index() const { return index_; }
    VkSemaphore acquired() const { return acquired_.at(turn_); }
    VkSemaphore rendered() const { return rendered_.at(index_); }

    /// Shows the image once `rendered()` is signalled.
    void present();

    /// Number of times the images were created, for per-image data.
    int generation() const { return generation_; }

  private:
    void choose_format();
    void make(VkSurfaceCapabilitiesKHR surface, glm::uvec2 wanted);
    void destroy_images();
    Gpu& gpu_;
    Display& display_;
    VkSurfaceKHR surface_ = VK_NULL_HANDLE;
    VkSwapchainKHR handle_ = VK_NULL_HANDLE;
    VkSurfaceFormatKHR surface_format_{};
    std::vector<Image> images_;
    std::vector<VkSemaphore> rendered_;      ///< one an image: free again when that image is acquired again
    std::array<VkSemaphore, 3> acquired_{};  ///< two frames in flight may still wait for theirs
    size_t turn_ = 0;
    uint32_t index_ = 0;
    bool outdated_ = true;
    int generation_ = 0;
};

}  // namespace lightwalk
