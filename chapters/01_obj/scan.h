// OBJ scanner: parses statements in place, in one pass without copies, streams or a locale.
#pragma once
#include <string>
#include <string_view>

#include "01_obj/assemble.h"

namespace lightwalk {

/// Reads one statement at a time into a Collected.
class Scanner {
  public:
    /// Collects into `into`. With `total`, the number of elements in the whole file, an index out of range is an error
    /// at once; without, assemble() finds it.
    Scanner(Collected& into, const Counts* total = nullptr) : out_(into), start_(mark(into)), total_(total) {}

    /// One trimmed statement that is not empty. Throws InputError with the reason alone.
    void statement(std::string_view text);

    /// Everything read since the constructor.
    Piece piece();

    /// How many corners of the faces so far named a uv or a normal that the file does not have. Counted with `total`.
    size_t absent() const { return absent_; }

  private:
    void face(std::string_view rest);
    uint32_t index(std::string_view& word, size_t so_far, size_t total, const char* what);
    uint32_t optional_index(std::string_view& word, size_t so_far, size_t total, const char* what);

    Collected& out_;
    Piece::Mark start_;
    const Counts* total_;
    std::vector<NameLine> names_;
    size_t absent_ = 0;
};

/// Collects a text after which 32 bytes can be read. Throws InputError with the reason alone.
Piece read_lines(std::string_view text, Collected& into);

/// Room for what a text of that size may hold, an estimate. Memory that is not touched costs nothing.
void reserve(Collected& into, size_t text_bytes);

/// The number that a word is. Throws InputError.
float float_or_throw(std::string_view word);

/// Reads `count` numbers at least and `most` at most; returns how many. Throws InputError with the reason alone.
int read_floats(std::string_view rest, int least, int most, float* values, std::string_view usage);

/// Throws InputError, with the reason alone, unless a keyword that means nothing to us is a word. The format has many
/// statements that the course has no use for, and programs add their own.
void check_keyword(std::string_view keyword);

/// Content of an unsupported statement: "lines", "points", "free-form curves and surfaces", or its keyword; "" where it
/// changes no picture.
std::string_view left_out_of(std::string_view keyword);

/// The number of the group after `s`; 0: off.
uint32_t smoothing_group(std::string_view name);

/// A colour among the numbers of a statement `v`: after x y z, or after x y z w. A colour that is no number (nan, as
/// some programs write) is none. Throws InputError as read_floats, and where the count is neither 3, 4, 6 nor 7.
struct VertexLine {
    float position[3];
    bool has_color = false;
    glm::vec3 color{1.0f};
    float fourth = no_fourth;  ///< as ColoredPosition has it
};
VertexLine read_vertex(std::string_view rest);

/// Throws InputError where the text cannot be OBJ: empty, or binary.
void check_is_text(std::string_view text, const std::string& name);

/// How many `v`, `vt` and `vn` statements.
Counts count_elements(std::string_view text);

/// Reads the text again, slowly and checking every index, and throws the first error with its line.
[[noreturn]] void throw_first_error(std::string_view text, const std::string& name);

/// Reads the text again, and warns, once, of the corners that name a uv or a normal which is not there.
void warn_of_absent(std::string_view text, const std::string& name);

}  // namespace lightwalk
