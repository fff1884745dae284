// Readers in processes of their own, and crashes.
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <atomic>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <new>

#include "common/base/bytes.h"
#include "common/base/files.h"
#include "common/base/guarded.h"
#include "common/base/sanitized.h"
#include "common/image/image.h"
#include "file_fixture.h"

using namespace lightwalk;
namespace fs = std::filesystem;

namespace {

// Text of `work` on stderr in a copy of this process, and its end, as waitpid() has it.
std::pair<std::string, int> crash_of(const std::function<void()>& work) {
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

void end_without_catching() noexcept {
    [[maybe_unused]] static void* volatile kept;  // or the compiler leaves it out
    kept = ::operator new (size_t{1} << 60);
}

}  // namespace

TEST_CASE("guarded: what a reader does wrong stays in its process") {
    const GuardLimits limits{.cpu_s = 1, .memory = size_t{300} << 20};
    const auto run = [&](const std::function<std::string()>& work) {
        return run_guarded("FILE", "READER", limits, work);
    };
    CHECK(run([] { return std::string(5000000, 'x'); }) == std::string(5000000, 'x'));
    CHECK(run([] { return std::string(); }).empty());
    CHECK(refusal_of([&] { run([]() -> std::string { throw InputError("FILE:3: no"); }); }) == "FILE:3: no");
    CHECK_THROWS_AS(run([]() -> std::string { throw std::runtime_error("no"); }), Failure);
    CHECK(run([&] { return run([] { return std::string("inner"); }); }) == "inner");
    static int touched = 0;
    CHECK(run([] { return std::to_string(++touched); }) == "1");
    CHECK(touched == 0);
#ifndef __SANITIZE_ADDRESS__
    const auto refused = [&](const std::function<std::string()>& work, std::string_view why) {
        const std::string said = refusal_of([&] { run(work); });
        INFO(said);
        CHECK(has_part(said, "FILE: READER "));
        CHECK(has_part(said, why));
    };
    refused([]() -> std::string { std::abort(); }, "crashed on it (Aborted)");
    refused(
        []() -> std::string {
            raise(SIGSEGV);
            return {};
        },
        "crashed on it (Segmentation fault)");
    refused([]() -> std::string { _exit(0); }, "ended on it without an answer");
    refused(
        []() -> std::string {
            for (std::atomic<int> i = 0;; ++i) {}
        },
        "takes more than 1 s");
    refused([] { return std::string(size_t{400} << 20, 'x'); }, "needs more than 300 MiB");
    const FileFolder folder;
    const std::string file = folder / "never";
    refused(
        [&]() -> std::string {
            std::ofstream(file) << "x" << std::flush;
            return {};
        },
        "crashed on it (File size limit exceeded)");
#endif
}

TEST_CASE("a crash says one line, and its signal ends the program") {
    if (sanitized) return;
    for (const auto& [signal, name] : {std::pair{SIGSEGV, "Segmentation fault"}, std::pair{SIGABRT, "Aborted"}}) {
        const auto [said, status] = crash_of([signal = signal] { raise(signal); });
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
        const auto [said, status] = crash_of(work);
        CHECK(said == "error: there is not enough memory for this\n");
        CHECK((WIFEXITED(status) && WEXITSTATUS(status) == 1));
    }
}

TEST_CASE("a JPEG for which there is no memory is not called broken") {
    if (sanitized) return;
    const std::string file = (course_root() / "assets/textures/portrait_albedo.jpg").string();
    const auto [said, status] = crash_of([&] {
        void* const left = std::malloc(1 << 20);  // for the file's bytes, and not for its texels
        leave_memory(1);
        while (std::malloc(1 << 19)) {}  // takes freed memory, too
        std::free(left);
        try {
            read_image8(file);
        } catch (const std::bad_alloc&) { _exit(7); } catch (const std::exception& e) {
            [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, e.what(), std::strlen(e.what()));
        }
    });
    CHECK(said == "");
    CHECK((WIFEXITED(status) && WEXITSTATUS(status) == 7));
}
