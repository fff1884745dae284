#include "18_playground/tree.h"

#include <algorithm>
#include <utility>

#include "18_playground/commands.h"
#include "common/base/names.h"

namespace lightwalk {

std::string shown_name(const Entry& entry) {
    if (!entry.name().empty()) return clean_name(entry.name());  // a file's may have line breaks, and this is a line
    if (const SceneObject* object = entry.object())
        return object->model.empty() ? "group" : object->model.filename().string();
    static constexpr const char* kinds[] = {"directional light", "point light", "spot light"};
    return kinds[static_cast<int>(entry.light()->kind)];
}

void Tree::unfold(EntryId id, bool open) {
    if (open ? unfolded_.insert(id).second : unfolded_.erase(id) > 0) made_.forget();
}

void Tree::show(const Document& document, EntryId id) {
    for (id = document.at(id).parent; id != no_entry; id = document.at(id).parent) unfold(id, true);
}

void Tree::search(const std::string& text) {
    const std::string words = text.find_first_not_of(' ') == text.npos ? "" : text;
    if (std::exchange(words_, words) != words) made_.forget();
}

const std::vector<TreeRow>& Tree::rows(const Document& document) {
    if (made_.is_current(document.structure())) return rows_;
    rows_.clear();
    struct Waiting {
        EntryId id;
        uint16_t depth;
    };
    std::vector<Waiting> stack{{root_entry, 0}};
    while (!stack.empty()) {
        const Waiting now = stack.back();
        stack.pop_back();
        const Entry& entry = document.at(now.id);
        const bool open = !words_.empty() || now.id == root_entry || unfolded_.contains(now.id);
        const size_t nodes = entry.object() && node_count ? node_count(now.id) : 0;
        if (now.id != root_entry) {
            if (words_.empty() || has_words(shown_name(entry), words_))
                rows_.push_back({now.id, -1, words_.empty() ? now.depth : uint16_t(0),
                                 words_.empty() && (!entry.children.empty() || nodes > 1)});
        }
        if (!open) continue;
        if (words_.empty() && nodes > 1)
            for (size_t i = 0; i < nodes; ++i)
                rows_.push_back({now.id, static_cast<int32_t>(i), static_cast<uint16_t>(now.depth + 1), false});
        const uint16_t below = static_cast<uint16_t>(std::min(now.depth + (now.id == root_entry ? 0 : 1), 60000));
        for (auto child = entry.children.rbegin(); child != entry.children.rend(); ++child)
            stack.push_back({*child, below});
    }
    return rows_;
}

std::vector<EntryId> Tree::between(EntryId first, EntryId last) const {
    const auto place = [&](EntryId id) {
        return std::find_if(rows_.begin(), rows_.end(), [&](const TreeRow& row) { return row.id == id; });
    };
    const auto from = place(first), to = place(last);
    if (from == rows_.end()) return {last};
    if (to == rows_.end()) return {first};
    std::vector<EntryId> ids;
    for (auto row = std::min(from, to); row <= std::max(from, to); ++row)
        if (row->node < 0) ids.push_back(row->id);
    if (to < from) std::reverse(ids.begin(), ids.end());
    return ids;
}

}  // namespace lightwalk
