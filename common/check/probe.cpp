#include "common/check/probe.h"

#include <bit>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <regex>

#include "common/base/error.h"
#include "common/base/files.h"
#include "common/check/run_checks.h"
#include "common/check/undefined.h"
#include "common/gpu/frame.h"
#include "common/gpu/glsl.h"

namespace lightwalk {
namespace {

struct Parameter {
    std::string type, name;
};

struct Signature {
    std::string result, function;
    std::vector<Parameter> parameters;
};

Signature parse(const std::string& text) {
    static const std::regex whole(R"(\s*(\w+)\s+(\w+)\s*\((.*)\)\s*)"), one(R"(\s*(\w+)\s+(\w+)\s*(,|$))");
    std::smatch match;
    if (!std::regex_match(text, match, whole)) throw Failure("not a signature: " + text);
    Signature result{.result = match[1], .function = match[2], .parameters = {}};
    const std::string list = match[3];
    for (std::sregex_iterator it(list.begin(), list.end(), one), end; it != end; ++it)
        result.parameters.push_back({(*it)[1], (*it)[2]});
    return result;
}

// Components of a built-in type; 0: struct.
size_t components(const std::string& type) {
    if (type == "float" || type == "int" || type == "uint" || type == "bool") return 1;
    if (type == "mat3") return 9;
    if (type == "mat4") return 16;
    if (type.find("vec") != type.npos) return static_cast<size_t>(type.back() - '0');
    return 0;
}

bool is_whole(const std::string& type) { return type == "bool" || type[0] == 'i' || type[0] == 'u'; }

std::string text_of(const Probe& probe) { return probe.before + "#include \"" + probe.include + "\"\n"; }

std::string shader_text(const Signature& s, const std::string& include, const std::string& output, std::string call) {
    std::string text = include + "layout(local_size_x = 64) in;\nstruct ProbeInput {\n";
    for (const Parameter& p : s.parameters) text += "    " + p.type + " " + p.name + ";\n";
    text += "};\nstruct ProbeOutput { " + output + s.result +
            " value; };\n"
            "layout(scalar) readonly buffer InputBuffer { ProbeInput probe_inputs[]; };\n"
            "layout(scalar) writeonly buffer OutputBuffer { ProbeOutput probe_outputs[]; };\n"
            "void main() {\n"
            "    uint i = gl_GlobalInvocationID.x;\n"
            "    if (i >= probe_inputs.length()) return;\n"
            "    ProbeInput row = probe_inputs[i];\n";
    std::string arguments;
    for (const Parameter& p : s.parameters) arguments += (arguments.empty() ? "row." : ", row.") + p.name;
    call.replace(call.find("CALL"), 4, s.function + "(" + arguments + ")");
    return text + call + "}\n";
}

// Integers are packed as such, other values as floats.
std::vector<uint32_t> pack(const Signature& s, const Table& table) {
    std::vector<uint32_t> words;
    for (const Row& row : table) {
        size_t at = 0;
        const auto put = [&](bool whole) {
            const double value = row[at++];
            words.push_back(whole ? static_cast<uint32_t>(static_cast<int64_t>(value))
                                  : std::bit_cast<uint32_t>(static_cast<float>(value)));
        };
        for (const Parameter& p : s.parameters) {
            // A struct is the last parameter and takes the rest of the row.
            const size_t count = components(p.type) ? components(p.type) : row.size() - at;
            if (at + count > row.size()) throw Failure("a row for " + s.function + " has too few numbers");
            for (size_t i = 0; i < count; ++i) put(components(p.type) && is_whole(p.type));
        }
        if (at != row.size()) throw Failure("a row for " + s.function + " has too many numbers");
    }
    return words;
}

}  // namespace

double Bound::allowed(double truth) const {
    const float near = static_cast<float>(std::fabs(truth));
    const double ulp = std::isfinite(near)
                           ? static_cast<double>(std::nextafter(near, std::numeric_limits<float>::infinity())) -
                                 static_cast<double>(near)
                           : 0.0;
    return std::max({absolute, relative * std::fabs(truth), ulps * ulp});
}

namespace {

std::vector<uint32_t> run(Gpu& gpu, const Probe& probe, const Signature& s, const std::string& source, size_t count) {
    const std::vector<uint32_t> words = pack(s, probe.inputs);
    const Pipeline pipeline = compute({.shader = "probe of " + s.function, .macros = probe.macros, .source = source});
    const Buffer inputs = gpu.upload("probe inputs", words);
    const Buffer results(gpu.device, {.name = "probe outputs", .bytes = 4 * count});
    {
        Frame frame(gpu);
        frame.begin({1, 1}, 0.0f);
        frame.compute(s.function, {.writes = {results}}, [&](Compute& pass) {
            pass.use(pipeline).set("probe_inputs", inputs).set("probe_outputs", results);
            pass.dispatch_threads(glm::uvec2(static_cast<uint32_t>(probe.inputs.size()), 1));
        });
        frame.end();
    }
    const std::vector<std::byte> bytes = gpu.read_back(results);
    std::vector<uint32_t> out(count);
    std::memcpy(out.data(), bytes.data(), 4 * count);
    return out;
}

double number_of(const Signature& s, uint32_t word) {
    if (s.result[0] == 'u') return static_cast<double>(word);
    return is_whole(s.result) ? static_cast<double>(static_cast<int32_t>(word))
                              : static_cast<double>(std::bit_cast<float>(word));
}

}  // namespace

Table run_probe(Gpu& gpu, const Probe& probe, size_t outputs) {
    const Signature s = parse(probe.signature);
    const std::string source = shader_text(s, text_of(probe), "", "    probe_outputs[i].value = CALL;\n");
    const std::vector<uint32_t> words = run(gpu, probe, s, source, outputs * probe.inputs.size());
    Table table(probe.inputs.size(), Row(outputs));
    for (size_t i = 0; i < words.size(); ++i) table[i / outputs][i % outputs] = number_of(s, words[i]);
    return table;
}

std::optional<std::vector<Undefined>> run_undefined(Gpu& gpu, const Probe& probe, size_t outputs) {
    const Signature s = parse(probe.signature);
    const std::string flat = flatten_text(text_of(probe), "probe", "99", probe.macros).text;
    const size_t kinds = std::size(undefined_results), stride = 3 + outputs;
    std::string call = "    float[] results = float[](";
    for (const float value : undefined_results)
        call += (value == undefined_results[0] ? "" : ", ") +
                (std::isnan(value) ? "uintBitsToFloat(0x7fc00000u)"
                                   : "float(" + number_text(static_cast<double>(value)) + ")");
    call +=
        ");\n    for (int k = 0; k < results.length(); ++k) {\n"
        "        undefined_what = 0; undefined_a = undefined_b = 0.0; undefined_result = results[k];\n"
        "        uint at = i * results.length() + k;\n"
        "        probe_outputs[at].value = CALL;\n"
        "        probe_outputs[at].what = undefined_what;\n"
        "        probe_outputs[at].a = undefined_a;\n"
        "        probe_outputs[at].b = undefined_b;\n    }\n";
    std::vector<uint32_t> words;
    try {
        const std::string source = shader_text(s, undefined_glsl() + instrumented(flat.substr(flat.find("#line 1 "))),
                                               "int what; float a, b; ", call);
        words = run(gpu, probe, s, source, stride * kinds * probe.inputs.size());
    } catch (const ShaderError& e) {
        if (check_options().strict) throw;
        return std::nullopt;
    }
    std::vector<Undefined> found;
    for (size_t at = 0; at < words.size(); at += stride) {
        if (words[at] == 0) continue;
        Undefined one{.row = at / stride / kinds,
                      .what = static_cast<int>(words[at]),
                      .a = static_cast<double>(std::bit_cast<float>(words[at + 1])),
                      .b = static_cast<double>(std::bit_cast<float>(words[at + 2])),
                      .result = {}};
        for (size_t k = 0; k < outputs; ++k) one.result.push_back(number_of(s, words[at + 3 + k]));
        found.push_back(std::move(one));
    }
    return found;
}

unsigned check_seed() {
    static const char* const given = std::getenv("LIGHTWALK_CHECK_SEED");
    return given ? static_cast<unsigned>(std::strtoul(given, nullptr, 10)) : 0;
}

namespace {

bool is_integer(double value) { return value == std::trunc(value) && std::fabs(value) < 9e15; }

}  // namespace

std::string number_text(double value) {
    if (std::isnan(value)) return "NaN";
    if (value == 0) return "0";
    if (std::isinf(value)) return value > 0 ? "infinity" : "-infinity";
    char buffer[32];
    // Integers may exceed a float's exact range.
    const auto [end, error] = is_integer(value)
                                  ? std::to_chars(buffer, buffer + sizeof buffer, static_cast<int64_t>(value))
                                  : std::to_chars(buffer, buffer + sizeof buffer, static_cast<float>(value));
    return {buffer, end};
}

std::string gave_text(std::span<const double> got, std::span<const double> expected) {
    const auto text = [](std::span<const double> values, int digits) {
        std::string all;
        for (const double value : values)
            all += (all.empty() ? "" : ", ") + (is_integer(value) || !std::isfinite(value)
                                                    ? number_text(value)
                                                    : fmt::format("{:.{}g}", value, digits));
        return values.size() == 1 ? all : "(" + all + ")";
    };
    int digits = 6;
    const auto are_told_apart = [&] {
        for (size_t i = 0; i < std::min(got.size(), expected.size()); ++i)
            if (got[i] != expected[i] && text(got.subspan(i, 1), digits) == text(expected.subspan(i, 1), digits))
                return false;
        return true;
    };
    while (digits < 17 && !are_told_apart()) ++digits;
    return "gave " + text(got, digits) + ", expected " + text(expected, digits);
}

std::string gave_text(double got, double expected) { return gave_text({&got, 1}, {&expected, 1}); }

namespace {

std::string tuple_text(std::span<const double> values) {
    if (values.size() == 1) return number_text(values[0]);
    std::string text = "(";
    for (size_t i = 0; i < values.size(); ++i) text += (i ? ", " : "") + number_text(values[i]);
    return text + ")";
}

std::string value_text(const Probe& probe, const std::string& name, std::span<const double> values) {
    const std::string words = probe.words ? probe.words(name, values) : "";
    return words.empty() ? tuple_text(values) : words;
}

}  // namespace

std::string result_text(const Probe& probe, std::span<const double> values) { return value_text(probe, "", values); }

std::string call_text(const Probe& probe, std::span<const double> row) {
    const Signature s = parse(probe.signature);
    // A check's own function, which calls the exercise's, has a name that answers may not use (glsl_answer.py).
    std::string text = s.function.substr(s.function.starts_with("check_") ? 6 : 0) + "(";
    size_t at = 0;
    for (size_t i = 0; i < s.parameters.size(); ++i) {
        const Parameter& p = s.parameters[i];
        const size_t count = components(p.type) ? components(p.type) : row.size() - at;
        text += (i ? ", " : "") + p.name + " = " + value_text(probe, p.name, row.subspan(at, count));
        at += count;
    }
    return text + ")";
}

double excess(const Probe& probe, std::span<const double> truth, std::span<const double> got) {
    double worst = 0;
    for (size_t k = 0; k < truth.size(); ++k) {
        double one = std::numeric_limits<double>::infinity();
        if (std::isfinite(truth[k]) && std::isfinite(got[k]))
            one = std::fabs(got[k] - truth[k]) / std::max(probe.bound.allowed(truth[k]), 1e-300);
        else if (got[k] == truth[k] || (std::isnan(got[k]) && std::isnan(truth[k])))
            one = 0;
        worst = std::max(worst, one);
    }
    return worst;
}

bool is_right(const Probe& probe, std::span<const double> input, std::span<const double> got) {
    return excess(probe, probe.truth(input), got) <= 1 || (probe.grants && probe.grants(input, got));
}

std::string wrong_text(const Probe& probe, size_t row, std::span<const double> got) {
    const Row truth = probe.truth(probe.inputs[row]);
    const std::string theirs = result_text(probe, got), right = result_text(probe, truth);
    return call_text(probe, probe.inputs[row]) + " " +
           (theirs == right ? gave_text(got, truth) : "gave " + theirs + ", expected " + right);
}

std::string worst_of(const Probe& probe, const Table& results) {
    double worst = 1.0;
    std::string text;
    for (size_t i = 0; i < results.size(); ++i) {
        const double one = excess(probe, probe.truth(probe.inputs[i]), results[i]);
        if (!(one > worst) || is_right(probe, probe.inputs[i], results[i])) continue;
        worst = one;
        text = wrong_text(probe, i, results[i]);
    }
    return text;
}

glm::vec3 Random::direction() {
    const double z = uniform(-1, 1), angle = uniform(0, 2 * 3.14159265358979);
    const double r = std::sqrt(std::max(0.0, 1 - z * z));
    return glm::normalize(glm::vec3(glm::dvec3(r * std::cos(angle), r * std::sin(angle), z)));
}

}  // namespace lightwalk
