// Fuzzes a guarded process's output: any bytes are a model with valid indices, or a Failure.
#include <cstdlib>

#include "common/base/error.h"
#include "common/scene/model_bytes.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    using namespace lightwalk;
    Model model;
    try {
        read_bytes({reinterpret_cast<const char*>(data), size}, "fuzz", model);
    } catch (const Failure&) { return 0; }
    model_bounds(model);
    world_transforms(model, 0.5f);
    for (const Mesh& mesh : model.meshes)
        for (const Part& part : mesh.parts)
            for (uint32_t i = 0; i < part.index_count; ++i)
                if (mesh.indices[part.first_index + i] >= mesh.vertices.size()) std::abort();
    return 0;
}
