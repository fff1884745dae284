// Growable array of plain values that does not clear the memory it is about to overwrite.
#pragma once
#include <sys/mman.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <new>
#include <span>
#include <type_traits>
#include <utility>

namespace lightwalk {

/// std::vector sets new elements to zero and copies when it grows. A loader writes every element itself, and at a
/// gigabyte per second both are felt; realloc() moves whole pages instead of copying them.
template <class T>
class Array {
    static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

  public:
    Array() = default;
    Array(Array&& other) noexcept { *this = std::move(other); }
    Array& operator=(Array&& other) noexcept {
        std::swap(data_, other.data_);
        std::swap(size_, other.size_);
        std::swap(capacity_, other.capacity_);
        return *this;
    }
    ~Array() { std::free(data_); }

    T* data() { return data_; }
    const T* data() const { return data_; }
    size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    T* begin() { return data_; }
    T* end() { return data_ + size_; }
    const T* begin() const { return data_; }
    const T* end() const { return data_ + size_; }
    T& operator[](size_t i) { return data_[i]; }
    const T& operator[](size_t i) const { return data_[i]; }

    /// Room for `count` more elements past the end; write them, then call added(). Throws std::bad_alloc.
    T* room(size_t count) {
        if (capacity_ - size_ < count) reserve(size_ + count + size_ / 2 + 1024);
        return data_ + size_;
    }
    void added(size_t count) { size_ += count; }
    void push_back(const T& value) {
        *room(1) = value;
        ++size_;
    }
    void clear() { size_ = 0; }
    /// The new elements are not set.
    void resize(size_t count) {
        if (count > capacity_) reserve(count);
        size_ = count;
    }
    void reserve(size_t count) {
        if (count <= capacity_) return;
        void* moved = std::realloc(data_, count * sizeof(T));
        if (!moved) throw std::bad_alloc();
        data_ = static_cast<T*>(moved);
        capacity_ = count;
        // Large pages where the system offers them: first touch costs a fault for 2 MiB instead of 4 KiB.
        constexpr uintptr_t large = uintptr_t{2} << 20;
        const uintptr_t begin = (reinterpret_cast<uintptr_t>(moved) + large - 1) & ~(large - 1);
        const uintptr_t end = reinterpret_cast<uintptr_t>(moved) + count * sizeof(T);
        if (begin + large <= end) madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
    }
    bool operator==(const Array& other) const {
        return size_ == other.size_ && (size_ == 0 || std::memcmp(data_, other.data_, size_ * sizeof(T)) == 0);
    }

  private:
    T* data_ = nullptr;
    size_t size_ = 0, capacity_ = 0;
};

}  // namespace lightwalk
