// libFuzzer: any bytes are materials or an InputError.
#include <string_view>

#include "01_obj/mtl.h"
#include "common/base/error.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    try {
        lightwalk::parse_mtl({reinterpret_cast<const char*>(data), size}, "fuzz.mtl", "folder");
    } catch (const lightwalk::InputError&) {}
    return 0;
}
