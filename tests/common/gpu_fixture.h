// Shared by the tests of common/gpu: a device with silent validation, small shaders, texels as numbers.
#pragma once
#include <cstdlib>
#include <cstring>

#include "catch.h"
#include "common/base/error.h"
#include "common/gpu/frame.h"

namespace lightwalk {

inline DeviceOptions validated() {
    const char* name = std::getenv("LIGHTWALK_DEVICE");
    return {.name = name ? name : "", .validate = true, .surface_extensions = {}, .on_message = {}};
}

inline Gpu& validated_device() {
    static Gpu& gpu = *new Gpu(validated());  // stays: at the program's end the layers may have gone before it
    return gpu;
}

/// A device that expects no validation message, and a frame that is not begun.
struct DeviceTest {
    Gpu& gpu = validated_device();
    Frame frame{gpu};
    ~DeviceTest() { CHECK_NOTHROW(gpu.device.check_validation()); }

    template <class T>
    std::vector<T> read(const ImageView& view) {
        return numbers<T>(gpu.read_back(view));
    }
    template <class T>
    std::vector<T> read(const Buffer& buffer) {
        return numbers<T>(gpu.read_back(buffer));
    }
    /// The value of every component of the view's first mip, or NaN where they differ.
    float value(const ImageView& view) {
        const auto all = read<float>(view);
        for (const float one : all)
            if (one != all[0]) return NAN;
        return all.at(0);
    }
    Image image(Image::Desc desc) {
        if (desc.name.empty()) desc.name = "test";
        return Image(gpu.device, desc);
    }

    template <class T>
    static std::vector<T> numbers(const std::vector<std::byte>& bytes) {
        std::vector<T> result(bytes.size() / sizeof(T));
        std::memcpy(result.data(), bytes.data(), result.size() * sizeof(T));
        return result;
    }
};

/// For TEST_CASE_METHOD: within a frame of 4×4 pixels.
struct OnDevice : DeviceTest {
    OnDevice() { frame.begin({4, 4}, 0); }
};

struct Quad {
    glm::vec4 rectangle{-1, -1, 1, 1};
    float depth = 0.5f, depth_right = 0.5f;
};
struct Paint {
    glm::vec4 first{1}, second{1};
};

inline std::string test_shader(const std::string& name) { return "../tests/common/shaders/" + name; }

/// A rectangle in one or two colours, or by another fragment shader.
inline Pipeline quad_pipeline(Pipeline::Graphics states = {}, const std::string& fragment = "paint_one.frag") {
    states.vertex = test_shader("quad.vert");
    states.fragment = test_shader(fragment);
    return graphics(std::move(states));
}

inline Pipeline compute_pipeline(const std::string& name, const std::string& source) {
    return compute({.shader = name, .source = source});
}

/// Text of a function's Failure; empty if it throws none.
template <class Function>
std::string failure_at(const Function& function) {
    try {
        function();
    } catch (const Failure& e) { return e.what(); }
    return {};
}

/// The same without file and line of a pass's statement.
template <class Function>
std::string failure_of(const Function& function) {
    const std::string text = failure_at(function);
    const size_t at = text.find(": pass '");
    return at == text.npos ? text : text.substr(at + 2);
}

constexpr VkFormat one_float = VK_FORMAT_R32_SFLOAT;
constexpr VkFormat four_floats = VK_FORMAT_R32G32B32A32_SFLOAT;

}  // namespace lightwalk
