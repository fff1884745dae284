#include <cstdio>
#include <cstdlib>

#include "common/app/options.h"
#include "common/base/error.h"

namespace lightwalk {

int run_chapter(int argc, char** argv, const char* name, const MakeChapter& make) {
    try {
        std::unique_ptr<Gpu> gpu;  // before the chapter, whose images and buffers it must outlive
        const std::unique_ptr<Chapter> chapter = make();
        chapter->name = name;
        const std::optional<Options> options = read_options(argc, argv, *chapter);
        if (!options) return 0;
        if (!options->list.empty()) return print_list(*options, *chapter);
        if (!options->compile_shaders.empty()) return compile_all_shaders(*chapter, options->compile_shaders);
        if (options->command) return options->command();
        if (options->headless()) return run_headless(*options, *chapter, gpu);
        return run_window(*options, *chapter, gpu, make);
    } catch (const InputError& e) {
        std::fprintf(stderr, "error: %s\n", e.what());
        return 2;
    } catch (const std::exception& e) {
        std::fprintf(stderr, "error: %s\n", e.what());
        return 1;
    }
}

}  // namespace lightwalk
