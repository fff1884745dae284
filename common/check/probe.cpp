#include "common/check/probe.h"

#include <bit>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <regex>

#include "common/base/error.h"
#include "common/base/files.h"
#include "common/gpu/frame.h"

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

// How many numbers a built-in type has; 0: a struct, of which nothing is known here.
size_t components(const std::string& type) {
    if (type == "float" || type == "int" || type == "uint" || type == "bool") return 1;
    if (type == "mat3") return 9;
    if (type == "mat4") return 16;
    if (type.find("vec") != type.npos) return static_cast<size_t>(type.back() - '0');
    return 0;
}

bool is_whole(const std::string& type) {
    return type == "int" || type == "uint" || type == "bool" || type[0] == 'i' || (type[0] == 'u' && type != "uint");
}

std::string shader_text(const Probe& probe, const Signature& s) {
    std::string text = "#include \"" + probe.include + "\"\n";
    text += "layout(local_size_x = 64) in;\nstruct ProbeInput {\n";
    for (const Parameter& p : s.parameters) text += "    " + p.type + " " + p.name + ";\n";
    text += "};\nstruct ProbeOutput { " + s.result + " value; };\n";
    text +=
        "layout(scalar) readonly buffer InputBuffer { ProbeInput probe_inputs[]; };\n"
        "layout(scalar) writeonly buffer OutputBuffer { ProbeOutput probe_outputs[]; };\n"
        "void main() {\n"
        "    uint i = gl_GlobalInvocationID.x;\n"
        "    if (i >= probe_inputs.length()) return;\n"
        "    ProbeInput row = probe_inputs[i];\n"
        "    probe_outputs[i].value = " +
        s.function + "(";
    for (size_t i = 0; i < s.parameters.size(); ++i) text += (i ? ", row." : "row.") + s.parameters[i].name;
    return text + ");\n}\n";
}

// The words of a row: whole numbers as such, the rest as floats.
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
            // The members of a struct, which comes last or is the only one, are the rest of the row.
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

Table run_probe(Gpu& gpu, const Probe& probe, size_t outputs) {
    const Signature s = parse(probe.signature);
    const std::vector<uint32_t> words = pack(s, probe.inputs);
    const Pipeline pipeline =
        compute({.shader = "probe of " + s.function, .macros = probe.macros, .source = shader_text(probe, s)});
    const Buffer inputs = gpu.upload("probe inputs", words);
    const Buffer results(gpu.device, {.name = "probe outputs", .bytes = 4 * outputs * probe.inputs.size()});
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
    // For tests/mutate.py: whether what a probe returns has changed at all.
    if (const char* log = std::getenv("LIGHTWALK_PROBE_LOG"))
        std::ofstream(log, std::ios::app)
            << s.function << " "
            << hash_bytes({reinterpret_cast<const char*>(bytes.data()), 4 * outputs * probe.inputs.size()}) << "\n";
    const bool whole = is_whole(s.result);
    Table table(probe.inputs.size(), Row(outputs));
    for (size_t i = 0; i < table.size() * outputs; ++i) {
        uint32_t word = 0;
        std::memcpy(&word, bytes.data() + 4 * i, 4);
        table[i / outputs][i % outputs] =
            whole ? static_cast<double>(static_cast<int32_t>(word)) : static_cast<double>(std::bit_cast<float>(word));
    }
    return table;
}

std::string number_text(double value) {
    if (std::isnan(value)) return "NaN";
    if (std::isinf(value)) return value > 0 ? "infinity" : "-infinity";
    char buffer[32];
    return {buffer, std::to_chars(buffer, buffer + sizeof buffer, static_cast<float>(value)).ptr};
}

namespace {

std::string tuple_text(std::span<const double> values) {
    if (values.size() == 1) return number_text(values[0]);
    std::string text = "(";
    for (size_t i = 0; i < values.size(); ++i) text += (i ? ", " : "") + number_text(values[i]);
    return text + ")";
}

}  // namespace

std::string call_text(const Probe& probe, std::span<const double> row) {
    const Signature s = parse(probe.signature);
    std::string text = s.function + "(";
    size_t at = 0;
    for (size_t i = 0; i < s.parameters.size(); ++i) {
        const Parameter& p = s.parameters[i];
        const size_t count = components(p.type) ? components(p.type) : row.size() - at;
        text += (i ? ", " : "") + p.name + " = " + tuple_text(row.subspan(at, count));
        at += count;
    }
    return text + ")";
}

std::string worst_of(const Probe& probe, const Table& results) {
    double worst = 1.0;
    std::string text;
    for (size_t i = 0; i < results.size(); ++i) {
        const Row truth = probe.truth(probe.inputs[i]);
        for (size_t k = 0; k < truth.size(); ++k) {
            const double got = results[i][k];
            double excess = 0;
            if (std::isfinite(truth[k]) && !std::isfinite(got))
                excess = std::numeric_limits<double>::infinity();
            else if (std::isfinite(truth[k]))
                excess = std::fabs(got - truth[k]) / std::max(probe.bound.allowed(truth[k]), 1e-300);
            else if (!(got == truth[k] || (std::isnan(got) && std::isnan(truth[k]))))
                excess = std::numeric_limits<double>::infinity();
            if (!(excess > worst)) continue;
            worst = excess;
            text = call_text(probe, probe.inputs[i]) + " gave " + tuple_text(results[i]) + ", expected " +
                   tuple_text(truth);
        }
    }
    return text;
}

glm::vec3 Random::direction() {
    const double z = uniform(-1, 1), angle = uniform(0, 2 * 3.14159265358979);
    const double r = std::sqrt(std::max(0.0, 1 - z * z));
    return glm::normalize(glm::vec3(glm::dvec3(r * std::cos(angle), r * std::sin(angle), z)));
}

}  // namespace lightwalk
