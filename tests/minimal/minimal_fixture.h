// Shared by the tests of docs/minimal's shaders: their functions, run on the device.
#pragma once

#include <cmath>
#include <regex>

#include "catch.h"
#include "common/base/files.h"
#include "common/check/check.h"

namespace lightwalk {

inline constexpr double pi = 3.14159265358979;

// The functions of a shader, without the stage that they run in: declarations of inputs and outputs, and main().
inline std::string functions_of(const std::string& name) {
    std::string text = read_file("docs/minimal/" + name);
    text = text.substr(0, text.find("void main()"));
    text = std::regex_replace(text, std::regex("#version.*\n"), "");
    return std::regex_replace(text, std::regex("layout\\(.*\n"), "");
}

// One result for each row. `before` stands in front of the shader's functions.
inline Table results_of(const std::string& shader, const std::string& signature, Table inputs, size_t outputs,
                        const std::string& before = "", const std::string& behind = "") {
    return run_probe(check_device(),
                     {.include = "common/srgb.glsl",
                      .before = before + functions_of(shader) + behind,
                      .signature = signature,
                      .inputs = std::move(inputs)},
                     outputs);
}

inline Row joined(std::initializer_list<glm::vec3> vectors) {
    Row row;
    for (const glm::vec3& v : vectors) append(row, v);
    return row;
}

}  // namespace lightwalk
