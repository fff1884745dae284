// Probes: GLSL functions evaluated on the device and compared with double-precision references.
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

/// Arguments of one call in signature order: vector components, matrix columns, struct members, integers.
using Row = std::vector<double>;
using Table = std::vector<Row>;

/// Tolerance of a result: the largest of the three.
struct Bound {
    double absolute = 0;
    double relative = 0;
    double ulps = 0;  ///< units in the last place of the reference as float
    double allowed(double truth) const;
};

struct Probe {
    std::string include;    ///< file with the exercise or solution, by toggle
    std::string before;     ///< GLSL inserted before `include`
    std::string signature;  ///< "float blinn_phong(vec3 normal, vec3 to_light, vec3 to_eye, float shininess)"
    Table inputs;
    std::function<Row(std::span<const double>)> truth;  ///< reference; inputs are rounded as on the device
    Bound bound;
    Macros macros;
    /// Text for a parameter, or for the result (name ""); empty: numbers.
    std::function<std::string(const std::string& name, std::span<const double>)> words;
    /// Accepts results that the specification allows beside the reference.
    std::function<bool(std::span<const double> input, std::span<const double> got)> grants;
    /// Hint for one call; if absent or empty, the exercise's.
    std::function<std::string(std::span<const double> input, std::span<const double> got)> hint;
};

/// Results of all calls, `outputs` numbers each. Throws ShaderError if the file does not compile.
Table run_probe(Gpu& gpu, const Probe& probe, size_t outputs);

/// Call that used an operation with a result undefined in GLSL.
struct Undefined {
    size_t row;
    int what;  ///< operation, with operands a and b, for undefined_words()
    double a, b;
    Row result;  ///< result with a substitute from undefined_results
};

/// Calls with undefined operations, once per substitute. Empty optional if the shader cannot be instrumented.
std::optional<std::vector<Undefined>> run_undefined(Gpu& gpu, const Probe& probe, size_t outputs);

/// True if the result is within the bound, or granted.
bool is_right(const Probe& probe, std::span<const double> input, std::span<const double> got);
/// Error in units of the bound; above 1 is wrong. Non-finite results are wrong unless the reference is the same.
double excess(const Probe& probe, std::span<const double> truth, std::span<const double> got);
/// "f(a = 0) gave 1, expected 2".
std::string wrong_text(const Probe& probe, size_t row, std::span<const double> got);

/// Message for the worst result, "f(a = 0, b = (0, 1, 0)) gave NaN, expected 0"; empty if all are within bounds.
std::string worst_of(const Probe& probe, const Table& results);

std::string call_text(const Probe& probe, std::span<const double> row);
std::string result_text(const Probe& probe, std::span<const double> values);
std::string number_text(double value);
/// "gave 1, expected 2", "gave (1, 0), expected (2, 0)", with enough digits to tell both apart.
std::string gave_text(std::span<const double> got, std::span<const double> expected);
std::string gave_text(double got, double expected);

inline glm::dvec3 vector3(std::span<const double> numbers, size_t at = 0) {
    return {numbers[at], numbers[at + 1], numbers[at + 2]};
}

template <class Vector>
void append(Row& row, const Vector& v) {
    for (int i = 0; i < Vector::length(); ++i) row.push_back(static_cast<double>(v[i]));
}

/// Random seed offset: $LIGHTWALK_CHECK_SEED, which makes graded inputs unpredictable; default 0.
unsigned check_seed();

/// Reproducible random numbers, rounded to float so that reference and device see equal values.
class Random {
  public:
    explicit Random(unsigned seed = 1) : engine_(seed + check_seed()) {}
    double uniform(double lower, double upper) {
        return static_cast<float>(std::uniform_real_distribution<double>(lower, upper)(engine_));
    }
    /// Uniform on the unit sphere.
    glm::vec3 direction();
    /// Log-uniform, for exponents and distances.
    double logarithmic(double lower, double upper) {
        return static_cast<float>(std::exp(uniform(std::log(lower), std::log(upper))));
    }

  private:
    std::mt19937 engine_;
};

}  // namespace lightwalk
