// The passes of a frame, and the images that one writes and another reads.
#pragma once
#include <string>
#include <vector>

#include "common/gpu/frame.h"

namespace lightwalk {

/// A listener to a frame: costs nothing while it is not `on`.
class FrameFlow : public PassListener {
  public:
    struct Node {
        std::string name, stage;
        std::vector<size_t> outputs;  ///< of Frame::outputs
        double gpu_ms = 0;
        int passes = 1;  ///< of one name, one after the other
    };
    struct Edge {
        size_t from, to;  ///< nodes
        std::string image;
        bool operator==(const Edge&) const = default;
    };

    bool on = false;
    const Frame* frame = nullptr;  ///< to be followed
    std::string own_pass;          ///< name of passes that are no part of the chapter's frame

    /// Of the frame that was recorded last; times where it has ended. Neighbours of one name are one node.
    std::vector<Node> nodes() const;
    std::vector<Edge> edges() const;

    void begins(const std::string& pass, const RasterTargets& targets) override;
    void begins(const std::string& pass, const ComputeAccess& access) override;
    void does_more(std::string_view what) override;
    void uses(const Pipeline&, const Macros&) override {}
    void sets(std::string_view, std::span<const ImageView>, const Sampler&) override {}
    void sets(std::string_view, std::span<const std::byte>) override {}
    void draws(uint32_t, uint32_t, uint32_t) override {}
    void dispatches(glm::uvec3) override {}
    void waits() override {}

  private:
    struct Write {
        ImageView view;
        size_t node;
    };
    bool follows(const std::string& pass);
    void add(const std::string& pass, const char* stage, const std::vector<ImageView>& reads,
             const std::vector<ImageView>& writes);
    std::vector<Node> nodes_;
    std::vector<Edge> edges_;
    std::vector<Write> writes_;
    uint64_t number_ = 0;  ///< of the frame
    size_t outputs_ = 0;   ///< that earlier passes have
};

}  // namespace lightwalk
