// Images owned by modules.
#pragma once
#include "common/app/module.h"
#include "common/gpu/image.h"

namespace lightwalk {

class Gpu;

class TargetBase {
  public:
    /// Throws Failure, which names the statement `where`, if a target of the module has this name.
    TargetBase(Module& owner, const std::string& name = "kept", SourceLocation where = SourceLocation::current());
    virtual ~TargetBase();
    TargetBase(const TargetBase&) = delete;
    virtual void begin_frame(Gpu& gpu, glm::uvec2 frame_size) = 0;
    virtual void forget() {}
    const std::string path;  ///< shadow.map

  private:
    Module& owner_;
};

/// Image::Desc with a size in pixels, or 0 and a scale of the frame size.
struct TargetDesc {
    std::string name;
    VkFormat format = VK_FORMAT_R16G16B16A16_SFLOAT;
    glm::uvec2 size{0};
    float scale = 1.0f;
    uint32_t mips = 1, layers = 1;  ///< mips 0: down to 1×1
    bool cube = false;
    bool kept = false;
};

/// Image of a module, named by its path; created at the start of a frame and recreated if its size changes.
class Target : public TargetBase, public Image {
  public:
    Target(Module& owner, TargetDesc desc, SourceLocation where = SourceLocation::current());
    void begin_frame(Gpu& gpu, glm::uvec2 frame_size) override;

    /// Size and layers may follow knobs; applied at the next frame.
    TargetDesc wanted;
};

/// Double-buffered image: `now` becomes the next frame's `before`.
class History : public TargetBase {
  public:
    History(Module& owner, const TargetDesc& desc, SourceLocation where = SourceLocation::current());
    const Image& now();
    const Image& before() const;           ///< requires valid()
    bool valid() const { return valid_; }  ///< written by the previous frame, at the current size
    void begin_frame(Gpu& gpu, glm::uvec2 frame_size) override;
    void forget() override { valid_ = written_ = false; }

  private:
    Target images_[2];
    int current_ = 0;
    bool written_ = false, valid_ = false;
};

}  // namespace lightwalk
