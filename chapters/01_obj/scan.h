// OBJ scanner: parses statements in place, in one pass without copies, streams or a locale.
#pragma once
#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

#include "01_obj/obj.h"
#include "common/base/sanitized.h"

namespace lightwalk {

// All throw InputError with file, line and reason; `name` is the file in messages.
ObjData parse_textbook(std::string_view text, const std::string& name);
ObjData parse_scan(std::string_view text, const std::string& name);
/// `text` must be followed by at least 64 readable zero bytes.
ObjData parse_parallel(std::string_view text, const std::string& name, ParseOptions options);
/// How parse_parallel() cuts a text: two chunks for each thread, but a single one where threads take no less time.
size_t chunk_bytes_for(size_t text_bytes, unsigned threads);
/// parse_tinyobjloader() or parse_assimp() in a guarded process, with its result checked.
ObjData parse_guarded(std::string_view text, const std::string& name, Loader loader);
/// Without objects and groups, which it does not tell apart; splits a quadrilateral along its shorter diagonal.
ObjData parse_tinyobjloader(std::string_view text, const std::string& name);
/// Positions, uvs and normals are Assimp's joined vertices, so the three indices of a corner are equal.
ObjData parse_assimp(std::string_view text, const std::string& name);

/// Runs job(thread, i) once for every i below `count`; each of up to `threads` threads, the caller's among them, takes the
/// next i that nobody has. Fewer where the system has no more. Rethrows the exception of one job that threw; the rest is
/// then left undone.
template <class Job>
void on_threads(unsigned threads, size_t count, const Job& job) {
    std::atomic<size_t> next = 0;
    std::mutex mutex;
    std::exception_ptr failure;
    const auto take_jobs = [&](unsigned thread) {
        try {
            for (size_t i; (i = next++) < count;) job(thread, i);
        } catch (...) {
            next = count;
            const std::lock_guard lock(mutex);
            failure = std::current_exception();
        }
    };
    {
        std::vector<std::jthread> others;
        try {
            for (unsigned thread = 1; thread < std::min<size_t>(threads, count); ++thread)
                others.emplace_back(take_jobs, thread);
        } catch (const std::system_error&) {}
        take_jobs(0);
    }
    if (failure) std::rethrow_exception(failure);
}

/// `o`, `g`, `usemtl`, `mtllib` or `s`, or a statement that is left out, with the number of polygons of its piece that stand before it.
struct NameLine {
    enum Kind { object, group, material, library, smoothing, left_out } kind;
    size_t polygon;
    std::string name;
};

/// The result of one thread. Indices counted from the end stay relative to the start of the piece until earlier
/// pieces are counted: see relative_index.
struct Collected {
    std::vector<float> positions, uvs, normals;
    std::vector<ColoredPosition> colors;  ///< by number within this Collected
    std::vector<Corner> corners;          ///< of polygons, one after the other
    std::vector<uint32_t> sizes;          ///< corners of each polygon
};

/// One stretch of the file: where its share of a Collected begins and ends, and its name lines.
struct Piece {
    Collected* from = nullptr;
    struct Mark {
        size_t positions = 0, uvs = 0, normals = 0, corners = 0, sizes = 0, colors = 0;
    } begin, end;
    std::vector<NameLine> names;
};
Piece::Mark mark(const Collected& collected);

/// Indices are below 2^30, so that the upper half can hold piece-relative ones, down to -2^30.
inline constexpr int64_t largest_index = (int64_t{1} << 30) - 1;
inline constexpr uint32_t relative_bias = 0xC0000000u;
inline bool is_relative(uint32_t index) { return index >= 0x80000000u && index != none; }
inline uint32_t relative_index(int64_t from_piece_start) {
    return static_cast<uint32_t>(static_cast<int64_t>(relative_bias) + from_piece_start);
}

/// Joins the pieces, in their order, on up to `threads` threads: names, absolute indices, triangles. A single piece's
/// arrays become the result's. Returns false where an index is out of range. A uv or a normal beyond the last one
/// becomes `none`, and `absent` true. Triangles and convex quadrilaterals are cut here, other polygons by the exercise
/// triangulate. Throws InputError where cutting takes more than CuttingTime allows; `name` stands for the file in
/// messages.
bool assemble(std::span<const Piece> pieces, unsigned threads, const std::string& name, ObjData& data, bool& absent);

/// Total time allowed for cutting a file's larger polygons. Spirals have few ears, and a student's version may search
/// for them forever.
class CuttingTime {
  public:
    explicit CuttingTime(const std::string& file, double most_s = 5 * slower) : file_(file), most_s_(most_s) {}

    /// Counts the time that cut() takes for a polygon of so many corners. Throws InputError beyond `most_s`.
    template <class Cut>
    void count(size_t corners, const Cut& cut) {
        if (corners < 64) return cut();  // looking at the clock would take longer
        const double before = now_s();
        cut();
        add(now_s() - before, corners);
    }

  private:
    static double now_s();
    void add(double seconds, size_t corners);
    const std::string& file_;
    const double most_s_;
    std::atomic<double> taken_s_ = 0;
};

/// Appends a run, unless it changes no name, and instead of one that starts at the same triangle.
void add_run(std::vector<Run>& runs, const Run& run);

/// Either version of the exercise triangulate.
using Triangulate = std::vector<glm::uvec3> (*)(std::span<const glm::vec3>);

/// The triangles of one polygon, checked: a student's version must not be able to corrupt memory. Throws Failure where
/// it returns other than `count` - 2 triangles or a corner that does not exist.
void cut_polygon(Triangulate triangulate, const Corner* polygon, size_t count, const std::vector<float>& positions,
                 Corner* out);

/// True where the four positions surely are a convex quadrilateral; false where they are not, or nearly not.
bool surely_convex(const float* a, const float* b, const float* c, const float* d);

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

/// Throws InputError, with the reason alone, unless a keyword that means nothing to us is a word. The format has many
/// statements that the course has no use for, and programs add their own.
void check_keyword(std::string_view keyword);

/// Content of an unsupported statement: "lines", "points", "free-form curves and surfaces", or its keyword; "" where it
/// changes no picture.
std::string_view left_out_of(std::string_view keyword);

/// The number of the group after `s`; 0: off.
uint32_t smoothing_group(std::string_view name);

/// A colour among the numbers of a statement `v`: after x y z, or after x y z w. A colour that is no number (nan, as
/// some programs write) is none. Throws InputError where a position or a weight is no number, and where the count is
/// neither 3, 4, 6 nor 7.
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
