// Probes: a GLSL function run on the device over a table of inputs, and compared with the truth in double precision.
#pragma once
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "common/gpu/gpu.h"

namespace lightwalk {

/// One call's arguments, flattened in the order of the signature: a vec3 is three numbers, a matrix its columns, a
/// struct its members. Integers for int, uint and bool.
using Row = std::vector<double>;
using Table = std::vector<Row>;

/// How far a result may be from the truth: the largest of the three.
struct Bound {
    double absolute = 0;
    double relative = 0;
    double ulps = 0;  ///< units in the last place of the truth as a float
    double allowed(double truth) const;
};

struct Probe {
    std::string include;    ///< "02_lambert_phong/blinn_phong.glsl": the exercise or the solution, by the toggle
    std::string before;     ///< GLSL that stands before it, such as a test's own version of a file that it includes
    std::string signature;  ///< "float blinn_phong(vec3 normal, vec3 to_light, vec3 to_eye, float shininess)"
    Table inputs;
    std::function<Row(std::span<const double>)> truth;  ///< inputs exactly as the device gets them
    Bound bound;
    Macros macros;  ///< that the file expects
    /// How a parameter's value, or the result (name ""), is told; an empty text: as numbers.
    std::function<std::string(const std::string& name, std::span<const double>)> words;
    /// Results that the specification allows besides the truth, such as any exit before the entry on a miss.
    std::function<bool(std::span<const double> input, std::span<const double> got)> grants;
    /// Explanation of this call's result; if absent or empty, the exercise's hint.
    std::function<std::string(std::span<const double> input, std::span<const double> got)> hint;
};

/// The results of each call, flattened. `probe.truth` and `bound` are not needed; `outputs` says how many numbers the
/// result has. Throws ShaderError if the file does not compile.
Table run_probe(Gpu& gpu, const Probe& probe, size_t outputs);

/// A call that used an operation with a result undefined in GLSL.
struct Undefined {
    size_t row;  ///< of the probe's inputs
    int what;    ///< as undefined_words takes it, with its operands
    double a, b;
    Row result;  ///< of the call, where that operation gave one of undefined_results
};

/// Every such call, once for each of undefined_results. Nothing if the shader's text cannot be instrumented: then
/// nobody has looked.
std::optional<std::vector<Undefined>> run_undefined(Gpu& gpu, const Probe& probe, size_t outputs);

/// Whether a call's result is right: within the bound, or granted.
bool is_right(const Probe& probe, std::span<const double> input, std::span<const double> got);
/// How far a result is from the truth, in units of the bound: above 1 is wrong. A NaN or infinity is wrong unless the
/// truth is the same.
double excess(const Probe& probe, std::span<const double> truth, std::span<const double> got);
/// "f(a = 0) gave 1, expected 2".
std::string wrong_text(const Probe& probe, size_t row, std::span<const double> got);

/// The worst input in words a student understands: "f(a = 0, b = (0, 1, 0)) gave NaN, expected 0"; empty if every
/// result is within its bound.
std::string worst_of(const Probe& probe, const Table& results);

/// "f(a = 0, b = (0, 1, 0))".
std::string call_text(const Probe& probe, std::span<const double> row);
std::string result_text(const Probe& probe, std::span<const double> values);
std::string number_text(double value);
/// "gave 1, expected 2", or of several numbers "gave (1, 0), expected (2, 0)": with as many digits as tell the one from the
/// other.
std::string gave_text(std::span<const double> got, std::span<const double> expected);
std::string gave_text(double got, double expected);

/// Three numbers from `at` on.
inline glm::dvec3 vector3(std::span<const double> numbers, size_t at = 0) {
    return {numbers[at], numbers[at + 1], numbers[at + 2]};
}

/// Appends a vector's components.
template <class Vector>
void append(Row& row, const Vector& v) {
    for (int i = 0; i < Vector::length(); ++i) row.push_back(static_cast<double>(v[i]));
}

/// Offset of random tables: $LIGHTWALK_CHECK_SEED, chosen by the grader so that inputs are unpredictable; else 0.
unsigned check_seed();

/// Reproducible random numbers for tables, rounded to float so that truth and device see the same values.
class Random {
  public:
    explicit Random(unsigned seed = 1) : engine_(seed + check_seed()) {}
    double uniform(double lower, double upper) {
        return static_cast<float>(std::uniform_real_distribution<double>(lower, upper)(engine_));
    }
    /// A direction evenly distributed over the sphere.
    glm::vec3 direction();
    /// Evenly in the logarithm: for exponents and distances.
    double logarithmic(double lower, double upper) {
        return static_cast<float>(std::exp(uniform(std::log(lower), std::log(upper))));
    }

  private:
    std::mt19937 engine_;
};

}  // namespace lightwalk
