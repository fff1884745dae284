// Subjects of studies that are not frames.
#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace lightwalk {

/// A loader, a mip chain: it brings its own measure.
struct Subject {
    virtual ~Subject() = default;

    /// Measures the request of study.json (`study`) and adds the points to `result`, with the fields that
    /// docs/study_format.md lists for this subject.
    virtual void measure(const nlohmann::json& study, nlohmann::json& result) = 0;

    /// The need rule: measures, and sets the cheapest method with an error of at most `budget` in this scene. Called
    /// after reading chapter.scene.file, before loading. Returns measurements and choice, as in docs/study_format.md.
    virtual nlohmann::json choose(double budget) = 0;
};

}  // namespace lightwalk
