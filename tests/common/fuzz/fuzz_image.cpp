// Fuzzes the readers of pictures: any bytes are a picture or an InputError. The first byte chooses the reader.
// Foreign ones run in their guarded process, so that their failures are an InputError too.
#include <sys/mman.h>
#include <unistd.h>

#include <string>

#include "common/base/error.h"
#include "common/image/decode.h"
#include "common/image/image.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    using namespace lightwalk;
    if (size < 1) return 0;
    static const int file = memfd_create("picture", 0);
    static const std::string path = "/proc/self/fd/" + std::to_string(file);
    if (ftruncate(file, 0) != 0 || pwrite(file, data + 1, size - 1, 0) < 0) return 0;
    try {
        if (data[0] == 0)
            decode_picture(path, 4, Depth::as_stored);
        else
            data[0] % 2 ? read_pfm(path) : read_radiance(path);
    } catch (const InputError&) {}
    return 0;
}
