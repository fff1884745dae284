#include <cctype>
#include <regex>
#include <set>
#include <vector>

#include "common/base/error.h"
#include "common/check/undefined.h"

namespace lightwalk {
namespace {

struct Token {
    std::string text;
    std::string space;
};

bool is_word(const std::string& text) {
    return !text.empty() && (std::isalnum(static_cast<unsigned char>(text[0])) || text[0] == '_' ||
                             (text[0] == '.' && text.size() > 1 && std::isdigit(static_cast<unsigned char>(text[1]))));
}

// Words, numbers and operators; comments, line ends and directives count as white space.
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
            take(at + 1, space);
            line_start = true;
        } else if (std::isspace(static_cast<unsigned char>(c))) {
            take(at + 1, space);
        } else if (c == '#' && line_start) {
            size_t end = glsl.find('\n', at);
            while (end != glsl.npos && glsl[end - 1] == '\\') end = glsl.find('\n', end + 1);
            take(end, space);
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
    // Rewrites tokens up to `end`. `factors`: start of the current product; `operand`: start of its last operand.
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
                const bool is_size = declares_;
                std::string inner = expression(close);
                const bool dynamic = text == "[" && after_operand && !is_number(inner) && !is_size;
                if (dynamic) inner = "undefined_index(" + inner + ", " + out.substr(operand) + ".length())";
                out += token.space + text + inner + tokens_[close].space + tokens_[close].text;
                at_ = close + 1;
                after_operand = text != "{";
                if (text == "{") factors = operand = out.size();
            } else if (text == "const" && end + 1 == tokens_.size()) {
                const size_t stop = end_of_statement();
                const bool stays = is_constant(stop);
                out += token.space + (stays ? text : "");
                ++at_;
                if (stays && is_whole(at_)) {  // perhaps the size of an array
                    for (; at_ < stop; ++at_) out += tokens_[at_].space + tokens_[at_].text;
                    after_operand = true;
                }
            } else if (is_word(text)) {
                declares_ = after_operand && !product_;
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

    std::string unary(size_t end) {
        std::string signs;
        while (at_ < end && std::string("+-!~").find(tokens_[at_].text) != std::string::npos) {
            signs += tokens_[at_].space + tokens_[at_].text;
            ++at_;
        }
        size_t stop = at_;
        const auto open = [&] { return tokens_[stop].text == "(" || tokens_[stop].text == "["; };
        if (stop < end) stop = open() ? closing(stop) + 1 : stop + 1;
        while (stop < end && (open() || tokens_[stop].text == "."))
            stop = open() ? closing(stop) + 1 : std::min(stop + 2, end);
        return signs + expression(stop);
    }

    size_t end_of_statement() const {
        size_t stop = at_;
        while (stop + 1 < tokens_.size() && tokens_[stop].text != ";") ++stop;
        return stop;
    }

    bool is_whole(size_t at) const { return tokens_[at].text == "int" || tokens_[at].text == "uint"; }

    // Whether a global stays a constant when its initialiser is instrumented: one that is initialised by a call does not,
    // nor one that names another such.
    bool is_constant(size_t stop) {
        static const std::regex type("float|u?int|bool|[biu]?vec[234]|mat[234](x[234])?");
        bool constant = true;
        for (size_t i = at_ + 1; i < stop; ++i) {
            const std::string &text = tokens_[i].text, &before = tokens_[i - 1].text;
            if (text == "(" && is_word(before) && !std::regex_match(before, type)) constant = false;
            if ((text == "/" || text == "%") && !is_number(tokens_[i + 1].text) && !is_whole(at_ + 1)) constant = false;
            if (not_constant_.count(text)) constant = false;
        }
        for (size_t i = at_ + 1; !constant && i < stop; ++i)
            if (tokens_[i + 1].text == "=" || tokens_[i + 1].text == "[") not_constant_.insert(tokens_[i].text);
        return constant;
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
    std::set<std::string> not_constant_;
    size_t at_ = 0;
    bool declares_ = false, product_ = false;
};

}  // namespace

std::string instrumented(const std::string& glsl) { return Rewriter(glsl).all(); }

}  // namespace lightwalk
