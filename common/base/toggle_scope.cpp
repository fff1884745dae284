#include "common/base/toggle_scope.h"

#include "common/base/exercise.h"

namespace lightwalk {

ToggleScope::ToggleScope(const std::vector<std::string>& ids, bool solution) : solution_(solution) {
    for (const std::string& id : ids) {
        if (!Exercises::has_solution(id) || Exercises::uses_solution(id) == solution) continue;
        Exercises::set(id, solution);
        changed_.push_back(id);
    }
}

ToggleScope::~ToggleScope() {
    for (const std::string& id : changed_) Exercises::set(id, !solution_);
}

}  // namespace lightwalk
