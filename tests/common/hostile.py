"""Submissions that attack their grading: the exercise, the answer, and words of the expected verdict.

A successful attack throws "BROKE OUT", or leaves the file OUTSIDE, or gets a mark.
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


def at_start(body: str, after: str = "") -> dict[str, str]:
    """The same before main()."""
    return box(after, f"[[gnu::constructor]] static void start() {{ {body} }}\n")


def lambert(text: str) -> dict[str, str]:
    return {"02.lambert": text}


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
        at_start('struct { unsigned long long size, nonce; unsigned kind, flags; unsigned long long count; char yes; } '
                 '__attribute__((packed)) all{25, 0, 0, 0, 1, 1}; for (int fd = 3; fd < 64; ++fd) '
                 'for (int i = 0; i < 1000; ++i) (void)!write(fd, &all, sizeof all);'), "nobody had asked"),
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
    "GLSL: includes another exercise": (
        lambert('#include "02_lambert_phong/phong.glsl"\n' + GLSL % "0.5"), "an exercise that the starter does not build on"),
    "GLSL: goes round to the reference": (
        lambert('#include "common/../02_lambert_phong/solution/lambert.glsl"\n'), "a path below shaders/"),
    "GLSL: includes itself": (lambert('#include "02_lambert_phong/lambert.glsl"\n' + GLSL % "0.5"), "gave 0.5"),
    "GLSL: defines the check": (lambert("#define value what\n" + GLSL % "0.5"), "a name that others use"),
    "GLSL: defines main behind a comment that goes on": (
        lambert("// \\\n/*\n#define main other\n" + GLSL % "0.5" + "// */\n"), "a name that others use"),
    "GLSL: makes a name of two": (
        lambert("#define JOIN(a, b) a##b\n" + GLSL % "float(JOIN(probe_in, puts).length())"), "no # within a line"),
    "GLSL: names the check's inputs": (lambert(GLSL % "float(probe_inputs.length())"), "the checks' own"),
    "GLSL: asks what operations gave": (lambert(GLSL % "float(undefined_what)"), "the checks' own"),
    "GLSL: takes a buffer by its number": (
        lambert("layout(set = 0, binding = 1) buffer Mine { float all[]; } mine;\n" + GLSL % "mine.all[0]"), "that its starter"),
    "GLSL: takes memory by its address": (
        lambert("#extension GL_EXT_buffer_reference : require\n"
                "layout(buffer_reference) buffer Any { float all[]; };\n" + GLSL % "Any(uvec2(4096u, 0u)).all[0]"),
        "no exercise needs #extension"),
    "GLSL: shows a file of the host": (
        lambert('#line 1 "/etc/passwd"\n' + GLSL % "syntax error"), "no exercise needs #line"),
    "GLSL: a comment without an end": (lambert(GLSL % "0.5" + "/* "), "a comment does not end"),
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
    "GLSL: a name with a newline": (lambert('#error "\\u000a honest 99/99"\n' + GLSL % "0.5"), "error"),
    "GLSL: is empty": (lambert(""), "lambert"),
}
