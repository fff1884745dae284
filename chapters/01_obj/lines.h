// Lexical layer shared by OBJ and MTL: statements, words, and their positions in the file.
#pragma once
#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "common/base/error.h"

namespace lightwalk {

/// Space within a line. A carriage return counts, so that CRLF files need no other care.
inline bool is_space(char c) {
    constexpr uint64_t spaces = 1ull << ' ' | 1ull << '\t' | 1ull << '\r' | 1ull << '\v' | 1ull << '\f';
    const auto code = static_cast<unsigned char>(c);
    return code <= ' ' && (spaces >> code & 1) != 0;
}

inline std::string_view trim(std::string_view text) {
    while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
    return text;
}

/// Without the mark that some editors put before UTF-8.
inline std::string_view without_mark(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    return text;
}

/// Takes the next word off `rest`; empty at the end.
inline std::string_view next_word(std::string_view& rest) {
    size_t begin = 0, end;
    while (begin < rest.size() && is_space(rest[begin])) ++begin;
    for (end = begin; end < rest.size() && !is_space(rest[end]);) ++end;
    const std::string_view word = rest.substr(begin, end - begin);
    rest.remove_prefix(end);
    return word;
}

/// As next_word, but a word that starts with # ends the line: numbers and faces may be followed by a comment.
inline std::string_view next_value(std::string_view& rest) {
    const std::string_view word = next_word(rest);
    return word.starts_with('#') ? std::string_view() : word;
}

/// Of a decimal number without its sign, out of a float's range: whether it is too small rather than too large, as the
/// power of ten of its first digit other than 0 says.
inline bool underflows(std::string_view number) {
    const size_t e = number.find_first_of("eE");
    const std::string_view digits = number.substr(0, e);
    const size_t first = digits.find_first_of("123456789");
    if (first == digits.npos) return true;
    const size_t point = std::min(digits.find('.'), digits.size());
    int64_t exponent = 0;
    if (e != number.npos) {
        const bool negative = number[e + 1] == '-';
        const char* begin = number.data() + e + 1 + (number[e + 1] == '-' || number[e + 1] == '+');
        if (std::from_chars(begin, number.data() + number.size(), exponent).ec != std::errc()) return negative;
        if (negative) exponent = -exponent;
    }
    return exponent < (first < point ? -static_cast<int64_t>(point - first) : static_cast<int64_t>(first - point));
}

/// A piece of input for a message: printable, quoted, short.
inline std::string shown(std::string_view text) {
    std::string out = "'";
    for (const char c : text.substr(0, 40)) out += c >= 32 && c < 127 ? c : '?';
    return out + (text.size() > 40 ? "...'" : "'");
}

/// Walks over the statements of a text: lines, without blank ones and comments. A backslash at the end of a line joins
/// the next one to it (but not in a comment, where it is just the end of somebody's Windows path).
class Statements {
  public:
    explicit Statements(std::string_view text) : rest_(text) {}

    /// False at the end. The statement is trimmed and valid until the next call.
    bool next(std::string_view& statement) {
        while (!rest_.empty()) {
            line_ = next_line_;
            statement = trim(take_line());
            if (statement.starts_with('#')) continue;
            if (statement.ends_with('\\')) {
                joined_.clear();
                for (; statement.ends_with('\\'); statement = trim(take_line()))
                    joined_.append(statement.substr(0, statement.size() - 1)) += ' ';
                joined_ += statement;
                statement = trim(joined_);
            }
            if (!statement.empty()) return true;
        }
        return false;
    }

    /// Of the last statement's first line, from 1.
    size_t line() const { return line_; }
    std::string_view rest() const { return rest_; }

  private:
    std::string_view take_line() {
        const size_t end = rest_.find('\n');
        const std::string_view line = rest_.substr(0, end);
        rest_.remove_prefix(end == rest_.npos ? rest_.size() : end + 1);
        ++next_line_;
        return line;
    }

    std::string_view rest_;
    std::string joined_;
    size_t line_ = 0, next_line_ = 1;
};

/// Throws InputError where a text's lines end in carriage returns alone, as on a Mac before 2001: it would be one line.
inline void check_line_ends(std::string_view text, const std::string& name) {
    if (text.find('\n') == text.npos && trim(text).find('\r') != text.npos)
        throw InputError("{}:1: its lines end in CR alone, expected LF or CR LF", name);
}

[[noreturn]] inline void fail_at(const std::string& file, size_t line, const std::string& reason) {
    throw InputError("{}:{}: {}", file, line, reason);
}

}  // namespace lightwalk
