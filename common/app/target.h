// Images that a module owns from frame to frame.
#pragma once
#include "common/app/module.h"
#include "common/gpu/image.h"

namespace lightwalk {

class Gpu;

class TargetBase {
  public:
    explicit TargetBase(Module& owner);
    virtual ~TargetBase();
    TargetBase(const TargetBase&) = delete;
    virtual void begin_frame(Gpu& gpu, glm::uvec2 frame_size) = 0;
    virtual void forget() {}

  private:
    Module& owner_;
};

/// As Image::Desc, except for the size: in pixels, or 0 and a scale of the frame's.
struct TargetDesc {
    std::string name;
    VkFormat format = VK_FORMAT_R16G16B16A16_SFLOAT;
    glm::uvec2 size{0};
    float scale = 1.0f;
    uint32_t mips = 1, layers = 1;  ///< mips 0: down to 1×1
    bool cube = false;
    bool kept = false;  ///< later frames read its contents
};

/// An image of a module, called path.name: made when a frame begins, and again if its size changes.
class Target : public TargetBase, public Image {
  public:
    Target(Module& owner, TargetDesc desc);
    void begin_frame(Gpu& gpu, glm::uvec2 frame_size) override;

    /// For a size or a number of layers that follows a knob: takes effect when the next frame begins.
    TargetDesc wanted;

  private:
    const std::string path_;
};

// [history]
/// Two images that swap each frame: this frame's output is the next one's `before`.
class History : public TargetBase {
  public:
    History(Module& owner, const TargetDesc& desc);
    const Image& now();                    ///< to write; marks it as written in this frame
    const Image& before() const;           ///< to read where valid()
    bool valid() const { return valid_; }  ///< the frame before this one wrote it, at this size
    void begin_frame(Gpu& gpu, glm::uvec2 frame_size) override;
    void forget() override { valid_ = written_ = false; }

  private:
    Target images_[2];
    int current_ = 0;
    bool written_ = false, valid_ = false;
};
// [/history]

}  // namespace lightwalk
