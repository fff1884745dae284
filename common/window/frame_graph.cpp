#include "common/window/frame_graph.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/window/event_log.h"
#include "common/window/overlay.h"

namespace lightwalk {
namespace {

constexpr glm::uvec2 small{256, 144};                               // pixels of an image of a target
constexpr uint32_t columns = 8, rows = 24;                          // of such images
constexpr float thumb_px = 112.0f, gap_px = 16.0f, lane_px = 6.0f;  // at scale 1; the least width of an image
constexpr const char* pass_name = "small image";

Area area_of(size_t output) {
    const auto i = static_cast<uint32_t>(output);
    return {small * glm::uvec2(i % columns, i / columns), small};
}

std::string name_of(const Frame& frame, size_t output) {
    const auto& [pass, view] = frame.outputs[output];
    return pass + ": " + view.name();
}

std::string time_of(const FrameFlow::Node& node) { return fmt::format("{:.2f} ms {}", node.gpu_ms, node.stage); }

std::string title_of(const FrameFlow::Node& node) {
    return node.passes > 1 ? fmt::format("{} ×{}", node.name, node.passes) : node.name;
}

float count_of_images(const FrameFlow::Node& node) {
    return static_cast<float>(std::max<size_t>(node.outputs.size(), 1));
}

// Of each edge: edges that overlap have others.
std::vector<size_t> lanes_of(const std::vector<FrameFlow::Edge>& edges) {
    std::vector<std::vector<FrameFlow::Edge>> lanes;
    std::vector<size_t> of;
    for (const FrameFlow::Edge& edge : edges) {
        const auto is_free = [&](const auto& lane) {
            return std::none_of(lane.begin(), lane.end(),
                                [&](const auto& other) { return edge.from < other.to && other.from < edge.to; });
        };
        const auto lane = static_cast<size_t>(std::find_if(lanes.begin(), lanes.end(), is_free) - lanes.begin());
        if (lane == lanes.size()) lanes.emplace_back();
        lanes[lane].push_back(edge);
        of.push_back(lane);
    }
    return of;
}

ImU32 edge_color(bool is_marked, bool another_is) {
    if (is_marked) return ImGui::GetColorU32(mine_color);
    return ImGui::GetColorU32({reference_color.x, reference_color.y, reference_color.z, another_is ? 0.15f : 0.6f});
}

}  // namespace

/// Of a node in the window.
struct FrameGraph::Place {
    size_t index;
    float left, width, top, scale;
};

uint32_t FrameGraph::height_px(float scale, uint32_t window_height) const {
    const float wanted = height * scale;
    return shown() && wanted < 0.6f * static_cast<float>(window_height) ? static_cast<uint32_t>(wanted) : 0;
}

void FrameGraph::attach(Frame& frame, const Camera& camera, const Bounds& bounds) {
    flow.frame = &frame;
    flow.own_pass = pass_name;
    if (!shown()) return;
    images_.ensure(frame.gpu.device, {.name = "small images",
                                      .format = VK_FORMAT_R8G8B8A8_UNORM,
                                      .size = small * glm::uvec2(columns, rows),
                                      .kept = true});
    frame.after_pass = [this, &frame, camera, bounds, also = std::move(frame.after_pass), seen = size_t(0)]() mutable {
        if (also) also();
        const size_t end = frame.outputs.size();
        if (seen > end) seen = 0;  // the next of several pictures
        for (; seen < end; ++seen) {
            if (seen >= columns * rows) continue;
            const Area area = area_of(seen);
            const ImageView view = frame.outputs[seen].second;  // a copy: recording adds to the list
            show_image(frame, pass_name, view, images_, {area.corner, area.size}, camera, bounds);
        }
        frame.outputs.resize(end);
    };
}

bool FrameGraph::draw(const Area& room, float scale, const Frame& frame, Look& look) {
    copies_.clear();
    if (room.size.y == 0) return false;
    nodes_ = flow.nodes();
    edges_ = flow.edges();
    std::stable_sort(edges_.begin(), edges_.end(),
                     [](const auto& a, const auto& b) { return a.to - a.from < b.to - b.from; });
    const glm::vec2 corner(room.corner), size(room.size);
    ImGui::SetNextWindowPos({corner.x, corner.y});
    ImGui::SetNextWindowSize({size.x, size.y});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
    ImGui::Begin("passes", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoNav |
                     ImGuiWindowFlags_HorizontalScrollbar | ImGuiWindowFlags_NoScrollWithMouse |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::PopStyleVar();
    if (ImGui::IsWindowHovered()) ImGui::SetScrollX(ImGui::GetScrollX() - 120.0f * scale * ImGui::GetIO().MouseWheel);
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float image_top = start.y + 2.0f * ImGui::GetTextLineHeightWithSpacing();
    choose_width({ImGui::GetContentRegionAvail().x, corner.y + size.y - image_top}, scale);
    std::vector<Place> places;
    float left = start.x;
    for (size_t i = 0; i < nodes_.size(); ++i) {
        const float words = std::max(ImGui::CalcTextSize(title_of(nodes_[i]).c_str()).x,
                                     ImGui::CalcTextSize(("00.00 ms " + nodes_[i].stage).c_str()).x);
        places.push_back({i, left, std::max(count_of_images(nodes_[i]) * image_px_, words), start.y, scale});
        left += places.back().width + gap_px * scale;
    }
    const float image_bottom = image_top + image_px_ * 9.0f / 16.0f;
    hovered_ = SIZE_MAX;
    const float mouse_x = ImGui::GetIO().MousePos.x;
    for (const Place& place : places)
        if (ImGui::IsWindowHovered() && mouse_x >= place.left && mouse_x < place.left + place.width)
            hovered_ = place.index;
    place_images(places, room, {image_top, image_bottom}, frame);
    fill_between(room, image_top, image_bottom);
    bool clicked = false;
    for (const Place& place : places) clicked |= draw_node(nodes_[place.index], place, frame, look);
    draw_edges(places, image_bottom, frame);
    ImGui::SetCursorScreenPos({left, start.y});
    ImGui::Dummy({1.0f, 1.0f});  // the end of what is scrolled
    if (hovered_ < nodes_.size()) explain(nodes_[hovered_], hovered_);
    ImGui::End();
    return clicked;
}

// As large as all of them fit, above the lanes; where they do not fit across, they are scrolled.
void FrameGraph::choose_width(glm::vec2 room, float scale) {
    size_t lanes = 0;
    for (const size_t lane : lanes_of(edges_)) lanes = std::max(lanes, lane + 1);
    float images = 0.0f;
    for (const FrameFlow::Node& node : nodes_) images += count_of_images(node);
    const float high = room.y - (static_cast<float>(lanes) + 4.0f) * lane_px * scale, least = thumb_px * scale,
                across = (room.x - static_cast<float>(nodes_.size()) * gap_px * scale) / std::max(images, 1.0f);
    const float most = std::min(high * 16.0f / 9.0f, 2.0f * least);
    image_px_ = std::floor(std::max(across < least ? most : std::min(most, across), least));
}

// Where the images come nothing is drawn: the window copies them before the panels. Cut at the edges of the room.
void FrameGraph::place_images(const std::vector<Place>& places, const Area& room, glm::vec2 rows_px,
                              const Frame& frame) {
    copies_.clear();
    const auto left_end = float(room.corner.x), right_end = float(room.corner.x + room.size.x);
    for (const Place& place : places) {
        const float width = image_px_, texels = float(small.x) / width;
        float x = place.left - width;
        for (const size_t output : nodes_[place.index].outputs) {
            x += width;
            const float low = std::max(x, left_end), high = std::min(x + width, right_end);
            if (output >= columns * rows || output >= frame.outputs.size() || low >= high) continue;
            const auto first = static_cast<uint32_t>((low - x) * texels),
                       last = std::min(static_cast<uint32_t>((high - x) * texels), small.x);
            const glm::uvec2 from = area_of(output).corner + glm::uvec2(first, 0), to(low, rows_px.x);
            copies_.push_back({{from, {last - first, small.y}}, {to, glm::uvec2(high, rows_px.y) - to}});
        }
    }
}

// The ground of the panel, but for the images.
void FrameGraph::fill_between(const Area& room, float top, float bottom) const {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRectFullScreen();  // its margins, too
    const ImU32 ground = ImGui::GetColorU32(ImGuiCol_WindowBg);
    const glm::vec2 low(room.corner), high(room.corner + room.size);
    list.AddRectFilled({low.x, low.y}, {high.x, std::floor(top)}, ground);
    list.AddRectFilled({low.x, std::floor(bottom)}, {high.x, high.y}, ground);
    float x = low.x;
    for (const auto& [from, to] : copies_) {
        list.AddRectFilled({x, std::floor(top)}, {float(to.corner.x), std::floor(bottom)}, ground);
        x = float(to.corner.x + to.size.x);
    }
    list.AddRectFilled({x, std::floor(top)}, {high.x, std::floor(bottom)}, ground);
    list.PopClipRect();
}

// Its name and time over its images.
bool FrameGraph::draw_node(const FrameFlow::Node& node, const Place& place, const Frame& frame, Look& look) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float line = ImGui::GetTextLineHeightWithSpacing(), thumb = image_px_;
    const ImVec2 image{place.left, place.top + 2.0f * line};
    const ImU32 frame_color =
        ImGui::GetColorU32(hovered_ == place.index ? mine_color : ImGui::GetStyle().Colors[ImGuiCol_Separator]);
    const ImVec4 clip{place.left, place.top, place.left + place.width, image.y};
    const auto text = [&](float y, ImU32 color, const std::string& words) {
        list.AddText(nullptr, 0.0f, {place.left, y}, color, words.c_str(), nullptr, 0.0f, &clip);
    };
    text(place.top, ImGui::GetColorU32(ImGuiCol_Text), title_of(node));
    text(place.top + line, ImGui::GetColorU32(quiet_color), time_of(node));
    bool clicked = false;
    for (size_t i = 0; i < node.outputs.size(); ++i) {
        if (node.outputs[i] >= frame.outputs.size()) continue;
        const std::string output = name_of(frame, node.outputs[i]);
        const ImVec2 at{image.x + static_cast<float>(i) * thumb, image.y};
        ImGui::SetCursorScreenPos(at);
        ImGui::PushID(static_cast<int>(place.index * 64 + i));
        if (ImGui::InvisibleButton("image", {thumb, thumb * 9.0f / 16.0f})) {
            look.output = look.output == output ? "" : output;
            log_event("look " + (look.output.empty() ? "the picture" : look.output));
            clicked = true;
        }
        ImGui::PopID();
        log_place("pass." + output);
        const bool is_shown = look.output == output;
        list.AddRect(at, {at.x + thumb, at.y + thumb * 9.0f / 16.0f},
                     is_shown ? ImGui::GetColorU32(right_color) : frame_color, 0.0f, 0, is_shown ? 3.0f : 1.0f);
    }
    if (node.outputs.empty()) list.AddRect(image, {image.x + thumb, image.y + thumb * 9.0f / 16.0f}, frame_color);
    return clicked;
}

// Where the image stands that is read, in images from the left end of its node.
float FrameGraph::image_x(const FrameFlow::Edge& edge, const Frame& frame) const {
    const std::vector<size_t>& outputs = nodes_[edge.from].outputs;
    for (size_t i = 0; i < outputs.size(); ++i)
        if (outputs[i] < frame.outputs.size() && frame.outputs[outputs[i]].second.image->desc.name == edge.image)
            return static_cast<float>(i) + 0.75f;
    return 0.75f;
}

// From the image that is read to the left end of its reader, short ones nearest to the images.
void FrameGraph::draw_edges(const std::vector<Place>& places, float bottom, const Frame& frame) {
    if (places.empty()) return;
    const float scale = places.front().scale, end = ImGui::GetWindowPos().y + ImGui::GetWindowHeight();
    const float most = std::max((end - bottom) / (lane_px * scale) - 4.0f, 1.0f);
    const std::vector<size_t> lanes = lanes_of(edges_);
    std::string all;
    for (size_t i = 0; i < edges_.size(); ++i) {
        const FrameFlow::Edge& edge = edges_[i];
        const float y = bottom + (std::min(static_cast<float>(lanes[i]), most) + 1.5f) * lane_px * scale;
        const Place &from = places[edge.from], &to = places[edge.to];
        const float x = from.left + image_x(edge, frame) * image_px_, into = to.left + 14.0f * scale;
        const bool is_marked = hovered_ == edge.from || hovered_ == edge.to;
        const ImU32 color = edge_color(is_marked, hovered_ != SIZE_MAX);
        const ImVec2 line[] = {{x, bottom}, {x, y}, {into, y}, {into, bottom + 2.0f * scale}};
        ImDrawList& list = *ImGui::GetWindowDrawList();
        for (int j = 0; j < 3; ++j) list.AddLine(line[j], line[j + 1], color, (is_marked ? 2.0f : 1.2f) * scale);
        const float head = 3.5f * scale;
        list.AddTriangleFilled({into, bottom}, {into - head, bottom + 1.8f * head}, {into + head, bottom + 1.8f * head},
                               color);
        all += fmt::format("; {} > {}", nodes_[edge.from].name, nodes_[edge.to].name);
    }
    if (std::exchange(logged_, all) != all) log_event("passes" + all);
}

void FrameGraph::explain(const FrameFlow::Node& node, size_t index) const {
    ImGui::BeginTooltip();
    ImGui::Text("%s: %.3f ms, %s", node.name.c_str(), node.gpu_ms, node.stage.c_str());
    for (const FrameFlow::Edge& edge : edges_)
        if (edge.to == index)
            ImGui::TextColored(quiet_color, "reads %s of %s", edge.image.c_str(), nodes_[edge.from].name.c_str());
    for (const FrameFlow::Edge& edge : edges_)
        if (edge.from == index)
            ImGui::TextColored(quiet_color, "%s is read by %s", edge.image.c_str(), nodes_[edge.to].name.c_str());
    if (!node.outputs.empty()) ImGui::TextColored(quiet_color, "A click shows an image large, another one the picture");
    ImGui::EndTooltip();
}

void FrameGraph::blit_to(VkCommandBuffer commands, const Image& window) const {
    for (const auto& [from, to] : copies_) blit(commands, images_, from, window, to);
}

}  // namespace lightwalk
