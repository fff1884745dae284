// Non-files, interrupted writes, messages with unprintable names, and what is kept in files.
#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/wait.h>

#include <cstdlib>
#include <fstream>

#include "common/base/bytes.h"
#include "common/base/files.h"
#include "common/base/kept.h"
#include "file_fixture.h"

using namespace lightwalk;
namespace fs = std::filesystem;

namespace {

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

}  // namespace

TEST_CASE("files: only regular ones are read, and at once refused otherwise") {
    const FileFolder folder;
    REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0);
    CHECK(has_part(refusal_of([&] { read_file(folder / "pipe"); }), "is a pipe, expected a file"));
    CHECK(has_part(refusal_of([] { read_file("/dev/zero"); }), "is a device"));
    CHECK(has_part(refusal_of([&] { read_file(folder.path); }), "is a folder"));
    CHECK(has_part(refusal_of([&] { read_file(folder / std::string(300, 'x').c_str()); }), "cannot be opened"));
    fs::create_symlink("around", folder / "around");
    CHECK(has_part(refusal_of([&] { read_file(folder / "around"); }), "cannot be opened"));
    fs::create_symlink(folder / "pipe", folder / "link");
    CHECK(has_part(refusal_of([&] { read_file(folder / "link"); }), "is a pipe"));
    write_file(folder / "text", "0123456789");
    CHECK(read_file(folder / "text") == "0123456789");
    CHECK(has_part(refusal_of([&] { read_file(folder / "text", 9); }), "larger than"));
}

TEST_CASE("files: a write keeps what is no file, follows links and keeps permissions") {
    const FileFolder folder;
    REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0);
    // A device of our own: who runs this as root could destroy the system's, should it fail.
    const bool device = mknod((folder / "device").c_str(), S_IFCHR | 0600, makedev(1, 3)) == 0;
    for (const fs::path& place :
         {folder / "pipe", folder / (device ? "device" : "pipe"), folder.path, folder / "none/file"}) {
        CAPTURE(place);
        CHECK(has_part(refusal_of([&] { write_file(place, "new"); }), "cannot be written"));
        CHECK(has_part(refusal_of([&] { check_writable(place); }), "cannot be written"));
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
    const FileFolder folder;
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
        CHECK(!refusal_of([&] { write_file(fmt::format("/dev/fd/{}", other), "x"); }).empty());
    for (const int one : {open_one, read_only, ends[0], ends[1]}) close(one);
}

TEST_CASE("files: whenever a write is killed, the old file or the new one is there") {
    const FileFolder folder;
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
        const std::string said = refusal_of([&] { write_file(file, std::string(3000000, 'c')); });
        _exit(has_part(said, "cannot be written: File too large") && folder.count() == before ? 7 : 8);
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
    const FileFolder folder;
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
