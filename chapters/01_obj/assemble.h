// Pieces of OBJ text as a reader collects them, and their assembly into one ObjData.
#pragma once
#include <atomic>
#include <span>
#include <string>
#include <vector>

#include "01_obj/obj.h"
#include "common/base/sanitized.h"

namespace lightwalk {

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

}  // namespace lightwalk
