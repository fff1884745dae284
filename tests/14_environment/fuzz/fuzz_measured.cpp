// Fuzzes the reader of measured BRDFs: any bytes are a table of finite numbers, which is fitted, or an InputError.
#include <cstdlib>

#include "14_environment/paint_fit.h"
#include "common/base/error.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    using namespace lightwalk;
    try {
        const MeasuredBrdf brdf = parse_measured({reinterpret_cast<const char*>(data), size}, "fuzz");
        if (parse_measured(measured_bytes(brdf), "fuzz").cells != brdf.cells) std::abort();
        fit_paint(brdf);
    } catch (const InputError&) {}
    return 0;
}
