#include "common/check/undefined.h"

#include <vector>

#include "common/check/probe.h"

namespace lightwalk {
namespace {

struct Operation {
    const char* name;
    int operands;
    const char* undefined;  ///< condition on a and b
    const char* words;
};

// GLSL 4.60, chapters 5.9 and 8.1 to 8.5; results for NaN are undefined, too. Entry 0: none; entry 1: an operator.
constexpr Operation operations[] = {
    {"", 0, "", ""},
    {"divide", 2, "b == 0.0", "divides A by 0"},
    {"pow", 2, "a < 0.0 || (a == 0.0 && b <= 0.0)", "takes pow(A, B)"},
    {"mod", 2, "b == 0.0", "takes mod(A, 0)"},
    {"sqrt", 1, "a < 0.0", "takes the square root of A"},
    {"inversesqrt", 1, "a <= 0.0", "takes inversesqrt(A)"},
    {"log", 1, "a <= 0.0", "takes the logarithm of A"},
    {"log2", 1, "a <= 0.0", "takes log2(A)"},
    {"acos", 1, "abs(a) > 1.0", "takes acos(A)"},
    {"asin", 1, "abs(a) > 1.0", "takes asin(A)"},
    {"acosh", 1, "a < 1.0", "takes acosh(A)"},
    {"atanh", 1, "abs(a) >= 1.0", "takes atanh(A)"},
    {"min", 2, "false", "takes the smaller of A and B"},
    {"max", 2, "false", "takes the larger of A and B"},
    {"clamp", 3, "b > c", "takes clamp with a lower limit A above the upper one B"},
    {"smoothstep", 3, "a >= b", "takes smoothstep between A and B, which must be the larger"},
};
enum { normalize_zero = 100, integer_division, outside, atan_zero };

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    for (size_t at = 0; (at = text.find(from, at)) != text.npos; at += to.size()) text.replace(at, from.size(), to);
    return text;
}

std::string defines() {
    std::string text = "#define normalize undefined_normalize\n#define atan undefined_atan\n";
    for (const Operation& op : operations)
        if (op.operands && std::string(op.name) != "divide")
            text += "#define " + std::string(op.name) + " undefined_" + op.name + "\n";
    return text;
}

}  // namespace

std::string undefined_glsl() {  // NOLINT(readability-function-cognitive-complexity): a loop for each operation and type
    std::string text =
        "float undefined_result = 0.0, undefined_a, undefined_b;\nint undefined_what = 0;\n"
        "bool undefined_nan(float a) { return (floatBitsToUint(a) & 0x7fffffffu) > 0x7f800000u; }\n"
        "float undefined_note(int what, float a, float b) {\n"
        "    if (undefined_what == 0) { undefined_what = what; undefined_a = a; undefined_b = b; }\n"
        "    return undefined_result;\n}\n";
    const std::string axes = "xyzw";
    int number = 0;
    for (const Operation& op : operations) {
        const int what = number++;
        if (op.operands == 0) continue;
        const std::string name = "undefined_" + std::string(op.name);
        const bool divide = std::string(op.name) == "divide";
        const std::string names[] = {"a", "b", "c"};
        // Operand types: equal, or one of them float.
        const auto overload = [&](const std::string& result, const std::vector<std::string>& types) {
            std::string head, call, body;
            for (size_t i = 0; i < types.size(); ++i) {
                head += (i ? ", " : "") + types[i] + " " + names[i];
                call += (i ? ", " : "") + names[i];
            }
            text += result + " " + name + "(" + head + ") { return ";
            if (result == "float") {
                const std::string noted = std::string(op.name) == "clamp" ? "b, c"
                                          : types.size() > 1              ? "a, b"
                                                                          : "a, 0.0";
                std::string open = op.undefined;
                for (size_t i = 0; i < types.size(); ++i) open += " || undefined_nan(" + names[i] + ")";
                text += "(" + open + ") ? undefined_note(" + std::to_string(what) + ", " + noted +
                        ") : " + (divide ? "a / b" : std::string(op.name) + "(" + call + ")") + "; }\n";
                return;
            }
            for (size_t k = 0; k < static_cast<size_t>(result.back() - '0'); ++k) {
                body += std::string(k ? ", " : "") + name + "(";
                for (size_t i = 0; i < types.size(); ++i)
                    body += (i ? ", " : "") + names[i] + (types[i] == "float" ? "" : std::string(".") + axes[k]);
                body += ")";
            }
            text += result + "(" + body + "); }\n";
        };
        const size_t count = static_cast<size_t>(op.operands);
        overload("float", std::vector<std::string>(count, "float"));
        for (const std::string vector : {"vec2", "vec3", "vec4"}) {
            overload(vector, std::vector<std::string>(count, vector));
            if (divide || std::string("mod min max").find(op.name) != std::string::npos)
                overload(vector, {vector, "float"});
            if (divide) overload(vector, {"float", vector});
            if (std::string(op.name) == "clamp") overload(vector, {vector, "float", "float"});
            if (std::string(op.name) == "smoothstep") overload(vector, {"float", "float", vector});
        }
    }
    const auto noted = [](int what) { return "undefined_note(" + std::to_string(what) + ", "; };
    for (const std::string integer : {"int", "uint"}) {
        for (const auto& [name, sign] : {std::pair("divide", "/"), std::pair("remainder", "%")}) {
            const std::string head = std::string("undefined_") + name + "(";
            text += integer + " " + head + integer + " a, " + integer + " b) { return b == " + integer + "(0) ? " +
                    integer + "(" + noted(integer_division) + "float(a), 0.0)) : a " + sign + " b; }\n";
            for (const std::string size : {"2", "3", "4"}) {
                const std::string vector = (integer == "int" ? "ivec" : "uvec") + size;
                for (const bool scalar : {false, true}) {
                    text += vector + " " + head + vector + " a, " + (scalar ? integer : vector) + " b) { return " +
                            vector + "(";
                    for (size_t k = 0; k < static_cast<size_t>(size[0] - '0'); ++k)
                        text += std::string(k ? ", " : "") + head + "a." + axes[k] + ", b" +
                                (scalar ? "" : std::string(".") + axes[k]) + ")";
                    text += "); }\n";
                }
            }
        }
        text += "int undefined_index(" + integer + " i, int count) { return int(i) < 0 || int(i) >= count ? int(" +
                noted(outside) + "float(i), float(count))) * 0 : int(i); }\n";
        for (const std::string size : {"", "2", "3", "4"}) {
            const std::string vector = size.empty() ? integer : (integer == "int" ? "ivec" : "uvec") + size;
            const std::string two = "(" + vector + " a, " + vector + " b", three = two + ", " + vector + " c";
            text += vector + " undefined_clamp" + three + ") { return clamp(a, b, c); }\n";
            for (const std::string name : {"min", "max"})
                text += vector + " undefined_" + name + two + ") { return " + name + "(a, b); }\n";
        }
    }
    for (const std::string size : {"2", "3", "4"}) {
        const std::string vector = "vec" + size, matrix = "mat" + size;
        text += vector + " undefined_normalize(" + vector + " v) { return v == " + vector + "(0.0) ? " + vector + "(" +
                noted(normalize_zero) + "0.0, 0.0)) : normalize(v); }\n" + matrix + " undefined_divide(" + matrix +
                " m, float d) { return m * undefined_divide(1.0, d); }\n" + vector + " undefined_atan(" + vector +
                " a) { return atan(a); }\n";
    }
    return text + "float undefined_normalize(float v) { return v == 0.0 ? " + noted(normalize_zero) +
           "0.0, 0.0) : normalize(v); }\nfloat undefined_atan(float a) { return atan(a); }\n"
           "float undefined_atan(float y, float x) { return y == 0.0 && x == 0.0 ? " +
           noted(atan_zero) + "0.0, 0.0) : atan(y, x); }\n" + defines();
}

bool counts_always(int what) { return what == outside; }

std::string undefined_template(int what) {
    if (what == normalize_zero) return "normalizes a vector of length 0";
    if (what == integer_division) return "divides the integer A by 0";
    if (what == outside) return "takes element A of B";
    if (what == atan_zero) return "takes atan(0, 0)";
    return what < int(std::size(operations)) ? operations[static_cast<size_t>(what)].words : "";
}

std::string undefined_words(int what, double a, double b) {
    return replaced(replaced(undefined_template(what), "B", number_text(b)), "A", number_text(a));
}

}  // namespace lightwalk
