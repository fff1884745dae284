// A recorded frame as data: recorded by an exercise in one process, replayed and judged in another.
#pragma once
#include <functional>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "common/gpu/frame.h"

namespace lightwalk {

// Of RecordedFrame every number may be a stranger's.
struct RecordedView {
    int32_t image = -1;  ///< of Cast::images; below 0: none
    uint32_t first_mip = 0, mips = 0, first_layer = 0, layers = 0;
    VkImageViewType type = VK_IMAGE_VIEW_TYPE_2D;
    VkFormat format = VK_FORMAT_UNDEFINED;
};

struct RecordedTarget {
    RecordedView view;
    Attachment::Load load = Attachment::Load::clear;
    glm::vec4 color{0.0f};
    float depth = 0;
    RecordedView resolve_into;
};

struct RecordedStep {
    enum class Kind : uint32_t { use, set_views, set_bytes, draw, call, dispatch, wait };
    Kind kind = Kind::wait;
    uint32_t index = 0;   ///< of Cast::pipelines or Cast::calls
    std::string binding;  ///< its name
    std::vector<RecordedView> views;
    Sampler sampler;
    std::vector<uint8_t> bytes;
    glm::uvec3 counts{0};  ///< groups, or vertices, instances and the first instance
};

struct RecordedPass {
    std::string name;
    bool is_compute = false;
    std::vector<RecordedTarget> color;
    RecordedTarget depth;
    std::vector<RecordedView> reads, writes;
    std::vector<uint32_t> with;  ///< of Cast::given
    uint32_t layers = 1;
    glm::uvec2 size{0};
    std::vector<RecordedStep> steps;
};

struct RecordedFrame {
    std::vector<RecordedPass> passes;
    std::string error;  ///< the exception thrown while recording
};

/// All that an exercise's passes may name, in one order where they are recorded and where they are replayed.
struct Cast {
    std::vector<const Image*> images;
    std::vector<const Pipeline*> pipelines;
    std::vector<const Given*> given;
    std::vector<std::function<void(Raster&)>> calls;  ///< draw functions given to an exercise
};

/// Stores everything recorded into the frames that it listens to.
class Recorder : public PassListener {
  public:
    /// Runs `record` on a frame of this recorder's; an exception is stored in the result, under `name`.
    RecordedFrame listen(const Cast& cast, const std::string& name, const std::function<void()>& record);
    /// The i-th of the cast's calls, as an exercise is given it.
    std::function<void(Raster&)> call(uint32_t i);

    void begins(const std::string& pass, const RasterTargets& targets) override;
    void begins(const std::string& pass, const ComputeAccess& access) override;
    void uses(const Pipeline& pipeline, const Macros& variant) override;
    void sets(std::string_view binding, std::span<const ImageView> views, const Sampler& sampler) override;
    void sets(std::string_view binding, std::span<const std::byte> bytes) override;
    void draws(uint32_t vertices, uint32_t instances, uint32_t first_instance) override;
    void dispatches(glm::uvec3 groups) override;
    void waits() override;
    void does_more(std::string_view what) override;

  private:
    RecordedStep* add(RecordedStep::Kind kind);
    RecordedPass& begin(const std::string& pass, const std::vector<Resource>& reads,
                        const std::vector<Resource>& writes, const std::vector<With>& with);
    RecordedView view_of(const ImageView& view) const;
    RecordedTarget target_of(const Attachment& target) const;
    const Cast* cast_ = nullptr;
    bool quiet_ = false;
    RecordedFrame frame_;
};

/// Records it again into a frame that has begun, with images and pipelines of this process. Returns the exception
/// thrown there or here; empty if none.
std::string replay(Frame& frame, const RecordedFrame& recorded, const Cast& cast);

/// Both frames, which begin with stage.begin(1) and (2): the exception thrown, and the second one's compute passes as
/// "first, second".
template <class Stage>
std::pair<std::string, std::string> replay_twice(Stage& stage, const std::vector<RecordedFrame>& recorded) {
    if (recorded.size() != 2) return {"it was not recorded twice", ""};
    std::string error, passes;
    for (size_t i = 0; i < 2 && error.empty(); ++i) {
        stage.begin(float(i + 1));
        error = replay(stage.frame, recorded[i], stage.cast);
        stage.frame.end();
    }
    for (const PassTime& pass : stage.frame.times)
        if (pass.stage == "compute") passes += (passes.empty() ? "" : ", ") + pass.name;
    return {error, passes};
}

}  // namespace lightwalk
