"""More submissions that attack their grading, by kind: what runs before main() and after it, the kernel's other doors,
clocks, signals, encodings, very long lines and deep nesting. The form is hostile.py's."""

from hostile import GAVE_TRUE, GLSL, box, lambert

FORGED = ('struct { unsigned long long size, nonce; unsigned kind, flags; unsigned long long count; char yes; } '
          '__attribute__((packed)) all{25, 0, 0, 0, 1, 1}; for (int fd = 3; fd < 64; ++fd) (void)!write(fd, &all, sizeof all);')
ENDED, ASKED = "ended", "nobody had asked|"


def refused(calls: str) -> str:
    """Each of these system calls, "number, arguments" divided by ";", must fail."""
    named = [(call.strip(), call.partition(",")[0].strip()) for call in calls.split(";")]
    return "".join(f'if (syscall({call}) >= 0) BROKE_OUT("{name}");' for call, name in named)


def open_any(*names: str, how: str = "O_RDONLY") -> str:
    return "".join(f'if (open("{name}", {how}) >= 0) BROKE_OUT("{name}");' for name in names)


ATTACKS = {
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
    "GLSL: conditions in conditions": (
        lambert("#if 1\n" * 9000 + GLSL % "0.5" + "#endif\n" * 9000), "gave 0.5|ended|error|nesting"),
    "GLSL: an array of gigabytes": (
        lambert("float lambert(vec3 n, vec3 l) { float a[1 << 28]; a[int(n.x * 1e8)] = 1.0; return a[int(l.x * 1e8)]; }\n"),
        "ended|error|takes element|end|memory"),
    "GLSL: writes beside its array": (
        lambert("float lambert(vec3 n, vec3 l) { float a[4]; for (int i = 0; i < 4096; ++i) a[i * int(1.0 + abs(n.x))] = 1.0; return a[0]; }\n"),
        "takes element|ended|end|gave 1"),
    "GLSL: says another size": (lambert("layout(local_size_x = 1024) in;\n" + GLSL % "0.5"), "that its starter|error|gave 0.5|layout"),
    "GLSL: shares a gigabyte": (
        lambert("shared float all[1 << 28];\n" + GLSL % "all[int(normal.x * 1e6)]"), "error|ended|that its starter|shared|end|memory|takes element"),
    "GLSL: includes by another slash": (
        lambert('#include "02_lambert_phong\\\\solution\\\\lambert.glsl"\n' + GLSL % "0.5"), "no file "),
}
