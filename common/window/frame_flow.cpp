#include "common/window/frame_flow.h"

#include <algorithm>

namespace lightwalk {
namespace {

constexpr const char* kept_stage = "kept";  // of images that an earlier frame wrote

// Ranges of mips or of layers; none is all from the first on.
bool overlap(uint32_t first, uint32_t count, uint32_t other, uint32_t others) {
    return first < other + std::max(others, 1u) && other < first + std::max(count, 1u);
}

bool overlap(const ImageView& a, const ImageView& b) {
    return a.image == b.image && overlap(a.first_mip, a.mips, b.first_mip, b.mips) &&
           overlap(a.first_layer, a.layers, b.first_layer, b.layers);
}

bool covers(const ImageView& whole, const ImageView& part) {
    return whole.first_mip <= part.first_mip && whole.first_mip + whole.mips >= part.first_mip + part.mips &&
           whole.first_layer <= part.first_layer && whole.first_layer + whole.layers >= part.first_layer + part.layers;
}

void add_views(std::vector<ImageView>& views, const std::vector<Resource>& resources) {
    for (const Resource& one : resources)
        if (one.view) views.push_back(one.view);
}

// A pass's own, and those of the modules that it names.
template <class Statement>
std::vector<Resource> all_reads(const std::string& pass, const Statement& statement, const PassInputs* root) {
    std::vector<const PassInputs*> given;
    all_inputs(given, pass, statement.with, root);
    std::vector<Resource> all;
    with_inputs(all, statement.reads, given);
    return all;
}

}  // namespace

// A frame that began since the last pass is another one.
bool FrameFlow::follows(const std::string& pass) {
    if (!on || !frame || pass == own_pass) return false;
    if (std::exchange(number_, frame->number()) != frame->number()) {
        nodes_.clear();
        edges_.clear();
        writes_.clear();
        outputs_ = 0;
    }
    return true;
}

void FrameFlow::begins(const std::string& pass, const RasterTargets& targets) {
    if (!follows(pass)) return;
    std::vector<ImageView> reads, writes;
    add_views(reads, all_reads(pass, targets, frame->root));
    std::vector<Attachment> all = targets.color;
    if (targets.depth.view) all.push_back(targets.depth);
    for (const Attachment& target : all) {
        const bool read_only = target.load == Attachment::Load::read_only;
        if (read_only || target.load == Attachment::Load::keep) reads.push_back(target.view);
        if (!read_only) writes.push_back(target.view);
        if (target.resolve_into) writes.push_back(target.resolve_into);
    }
    add_views(writes, targets.writes);
    add(pass, "raster", reads, writes);
}

void FrameFlow::begins(const std::string& pass, const ComputeAccess& access) {
    if (!follows(pass)) return;
    std::vector<ImageView> reads, writes;
    add_views(reads, all_reads(pass, access, frame->root));
    add_views(writes, access.writes);
    add(pass, "compute", reads, writes);
}

// Of a transfer a listener gets the name alone.
void FrameFlow::does_more(std::string_view what) {
    constexpr std::string_view before = "the transfer pass '";
    if (!what.starts_with(before)) return;
    const std::string pass(what.substr(before.size(), what.size() - before.size() - 1));
    if (follows(pass)) add(pass, "transfer", {}, {});
}

void FrameFlow::add(const std::string& pass, const char* stage, const std::vector<ImageView>& reads,
                    const std::vector<ImageView>& writes) {
    std::vector<size_t> written;
    for (; outputs_ < frame->outputs.size(); ++outputs_) {
        const auto& [output, view] = frame->outputs[outputs_];
        if (output.starts_with(pass)) {
            written.push_back(outputs_);
            continue;
        }
        writes_.push_back({view, nodes_.size()});
        nodes_.push_back({.name = output, .stage = kept_stage, .outputs = {outputs_}});
    }
    const size_t node = nodes_.size();
    nodes_.push_back({.name = pass, .stage = stage, .outputs = written});
    for (const ImageView& view : reads)
        for (auto write = writes_.rbegin(); write != writes_.rend(); ++write) {
            if (!overlap(write->view, view)) continue;
            const Edge edge{write->node, node, view.image->desc.name};
            if (std::find(edges_.begin(), edges_.end(), edge) == edges_.end()) edges_.push_back(edge);
            if (covers(write->view, view)) break;
        }
    for (const ImageView& view : writes) writes_.push_back({view, node});
}

// The frame's times are those of its last passes, in order.
std::vector<FrameFlow::Node> FrameFlow::nodes() const {
    std::vector<Node> result = nodes_;
    size_t at = result.size();
    if (frame)
        for (auto time = frame->times.rbegin(); time != frame->times.rend(); ++time) {
            if (time->name == own_pass) continue;
            while (at > 0 && result[at - 1].stage == kept_stage) --at;
            if (at == 0) break;
            result[--at].gpu_ms = time->gpu_ms;
        }
    std::vector<Node> joined;
    for (Node& node : result) {
        if (joined.empty() || joined.back().name != node.name || joined.back().stage != node.stage) {
            joined.push_back(std::move(node));
            continue;
        }
        Node& into = joined.back();
        into.outputs = node.outputs.empty() ? into.outputs : node.outputs;
        into.gpu_ms += node.gpu_ms;
        ++into.passes;
    }
    return joined;
}

std::vector<FrameFlow::Edge> FrameFlow::edges() const {
    std::vector<size_t> joined_at;  // by pass
    for (size_t i = 0, node = 0; i < nodes_.size(); ++i) {
        const bool same = i > 0 && nodes_[i].name == nodes_[i - 1].name && nodes_[i].stage == nodes_[i - 1].stage;
        node += i > 0 && !same;
        joined_at.push_back(node);
    }
    std::vector<Edge> result;
    for (Edge edge : edges_) {
        edge.from = joined_at[edge.from];
        edge.to = joined_at[edge.to];
        if (edge.from != edge.to && std::find(result.begin(), result.end(), edge) == result.end())
            result.push_back(edge);
    }
    return result;
}

}  // namespace lightwalk
