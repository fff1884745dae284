// The visible lines of the tree: unfolded entries, or search results.
#pragma once
#include <functional>
#include <unordered_set>

#include "18_playground/document.h"
#include "common/base/epoch.h"

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

    /// Words that must all be in a name, case aside; empty: no search. With a search, the rows found are flat.
    void search(const std::string& words);

    /// Rebuilt if the document, the unfolded entries or the search changed.
    const std::vector<TreeRow>& rows(const Document& document);

    /// Entries from one row to another, inclusive and in order: a Shift-click's selection.
    std::vector<EntryId> between(EntryId first, EntryId last) const;

  private:
    std::unordered_set<EntryId> unfolded_;
    std::string words_;
    std::vector<TreeRow> rows_;
    Fingerprint made_;
};

/// Displayed name of an unnamed entry: "spot light", "model.obj".
std::string shown_name(const Entry& entry);

}  // namespace lightwalk
