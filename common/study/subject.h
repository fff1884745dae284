// What a study measures where its subject is no frame.
#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace lightwalk {

/// A loader, a mip chain: it brings its own measure.
struct Subject {
    virtual ~Subject() = default;

    /// Measures what study.json (as `study`) asks for and puts into `result` the points and what else
    /// docs/study_format.md asks of such a subject.
    virtual void measure(const nlohmann::json& study, nlohmann::json& result) = 0;

    /// The need rule: sets the cheapest method whose error in this scene is at most `budget`, by measuring. Called when
    /// chapter.scene.file is read and nothing loaded. Returns what was measured and chosen, as docs/study_format.md
    /// says.
    virtual nlohmann::json choose(double budget) = 0;
};

}  // namespace lightwalk
