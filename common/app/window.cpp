#include "common/app/options.h"
#include "common/error.h"
namespace lightwalk {
int run_window(const Options&, Chapter&, std::unique_ptr<Gpu>&) {
    throw InputError("no display: use --screenshot FILE");
}
}  // namespace lightwalk
