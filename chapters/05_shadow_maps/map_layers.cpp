#include "05_shadow_maps/map_layers.h"

#include <algorithm>
#include <atomic>
#include <tuple>

#include "common/gpu/gpu_work.h"

namespace lightwalk {

bool MapContent::operator==(const MapContent& other) const {
    if (number && number == other.number) return true;
    if (view != other.view || others != other.others) return false;
    ++gpu_work.lists;
    if (casters != other.casters) return false;
    static std::atomic<uint64_t> last{0};
    if (!number) number = other.number ? other.number : ++last;
    other.number = number;
    return true;
}

std::vector<uint32_t> moved_between(const MapContent& before, const MapContent& now) {
    const auto& [a, b] = std::tie(before.casters, now.casters);
    std::vector<uint32_t> moved;
    for (auto i = a.begin(), j = b.begin(); i != a.end() || j != b.end();) {
        const uint32_t left = i == a.end() ? ~0u : i->first, right = j == b.end() ? ~0u : j->first;
        if (left != right || i->second != j->second) moved.push_back(std::min(left, right));
        i += left <= right;
        j += right <= left;
    }
    return moved;
}

MapContent without(MapContent content, const std::vector<uint32_t>& items) {
    std::erase_if(content.casters, [&](const auto& caster) { return std::ranges::binary_search(items, caster.first); });
    content.number = 0;
    return content;
}

const MapLayers::Layer* MapLayers::before(const MapContent& wanted) const {
    const Layer* found = nullptr;
    for (const Layer& layer : layers_) {
        if (layer.content == wanted) return nullptr;
        if (layer.content.view == wanted.view && layer.content.others == wanted.others) found = &layer;
    }
    return found;
}

// [choose]
std::vector<uint32_t> MapLayers::choose(uint32_t id, const std::vector<const MapContent*>& wanted, uint32_t most) {
    constexpr uint32_t none = ~0u;
    std::vector<uint32_t>& chosen = of_view_[id];
    const std::vector<uint32_t> before = std::exchange(chosen, std::vector<uint32_t>(wanted.size(), none));
    std::vector<bool> taken(layers_.size()), of_another(layers_.size());
    for (const auto& [other, layers] : of_view_)
        for (const uint32_t layer : layers)
            if (other != id) of_another[layer] = true;

    const auto take = [&](uint32_t& layer, auto suits) {
        for (uint32_t i = 0; layer == none && i < layers_.size(); ++i)
            if (suits(i)) {
                layer = i;
                taken[i] = true;
            }
    };
    for (size_t i = 0; i < wanted.size(); ++i)
        take(chosen[i], [&](uint32_t layer) { return layers_[layer].content == *wanted[i]; });
    for (size_t i = 0; i < wanted.size(); ++i)
        take(chosen[i],
             [&](uint32_t layer) { return !taken[layer] && layers_[layer].content.view == wanted[i]->view; });
    for (uint32_t& layer : chosen) {
        const bool is_full = layers_.size() >= most;
        take(layer, [&](uint32_t other) { return !taken[other] && (is_full || !of_another[other]); });
        if (layer != none) continue;
        layer = static_cast<uint32_t>(layers_.size());
        layers_.emplace_back();
        taken.push_back(true);
        of_another.push_back(false);
    }
    changes_ += chosen != before;
    return chosen;
}
// [/choose]

}  // namespace lightwalk
