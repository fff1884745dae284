#include "common/window/run.h"

#include "common/app/compile_shaders.h"
#include "common/app/headless.h"
#include "common/app/lists.h"
#include "common/base/crash.h"
#include "common/base/files.h"
#include "common/base/freed_memory.h"
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
    keep_freed_memory();
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
        const bool foreign = !options->scene.empty() && !lies_below(options->scene, course_root());
        if (foreign || !options->headless()) prepare_guard();
        const Loading loading = automatic_choice(*options, *chapter);
        if (options->headless()) return run_headless(*options, *chapter, gpu, loading);
        return run_window(*options, *chapter, gpu, make, loading);
    } catch (const std::exception& e) { return report_exception(e); }
}

}  // namespace lightwalk
