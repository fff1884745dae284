#include "common/check/undefined.h"

#include <cctype>
#include <vector>

#include "common/base/error.h"
#include "common/check/probe.h"

namespace lightwalk {
namespace {

struct Operation {
    const char* name;       ///< the function's in GLSL
    int operands;           ///< of each component
    const char* undefined;  ///< condition on a and b
    const char* words;      ///< with A and B for the operands
};

// GLSL 4.60, chapters 5.9 and 8.1 to 8.5; what any of them makes of a NaN is open too. The first stands for none, the
// second is an operator.
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

struct Token {
    std::string text;
    std::string space;  ///< before it
};

bool is_word(const std::string& text) {
    return !text.empty() && (std::isalnum(static_cast<unsigned char>(text[0])) || text[0] == '_' ||
                             (text[0] == '.' && text.size() > 1 && std::isdigit(static_cast<unsigned char>(text[1]))));
}

// Words, numbers and operators; comments, line ends and directives are space.
std::vector<Token> tokens_of(const std::string& glsl) {
    std::vector<Token> tokens;
    std::string space;
    bool line_start = true;
    for (size_t at = 0; at < glsl.size();) {
        const auto take = [&](size_t end, std::string& into) {
            end = std::min(end, glsl.size());
            into += glsl.substr(at, end - at);
            at = end;
        };
        const char c = glsl[at];
        const auto digit = [&](size_t i) {
            return i < glsl.size() && std::isdigit(static_cast<unsigned char>(glsl[i]));
        };
        if (c == '\n') {
            take(at + 1, space), line_start = true;
        } else if (std::isspace(static_cast<unsigned char>(c))) {
            take(at + 1, space);
        } else if (c == '#' && line_start) {
            take(glsl.find('\n', at), space);
        } else if (glsl.compare(at, 2, "//") == 0) {
            take(glsl.find('\n', at), space);
        } else if (glsl.compare(at, 2, "/*") == 0) {
            const size_t end = glsl.find("*/", at + 2);
            take(end == glsl.npos ? end : end + 2, space);
        } else {
            line_start = false;
            size_t end = at + 1;
            if (digit(at) || (c == '.' && digit(at + 1))) {
                while (end < glsl.size() &&
                       (std::isalnum(static_cast<unsigned char>(glsl[end])) || glsl[end] == '.' ||
                        ((glsl[end] == '+' || glsl[end] == '-') && std::tolower(glsl[end - 1]) == 'e')))
                    ++end;
            } else if (is_word(std::string(1, c))) {
                while (end < glsl.size() && is_word(std::string(1, glsl[end]))) ++end;
            } else if (end < glsl.size() && glsl[end] == '=' &&
                       std::string("/%*+-<>=!&|^").find(c) != std::string::npos) {
                ++end;
            }
            Token token{.text = "", .space = std::move(space)};
            space.clear();
            take(end, token.text);
            tokens.push_back(std::move(token));
        }
    }
    tokens.push_back({"", space});
    return tokens;
}

class Rewriter {
  public:
    explicit Rewriter(const std::string& glsl) : tokens_(tokens_of(glsl)) {}
    std::string all() { return expression(tokens_.size() - 1) + tokens_.back().space; }

  private:
    // Tokens up to `end`, with each division as a call. `factors` is where the product that is being written begins,
    // `operand` where its last operand does.
    std::string expression(size_t end) {
        std::string out;
        size_t factors = 0, operand = 0;
        bool after_operand = false;
        while (at_ < end) {
            const Token& token = tokens_[at_];
            const std::string& text = token.text;
            if (text == "/" || text == "%") {
                ++at_;
                const std::string right = unary(end);
                after_operand = true;
                if (is_number(right) && right.find_first_of("123456789") != right.npos) {
                    out += token.space + text + right;
                    continue;
                }
                out.insert(factors, text == "/" ? "undefined_divide(" : "undefined_remainder(");
                out += "," + token.space + right + ")";
                operand = factors;
            } else if (text == "/=" || text == "%=") {
                ++at_;
                const std::string left = out.substr(factors), right = expression(end_of_assignment(end));
                out += " = " + std::string(text == "/=" ? "undefined_divide(" : "undefined_remainder(") + left + ", " +
                       right + ")";
                after_operand = false;
            } else if (text == "(" || text == "[" || text == "{") {
                const size_t close = closing(at_);
                if (!after_operand) operand = out.size() + token.space.size();
                if (!after_operand && !product_) factors = operand;
                ++at_;
                std::string inner = expression(close);
                const bool dynamic = text == "[" && after_operand && !is_number(inner) && !declares_;
                if (dynamic) inner = "undefined_index(" + inner + ", " + out.substr(operand) + ".length())";
                out += token.space + text + inner + tokens_[close].space + tokens_[close].text;
                at_ = close + 1;
                after_operand = text != "{";
                if (text == "{") factors = operand = out.size();
            } else if (text == "const" && end + 1 == tokens_.size()) {
                out += token.space;  // a global whose value is a call is no constant
                ++at_;
            } else if (is_word(text)) {
                declares_ = after_operand && !product_;  // a type was before it
                if (!after_operand || declares_) {
                    operand = out.size() + token.space.size();
                    if (!product_) factors = operand;
                }
                out += token.space + text;
                ++at_;
                after_operand = text != "return" && text != "else" && text != "case";
                if (!after_operand) factors = operand = out.size();
            } else {
                out += token.space + text;
                ++at_;
                if (text == ".") {
                    out += tokens_[at_].space + tokens_[at_].text;
                    ++at_;
                    continue;
                }
                after_operand = false;
                if (text != "*") {
                    factors = operand = out.size();
                } else {
                    product_ = true;
                    continue;
                }
            }
            product_ = false;
        }
        return out;
    }

    // One operand with its signs, calls, indices and members.
    std::string unary(size_t end) {
        std::string signs;
        while (at_ < end && std::string("+-!~").find(tokens_[at_].text) != std::string::npos)
            signs += tokens_[at_].space + tokens_[at_].text, ++at_;
        size_t stop = at_;
        const auto open = [&] { return tokens_[stop].text == "(" || tokens_[stop].text == "["; };
        if (stop < end) stop = open() ? closing(stop) + 1 : stop + 1;
        while (stop < end && (open() || tokens_[stop].text == "."))
            stop = open() ? closing(stop) + 1 : std::min(stop + 2, end);
        return signs + expression(stop);
    }

    size_t closing(size_t open) const {
        int depth = 0;
        for (size_t i = open; i + 1 < tokens_.size(); ++i) {
            const std::string& text = tokens_[i].text;
            if (text == "(" || text == "[" || text == "{") ++depth;
            if ((text == ")" || text == "]" || text == "}") && --depth == 0) return i;
        }
        throw Failure("a bracket is not closed");
    }

    size_t end_of_assignment(size_t end) const {
        for (size_t i = at_; i < end; ++i) {
            const std::string& text = tokens_[i].text;
            if (text == ";" || text == ",") return i;
            if (text == "(" || text == "[") i = closing(i);
        }
        return end;
    }

    static bool is_number(const std::string& text) { return text.find_first_not_of(" .0123456789uf") == text.npos; }

    std::vector<Token> tokens_;
    size_t at_ = 0;
    bool declares_ = false, product_ = false;
};

}  // namespace

std::string instrumented(const std::string& glsl) {
    std::string defines;
    for (const Operation& op : operations)
        if (op.operands && std::string(op.name) != "divide")
            defines += "#define " + std::string(op.name) + " undefined_" + op.name + "\n";
    return defines + "#define normalize undefined_normalize\n#define atan undefined_atan\n" + Rewriter(glsl).all();
}

std::string undefined_glsl() {
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
        // The operands' types: all alike, or one of them a float.
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
            text += integer + " " + head + integer + " a, " + integer + " b) { return b == 0 ? " + integer + "(" +
                    noted(integer_division) + "float(a), 0.0)) : a " + sign + " b; }\n";
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
        text += "int undefined_index(" + integer + " i, int count) { return i < 0 || i >= count ? int(" +
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
           noted(atan_zero) + "0.0, 0.0) : atan(y, x); }\n";
}

bool counts_always(int what) { return what == outside; }

std::string undefined_words(int what, double a, double b) {
    if (what == normalize_zero) return "normalizes a vector of length 0";
    if (what == integer_division) return "divides the whole number " + number_text(a) + " by 0";
    if (what == outside) return "takes element " + number_text(a) + " of " + number_text(b);
    if (what == atan_zero) return "takes atan(0, 0)";
    const std::string words = operations[static_cast<size_t>(what)].words;
    return replaced(replaced(words, "B", number_text(b)), "A", number_text(a));
}

}  // namespace lightwalk
