#include "common/scene/json_lines.h"

#include <algorithm>

#include "common/base/error.h"

namespace lightwalk {
namespace {

using nlohmann::json;

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

class LineReader : public json::json_sax_t {
  public:
    LineReader(const std::string& text, JsonWithLines& result, const int& line)
        : text_(text), result_(result), line_(line) {}

    bool null() override { return next(); }
    bool boolean(bool) override { return next(); }
    bool number_integer(json::number_integer_t) override { return next(); }
    bool number_unsigned(json::number_unsigned_t) override { return next(); }
    bool number_float(json::number_float_t, const json::string_t&) override { return next(); }
    bool string(json::string_t&) override {
        note();
        return next();
    }
    bool binary(json::binary_t&) override { return next(); }
    bool start_object(std::size_t) override { return open(false); }
    bool start_array(std::size_t) override { return open(true); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }
    bool key(json::string_t& name) override {
        Level& level = levels_.back();
        pointer_.resize(level.end);
        pointer_ += "/" + pointer_step(name);
        if (!add_line()) throw InputError("{}:{}: key '{}' stands twice", result_.file, line_, name);
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
        size_t end;
    };
    static constexpr size_t most_pointer_bytes = size_t{256} << 20;

    bool add_line() {
        pointer_bytes_ += pointer_.size() + sizeof(std::pair<std::string, int>);
        if (pointer_bytes_ > most_pointer_bytes)
            throw InputError("{}:{}: too large: the names of its values take more than {} MiB", result_.file, line_,
                             most_pointer_bytes >> 20);
        return result_.lines.emplace(pointer_, line_).second;
    }
    void note() {
        if (levels_.empty()) add_line();
        if (levels_.empty() || !levels_.back().array) return;
        pointer_.resize(levels_.back().end);
        pointer_ += "/" + std::to_string(levels_.back().index);
        add_line();
    }
    bool next() {
        if (!levels_.empty() && levels_.back().array) ++levels_.back().index;
        return true;
    }
    bool open(bool array) {
        note();
        if (levels_.size() > 64) throw InputError("{}:{}: nested too deep, at most 64 levels", result_.file, line_);
        levels_.push_back({array, 0, pointer_.size()});
        return true;
    }
    bool close() {
        levels_.pop_back();
        pointer_.resize(levels_.empty() ? 0 : levels_.back().end);
        return next();
    }
    const std::string& text_;
    JsonWithLines& result_;
    const int& line_;
    std::vector<Level> levels_;
    std::string pointer_;
    size_t pointer_bytes_ = 0;
};

std::string unescaped(std::string step) {
    for (const auto& [from, to] : {std::pair("~1", "/"), std::pair("~0", "~")})
        for (size_t at = 0; (at = step.find(from, at)) != step.npos; ++at) step.replace(at, 2, to);
    return step;
}

}  // namespace

std::string JsonWithLines::where(const std::string& pointer) const {
    for (std::string at = pointer;; at.resize(at.rfind('/'))) {
        const auto it = lines.find(at);
        if (it != lines.end() || at.empty()) {
            const int line = it != lines.end() ? it->second : 1;
            const std::string key = unescaped(pointer.substr(pointer.rfind('/') + 1));
            return fmt::format("{}:{}:{}", file, line, key.empty() ? "" : " key '" + key + "'");
        }
    }
}

std::string pointer_step(std::string_view key) {
    std::string step;
    for (const char c : key) step += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
    return step;
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
