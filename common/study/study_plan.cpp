#include "common/study/study_plan.h"

#include <algorithm>
#include <initializer_list>
#include <set>

#include "common/app/module.h"
#include "common/base/error.h"
#include "common/scene/json_lines.h"
#include "common/scene/scene_file.h"

namespace lightwalk {

namespace {

/// A value of the file with its position: errors name file, line and key.
class JsonNode {
  public:
    JsonNode(const JsonWithLines& source, const nlohmann::json& of, std::string pointer)
        : value(of), source_(source), pointer_(std::move(pointer)) {}

    const nlohmann::json& value;

    [[noreturn]] void refuse(const std::string& why) const {
        throw InputError(source_.where(pointer_) + (why[0] == ':' ? "" : " ") + why);
    }
    void expect(bool right, const char* what) const {
        if (!right) refuse(std::string("is ") + value.dump() + ", expected " + what);
    }
    void expect_keys(std::initializer_list<const char*> known) const {
        expect(value.is_object(), "an object { }");
        std::string names;
        for (const char* name : known) names += (names.empty() ? "" : ", ") + std::string(name);
        for (const auto& [key, ignored] : value.items())
            if (std::find(known.begin(), known.end(), key) == known.end())
                (*this)[key].refuse("is unknown here; known: " + names);
    }
    bool has(const std::string& key) const { return value.contains(key); }
    JsonNode operator[](const std::string& key) const {
        if (!has(key)) refuse("has no \"" + key + "\"");
        return {source_, value.at(key), pointer_ + "/" + key};
    }
    std::vector<JsonNode> items() const {
        expect(value.is_array() && !value.empty(), "a list [ ] with something in it");
        std::vector<JsonNode> nodes;
        for (size_t i = 0; i < value.size(); ++i)
            nodes.emplace_back(source_, value[i], pointer_ + "/" + std::to_string(i));
        return nodes;
    }
    std::string text() const {
        expect(value.is_string() && !value.get_ref<const std::string&>().empty(), "a text in quotes");
        return value.get<std::string>();
    }
    std::string one_of(std::initializer_list<const char*> words, const char* what) const {
        expect(std::find(words.begin(), words.end(), text()) != words.end(), what);
        return text();
    }

  private:
    const JsonWithLines& source_;
    std::string pointer_;
};

using nlohmann::json;

class PlanReader {
  public:
    /// `method`: of another chapter than the study's, which has these knobs; null: it is the study's own.
    explicit PlanReader(const KnobList& knobs, const KnobBase* method = nullptr)
        : knobs_(knobs), method_(method), module_(method ? &method->owner : nullptr) {}

    StudyPlan read_for_method(const JsonNode& study) {
        plan_.error_metric = study["error_metric"].text();
        read_truth(study["truth"]);
        for (const JsonNode& curve : study[study.has("candidates") ? "candidates" : "curves"].items()) try {
                read_curve(curve, plan_.candidates);
            } catch (const InputError&) {}  // this chapter does not have it
        for (StudyPoint& point : plan_.candidates)
            if (!point.method.empty()) point.set.emplace_back(method_->path(), std::exchange(point.method, ""));
        return plan_;
    }

    StudyPlan read(const JsonNode& study) {
        study.expect_keys({"title",   "module",      "error_metric", "stage",       "size",       "rounds",
                           "times",   "truth",       "scenes",       "curves",      "charts",     "better",
                           "metrics", "generate",    "test_size",    "test_scenes", "candidates", "budgets",
                           "crops",   "method_knob", "verdicts",     "unsteady"});
        plan_.title = study["title"].text();
        if (study.has("method_knob")) {
            method_ = &find(study["method_knob"], study["method_knob"].text());
            module_ = &method_->owner;
        }
        if (study.has("module")) {
            const Module& owner = (method_ ? *method_ : find(study["module"], "method")).owner;
            study["module"].expect(study["module"].text() == owner.kind(),
                                   "the kind of the module that has the methods");
            module_ = &owner;
        }
        plan_.error_metric = study["error_metric"].text();
        plan_.stage = study["stage"].text();
        if (study.has("size")) plan_.size = read_size(study["size"]);
        if (study.has("test_size")) read_size(study["test_size"]);  // study_test.py's
        if (study.has("rounds")) {
            const json& rounds = study["rounds"].value;
            study["rounds"].expect(rounds.is_number_integer() && rounds >= 1 && rounds <= 100000, "an integer from 1");
            plan_.rounds = rounds.get<int>();
        }
        if (study.has("times")) {
            study["times"].one_of({"each_frame"}, "\"each_frame\"");
            plan_.each_frame = true;
        }
        read_truth(study["truth"]);
        for (const JsonNode& curve : study["curves"].items()) read_curve(curve, plan_.points);
        plan_.candidates = plan_.points;
        if (study.has("candidates")) {
            plan_.candidates.clear();
            for (const JsonNode& curve : study["candidates"].items()) read_curve(curve, plan_.candidates);
        }
        if (study.has("budgets"))
            for (const JsonNode& budget : study["budgets"].items()) {
                budget.expect(budget.value.is_number() && budget.value >= 0, "a number from 0");
                plan_.budgets.push_back(budget.value.get<double>());
            }
        if (study.has("crops")) {
            study["crops"].expect(study["crops"].value.is_boolean(), "true or false");
            plan_.crops = study["crops"].value;
        }
        for (const JsonNode& scene : study["scenes"].items()) read_scene_entry(scene);
        if (study.has("charts")) read_charts(study["charts"]);
        if (study.has("better")) {
            study["better"].expect(study["better"].value.is_object(), "an object { } of knobs");
            for (const auto& [name, ignored] : study["better"].value.items()) {
                find(study["better"][name], name);
                study["better"][name].one_of({"lower", "higher", "either"}, "\"lower\", \"higher\" or \"either\"");
            }
        }
        if (study.has("metrics")) {
            study["metrics"].expect(study["metrics"].value.is_object(), "an object { }");
            for (const auto& [name, ignored] : study["metrics"].value.items()) study["metrics"][name].text();
            plan_.metrics = study["metrics"].value;
        }
        return plan_;
    }

  private:
    KnobBase& find(const JsonNode& at, const std::string& name) const {
        for (KnobBase* knob : knobs_)
            if (&knob->owner == module_ && knob->name == name) return *knob;
        try {
            return find_knob(knobs_, name);
        } catch (const InputError& e) { at.refuse(std::string(": ") + e.what()); }
    }

    // A knob's value, which the knob itself has taken.
    std::string checked(const JsonNode& at, const std::string& name) const {
        if (at.value.is_structured() || at.value.is_null()) at.refuse("is " + at.value.dump() + ", expected one value");
        const std::string text = at.value.is_string() ? at.value.get<std::string>() : at.value.dump();
        KnobBase& knob = find(at, name);
        try {
            knob.set(text);
        } catch (const InputError& e) { at.refuse(std::string(": ") + e.what()); }
        return text;
    }

    std::string named(const JsonNode& at, const std::string& name) const {
        const KnobBase& knob = find(at, name);
        return method_ || !has_short_name(knobs_, knob) ? knob.path() : name;
    }

    static std::vector<JsonNode> values_of(const JsonNode& node) {
        return node.value.is_array() ? node.items() : std::vector<JsonNode>{node};
    }

    KnobValues read_set(const JsonNode& set) const {
        set.expect(set.value.is_object(), "an object { } of knobs");
        KnobValues values;
        for (const auto& [name, ignored] : set.value.items())
            values.emplace_back(named(set[name], name), checked(set[name], name));
        return values;
    }

    static glm::uvec2 read_size(const JsonNode& size) {
        const auto side = [](const json& n) { return n.is_number_integer() && n >= 1 && n <= 16384; };
        size.expect(size.value.is_array() && size.value.size() == 2 && side(size.value[0]) && side(size.value[1]),
                    "[width, height], each from 1 to 16384");
        return {size.value[0].get<unsigned>(), size.value[1].get<unsigned>()};
    }

    void read_truth(const JsonNode& truth) {
        truth.expect_keys({"set", "doubled", "pictures", "most_change", "exact"});
        plan_.truth = read_set(truth["set"]);
        if (truth.has("exact")) {
            truth["exact"].expect(truth["exact"].value == true, "true");
            for (const char* key : {"doubled", "pictures", "most_change"})
                if (truth.has(key)) truth[key].refuse("does not go with \"exact\": it has no samples to double");
            return;
        }
        if (truth.has("doubled") == truth.has("pictures"))
            truth.refuse(
                "needs \"doubled\" or \"pictures\", and \"most_change\", or \"exact\": true where it has no samples to "
                "double");
        if (truth.has("doubled")) plan_.doubled = read_set(truth["doubled"]);
        if (truth.has("pictures")) {
            const json& pictures = truth["pictures"].value;
            truth["pictures"].expect(
                pictures.is_number_unsigned() && pictures >= 2 && pictures <= 65536 && pictures.get<int>() % 2 == 0,
                "an even integer from 2 to 65536");
            plan_.pictures = pictures.get<int>();
        }
        const JsonNode most = truth["most_change"];
        most.expect(most.value.is_number() && most.value >= 0, "a number from 0");
        plan_.most_change = most.value.get<double>();
    }

    void read_curve(const JsonNode& curve, std::vector<StudyPoint>& into) const {
        curve.expect_keys({"method", "set", "where", "as"});
        std::vector<StudyPoint> points{
            {.method = curve.has("method") ? checked(curve["method"], method_ ? method_->name : "method") : ""}};
        if (method_) points[0].knob = method_->path();
        if (curve.has("as")) points[0].name = curve["as"].text();
        if (curve.has("where")) points[0].where = read_set(curve["where"]);
        if (curve.has("set")) {
            curve["set"].expect(curve["set"].value.is_object(), "an object { } of knobs");
            for (const auto& [name, ignored] : curve["set"].value.items()) {
                const JsonNode node = curve["set"][name];
                std::vector<StudyPoint> next;
                for (const StudyPoint& point : points)
                    for (const JsonNode& value : values_of(node)) {
                        next.push_back(point);
                        next.back().set.emplace_back(named(node, name), checked(value, name));
                    }
                points = std::move(next);
            }
        }
        into.insert(into.end(), points.begin(), points.end());
    }

    void read_scene_entry(const JsonNode& entry) {
        StudyScene scene;
        if (entry.value.is_object()) {
            entry.expect_keys({"scene", "set", "label"});
            scene.file = entry["scene"].text();
            if (entry.has("set")) scene.set = read_set(entry["set"]);
            if (entry.has("label")) scene.label = entry["label"].text();
        } else {
            scene.file = entry.text();
        }
        if (scene.label.empty()) scene.label = std::filesystem::path(scene.file).stem().string();
        try {
            find_asset(scene.file);
        } catch (const InputError& e) { entry.refuse(std::string(": ") + e.what()); }
        for (const StudyScene& before : plan_.scenes)
            if (before.label == scene.label)
                entry.refuse(": two scenes are called '" + scene.label + "'; a \"label\" of its own tells them apart");
        for (const auto& [name, ignored] : scene.set)
            if (sets_elsewhere(name, scene.set))
                entry.refuse(": '" + name + "' is set by the scene, so neither a curve nor the truth may set it");
        plan_.scenes.push_back(scene);
    }

    // Whether something else sets a knob of a scene: the truth, or a curve for the scene without a "where" for this
    // very knob, which in the scene has the truth's value.
    bool sets_elsewhere(const std::string& name, const KnobValues& by_scene) const {
        const auto sets = [&](const KnobValues& values) {
            return std::any_of(values.begin(), values.end(), [&](const auto& value) { return value.first == name; });
        };
        return sets(plan_.truth) || (plan_.doubled && sets(*plan_.doubled)) ||
               std::any_of(plan_.points.begin(), plan_.points.end(), [&](const StudyPoint& point) {
                   for (const auto& [key, value] : point.where) {
                       if (key == name) return false;
                       for (const auto& [other, given] : by_scene)
                           if (other == key && given != value) return false;
                   }
                   return sets(point.set) || (name == point.knob && !point.method.empty());
               });
    }

    static void read_enough(const JsonNode& enough) {
        enough.expect_keys({"at", "text"});
        enough["at"].expect(enough["at"].value.is_number() && enough["at"].value >= 0, "a number from 0");
        enough["text"].text();
    }

    void read_charts(const JsonNode& charts) {
        std::set<std::string> names;
        for (const JsonNode& chart : charts.items()) {
            chart.expect_keys({"name", "title", "x", "y", "scenes", "methods", "knobs", "x_scale", "x_label", "y_label",
                               "panel", "enough", "says", "over", "passes"});
            const std::string name = chart["name"].text();
            if (name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") != name.npos)
                chart["name"].refuse("is '" + name +
                                     "', expected small letters, digits and _: it is part of a file's name");
            if (!names.insert(name).second) chart["name"].refuse(": two charts are called '" + name + "'");
            for (const char* words : {"title", "x_label", "y_label", "panel", "says", "over"})
                if (chart.has(words)) chart[words].text();
            if (chart.has("enough")) read_enough(chart["enough"]);
            for (const char* axis : {"x", "y"})
                if (chart.has(axis)) {
                    const std::string text = chart[axis].text();
                    if (text.rfind("knob ", 0) != 0) continue;
                    if (*axis == 'y') chart[axis].refuse("is '" + text + "', expected \"time\" or a metric");
                    find(chart[axis], text.substr(5));
                }
            if (chart.has("x_scale")) chart["x_scale"].one_of({"linear", "log"}, "\"linear\" or \"log\"");
            if (chart.has("knobs")) {
                chart["knobs"].expect(chart["knobs"].value.is_object(), "an object { } of knobs");
                for (const auto& [knob, ignored] : chart["knobs"].value.items())
                    for (const JsonNode& value : values_of(chart["knobs"][knob])) checked(value, knob);
            }
            if (chart.has("scenes"))
                for (const JsonNode& scene : chart["scenes"].items())
                    if (std::none_of(plan_.scenes.begin(), plan_.scenes.end(),
                                     [&](const StudyScene& known) { return known.label == scene.text(); }))
                        scene.refuse(": no scene is called '" + scene.text() + "'");
            if (chart.has("methods"))
                for (const JsonNode& method : chart["methods"].items())
                    if (std::none_of(plan_.points.begin(), plan_.points.end(),
                                     [&](const StudyPoint& known) { return known.shown() == method.text(); }))
                        method.refuse(": no curve has the method '" + method.text() + "'");
        }
        plan_.charts = charts.value;
    }

    const KnobList& knobs_;
    const KnobBase* method_;
    const Module* module_;  // its knobs' short names mean these
    StudyPlan plan_;
};

}  // namespace

StudyPlan read_study(const JsonWithLines& source, const KnobList& knobs) {
    const KeptKnobs kept(knobs);  // reading tries every value
    return PlanReader(knobs).read(JsonNode(source, source.root, ""));
}

StudyPlan read_study_of(const KnobBase& method, const JsonWithLines& source, const KnobList& knobs) {
    const KeptKnobs kept(knobs);
    return PlanReader(knobs, &method).read_for_method(JsonNode(source, source.root, ""));
}

KnobValues StudyPoint::all() const {
    KnobValues values = set;
    if (!method.empty()) values.emplace_back(knob, method);
    return values;
}

void set_knobs(const KnobList& knobs, const KnobValues& values) {
    for (const auto& [name, value] : values) find_knob(knobs, name).set(value);
}

bool have_values(const KnobList& knobs, const KnobValues& values) {
    const KeptKnobs kept(knobs);
    return std::all_of(values.begin(), values.end(), [&](const auto& wanted) {
        KnobBase& knob = find_knob(knobs, wanted.first);
        const std::string now = knob.text();
        knob.set(wanted.second);
        return knob.text() == now;
    });
}

nlohmann::json as_json(const KnobValues& values) {
    using nlohmann::json;
    json knobs = json::object();
    for (const auto& [name, value] : values) {
        const json number = json::parse(value, nullptr, false);
        knobs[name] = number.is_number() ? number : json(value);
    }
    return knobs;
}

KeptKnobs::KeptKnobs(const KnobList& knobs) {
    for (KnobBase* knob : knobs) kept_.emplace_back(knob, knob->text());
}

void KeptKnobs::put_back() const {
    for (const auto& [knob, text] : kept_) knob->set(text);
}

}  // namespace lightwalk
