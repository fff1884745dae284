// Memory that a thread takes, counted by the program's own operator new. For one file of a program.
#pragma once
#include <cstdlib>
#include <new>

namespace {

thread_local size_t blocks_taken = 0, bytes_taken = 0;

}  // namespace

void* operator new(size_t bytes) {
    ++blocks_taken;
    bytes_taken += bytes;
    if (void* const block = std::malloc(bytes ? bytes : 1)) return block;
    throw std::bad_alloc();
}
// Sanitizers have one of their own, whose blocks the operators below could not free.
void* operator new(size_t bytes, const std::nothrow_t&) noexcept {
    ++blocks_taken;
    bytes_taken += bytes;
    return std::malloc(bytes ? bytes : 1);
}
void operator delete(void* block) noexcept { std::free(block); }
void operator delete(void* block, size_t) noexcept { std::free(block); }
