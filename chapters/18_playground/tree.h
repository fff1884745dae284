// The lines of the tree as they stand on the screen: what is unfolded, or what a search finds.
#pragma once
#include <functional>
#include <unordered_set>

#include "18_playground/document.h"
#include "common/base/made.h"

namespace lightwalk {

struct TreeRow {
    EntryId id = no_entry;
    int32_t node = -1;  ///< of the object's model; -1: the entry itself
    uint16_t depth = 0;
    bool has_children = false;
};

class Tree {
  public:
    /// Nodes of an object's model that are shown below it; may be empty.
    std::function<size_t(EntryId)> node_count;

    /// Entries that are unfolded; the root always is.
    void unfold(EntryId id, bool open);
    bool is_unfolded(EntryId id) const { return unfolded_.contains(id); }
    void show(const Document& document, EntryId id);  ///< unfolds all above it

    /// Words that must all be in a name, case aside; empty: no search. With a search, the rows are those found, and flat.
    void search(const std::string& words);

    /// Rebuilt where the document, what is unfolded or the search has changed; else what was there.
    const std::vector<TreeRow>& rows(const Document& document);

    /// Entries from one row to another, both included, in this order: what Shift and a click select.
    std::vector<EntryId> between(EntryId first, EntryId last) const;

  private:
    std::unordered_set<EntryId> unfolded_;
    std::vector<std::string> words_;
    std::vector<TreeRow> rows_;
    Made<uint64_t> made_;  ///< Document::structure()
};

/// What a person reads of an entry that has no name: "spot light", "model.obj".
std::string shown_name(const Entry& entry);

}  // namespace lightwalk
