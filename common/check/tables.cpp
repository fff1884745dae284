#include "common/check/tables.h"

#include <cstdlib>
#include <filesystem>

#include "common/base/exercise.h"
#include "common/base/files.h"
#include "common/check/undefined.h"
#include "common/gpu/glsl.h"

namespace lightwalk {
namespace {

using Json = nlohmann::ordered_json;

constexpr size_t most_rows = 400, first_rows = 200;
constexpr double no_bound = 1e6;  // threshold of probes judged by other means

Json number(double value) {
    if (!std::isfinite(value)) return number_text(value);
    if (value == std::trunc(value) && std::fabs(value) < 1e15) return value;
    if (static_cast<double>(static_cast<float>(value)) == value)
        return std::strtod(number_text(value).c_str(), nullptr);
    return std::strtod(fmt::format("{:.9g}", value).c_str(), nullptr);
}

Json numbers(std::span<const double> row) {
    Json list = Json::array();
    for (const double value : row) list.push_back(number(value));
    return list;
}

// All handwritten rows, which come first, and every n-th random one.
std::vector<size_t> kept_rows(size_t count) {
    std::vector<size_t> kept;
    for (size_t i = 0; i < std::min(count, first_rows); ++i) kept.push_back(i);
    const size_t rest = count - kept.size(), taken = std::min(rest, most_rows - first_rows);
    for (size_t i = 0; i < taken; ++i) kept.push_back(first_rows + i * rest / taken);
    return kept;
}

// Hints depend on the result, so they are stored for these kinds of wrong results, named as in the page.
Row wrong_result(const std::string& kind, const Row& truth) {
    Row row;
    for (const double t : truth)
        row.push_back(kind == "nan"        ? std::numeric_limits<double>::quiet_NaN()
                      : kind == "zero"     ? 0
                      : kind == "negative" ? -1 - std::fabs(t)
                      : kind == "low"      ? t - 0.4 * std::fabs(t) - 1e-3
                                           : t + 0.6 * std::fabs(t) + 1e-2);
    return row;
}

Json hints_of(const Probe& probe, const std::vector<size_t>& rows) {
    Json texts = Json::array({""}), kinds;
    for (const std::string kind : {"nan", "zero", "negative", "low", "high"})
        for (const size_t row : rows) {
            const std::string hint = probe.hint(probe.inputs[row], wrong_result(kind, probe.truth(probe.inputs[row])));
            auto at = std::find(texts.begin(), texts.end(), hint);
            if (at == texts.end()) at = texts.insert(texts.end(), hint);
            kinds[kind].push_back(at - texts.begin());
        }
    return {{"texts", texts}, {"kinds", kinds}};
}

}  // namespace

void ProbeTables::add(const Probe& probe, const Table& results) {
    if (probe.bound.absolute > no_bound) return;
    rows_ += static_cast<int>(results.size());
    if (probe.grants) add_other();  // pages know only the reference
    Json one = {
        {"signature", probe.signature},
        {"text", flatten_text(probe.before + "#include \"" + probe.include + "\"\n", "probe", "99", probe.macros).text},
        {"bound", {probe.bound.absolute, probe.bound.relative, probe.bound.ulps}},
        {"inputs", Json::array()},
        {"truth", Json::array()}};
    const std::vector<size_t> rows = kept_rows(probe.inputs.size());
    for (const size_t row : rows) {
        const Row truth = probe.truth(probe.inputs[row]);
        one["inputs"].push_back(numbers(probe.inputs[row]));
        one["truth"].push_back(numbers(truth));
        if (!probe.words) continue;
        one["calls"].push_back(call_text(probe, probe.inputs[row]));
        one["expected"].push_back(result_text(probe, truth));
    }
    if (probe.hint) one["hints"] = hints_of(probe, rows);
    probes_.push_back(std::move(one));
}

Json ProbeTables::json(const ExerciseCheck& exercise, const Check& check) const {
    return {{"exercise", exercise.id},
            {"hint", exercise.hint},
            {"others", check.passed + check.failed - check.properties - rows_ + others_},
            {"probes", probes_}};
}

void write_tables(const ExerciseCheck& exercise, const std::string& folder) {
    ProbeTables tables(exercise.id);
    const Check check = run_check(exercise, true, &tables);
    if (check.failed) throw Failure("the reference of " + exercise.id + " fails its check: " + check.first_failure);
    const Json json = tables.json(exercise, check);
    if (json["probes"].empty()) return;
    std::filesystem::create_directories(folder);
    write_file(folder + "/" + exercise.id + ".json", json.dump() + "\n");
}

void write_undefined(const std::string& folder) {
    Json words = Json::array();
    for (int what = 1; what < 104; ++what)
        if (const std::string text = undefined_template(what); !text.empty())
            words.push_back({what, text, counts_always(what)});
    Json results = Json::array();
    for (const float value : undefined_results) results.push_back(number(static_cast<double>(value)));
    std::filesystem::create_directories(folder);
    write_file(folder + "/undefined.json",
               Json{{"glsl", undefined_glsl()}, {"words", words}, {"results", results}}.dump() + "\n");
}

}  // namespace lightwalk
