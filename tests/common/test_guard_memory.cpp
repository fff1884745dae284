// Memory that a guarded reader shares with this process: it cannot be shortened, and is given back.
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "catch.h"
#include "common/base/freed_memory.h"
#include "common/base/guarded.h"
#include "common/base/sanitized.h"

using namespace lightwalk;

namespace {

// Descriptors of this process's shared memory.
std::vector<int> shared_memory() {
    std::vector<int> all;
    for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) {
        std::error_code gone;
        const std::string target = std::filesystem::read_symlink(entry, gone).string();
        if (target.rfind("/memfd:lightwalk", 0) == 0) all.push_back(std::stoi(entry.path().filename()));
    }
    return all;
}

size_t bytes_in_use() {
    size_t bytes = 0;
    for (const int file : shared_memory()) {
        struct stat about {};
        if (fstat(file, &about) == 0) bytes += 512 * static_cast<size_t>(about.st_blocks);
    }
    return bytes;
}

std::string ask(GuardReader read) {
    std::string said;
    read_guarded({"FILE", "READER", read}, {.cpu_s = 5, .memory = size_t{200} << 20}, {"input"},
                 [&](std::string_view bytes) { said = bytes; });
    return said;
}

}  // namespace

TEST_CASE("a hijacked reader cannot shorten the memory from which its answer is read") {
    const GuardReader shortens = [](std::string_view, GuardReply& reply) {
        reply.append(std::string(3000000, 'x'));
        std::string tried;
        for (const int file : shared_memory())
            tried += ftruncate(file, 0) == 0 ? " shortened" : std::string(" ") + std::strerror(errno);
        reply.append(tried);
    };
    CHECK(ask(shortens) == std::string(3000000, 'x') + " Operation not permitted");
}

TEST_CASE("a large answer's memory is given back") {
    const GuardReader large = [](std::string_view, GuardReply& reply) { reply.append(std::string(150000000, 'x')); };
    CHECK(ask(large).size() == 150000000);
    CHECK(bytes_in_use() > 0);
    CHECK(bytes_in_use() <= size_t{65} << 20);
}

namespace {

// Faults of pages, as the system counts them, of taking and freeing 20 MB a second time: 5000 pages of 4 KiB.
std::string faults_of_again() {
    long before = 0, after = 0;
    for (long* const faults : {&before, &after}) {
        std::vector<std::string> parts;
        for (int i = 0; i < 200; ++i) parts.emplace_back(100000, 'x');
        rusage used{};
        getrusage(RUSAGE_SELF, &used);
        *faults = used.ru_minflt;
    }
    return std::to_string(after - before);
}

}  // namespace

TEST_CASE("a reader's process keeps the memory of small files", "[common.guard_keeps]") {
    const GuardReader small = [](std::string_view, GuardReply& reply) { reply.append(faults_of_again()); };
    if (!sanitized) CHECK(std::stol(ask(small)) < 500);
}

TEST_CASE("a program that keeps freed memory takes it again without faults", "[common.keeps_freed]") {
    const auto again = [](bool keeps) {
        return std::stol(run_guarded("FILE", "READER", {.cpu_s = 5}, [&] {
            if (keeps) keep_freed_memory();
            return faults_of_again();
        }));
    };
    if (!sanitized) CHECK(again(true) < 500);
}
