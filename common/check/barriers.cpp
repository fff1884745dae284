#include "common/check/barriers.h"

#include <fmt/core.h>

#include <cctype>

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

Raced traced_races(const std::string& text, const std::string& array, const std::string& type, uint32_t count) {
    const std::string size = std::to_string(count);
    Raced raced;
    std::string traced = traced_barriers();
    const std::string wait = "void check_barrier() { barrier(); }\n";
    traced.replace(traced.find(wait), wait.size(),
                   "shared uint check_named_by[" + size +
                       "];  // 0 nobody, 1 + an invocation, or 999 for several\n"
                       "shared bool check_raced;\n"
                       "shared " +
                       type + " check_kept[" + size +
                       "];\n"
                       "void check_wait() { barrier(); }\nvoid check_interval();\n"
                       "void check_barrier() { check_wait(); check_interval(); check_wait(); }\n"
                       "uint check_named(uint i) {\n"
                       "    uint mine = check_stands_for + 1u, before = atomicCompSwap(check_named_by[i % " +
                       size +
                       "u], 0u, mine);\n"
                       "    if (before != 0u && before != mine) atomicMax(check_named_by[i % " +
                       size +
                       "u], 999u);\n"
                       "    return i;\n}\n"
                       "uint check_named(int i) { return check_named(uint(i)); }\n");
    raced.before = "uint check_stands_for;\n" + traced;
    for (size_t at = 0; at < text.size();) {
        const size_t found = text.find(array + "[", at);
        if (found == text.npos ||
            (found > 0 && (std::isalnum(static_cast<unsigned char>(text[found - 1])) || text[found - 1] == '_'))) {
            const size_t end = found == text.npos ? text.size() : found + 1;
            raced.text += text.substr(at, end - at);
            at = end;
            continue;
        }
        const size_t open = found + array.size();
        size_t close = open;
        for (int depth = 0; close < text.size(); ++close) {
            if (text[close] == '[') ++depth;
            if (text[close] == ']' && --depth == 0) break;
        }
        const bool declared = text.substr(0, found).ends_with(type + " ");
        raced.text += text.substr(at, open + 1 - at);
        const std::string index = text.substr(open + 1, close - open - 1);
        raced.text += declared ? index : "check_named(" + index + ")";
        at = close;
    }
    raced.after =
        "void check_interval() {\n    uint i = check_stands_for;\n"
        "    if (check_kept[i] != " +
        array +
        "[i] && check_named_by[i] == 999u) check_raced = true;\n"
        "    check_kept[i] = " +
        array + "[i];\n    check_named_by[i] = 0u;\n}\n";
    return raced;
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
