#include "common/base/freed_memory.h"

#include <malloc.h>

namespace lightwalk {

void keep_freed_memory() {
    constexpr int largest = 32 << 20;  // larger blocks are mapped individually
    mallopt(M_MMAP_THRESHOLD, largest);
    mallopt(M_TRIM_THRESHOLD, 2 * largest);
}

}  // namespace lightwalk
