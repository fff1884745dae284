// The request in chapters/NN_name/study.json, checked before anything is measured.
#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/app/knob.h"
#include "common/scene/json_lines.h"

namespace lightwalk {

/// Knobs by name, each with the text that KnobBase::set takes.
using KnobValues = std::vector<std::pair<std::string, std::string>>;

void set_knobs(const KnobList& knobs, const KnobValues& values);

/// Whether the knobs have these values, in any notation.
bool have_values(const KnobList& knobs, const KnobValues& values);

/// As JSON has them: a number where it is one.
nlohmann::json as_json(const KnobValues& values);

/// Restores every knob to its value at construction.
class KeptKnobs {
  public:
    explicit KeptKnobs(const KnobList& knobs);
    ~KeptKnobs() { put_back(); }
    KeptKnobs(const KeptKnobs&) = delete;
    void put_back() const;

  private:
    std::vector<std::pair<KnobBase*, std::string>> kept_;
};

struct StudyScene {
    std::string file;   ///< as load_scene takes it
    std::string label;  ///< name of its points and panels; default: the file's stem
    KnobValues set;     ///< for every point and for the truth
};

struct StudyPoint {
    std::string method;  ///< empty if the chapter has none
    KnobValues set;
    KnobValues where;             ///< only in scenes where these knobs have these values
    std::string knob = "method";  ///< whose value the method is
    std::string name{};           ///< the method's in the result; empty: `method`

    KnobValues all() const;  ///< its settings, including the method
    const std::string& shown() const { return name.empty() ? method : name; }
};

/// The sweep of one frame study.
///
///     {"title": "...", "module": "shadow", "error_metric": "flip_mean", "stage": "fragment", "size": [960, 540],
///      "rounds": 11,
///      "truth": {"set": {"samples": 8}, "doubled": {"samples": 16}, "most_change": 0.001},
///      "scenes": ["assets/scenes/teapot.json",
///                 {"scene": "assets/scenes/yard.json", "set": {"lights": 100}, "label": "100 lights"}],
///      "curves": [{"method": "gouraud"}, {"method": "phong", "set": {"samples": [1, 2, 4]}}],
///      "candidates": [{"method": "phong"}, {"method": "gouraud", "where": {"ambient": "on"}}],
///      "test_size": [96, 54], "better": {"threshold": "lower"}, "metrics": {"hit_texels": "hit error, texels"},
///      "charts": [{"name": "lights", "title": "...", "x": "knob lights", "y": "time", "scenes": ["100 lights"],
///                  "methods": ["phong"], "knobs": {"samples": 4}, "x_scale": "linear"}]}
///
/// A truth without samples that could be doubled has "exact": true instead of "doubled" and "most_change". "pictures": 64 in
/// place of "doubled": the mean of so many pictures, each with a seed of its own, against that of half of them.
/// docs/study_format.md says what each key means.
struct StudyPlan {
    std::string title, error_metric, stage;
    std::optional<glm::uvec2> size;  ///< pixels
    int rounds = 11;
    KnobValues truth;
    std::optional<KnobValues> doubled;
    int pictures = 1;  ///< whose mean is the truth
    double most_change = 0;
    std::vector<StudyScene> scenes;
    std::vector<StudyPoint> points;      ///< every curve's: the product of the values its knobs list
    std::vector<StudyPoint> candidates;  ///< the need rule's candidates; default: the points
    std::vector<double> budgets;         ///< for each of which the need rule is asked in each scene
    bool crops = false;                  ///< it is to draw crops also where whole pictures cost less
    bool each_frame = false;             ///< times leave out passes that ran in a point's first frame alone
    nlohmann::json charts, metrics = nlohmann::json::object();  ///< for the result as they are; charts may be null

    bool is_exact() const { return !doubled && pictures == 1; }
};

/// Throws InputError with file, line and key: a key that is missing, unknown or of a wrong type, a file that is not
/// there, a knob or value that the chapter does not have, a knob set twice, two scenes with one label.
StudyPlan read_study(const JsonWithLines& source, const KnobList& knobs);

/// From another chapter's study, the part that the need rule needs, with the methods of `method`, a knob of this
/// chapter: metric, truth and candidates. A knob is first looked up in the method's own module; all are named by
/// path. Candidates with knobs or values absent from this chapter are omitted. Throws InputError if the truth has
/// some.
StudyPlan read_study_of(const KnobBase& method, const JsonWithLines& source, const KnobList& knobs);

}  // namespace lightwalk
