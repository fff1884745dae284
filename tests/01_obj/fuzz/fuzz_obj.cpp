// libFuzzer: our three loaders agree on any bytes, and their results can be welded.
#include <cstdio>
#include <cstdlib>

#include "../agreement.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    using namespace lightwalk;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    if (const std::string found = disagreement(text); !found.empty()) {
        std::fprintf(stderr, "%s\n", found.c_str());
        std::abort();
    }
    Outcome outcome = outcome_of(text, Loader::parallel);
    if (outcome.error.empty())
        for (const Mesh& mesh : weld(outcome.data, {}, "fuzz").meshes)
            for (const uint32_t index : mesh.indices)
                if (index >= mesh.vertices.size()) std::abort();
    return 0;
}
