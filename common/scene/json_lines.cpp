#include "common/scene/json_lines.h"

#include <algorithm>

#include "common/base/error.h"

namespace lightwalk {
namespace {

using nlohmann::json;

// An input iterator that counts the lines the parser has consumed.
class CountingIterator {
  public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;
    CountingIterator(const char* at, int* line) : at_(at), line_(line) {}
    reference operator*() const { return *at_; }
    CountingIterator& operator++() {
        if (*at_ == '\n') ++*line_;
        ++at_;
        return *this;
    }
    bool operator==(const CountingIterator& other) const { return at_ == other.at_; }
    bool operator!=(const CountingIterator& other) const { return at_ != other.at_; }

  private:
    const char* at_;
    int* line_;
};

// Notes the line at which each value starts, by its pointer.
class LineReader : public json::json_sax_t {
  public:
    LineReader(const std::string& text, JsonWithLines& result, const int& line)
        : text_(text), result_(result), line_(line) {}

    bool null() override { return value(); }
    bool boolean(bool) override { return value(); }
    bool number_integer(json::number_integer_t) override { return value(); }
    bool number_unsigned(json::number_unsigned_t) override { return value(); }
    bool number_float(json::number_float_t, const json::string_t&) override { return value(); }
    bool string(json::string_t&) override { return value(); }
    bool binary(json::binary_t&) override { return value(); }
    bool start_object(std::size_t) override { return open(false); }
    bool start_array(std::size_t) override { return open(true); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }
    bool key(json::string_t& name) override {
        levels_.back().key = name;
        if (!result_.lines.emplace(pointer(), line_).second)
            throw InputError("{}:{}: key '{}' stands twice", result_.file, line_, name);
        return true;
    }
    bool parse_error(std::size_t position, const std::string&, const json::exception& e) override {
        const size_t end = std::min(position ? position - 1 : 0, text_.size());
        const auto at = 1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(end), '\n');
        std::string why = e.what();
        if (const size_t colon = why.rfind(": "); colon != why.npos)
            why = why.substr(why.find(": ", why.find("column")) + 2);
        throw InputError("{}:{}: not JSON: {}", result_.file, at, why);
    }

  private:
    struct Level {
        bool array;
        size_t index;
        std::string key;
    };
    std::string pointer() const {
        std::string result;
        for (const Level& level : levels_) result += "/" + (level.array ? std::to_string(level.index) : level.key);
        return result;
    }
    void note() {
        if (levels_.empty() || levels_.back().array) result_.lines.emplace(pointer(), line_);
    }
    void next() {
        if (!levels_.empty() && levels_.back().array) ++levels_.back().index;
    }
    bool value() {
        note();
        next();
        return true;
    }
    bool open(bool array) {
        note();
        if (levels_.size() > 64) throw InputError("{}:{}: nested too deep", result_.file, line_);
        levels_.push_back({array, 0, ""});
        return true;
    }
    bool close() {
        levels_.pop_back();
        next();
        return true;
    }
    const std::string& text_;
    JsonWithLines& result_;
    const int& line_;
    std::vector<Level> levels_;
};

}  // namespace

std::string JsonWithLines::where(const std::string& pointer) const {
    for (std::string at = pointer;; at.resize(at.rfind('/'))) {
        const auto it = lines.find(at);
        if (it != lines.end() || at.empty()) {
            const int line = it != lines.end() ? it->second : 1;
            const std::string key = pointer.substr(pointer.rfind('/') + 1);
            return fmt::format("{}:{}:{}", file, line, key.empty() ? "" : " key '" + key + "'");
        }
    }
}

JsonWithLines parse_json(const std::string& text, const std::string& file) {
    JsonWithLines result{.root = {}, .lines = {}, .file = file};
    int line = 1;
    LineReader reader(text, result, line);
    json::sax_parse(CountingIterator(text.data(), &line), CountingIterator(text.data() + text.size(), &line), &reader);
    result.root = json::parse(text);
    return result;
}

}  // namespace lightwalk
