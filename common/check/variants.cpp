#include "common/check/variants.h"

#include <map>

#include "common/base/error.h"

namespace lightwalk {
namespace {

std::map<std::string, void (*)()>& variants() {
    static std::map<std::string, void (*)()> known;
    return known;
}

}  // namespace

RegisterVariant::RegisterVariant(const char* name, void (*choose)()) { variants()[name] = choose; }

void choose_variant(const std::string& name) {
    const auto found = variants().find(name);
    if (found == variants().end()) throw InputError("this program has no variant '{}'", name);
    found->second();
}

}  // namespace lightwalk
