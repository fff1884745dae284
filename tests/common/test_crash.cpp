// What a program says where it crashes, and where its memory ends.
#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstring>
#include <fstream>
#include <functional>
#include <new>
#include <string>
#include <utility>

#include "catch.h"
#include "common/base/crash.h"
#include "common/base/error.h"
#include "common/base/files.h"
#include "common/base/sanitized.h"
#include "common/image/image.h"

using namespace lightwalk;

namespace {

// What `work` says on stderr in a copy of this process, and how that ends, as waitpid() has it.
std::pair<std::string, int> run(const std::function<void()>& work) {
    int ends[2];
    REQUIRE(pipe(ends) == 0);
    const pid_t copy = fork();
    if (copy == 0) {
        dup2(ends[1], STDERR_FILENO);
        const rlimit none{0, 0};
        setrlimit(RLIMIT_CORE, &none);
        say_crashes();
        work();
        _exit(0);
    }
    close(ends[1]);
    std::string said;
    char bytes[256];
    for (ssize_t count = 0; (count = read(ends[0], bytes, sizeof bytes)) > 0;)
        said.append(bytes, static_cast<size_t>(count));
    close(ends[0]);
    int status = 0;
    waitpid(copy, &status, 0);
    return {said, status};
}

// From now on this process gets no more than so many MiB.
void leave_memory(size_t mib) {
    size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    const rlim_t most = pages * static_cast<size_t>(sysconf(_SC_PAGESIZE)) + (mib << 20);
    const rlimit limit{most, most};
    setrlimit(RLIMIT_AS, &limit);
}

void end_without_catching() noexcept { throw std::bad_alloc(); }

}  // namespace

TEST_CASE("a crash says one line, and its signal ends the program") {
    if (sanitized) return;
    for (const auto& [signal, name] : {std::pair{SIGSEGV, "Segmentation fault"}, std::pair{SIGABRT, "Aborted"}}) {
        const auto [said, status] = run([signal = signal] { raise(signal); });
        CHECK(said == std::string("error: crashed (") + name + ")\n");
        CHECK((WIFSIGNALED(status) && WTERMSIG(status) == signal));
    }
}

TEST_CASE("where memory has ended a crash says that, and the exit code is 1") {
    if (sanitized) return;
    const auto crash = [] {
        leave_memory(16);
        raise(SIGSEGV);
    };
    for (const auto& work : {std::function<void()>(crash), std::function<void()>(end_without_catching)}) {
        const auto [said, status] = run(work);
        CHECK(said == "error: there is not enough memory for this\n");
        CHECK((WIFEXITED(status) && WEXITSTATUS(status) == 1));
    }
}

TEST_CASE("a JPEG for which there is no memory is not called broken") {
    if (sanitized) return;
    const std::string file = (course_root() / "assets/textures/portrait_albedo.jpg").string();
    const auto [said, status] = run([&] {
        mallopt(M_MMAP_THRESHOLD, 1 << 16);  // what is large does not come from what others have freed
        leave_memory(3);                     // the file's bytes, and not its texels'
        try {
            read_image8(file);
        } catch (const std::bad_alloc&) { _exit(7); } catch (const std::exception& e) {
            [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, e.what(), std::strlen(e.what()));
        }
    });
    CHECK(said == "");
    CHECK((WIFEXITED(status) && WEXITSTATUS(status) == 7));
}
