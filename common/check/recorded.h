// Frames as data: recorded by an exercise in one process, replayed and judged in another.
#pragma once
#include <functional>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "common/gpu/frame.h"

namespace lightwalk {

// Untrusted: every number of a RecordedFrame may be invalid.
struct RecordedView {
    int32_t image = -1;  ///< index into Cast::images; negative: none
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
    uint32_t index = 0;
    std::string binding;
    std::vector<RecordedView> views;
    Sampler sampler;
    std::vector<uint8_t> bytes;
    glm::uvec3 counts{0};  ///< workgroups; or vertices, instances, first instance
};

struct RecordedPass {
    std::string name;
    bool is_compute = false;
    std::vector<RecordedTarget> color;
    RecordedTarget depth;
    std::vector<RecordedView> reads, writes;
    std::vector<uint32_t> with;
    uint32_t layers = 1;
    glm::uvec2 size{0};
    std::vector<RecordedStep> steps;
};

struct RecordedFrame {
    std::vector<RecordedPass> passes;
    std::string error;
};

/// Objects that an exercise may use, in equal order in both processes.
struct Cast {
    std::vector<const Image*> images;
    std::vector<const Pipeline*> pipelines;
    std::vector<const PassInputs*> given;
    std::vector<std::function<void(Raster&)>> calls;
};

class Recorder : public PassListener {
  public:
    /// Runs `record` on a frame with this listener. Exceptions are stored in the result, prefixed with `name`.
    RecordedFrame listen(const Cast& cast, const std::string& name, const std::function<void()>& record);
    /// Recordable stand-in for the cast's i-th call.
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

/// Replays into a begun frame. Returns the exception text of recording or replay; empty if none.
std::string replay(Frame& frame, const RecordedFrame& recorded, const Cast& cast);

/// Hint for replay()'s exception text; empty where the text says what would be right.
inline std::string hint_for(const std::string& error) {
    return error.find("stating it") == error.npos ? "" : "what a pass binds stands in its reads or writes";
}

/// Replays two frames. Returns the exception text, and the compute passes of the second as "first, second".
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
