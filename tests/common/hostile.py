"""Submissions that attack their grading: the exercise, the answer, and words of the expected verdict.

A successful attack throws "BROKE OUT", or leaves the file OUTSIDE, or gets a mark. What is refused by its text alone is in
test_grade_words.py.
"""

import json
import os

OUTSIDE = f"/var/tmp/lightwalk-broke-out.{os.getpid()}"
ABSTRACT = "lightwalk-grade-test"  # a socket that the tests listen on

HEAD = """#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dirent.h>
#include <fcntl.h>
#include <fstream>
#include <signal.h>
#include <sstream>
#include <string>
#include <sys/mman.h>
#include <sys/ptrace.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <netinet/in.h>
#include <arpa/inet.h>
#include <thread>
#include <unistd.h>
#include "03_attenuation/exercises.h"
#include "common/base/error.h"
#define BROKE_OUT(what) throw lightwalk::InputError("BROKE OUT: {}", what)
"""
PASSED = json.dumps({"exercise": "03.light_reaches_box", "ok": True, "passed": 99, "failed": 0, "first_failure": None,
                     "hint": None, "nonce": ""})


def box(body: str, before: str = "") -> dict[str, str]:
    """An answer to 03.light_reaches_box that does something else, and then says true to everything."""
    return {"03.light_reaches_box": f"""{HEAD}{before}
namespace lightwalk::exercise {{
bool light_reaches_box(const Light& light, float radius_m, const Bounds& box) {{
    (void)light; (void)radius_m; (void)box;
    {body}
    return true;
}}
}}
"""}


def lambert(text: str) -> dict[str, str]:
    return {"02.lambert": text}


FORGED = ('struct { unsigned long long size, nonce; unsigned kind, flags; unsigned long long count; char yes; } '
          '__attribute__((packed)) all{25, 0, 0, 0, 1, 1}; for (int fd = 3; fd < 64; ++fd) (void)!write(fd, &all, sizeof all);')
ENDED, ASKED = "ended", "nobody had asked|"


def refused(calls: str) -> str:
    """Each of these system calls, "number, arguments" divided by ";", must fail."""
    named = [(call.strip(), call.partition(",")[0].strip()) for call in calls.split(";")]
    return "".join(f'if (syscall({call}) >= 0) BROKE_OUT("{name}");' for call, name in named)


def open_any(*names: str, how: str = "O_RDONLY") -> str:
    return "".join(f'if (open("{name}", {how}) >= 0) BROKE_OUT("{name}");' for name in names)


GLSL = "float lambert(vec3 normal, vec3 to_light) { return %s; }\n"
PRINT = f"std::puts({json.dumps(PASSED)}); std::fflush(stdout);"
GAVE_TRUE = "gave true"  # the attack failed, and the rest is wrong

# name: (answer, words of the verdict)
ATTACKS = {
    "prints a pass line and exits": (box(PRINT + " _exit(0);"), "ended the program"),
    "prints without an end": (box("for (;;) std::puts(\"more and more and more\");"), "did not return within 2 s"),
    "writes an answer without an end": (
        box('unsigned long long many = ~0ull; for (int fd = 3; fd < 64; ++fd) (void)!write(fd, &many, 8);'),
        "without an end"),
    "answers before it is asked": (
        box("", "[[gnu::constructor]] static void start() { " + FORGED.replace("(void)", "for (int i = 0; i < 1000; ++i) (void)") + " }\n"),
        "nobody had asked"),
    "closes everything": (box("for (int fd = 0; fd < 64; ++fd) close(fd);"), "ended|answer"),
    "calls the reference": (
        {"03.light_reaches_box": HEAD + """namespace lightwalk::solution {
bool light_reaches_box(const Light& light, float radius_m, const Bounds& box);
}
namespace lightwalk::exercise {
bool light_reaches_box(const Light& light, float radius_m, const Bounds& box) {
    return solution::light_reaches_box(light, radius_m, box);
}
}
"""}, "there is no lightwalk::solution::light_reaches_box"),
    "looks the reference up": (
        box('void* all = dlopen(nullptr, RTLD_NOW); if (dlsym(all, "_ZN9lightwalk8solution17light_reaches_boxERKNS_5LightE'
            'fRKNS_6BoundsE")) BROKE_OUT("reference");', "#include <dlfcn.h>\n"), GAVE_TRUE),
    "calls the truth": (
        box("return truth::misses_box_by(light, double(radius_m), box) < 0;",
            "namespace lightwalk::truth { double misses_box_by(const Light&, double, const Bounds&); }\n"),
        "there is no lightwalk::truth::misses_box_by"),
    "includes the reference": (box("", '#include "../solution/light_reaches_box.cpp"\n'), "No such file"),
    "takes the reference's bytes": (
        box("", 'asm(".incbin \\"ROOT/chapters/03_attenuation/solution/light_reaches_box.cpp\\"");\n'),
        "it does not compile"),
    "compiles without an end": (
        box("", "template <int n> struct Many { using A = typename Many<n + 1>::A; using B = typename Many<n + 2>::B; };\n"
                "static_assert(sizeof(Many<0>::A));\n"), "it does not compile"),
    "compiles to gigabytes": (box("", "char all[3000000000] = {1};\n"), "it does not"),
    "has a main": (box("", 'int main() { ' + PRINT + ' }\n'), "it does not link|ended"),
    "is no text": ({"03.light_reaches_box": bytes(range(256)) * 20}, "it does not compile"),
    "rewrites the checks": (
        box('for (const char* name : {"ROOT/tests/03_attenuation/checks_exercises.cpp", "ROOT/build/grade/judge_03_attenuation",'
            ' "BUILD/grade/judge_03_attenuation", "BUILD/liblightwalk.so", "BUILD/liblightwalk_check.so", "/grade/judge", "/grade/worker"}) '
            'if (std::ofstream(name, std::ios::app) << "x") BROKE_OUT(name);'), GAVE_TRUE),
    "reads the checks": (
        box('for (const char* name : {"ROOT/tests/03_attenuation/checks_exercises.cpp", '
            '"ROOT/chapters/03_attenuation/truth.h", "ROOT/chapters/03_attenuation/solution/light_reaches_box.cpp", '
            '"ROOT/shaders/03_attenuation/solution/range_fade.glsl", "BUILD/grade/seed"}) '
            'if (std::ifstream(name)) BROKE_OUT(name);'), GAVE_TRUE),
    "reads the others": (
        box('for (const char* name : {"CLASS", "/grade", "/proc/1/root/CLASS"}) if (DIR* all = opendir(name)) '
            'while (dirent* one = readdir(all)) if (!std::strncmp(one->d_name, "honest", 6)) BROKE_OUT(one->d_name);'
            'if (std::ifstream("CLASS/honest/chapters/01_obj/exercise/triangulate.cpp")) BROKE_OUT("read");'), GAVE_TRUE),
    "reads the system": (
        box('for (const char* name : {"/etc/passwd", "/etc/shadow", "/root/.bashrc", "/home", "/var/tmp", "/dev/kmsg"}) '
            '{ struct stat about; if (!stat(name, &about)) BROKE_OUT(name); }'), GAVE_TRUE),
    # The sandbox has a /tmp of its own: of a course below /tmp, the test looks afterwards whether ROOT/x is there.
    "writes outside": (
        box(f'for (const char* name : {{"{OUTSIDE}", "CLASS/x", "ROOT/x", "/usr/x", "/x", "/grade/x"}}) '
            'if (std::ofstream(name) << "x" << std::flush && std::strncmp(name, "/tmp/", 5)) BROKE_OUT(name);'), GAVE_TRUE),
    "writes the machine's settings": (
        box('for (const char* name : {"/proc/sys/kernel/core_pattern", "/proc/sys/vm/overcommit_memory", '
            '"/proc/sys/kernel/hostname", "/proc/sysrq-trigger"}) if (open(name, O_WRONLY) >= 0) BROKE_OUT(name);'), GAVE_TRUE),
    "changes the machine's devices": (
        box('for (const char* name : {"/dev/null", "/dev/zero", "/dev/urandom"}) if (!chmod(name, 0666)) BROKE_OUT(name);'
            'if (!mknod("/tmp/x", S_IFCHR | 0666, makedev(1, 1))) BROKE_OUT("mknod");', "#include <sys/sysmacros.h>\n"),
        GAVE_TRUE),
    "leaves a process behind": (
        box(f'if (fork() == 0) {{ sleep(3); std::ofstream("{OUTSIDE}"); sleep(600); }} '
            'if (fork() >= 0 || vfork() >= 0) BROKE_OUT("fork");'), GAVE_TRUE),
    "forks without an end": (box("for (;;) if (syscall(SYS_clone, SIGCHLD, 0, 0, 0, 0) > 0) BROKE_OUT(\"clone\");"),
                             "did not return within 2 s"),
    "starts threads without an end": (
        box("for (;;) std::thread([] { for (;;) pause(); }).detach();"), "threw an exception|unavailable|ended"),
    "opens a socket": (
        box(f'int s = socket(AF_UNIX, SOCK_STREAM, 0); sockaddr_un to{{}}; to.sun_family = AF_UNIX; '
            f'std::strcpy(to.sun_path + 1, "{ABSTRACT}"); '
            f'if (!connect(s, reinterpret_cast<sockaddr*>(&to), socklen_t(sizeof(sa_family_t) + 1 + std::strlen("{ABSTRACT}")))) '
            'BROKE_OUT("unix"); sockaddr_in in{}; in.sin_family = AF_INET; in.sin_port = htons(PORT); '
            'in.sin_addr.s_addr = htonl(INADDR_LOOPBACK); s = socket(AF_INET, SOCK_STREAM, 0); '
            'if (!connect(s, reinterpret_cast<sockaddr*>(&in), sizeof in)) BROKE_OUT("tcp");'), GAVE_TRUE),
    "kills its parent": (box("kill(getppid(), SIGKILL); kill(1, SIGKILL); kill(-1, SIGKILL);"), "ended|" + GAVE_TRUE),
    "stops itself": (box("raise(SIGSTOP); kill(getpid(), SIGSTOP); pause();"), "did not return within 2 s"),
    "follows its parent": (
        box('if (!ptrace(PTRACE_ATTACH, 1, 0, 0) || !ptrace(PTRACE_ATTACH, getppid(), 0, 0)) BROKE_OUT("ptrace");'
            'DIR* all = opendir("/proc"); while (dirent* one = readdir(all)) '
            'if (int other = std::atoi(one->d_name); other > 0 && other != getpid()) BROKE_OUT(one->d_name);'), GAVE_TRUE),
    "takes other rights": (
        box('if (!syscall(SYS_unshare, 0x10000000) || !setuid(0) || !chroot("/")) BROKE_OUT("rights");'
            'if (syscall(SYS_memfd_create, "x", 0) >= 0) BROKE_OUT("memory");'), GAVE_TRUE),
    "looks for the nonce": (
        box('std::ifstream all("/proc/self/environ"), words("/proc/self/cmdline"); std::stringstream text; text << all.rdbuf() << words.rdbuf(); '
            'for (const char* word : {"--nonce", "SEED", "--worker"}) '
            'if (text.str().find(word) != std::string::npos || getenv(word)) BROKE_OUT(word);'), GAVE_TRUE),
    "never returns": (box("for (volatile int i = 0;; i = i + 1) {}"), "did not return within 2 s"),
    "takes all memory": (
        box('for (size_t got = 0;; got += 1 << 24) std::memset(std::malloc(1 << 24), 1, 1 << 24);'),
                         "crashed|ended|did not return"),
    "fills the disk": (
        box('static int i = 0; for (; i < 50; ++i) { std::ofstream out("/tmp/" + std::to_string(i)); '
            'static char all[1 << 20]; for (int k = 0; k < 60; ++k) if (!out.write(all, sizeof all)) return i = 50; '
            'if (i == 40) BROKE_OUT("2 GB"); }'),
        # Which of the two ends it depends on how fast the machine fills the sandbox's /tmp.
        GAVE_TRUE + "|did not return"),
    "overflows the stack": (
        box("return deep(1) == 0;", "static int deep(volatile int n) { char big[4096]; big[n % 4096] = 1; "
                                    "return deep(n + 1) + big[(n * 7) % 4096]; }\n"), "crashed"),
    "crashes": (box("*reinterpret_cast<volatile int*>(8) = 1;"), "crashed"),
    "throws what is no exception": (box("throw 42;"), "what is no std::exception"),
    "throws a novel": (box('throw InputError("{}", std::string(20 << 20, \'x\'));'), "xxxx|did not return"),
    "throws a grade": (
        box(r'throw InputError("{}", "x\nhonest 99/99\r\x1b[2Jhonest 99/99\xe2\x80\xae\xff");'), r"\\u000ahonest"),
    "gives gigabytes": (
        {"01.triangulate": '#include "01_obj/exercises.h"\nnamespace lightwalk::exercise {\n'
         "std::vector<glm::uvec3> triangulate(std::span<const glm::vec3>) { return std::vector<glm::uvec3>(100u << 20); }\n}\n"},
        "more than can be right|crashed|exception|ended|did not return"),
    "puts itself before the harness": (
        box("", "namespace lightwalk { void guard_call(std::string) {}\n"
                "void guard_calls(std::function<void(const std::string&)>) { _exit(0); } }\n"), "ended"),
    "GLSL: includes the reference": (lambert('#include "02_lambert_phong/solution/lambert.glsl"\n'), "no file of that name"),
    "GLSL: includes itself": (lambert('#include "02_lambert_phong/lambert.glsl"\n' + GLSL % "0.5"), "gave 0.5"),
    "GLSL: never returns": (
        lambert("float lambert(vec3 normal, vec3 to_light) { float x = 0.0; for (;;) { x += normal.x; "
                "if (x == 1e30) break; } return x; }\n"), "return|end"),
    "GLSL: brackets": (lambert("float lambert(vec3 n, vec3 l) { return " + "(" * 100000 + "0.0" + ")" * 100000 + "; }\n"),
                       "ended|error|memory exhausted"),
    "GLSL: macros of macros": (
        lambert("#define Q0 0.0+0.0\n" + "".join(f"#define Q{i + 1} Q{i}+Q{i}\n" for i in range(40)) + GLSL % "Q40"),
        "end|error|bad_alloc"),
    "GLSL: calls itself": (
        lambert("float lambert(vec3 n, vec3 l);\nfloat other(vec3 n) { return lambert(n, n); }\n"
                "float lambert(vec3 n, vec3 l) { return other(n); }\n"), "Recursion|recursi"),
    "GLSL: is empty": (lambert(""), "lambert"),
    # Before main() and after it.
    "forges at exit": (box(f"std::atexit([] {{ {FORGED} }}); std::exit(0);"), ASKED + ENDED),
    "is an initialiser of its own section": (
        box("", "static void first(int, char**, char**) { " + "_exit(0); }\n"
            '[[gnu::section(".preinit_array"), gnu::used]] static void (*const begins)(int, char**, char**) = first;\n'), "ended|link"),
    "is the C library's read": (
        box("", 'extern "C" ssize_t read(int, void* into, size_t size) { std::memset(into, 1, size); return ssize_t(size); }\n'),
        "answer|ended|did not return|" + GAVE_TRUE),
    "replaces operator new": (
        box("", "#include <new>\nvoid* operator new(size_t) { for (;;) pause(); }\nvoid operator delete(void*) noexcept {}\n"
                "void operator delete(void*, size_t) noexcept {}\n"), "did not return within 2 s|ended"),
    "throws while it unwinds": (
        box("Bad bad; throw 1;", "struct Bad { ~Bad() noexcept(false) { throw 2; } };\n"), "gave up|crashed|ended"),
    # Signals.
    "lives through its crash": (
        box("static sigjmp_buf back; struct sigaction act{}; act.sa_handler = [](int) { siglongjmp(back, 1); }; "
            "act.sa_flags = SA_NODEFER; sigaction(SIGSEGV, &act, nullptr); "
            "if (!sigsetjmp(back, 1)) *reinterpret_cast<volatile int*>(8) = 1;", "#include <setjmp.h>\n"), GAVE_TRUE),
    "forgets its parent's death, by a number of 64 bits": (
        box('if (!syscall(SYS_prctl, 0x100000001ul, 0ul, 0ul, 0ul, 0ul)) BROKE_OUT("prctl");'), GAVE_TRUE),
    # The kernel's other doors.
    "asks the kernel as 32 bits": (
        box('long got = 20; asm volatile("int $0x80" : "+a"(got)); if (got > 0) BROKE_OUT("int 0x80");'), "crashed|ended|" + GAVE_TRUE),
    "asks for kernel memory": (
        box(refused("SYS_io_setup, 1024, &deep; SYS_landlock_create_ruleset, nullptr, 0, 1; SYS_io_uring_setup, 1, &deep; "
                    "SYS_inotify_init1, 0; SYS_bpf, 0, 0, 0; SYS_userfaultfd, 0; SYS_memfd_create, \"x\", 0; SYS_memfd_secret, 0; "
                    "SYS_semget, 0, 1, 0600; SYS_msgget, 0, 0600; SYS_shmget, 0, 4096, 0600; SYS_add_key, \"user\", \"x\", \"x\", 1, -3; "
                    "SYS_socket, 40, 1, 0; SYS_perf_event_open, 0, 0, -1, -1, 0"), "static long deep = 0;\n"),
        GAVE_TRUE),
    "hoards locks": (
        box('static int file = open("/grade/worker", O_RDONLY); struct flock one{}; one.l_type = F_RDLCK; one.l_len = 1; int got = 0; '
            'for (int i = 2000; i > 0; --i) { one.l_start = 2L * i; got += !fcntl(file, F_SETLK, &one); } if (got > 0) BROKE_OUT("locks");'),
        GAVE_TRUE),
    "shares memory with itself": (
        box('void* at = mmap(nullptr, 1 << 20, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0); '
            'if (at != MAP_FAILED) BROKE_OUT("shared memory"); int zero = open("/dev/zero", O_RDWR); '
            'if (mmap(nullptr, 1 << 20, PROT_READ | PROT_WRITE, MAP_SHARED, zero, 0) != MAP_FAILED) BROKE_OUT("/dev/zero");'), GAVE_TRUE),
    "makes longer pipes": (
        box('int ends[2]; if (!pipe(ends) && fcntl(ends[1], F_SETPIPE_SZ, 1 << 20) >= 0) BROKE_OUT("pipe"); '
            'if (!syscall(SYS_pipe2, ends, O_NONBLOCK) && syscall(SYS_fcntl, long(ends[1]), 0x100000407l, 1 << 20) >= 0) BROKE_OUT("pipe");'),
        GAVE_TRUE),
    "writes back the machine's disks": (box(refused("SYS_sync; SYS_syncfs, 0")), GAVE_TRUE),
    "becomes a shell that answers": (
        box("""execl("/bin/sh", "sh", "-c", "for fd in 3 4 5 6 7 8 9; do printf '%64s' 1 >&$fd; done; exit 0", nullptr);"""),
        "answer|" + ENDED),
    "raises its limits": (
        box('for (int kind = 0; kind < 16; ++kind) { rlimit is{}; getrlimit(__rlimit_resource_t(kind), &is); '
            'if (is.rlim_max == RLIM_INFINITY) continue; is.rlim_cur = is.rlim_max = is.rlim_max + 1; '
            'if (!setrlimit(__rlimit_resource_t(kind), &is)) BROKE_OUT(std::to_string(kind)); }', "#include <sys/resource.h>\n"), GAVE_TRUE),
    "goes before others": (
        box('sched_param p{1}; if (!sched_setscheduler(0, SCHED_FIFO, &p)) BROKE_OUT("scheduler"); '
            'if (!setpriority(PRIO_PROCESS, 0, -5)) BROKE_OUT("priority");', "#include <sched.h>\n#include <sys/resource.h>\n"), GAVE_TRUE),
    # Clocks.
    "sets the clock": (
        box('timespec t{1000000000, 0}; if (!clock_settime(CLOCK_REALTIME, &t)) BROKE_OUT("clock"); timex change{}; change.modes = 1; '
            'if (adjtimex(&change) >= 0) BROKE_OUT("adjtimex"); '
            'if (int file = open("/proc/self/timens_offsets", O_WRONLY); write(file, "monotonic 100000 0", 18) > 0) BROKE_OUT("timens");',
            "#include <sys/timex.h>\n#include <time.h>\n"), GAVE_TRUE),
    # Files, links, devices.
    "opens other devices": (
        box(open_any(*("/dev/" + name for name in (
            "sda vda mem kmem port kvm fuse loop0 loop-control shm mqueue pts tty console dri/card0 dri/renderD128 net/tun "
            "hwrng mapper/control nvidiactl input/event0 vhost-net").split()))), GAVE_TRUE),
    "walks up from what is open": (
        box('for (int fd = 0; fd < 256; ++fd) for (const char* name : {"../etc/passwd", "../../../../etc/passwd", "../../../../CLASS"}) '
            'if (openat(fd, name, O_RDONLY) >= 0) BROKE_OUT(name);'), GAVE_TRUE),
    "goes through the processes": (
        box(open_any("/proc/1/root/etc/passwd", "/proc/self/root/etc/passwd", "/proc/self/cwd/../etc/passwd", "/proc/kcore", "/proc/kmsg",
                     "/proc/1/mem", "/proc/kallsyms_", "/proc/sys/kernel/core_pattern", "/sys/fs/cgroup/cgroup.procs")
            .replace('if (open("/proc/1/mem"', 'if (getpid() != 1 && open("/proc/1/mem"')), GAVE_TRUE),
    "rewrites itself": (
        box(open_any("/proc/self/exe", "/grade/worker", how="O_WRONLY") + 'if (!unlink("/grade/worker") || !rename("/grade/worker", "/grade/x") || '
            '!symlink("CLASS", "/tmp/x") || !link("/grade/worker", "/tmp/x")) BROKE_OUT("link");'), GAVE_TRUE),
    "makes a file without a name": (box(open_any("/tmp", "/", "/grade", how="O_TMPFILE | O_RDWR")), GAVE_TRUE),
    # The compiler.
    "asks which files there are": (
        box("", "".join(f'#if __has_include("{name}")\n#error found {name}\n#endif\n' for name in
                        ("/etc/passwd", "ROOT/chapters/03_attenuation/truth.h", "CLASS/aa honest", "/proc/1/environ_"))), GAVE_TRUE),
    "assembles a file without an end": (box("", 'asm(".incbin \\"/dev/urandom\\"");\n'), "it does not"),
    "assembles its world": (
        box('if (std::strstr(world, "NONCE")) BROKE_OUT("nonce");',
            'asm(".data\\n.globl world\\nworld: .incbin \\"/proc/self/environ\\"\\n.byte 0\\n.text");\nextern "C" const char world[];\n'),
        GAVE_TRUE + "|it does not"),
    "is nested deeply": (box("return " + "(" * 60000 + "true" + ")" * 60000 + ";"), GAVE_TRUE + "|it does not|ended"),
    "warns that it was killed": (
        box("", '#warning "c++: fatal error: Killed signal terminated program cc1plus"\n#warning "No space left on device"\nint wrong = ;\n'),
        "it does not compile"),
    "links with a warning": (
        box("", '[[gnu::section(".gnu.warning.close"), gnu::used]] static const char said[] = "No space left on device: undefined symbol x";\n'),
        GAVE_TRUE + "|it does not"),
    # Encodings.
    "has bytes of no character": ({"03.light_reaches_box": box("")["03.light_reaches_box"].encode() + b"// \xff\xfe\xc0\xaf\n"}, GAVE_TRUE),
    "turns the reading direction": (
        box("/* \u202e } \u2066 if (false) \u2069 */"), GAVE_TRUE + "|it does not compile"),
    "GLSL: joins by a trigraph": (lambert("??=define main other\n" + GLSL % "0.5"), "error|unexpected|a name"),
    "GLSL: includes by another slash": (lambert('#include "02_lambert_phong\\\\solution\\\\lambert.glsl"\n' + GLSL % "0.5"), "no file "),
    "GLSL: conditions in conditions": (
        lambert("#if 1\n" * 9000 + GLSL % "0.5" + "#endif\n" * 9000), "gave 0.5|ended|error|nesting"),
    "GLSL: an array of gigabytes": (
        lambert("float lambert(vec3 n, vec3 l) { float a[1 << 28]; a[int(n.x * 1e8)] = 1.0; return a[int(l.x * 1e8)]; }\n"),
        "ended|error|takes element|end|memory"),
    "GLSL: writes beside its array": (
        lambert("float lambert(vec3 n, vec3 l) { float a[4]; for (int i = 0; i < 4096; ++i) a[i * int(1.0 + abs(n.x))] = 1.0; return a[0]; }\n"),
        "takes element|ended|end|gave 1"),
    "GLSL: shares a gigabyte": (
        lambert("shared float all[1 << 28];\n" + GLSL % "all[int(normal.x * 1e6)]"), "error|ended|that its starter|shared|end|memory|takes element"),
}
