#include "common/base/error.h"
#include "common/study/study.h"

namespace lightwalk {

Loading automatic_choice(const Options& options, Chapter& chapter) {
    if (!options.automatic) return {};
    throw InputError("chapter " + chapter.name + " has no rule for auto");
}

}  // namespace lightwalk
