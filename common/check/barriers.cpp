#include "common/check/barriers.h"

#include <fmt/core.h>

namespace lightwalk {

std::string traced_barriers() {
    std::string text =
        "uint check_barriers_passed = 0u;  // a hash of the lines, 24 bits, and their number\n"
        "void check_barrier() { barrier(); }\n"
        "void check_pass_barrier(uint line) {\n"
        "    uint lines = (check_barriers_passed >> 8u) * 0x5bd1e995u + line + 1u;\n"
        "    check_barriers_passed = (lines ^ lines >> 15u) << 8u | min((check_barriers_passed & 255u) + 1u, 255u);\n"
        "    check_barrier();\n}\n"
        "#define barrier() check_pass_barrier(uint(__LINE__))\n";
    for (const char* name :
         {"memoryBarrier", "memoryBarrierShared", "memoryBarrierBuffer", "memoryBarrierImage", "groupMemoryBarrier"})
        text += fmt::format("#define {}()\n", name);
    return text;
}

std::string barriers_wrong(std::span<const uint32_t> passed) {
    for (size_t i = 1; i < passed.size(); ++i) {
        const uint32_t first = passed[0] & 255u, here = passed[i] & 255u;
        if (here != first)
            return fmt::format(
                "invocation 0 comes to {} barriers, and invocation {} to {}: who does not come by is waited "
                "for, on some devices for ever",
                first, i, here);
        if (passed[i] != passed[0])
            return fmt::format(
                "invocations 0 and {} wait at different barriers: each waits for all others to come to the "
                "same one",
                i);
    }
    return "";
}

}  // namespace lightwalk
