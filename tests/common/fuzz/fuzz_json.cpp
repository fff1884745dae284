// Fuzzes the readers of studies and of shots: any bytes are one, or an InputError. The first byte chooses.
#include "common/app/shots.h"
#include "common/base/error.h"
#include "common/study/study_plan.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    using namespace lightwalk;
    if (size < 1) return 0;
    const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
    try {
        if (data[0] % 2)
            read_study(parse_json(text, "study.json"), {});
        else
            parse_shots(text, "shots.json");
    } catch (const InputError&) {}
    return 0;
}
