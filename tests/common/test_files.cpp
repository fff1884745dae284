// Non-files, interrupted writes, messages with unprintable names, and crashes.
#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <new>

#include "catch.h"
#include "common/base/bytes.h"
#include "common/base/crash.h"
#include "common/base/error.h"
#include "common/base/files.h"
#include "common/base/guarded.h"
#include "common/base/kept.h"
#include "common/base/sanitized.h"
#include "common/base/text.h"
#include "common/image/image.h"

using namespace lightwalk;
namespace fs = std::filesystem;

namespace {

struct Folder {
    fs::path path = fs::temp_directory_path() / fmt::format("lightwalk_files_{}", getpid());
    Folder() { fs::create_directories(path); }
    ~Folder() {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
    fs::path operator/(const char* name) const { return path / name; }
    size_t count() const { return static_cast<size_t>(std::distance(fs::directory_iterator(path), {})); }
};

std::string message(const std::function<void()>& call) {
    try {
        call();
    } catch (const InputError& e) { return e.what(); }
    return "no error";
}

bool has(const std::string& text, std::string_view part) { return text.find(part) != text.npos; }

// Actions of a child before it is killed, or ends; its exit status.
int in_child(const std::function<void()>& work, useconds_t killed_after_us = 0) {
    const pid_t child = fork();
    if (child == 0) {
        work();
        _exit(0);
    }
    if (killed_after_us > 0) {
        usleep(killed_after_us);
        kill(child, SIGKILL);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return status;
}

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

TEST_CASE("files: only regular ones are read, and at once refused otherwise") {
    const Folder folder;
    REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0);
    CHECK(has(message([&] { read_file(folder / "pipe"); }), "is a pipe, expected a file"));
    CHECK(has(message([] { read_file("/dev/zero"); }), "is a device"));
    CHECK(has(message([&] { read_file(folder.path); }), "is a folder"));
    CHECK(has(message([&] { read_file(folder / std::string(300, 'x').c_str()); }), "cannot be opened"));
    fs::create_symlink("around", folder / "around");
    CHECK(has(message([&] { read_file(folder / "around"); }), "cannot be opened"));
    fs::create_symlink(folder / "pipe", folder / "link");
    CHECK(has(message([&] { read_file(folder / "link"); }), "is a pipe"));
    write_file(folder / "text", "0123456789");
    CHECK(read_file(folder / "text") == "0123456789");
    CHECK(has(message([&] { read_file(folder / "text", 9); }), "larger than"));
}

TEST_CASE("files: a write keeps what is no file, follows links and keeps permissions") {
    const Folder folder;
    REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0);
    // A device of our own: who runs this as root could destroy the system's, should it fail.
    const bool device = mknod((folder / "device").c_str(), S_IFCHR | 0600, makedev(1, 3)) == 0;
    for (const fs::path& place :
         {folder / "pipe", folder / (device ? "device" : "pipe"), folder.path, folder / "none/file"}) {
        CAPTURE(place);
        CHECK(has(message([&] { write_file(place, "new"); }), "cannot be written"));
        CHECK(has(message([&] { check_writable(place); }), "cannot be written"));
    }
    CHECK(fs::is_fifo(folder / "pipe"));
    CHECK(fs::is_character_file(folder / "device") == device);
    fs::create_directory(folder / "inner");
    write_file(folder / "inner/target", "old");
    fs::permissions(folder / "inner/target", fs::perms(0640));
    fs::create_symlink("inner/target", folder / "link");
    fs::create_symlink("link", folder / "link to a link");
    write_file(folder / "link to a link", "new");
    CHECK(fs::is_symlink(folder / "link to a link"));
    CHECK(fs::is_symlink(folder / "link"));
    CHECK(read_file(folder / "inner/target") == "new");
    CHECK(fs::status(folder / "inner/target").permissions() == fs::perms(0640));
    fs::create_symlink("inner/nobody yet", folder / "dangling");
    write_file(folder / "dangling", "here");
    CHECK(read_file(folder / "inner/nobody yet") == "here");
    check_writable(folder / "another");
    CHECK_FALSE(fs::exists(folder / "another"));
}

TEST_CASE("files: what was left open for writing is written to as it is, and anything else of that name is not") {
    const Folder folder;
    const int open_one = open((folder / "open").c_str(), O_RDWR | O_CREAT, 0600);
    const int read_only = open((folder / "open").c_str(), O_RDONLY);
    fs::remove(folder / "open");
    const std::string name = fmt::format("/dev/fd/{}", open_one);
    check_writable(name);
    write_file(name, "all of it");
    char read_back[16] = {};
    CHECK(pread(open_one, read_back, sizeof read_back, 0) == 9);
    CHECK(std::string(read_back) == "all of it");
    CHECK(folder.count() == 0);
    int ends[2];
    REQUIRE(pipe(ends) == 0);
    for (const int other : {1, read_only, ends[1], 999})
        CHECK(!message([&] { write_file(fmt::format("/dev/fd/{}", other), "x"); }).empty());
    for (const int one : {open_one, read_only, ends[0], ends[1]}) close(one);
}

TEST_CASE("files: whenever a write is killed, the old file or the new one is there") {
    const Folder folder;
    const fs::path file = folder / "file";
    const std::string first(3000000, 'a'), second(3000000, 'b');
    write_file(file, first);
    bool whole = true;
    for (useconds_t i = 0; i < 60; ++i) {
        in_child(
            [&] {
                for (;;) {
                    write_file(file, second);
                    write_file(file, first);
                }
            },
            300 + 177 * i);
        const std::string now = read_file(file);
        whole = whole && (now == first || now == second);
    }
    CHECK(whole);
    // A disk that is full: no more than 1 MB can be written.
    const int status = in_child([&] {
        signal(SIGXFSZ, SIG_IGN);
        const rlimit little{1000000, 1000000};
        setrlimit(RLIMIT_FSIZE, &little);
        const size_t before = folder.count();
        const std::string said = message([&] { write_file(file, std::string(3000000, 'c')); });
        _exit(has(said, "cannot be written: File too large") && folder.count() == before ? 7 : 8);
    });
    CHECK(WEXITSTATUS(status) == 7);
    CHECK(read_file(file) != std::string(3000000, 'c'));
}

TEST_CASE("messages: a name can neither end a line nor move the cursor") {
    CHECK(printable("a\nb\x1b[2Jc\td\x7f") == "a\\x0ab\\x1b[2Jc\\x09d\\x7f");
    CHECK(printable("a\nb\tc\r", true) == "a\nb\tc\\x0d");
    CHECK(printable("Grün 木 😀") == "Grün 木 😀");
    CHECK(printable("\xff\xc0\x80\xed\xa0\x80z\xc3") == "\\xff\\xc0\\x80\\xed\\xa0\\x80z\\xc3");
    CHECK(printable("\xc2\x9b") == "\\xc2\\x9b");  // the control character CSI
    CHECK(printable(std::string(1, '\0')) == "\\x00");
}

TEST_CASE("guarded: what a reader does wrong stays in its process") {
    const GuardLimits limits{.cpu_s = 1, .memory = size_t{300} << 20};
    const auto run = [&](const std::function<std::string()>& work) {
        return run_guarded("FILE", "READER", limits, work);
    };
    CHECK(run([] { return std::string(5000000, 'x'); }) == std::string(5000000, 'x'));
    CHECK(run([] { return std::string(); }).empty());
    CHECK(message([&] { run([]() -> std::string { throw InputError("FILE:3: no"); }); }) == "FILE:3: no");
    CHECK_THROWS_AS(run([]() -> std::string { throw std::runtime_error("no"); }), Failure);
    CHECK(run([&] { return run([] { return std::string("inner"); }); }) == "inner");
    static int touched = 0;
    CHECK(run([] { return std::to_string(++touched); }) == "1");
    CHECK(touched == 0);
#ifndef __SANITIZE_ADDRESS__
    const auto refused = [&](const std::function<std::string()>& work, std::string_view why) {
        const std::string said = message([&] { run(work); });
        INFO(said);
        CHECK(has(said, "FILE: READER "));
        CHECK(has(said, why));
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
    const Folder folder;
    const std::string file = folder / "never";
    refused(
        [&]() -> std::string {
            std::ofstream(file) << "x" << std::flush;
            return {};
        },
        "crashed on it (File size limit exceeded)");
#endif
}

TEST_CASE("guarded: one process reads one file after another; after a crash or a limit it is another") {
    const auto ask = [](GuardReader read, std::string_view input) {
        std::string said;
        read_guarded({"FILE", "READER", read}, {.cpu_s = 1, .memory = size_t{50} << 20}, {"input ", input},
                     [&](std::string_view bytes) { said = bytes; });
        return said;
    };
    const GuardReader process = [](std::string_view, GuardReply& reply) { reply.append(std::to_string(getpid())); };
    const GuardReader twice = [](std::string_view input, GuardReply& reply) {
        reply.append(input);
        reply.append(input);
    };
    const GuardReader refuses = [](std::string_view input, GuardReply& reply) {
        reply.append("half an answer");
        throw InputError("FILE:3: {}", input);
    };
    const GuardReader folder = [](std::string_view, GuardReply& reply) { reply.append(fs::current_path().string()); };
    const std::string first = ask(process, "");
    CHECK(first != std::to_string(getpid()));
    CHECK(ask(twice, "x") == "input xinput x");
    CHECK(ask(twice, std::string(20000000, 'x')).size() == 40000012);  // larger than the memory that is kept mapped
    CHECK(message([&] { ask(refuses, "no"); }) == "FILE:3: input no");
    CHECK(ask(process, "") == first);
    const Folder elsewhere;
    const fs::path here = fs::current_path();
    fs::current_path(elsewhere / "");
    CHECK(fs::equivalent(ask(folder, ""), fs::current_path()));  // relative names mean the same file there
    fs::current_path(here);
#ifndef __SANITIZE_ADDRESS__
    const GuardReader crashes = [](std::string_view, GuardReply&) { raise(SIGSEGV); };
    CHECK(has(message([&] { ask(crashes, ""); }), "FILE: READER crashed on it (Segmentation fault)"));
    const std::string second = ask(process, "");
    CHECK(second != first);
    CHECK(has(message([&] { ask(twice, std::string(30000000, 'x')); }), "FILE: READER needs more than 50 MiB"));
    CHECK(ask(process, "") != second);
    const GuardReader endless = [](std::string_view, GuardReply&) {
        for (std::atomic<int> i = 0;; ++i) {}
    };
    CHECK(has(message([&] { ask(endless, ""); }), "takes more than 1 s"));
#endif
}

TEST_CASE("bytes: what is written is read back, and what is cut off is noticed") {
    ByteWriter writer;
    const std::vector<std::string> names{"a", "", std::string("b\0c", 3)};
    writer(7, std::string("text"), names, std::vector<float>{1, 2}, fs::path("x/y"));
    int number = 0;
    std::string text;
    std::vector<std::string> read_names;
    std::vector<float> floats;
    fs::path path;
    ByteReader{writer.bytes}(number, text, read_names, floats, path);
    CHECK(
        (number == 7 && text == "text" && read_names == names && floats == std::vector<float>{1, 2} && path == "x/y"));
    for (size_t length = 0; length < writer.bytes.size(); ++length) {
        ByteReader cut(std::string_view(writer.bytes).substr(0, length));
        CHECK_THROWS_AS(cut(number, text, read_names, floats, path), Failure);
    }
}

TEST_CASE("kept: what was kept is read back; a file that is cut, changed, longer or another is not believed") {
    const Folder folder;
    const auto file = folder / "entry.kept";
    const std::string bytes = "a module's words " + std::string(10000, '\0') + "and its end";
    CHECK_FALSE(read_kept(file, bytes.size()));
    keep(file, bytes);
    CHECK(read_kept(file, bytes.size()) == bytes);
    CHECK(std::filesystem::file_size(file) < 200);
    CHECK_FALSE(read_kept(file, bytes.size() - 1));
    const std::string whole = read_file(file);
    for (size_t i = 0; i < whole.size(); ++i) {
        std::string changed = whole;
        changed[i] ^= 4;
        write_file(file, changed);
        CHECK(read_kept(file, bytes.size()).value_or(bytes) == bytes);
        write_file(file, whole.substr(0, i));
        CHECK_FALSE(read_kept(file, bytes.size()));
    }
    // The oldest use is removed first.
    keep(file, bytes);
    const auto old = std::filesystem::file_time_type::clock::now() - std::chrono::hours(48);
    std::filesystem::last_write_time(file, old);
    CHECK(read_kept(file, bytes.size()));
    CHECK(std::filesystem::last_write_time(file) > old + std::chrono::hours(24));
    keep("/proc/no/such/folder", bytes);
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
