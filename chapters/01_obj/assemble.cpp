#include <cstring>
#include <ctime>
#include <map>

#include "01_obj/exercises.h"
#include "01_obj/scan.h"
#include "common/base/error.h"

namespace lightwalk {
namespace {

// Names are few; each kind keeps them in order of first use.
class Interner {
  public:
    explicit Interner(std::vector<std::string>& names) : names_(names) {}
    uint32_t operator()(const std::string& name) {
        const auto [it, is_new] = index_.try_emplace(name, static_cast<uint32_t>(names_.size()));
        if (is_new) names_.push_back(name);
        return it->second;
    }

  private:
    std::vector<std::string>& names_;
    std::map<std::string, uint32_t> index_;
};

// Where a piece's share of the result begins.
struct Base {
    size_t positions = 0, uvs = 0, normals = 0, triangles = 0;
};

size_t triangle_count(const Piece& p) { return (p.end.corners - p.begin.corners) - 2 * (p.end.sizes - p.begin.sizes); }

void copy_floats(const std::vector<float>& from, size_t begin, size_t end, std::vector<float>& to, size_t at) {
    if (end > begin) std::memcpy(to.data() + at, from.data() + begin, (end - begin) * sizeof(float));
}

void take_elements(Collected& from, ObjData& data) {
    data.positions = std::move(from.positions);
    data.uvs = std::move(from.uvs);
    data.normals = std::move(from.normals);
}

void copy_elements(std::span<const Piece> pieces, std::span<const Base> bases, unsigned threads, ObjData& data) {
    const Base& total = bases.back();
    data.positions.resize(3 * total.positions);
    data.uvs.resize(2 * total.uvs);
    data.normals.resize(3 * total.normals);
    // A round of its own, because a face may use any position. Few bytes are copied before a thread has started.
    const size_t floats = data.positions.size() + data.uvs.size() + data.normals.size();
    on_threads(floats < (1 << 21) ? 1 : threads, pieces.size(), [&](unsigned, size_t i) {
        const Piece& p = pieces[i];
        copy_floats(p.from->positions, p.begin.positions, p.end.positions, data.positions, 3 * bases[i].positions);
        copy_floats(p.from->uvs, p.begin.uvs, p.end.uvs, data.uvs, 2 * bases[i].uvs);
        copy_floats(p.from->normals, p.begin.normals, p.end.normals, data.normals, 3 * bases[i].normals);
    });
}

// False if the index is out of range. Makes a relative index absolute; `base` counts the elements before the piece.
bool resolve(uint32_t& index, size_t base, size_t count) {
    if (index < count) return true;
    if (!is_relative(index)) return false;
    index += static_cast<uint32_t>(base) - relative_bias;
    return index < count;
}

// A uv or a normal past the end is left out.
bool resolve_optional(uint32_t& index, size_t base, size_t count, bool& absent) {
    if (index == none || resolve(index, base, count)) return true;
    if (index > static_cast<uint32_t>(largest_index)) return false;
    absent = true;
    index = none;
    return true;
}

bool resolve(Corner& corner, const Base& base, const ObjData& data, bool& absent) {
    return resolve(corner.position, base.positions, data.positions.size() / 3) &&
           resolve_optional(corner.uv, base.uvs, data.uvs.size() / 2, absent) &&
           resolve_optional(corner.normal, base.normals, data.normals.size() / 3, absent);
}

// `from`: the piece's corners, of which triangles may lie where they are written.
bool cut_piece(const Piece& piece, const Corner* from, const Base& base, Triangulate cut, CuttingTime& time,
               ObjData& data, bool& absent) {
    Corner* out = data.corners.data() + 3 * base.triangles;
    std::vector<Corner> large;
    for (size_t i = piece.begin.sizes; i < piece.end.sizes; ++i) {
        const size_t count = piece.from->sizes[i];
        Corner small[4];
        Corner* polygon = small;
        if (count > 4) {
            large.resize(count);
            polygon = large.data();
        }
        for (size_t k = 0; k < count; ++k) {
            polygon[k] = from[k];
            if (!resolve(polygon[k], base, data, absent)) return false;
        }
        const auto at = [&](size_t k) { return data.positions.data() + 3 * size_t{polygon[k].position}; };
        if (count == 3) {
            std::copy_n(polygon, 3, out);
        } else if (count == 4 && surely_convex(at(0), at(1), at(2), at(3))) {
            out[0] = polygon[0];
            out[1] = polygon[1];
            out[2] = polygon[2];
            out[3] = polygon[0];
            out[4] = polygon[2];
            out[5] = polygon[3];
        } else {
            time.count(count, [&] { cut_polygon(cut, polygon, count, data.positions, out); });
        }
        from += count;
        out += 3 * (count - 2);
    }
    return true;
}

// A piece counts positions from where its share of a Collected begins.
void add_colors(std::span<const Piece> pieces, std::span<const Base> bases, ObjData& data) {
    for (size_t i = 0; i < pieces.size(); ++i)
        for (size_t k = pieces[i].begin.colors; k < pieces[i].end.colors; ++k) {
            ColoredPosition one = pieces[i].from->colors[k];
            one.position += static_cast<uint32_t>(bases[i].positions - pieces[i].begin.positions / 3);
            data.colors.push_back(one);
        }
}

// Name lines take effect at the next face, so a run starts where the first face after them does.
void collect_runs(std::span<const Piece> pieces, std::span<const Base> bases, ObjData& data) {
    Interner object(data.objects), group(data.groups), material(data.materials);
    Run run;
    data.runs = {run};
    for (size_t i = 0; i < pieces.size(); ++i) {
        const Piece& piece = pieces[i];
        size_t polygon = 0, triangle = bases[i].triangles;
        for (const NameLine& line : piece.names) {
            for (; polygon < line.polygon; ++polygon) triangle += piece.from->sizes[piece.begin.sizes + polygon] - 2;
            switch (line.kind) {
                case NameLine::object:
                    run.object = object(line.name);
                    break;
                case NameLine::group:
                    run.group = group(line.name);
                    break;
                case NameLine::material:
                    run.material = material(line.name);
                    break;
                case NameLine::smoothing:
                    run.smoothing = smoothing_group(line.name);
                    break;
                case NameLine::left_out:
                    if (std::find(data.left_out.begin(), data.left_out.end(), line.name) == data.left_out.end())
                        data.left_out.push_back(line.name);
                    continue;
                case NameLine::library:
                    data.libraries.push_back(line.name);
                    continue;
            }
            run.first_triangle = static_cast<uint32_t>(triangle);
            add_run(data.runs, run);
        }
    }
    // Name lines after the last face name nothing.
    while (data.runs.size() > 1 && data.runs.back().first_triangle >= data.triangles()) data.runs.pop_back();
}

}  // namespace

Piece::Mark mark(const Collected& c) {
    return {c.positions.size(), c.uvs.size(), c.normals.size(), c.corners.size(), c.sizes.size(), c.colors.size()};
}

void add_run(std::vector<Run>& runs, const Run& run) {
    if (!runs.empty() && runs.back().first_triangle == run.first_triangle) runs.pop_back();
    Run previous = runs.empty() ? Run() : runs.back();
    previous.first_triangle = run.first_triangle;
    if (runs.empty() || !(previous == run)) runs.push_back(run);
}

bool surely_convex(const float* a, const float* b, const float* c, const float* d) {
    // With the edges e from a, twice the area of triangle a p q, seen along the polygon's normal n, is (e_p x e_q).n.
    // The quadrilateral is convex where all four triangles of its corners are wound as it is. The margin leaves
    // doubtful ones, and overflow and NaN, to the exercise.
    const glm::vec3 origin(a[0], a[1], a[2]);
    const glm::vec3 e1 = glm::vec3(b[0], b[1], b[2]) - origin;
    const glm::vec3 e2 = glm::vec3(c[0], c[1], c[2]) - origin;
    const glm::vec3 e3 = glm::vec3(d[0], d[1], d[2]) - origin;
    const glm::vec3 abc = glm::cross(e1, e2), acd = glm::cross(e2, e3), abd = glm::cross(e1, e3);
    const glm::vec3 n = abc + acd;
    const float area_abc = glm::dot(abc, n), area_acd = glm::dot(acd, n), area_abd = glm::dot(abd, n);
    const float area_bcd = area_abc + area_acd - area_abd;
    const float margin = 1e-3f * glm::dot(n, n);
    return margin > 1e-30f && area_abc > margin && area_acd > margin && area_abd > margin && area_bcd > margin &&
           area_abc < 1e30f;
}

void cut_polygon(Triangulate cut, const Corner* polygon, size_t count, const std::vector<float>& positions,
                 Corner* out) {
    std::vector<glm::vec3> points(count);
    for (size_t k = 0; k < count; ++k)
        std::memcpy(&points[k], positions.data() + 3 * size_t{polygon[k].position}, sizeof(glm::vec3));
    const std::vector<glm::uvec3> triangles = cut(points);
    if (triangles.size() != count - 2)
        throw Failure("triangulate returned {} triangles for a polygon with {} corners, expected {}", triangles.size(),
                      count, count - 2);
    for (const glm::uvec3& triangle : triangles)
        for (int k = 0; k < 3; ++k) {
            if (triangle[k] >= count)
                throw Failure("triangulate returned corner {} of a polygon with {} corners", triangle[k], count);
            *out++ = polygon[triangle[k]];
        }
}

double CuttingTime::now_s() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void CuttingTime::add(double seconds, size_t corners) {
    if ((taken_s_ += seconds) > most_s_)
        throw InputError("{}: cutting its polygons into triangles takes more than {} s; one has {} corners", file_,
                         most_s_, corners);
}

bool assemble(std::span<const Piece> pieces, unsigned threads, const std::string& name, ObjData& data, bool& absent) {
    std::vector<Base> bases(pieces.size() + 1);
    for (size_t i = 0; i < pieces.size(); ++i) {
        const Piece& p = pieces[i];
        bases[i + 1] = {bases[i].positions + (p.end.positions - p.begin.positions) / 3,
                        bases[i].uvs + (p.end.uvs - p.begin.uvs) / 2,
                        bases[i].normals + (p.end.normals - p.begin.normals) / 3,
                        bases[i].triangles + triangle_count(p)};
    }
    const Base& total = bases.back();
    if (std::max({total.positions, total.uvs, total.normals, total.triangles}) > static_cast<size_t>(largest_index))
        return false;
    Collected& first = *pieces.front().from;
    const bool alone = pieces.size() == 1, are_triangles = alone && first.corners.size() == 3 * total.triangles;
    if (alone)
        take_elements(first, data);
    else
        copy_elements(pieces, bases, threads, data);
    if (are_triangles)
        data.corners = std::move(first.corners);
    else
        data.corners.resize(3 * total.triangles);
    const Triangulate cut = triangulate.function();  // the toggle is not for several threads
    std::atomic<bool> in_range = true, any_absent = false;
    CuttingTime time(name);
    on_threads(threads, pieces.size(), [&](unsigned, size_t i) {
        bool here = false;
        const Corner* corners = are_triangles ? data.corners.data() : pieces[i].from->corners.data();
        corners += pieces[i].begin.corners;
        if (in_range && !cut_piece(pieces[i], corners, bases[i], cut, time, data, here)) in_range = false;
        if (here) any_absent = true;
    });
    absent = any_absent;
    if (in_range) {
        collect_runs(pieces, bases, data);
        add_colors(pieces, bases, data);
    }
    return in_range;
}

}  // namespace lightwalk
