#include "common/app/target.h"

#include <algorithm>

#include "common/base/error.h"
#include "common/gpu/gpu.h"

namespace lightwalk {
namespace {

TargetDesc kept(TargetDesc target, const char* suffix) {
    target.kept = true;
    target.name += suffix;
    return target;
}

}  // namespace

TargetBase::TargetBase(Module& owner, const std::string& name, SourceLocation where)
    : path((owner.path().empty() ? "" : owner.path() + ".") + name), owner_(owner) {
    if (std::ranges::find(owner_.targets_, path, &TargetBase::path) != owner_.targets_.end())
        throw Failure("{}: target '{}' stands twice in one module; give one another name", place_of(where), path);
    owner_.targets_.push_back(this);
}
TargetBase::~TargetBase() { std::erase(owner_.targets_, this); }

Target::Target(Module& owner, TargetDesc target, SourceLocation where)
    : TargetBase(owner, target.name, where), wanted(std::move(target)) {
    if (!(wanted.scale > 0))
        throw Failure("{}: target '{}': a scale of {}; expected one above 0", place_of(where), path, wanted.scale);
}

void Target::begin_frame(Gpu& gpu, glm::uvec2 frame_size) {
    glm::uvec2 size = wanted.size;
    if (size == glm::uvec2(0)) size = glm::max(glm::uvec2(glm::ceil(wanted.scale * glm::vec2(frame_size))), 1u);
    const Image::Desc next{.name = path,
                           .format = wanted.format,
                           .size = size,
                           .mips = wanted.mips ? wanted.mips : full_mip_count(size),
                           .layers = wanted.layers,
                           .cube = wanted.cube,
                           .kept = wanted.kept};
    if (handle && desc == next) return;
    static_cast<Image&>(*this) = Image(gpu.device, next);
}

History::History(Module& owner, const TargetDesc& target, SourceLocation where)
    : TargetBase(owner, target.name, where),
      images_{{owner, kept(target, " a"), where}, {owner, kept(target, " b"), where}} {}

const Image& History::now() {
    written_ = true;
    return images_[current_];
}

const Image& History::before() const { return images_[1 - current_]; }

// Called before its images' own begin_frame(), since it registered first, and thus detects their resizing.
void History::begin_frame(Gpu& gpu, glm::uvec2 frame_size) {
    const VkImage last = images_[current_].handle;
    for (Target& image : images_) image.begin_frame(gpu, frame_size);
    valid_ = written_ && images_[current_].handle == last;
    if (written_) current_ = 1 - current_;
    written_ = false;
}

}  // namespace lightwalk
