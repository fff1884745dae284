// Binary serialisation, for messages between processes of one program.
#pragma once
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "common/base/error.h"

namespace lightwalk {

// Types that are not trivially copyable list their fields once, for both directions:
//     template <class Bytes> void fields(Bytes& bytes, Mesh& mesh) { bytes(mesh.name, mesh.vertices); }

class ByteWriter {
  public:
    std::string bytes;

    template <class... Values>
    void operator()(const Values&... values) {
        (put(values), ...);
    }

  private:
    void raw(const void* from, size_t count) { bytes.append(static_cast<const char*>(from), count); }
    void put(const std::string& text) {
        put(text.size());
        raw(text.data(), text.size());
    }
    void put(const std::filesystem::path& path) { put(path.native()); }
    template <class T>
    void put(const std::vector<T>& list) {
        put(list.size());
        if constexpr (std::is_trivially_copyable_v<T>)
            raw(list.data(), list.size() * sizeof(T));
        else
            for (const T& one : list) put(one);
    }
    template <class T>
    void put(const T& value) {
        if constexpr (std::is_trivially_copyable_v<T>)
            raw(&value, sizeof value);
        else
            fields(*this, const_cast<T&>(value));
    }
};

/// Throws Failure if the bytes end too early. Ranges are not validated.
class ByteReader {
  public:
    explicit ByteReader(std::string_view bytes) : rest_(bytes) {}

    template <class... Values>
    void operator()(Values&... values) {
        (get(values), ...);
    }
    std::string_view take(size_t count, size_t size = 1) {
        if (count > rest_.size() / size) throw Failure("a message from another process ends too early");
        const std::string_view taken = rest_.substr(0, count * size);
        rest_.remove_prefix(taken.size());
        return taken;
    }

  private:
    size_t count() {
        size_t value = 0;
        get(value);
        return value;
    }
    void get(std::string& text) { text = take(count()); }
    void get(std::filesystem::path& path) { path = take(count()); }
    template <class T>
    void get(std::vector<T>& list) {
        const size_t size = count();
        if constexpr (std::is_trivially_copyable_v<T>) {
            const std::string_view bytes = take(size, sizeof(T));
            list.resize(size);
            if (size > 0) std::memcpy(static_cast<void*>(list.data()), bytes.data(), bytes.size());
        } else {
            list.clear();
            for (size_t i = 0; i < size; ++i) get(list.emplace_back());
        }
    }
    template <class T>
    void get(T& value) {
        if constexpr (std::is_trivially_copyable_v<T>)
            std::memcpy(static_cast<void*>(&value), take(sizeof value).data(), sizeof value);
        else
            fields(*this, value);
    }
    std::string_view rest_;
};

}  // namespace lightwalk
