#include "common/window/run.h"

#include <malloc.h>

#include "common/app/headless.h"
#include "common/base/guarded.h"
#include "common/base/text.h"
#include "common/gpu/sealed.h"
#include "common/study/study.h"
#include "common/window/event_log.h"
#include "common/window/pictures.h"
#include "common/window/window.h"

namespace lightwalk {

int run_chapter(int argc, char** argv, const char* name, const MakeChapter& make) {
    say_crashes();
    // Keeping 64 MiB of freed memory avoids 25% of the page faults at a chapter's start.
    mallopt(M_MMAP_THRESHOLD, 32 << 20);
    mallopt(M_TRIM_THRESHOLD, 64 << 20);
    try {
        std::unique_ptr<Gpu> gpu;  // before the chapter, since it must outlive its images and buffers
        const std::unique_ptr<Chapter> chapter = make();
        chapter->name = name;
        const std::optional<Options> options = read_options(argc, argv, *chapter);
        if (!options) return 0;
        log_events(options->events == "on");
        use_sealed(options->shaders_into, options->shaders_from);
        if (!options->list.empty()) return print_list(*options, *chapter);
        if (!options->compile_shaders.empty())
            return compile_all_shaders(*chapter, options->compile_shaders, !options->default_variants);
        if (options->pictures) return draw_pictures(*options, name, make, gpu);
        if (options->command) return options->command(*options, gpu);
        if (!options->study.empty()) return run_study(*options, *chapter, gpu);
        const Loading loading = automatic_choice(*options, *chapter);
        if (options->headless()) return run_headless(*options, *chapter, gpu, loading);
        return run_window(*options, *chapter, gpu, make, loading);
    } catch (const std::exception& e) { return report_exception(e); }
}

}  // namespace lightwalk
