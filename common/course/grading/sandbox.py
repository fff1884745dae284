"""Runs a program that is not trusted, in bubblewrap: no network, nothing that can be written, process numbers of its own,
and limits of memory, time, threads and output. Without bubblewrap nothing runs.

Inside there are only the files named by Mounts; at its end nothing of it is left. It never runs as root: bubblewrap alone
gives a process of root's another number inside, but to the kernel, which owns /proc/sys and the device nodes, it stays
root. So where root grades, root makes the sandbox, and its program becomes somebody who is nobody outside before it
starts: a compiler NOBODY, a student's code a user of its own, whose threads the kernel can count.
"""

import contextlib
import dataclasses
import fcntl
import functools
import itertools
import json
import mmap
import os
import selectors
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from grading.cage import Cage
from tree import BUILD, ROOT, Failure, Unjudged, cores

PACKAGE = "bubblewrap"
SYSTEM = ("/usr", "/bin", "/sbin", "/lib", "/lib32", "/lib64", "/etc/alternatives", "/etc/ld.so.cache", "/etc/vulkan")
DEVICES = ("/dev/null", "/dev/full", "/dev/random", "/dev/urandom")  # /dev/zero is memory that no limit counts
COVERED = ("/proc/sys", "/proc/irq", "/proc/bus", "/proc/fs", "/proc/acpi", "/proc/scsi")  # the machine's own settings
# The kernel's settings that keep a user from making namespaces: the value that does, and another.
NAMESPACES = {"user.max_user_namespaces": ("0", "10000"), "kernel.unprivileged_userns_clone": ("0", "1"),
              "kernel.apparmor_restrict_unprivileged_userns": ("1", "0")}
NOBODY = 65534  # who runs it where root asks for it
TMP_BYTES = 256 << 20
OUTPUT_BYTES = 1 << 20
FILE_BYTES = 64 << 20
OPEN_FILES = 64

# System calls that nobody in a sandbox has: memory that no limit counts, other processes, other rights, other worlds.
REFUSED = """semget semop semtimedop shmget shmat shmctl msgget msgsnd msgrcv mq_open memfd_secret add_key request_key keyctl bpf
userfaultfd perf_event_open io_uring_setup inotify_init inotify_init1 fanotify_init timer_create socket socketpair vmsplice tee
splice mount umount2 pivot_root chroot fsopen fsmount fspick open_tree move_mount mount_setattr unshare setns ptrace
process_vm_readv process_vm_writev pidfd_getfd process_madvise name_to_handle_at open_by_handle_at personality quotactl acct
swapon swapoff reboot kexec_load kexec_file_load init_module finit_module delete_module syslog lookup_dcookie nfsservctl
sched_setattr sched_setaffinity mbind move_pages migrate_pages set_mempolicy kcmp io_setup landlock_create_ruleset
landlock_add_rule landlock_restrict_self sync syncfs""".split()
STARTING = ("fork", "vfork", "clone3")  # and clone() without CLONE_THREAD
CLONE_THREAD, PR_SET_PDEATHSIG = 0x10000, 1
# Each lock is the kernel's memory, and so is a longer pipe.
KEEPING = (fcntl.F_SETLK, fcntl.F_SETLKW, fcntl.F_OFD_SETLK, fcntl.F_OFD_SETLKW, fcntl.F_SETPIPE_SZ)
SHARED_ANONYMOUS = mmap.MAP_SHARED | mmap.MAP_ANONYMOUS
NUMBER = 0xFFFFFFFF  # all that the kernel takes of a number: higher bits must not hide it
OWN_USERS = range(2_000_000_000, 2_000_060_000)  # for students' code, one after the other
NUMBERS = itertools.count()
THREADS = 64
SUPERVISOR = Path(__file__).with_name("supervise.py")
CLOCK_FACTOR = 4
DATA_BYTES = 1 << 30  # of a process with a student's code, including reserved memory


@dataclasses.dataclass
class Limits:
    """Of each process: address space, processor time, size of a file it writes. The whole run's time by the clock is
    CLOCK_FACTOR times as long: a busy machine is not the answer's fault."""

    memory_bytes: int
    cpu_s: float
    processes: bool = False  # a compiler: it may start others, and write in /tmp
    # It draws. Mesa 25 keeps a device's memory in a file without a name (memfd_create), which a process without a
    # device may not have: unmapped data in it escapes all limits but that of a file's size, OPEN_FILES times.
    device: bool = False

    @property
    def wall_s(self) -> float:
        return CLOCK_FACTOR * self.cpu_s


class Mounts:
    """The files beside the system, in order: a later one may lie in an earlier one."""

    def __init__(self):
        self.words = []

    def read(self, where: Path, seen: Path | None = None):
        """A file or folder that can be read, at the same place or at another."""
        self.words += [*parents(seen or where), "--ro-bind", str(where), str(seen or where)]

    def write(self, where: Path, seen: Path):
        """A writable folder, owned by the sandbox's user."""
        if drops_root():
            os.chown(where, NOBODY, NOBODY)
        self.words += [*parents(seen), "--bind", str(where), str(seen)]

    def empty(self, seen: Path):
        self.words += [*parents(seen), "--size", str(1 << 20), "--tmpfs", str(seen)]


def parents(seen: Path) -> list[str]:
    """The folders on the way to a place: of itself bubblewrap makes them for root alone."""
    return [word for folder in reversed(Path(seen).parents[:-1]) for word in ("--perms", "0755", "--dir", str(folder))]


@functools.cache
def drops_root() -> bool:
    """Whether it is root that asks, of a system in which there is a NOBODY to become."""
    return os.geteuid() == 0 and all(is_mapped(NOBODY, Path(f"/proc/self/{kind}_map").read_text(encoding="utf-8")) for kind in ("uid", "gid"))


def is_mapped(number: int, table: str) -> bool:
    """Of a user namespace's table: whether this user is somebody outside."""
    rows = [[int(word) for word in line.split()] for line in table.splitlines()]
    return any(first <= number < first + count for first, _, count in rows)


def require_readable(paths):
    """Raises Failure if root alone can read a path meant for a sandbox."""
    for path in paths if drops_root() else ():
        wanted = 0o005 if path.is_dir() else 0o004
        if path.stat().st_mode & wanted != wanted:
            raise Failure(f"{path} cannot be read by others, and students' code does not run as root: "
                          f"chmod -R o+rX {BUILD if path.is_relative_to(BUILD) else ROOT}")


def require():
    """Raises Unjudged, with the remedy, if nothing can be contained on this machine."""
    if not shutil.which("bwrap"):
        raise Unjudged(f"students' code runs in bubblewrap alone, and it is not there: as root, apt-get install {PACKAGE}")
    try:
        import seccomp  # noqa: F401
    except ImportError:
        raise Unjudged("students' code runs behind a filter of system calls alone: as root, apt-get install python3-seccomp") from None
    try:
        done = run(["/usr/bin/true"], Mounts(), Limits(1 << 30, 20))
        said = done.said() if done.code else ""
    except Failure as failure:
        said = str(failure)
    if said:
        raise Unjudged(f"bubblewrap cannot contain anything here, and students' code runs in it alone: {said}; {remedy()}")


def remedy() -> str:
    """How this machine, or its container, allows namespaces."""
    for name, (closed, opened) in NAMESPACES.items() if not drops_root() else ():
        with contextlib.suppress(OSError):
            if Path("/proc/sys", name.replace(".", "/")).read_text(encoding="utf-8").strip() == closed:
                return f"as root, type: sysctl {name}={opened}"
    return "a container that was started with --privileged allows it"


def write_filter(limits: Limits, file):
    import errno

    import seccomp
    made = seccomp.SyscallFilter(defaction=seccomp.ALLOW)
    refused = [*REFUSED, *(() if limits.device else ("memfd_create",)), *(() if limits.processes else STARTING)]
    for name in refused:
        with contextlib.suppress(RuntimeError):  # one that this machine's kernel or library does not have
            # The C library asks for clone() where there is no clone3().
            made.add_rule(seccomp.ERRNO(errno.ENOSYS if name == "clone3" else errno.EPERM), name)
    if not limits.processes:
        made.add_rule(seccomp.ERRNO(errno.EPERM), "clone", seccomp.Arg(0, seccomp.MASKED_EQ, CLONE_THREAD, 0))
        made.add_rule(seccomp.ERRNO(errno.EPERM), "mmap", seccomp.Arg(3, seccomp.MASKED_EQ, SHARED_ANONYMOUS, SHARED_ANONYMOUS))
        for kind in KEEPING:
            made.add_rule(seccomp.ERRNO(errno.EPERM), "fcntl", seccomp.Arg(1, seccomp.MASKED_EQ, NUMBER, kind))
    made.add_rule(seccomp.ERRNO(errno.EPERM), "prctl", seccomp.Arg(0, seccomp.MASKED_EQ, NUMBER, PR_SET_PDEATHSIG))
    made.export_bpf(file)


def signal_words(code: int) -> str:
    try:
        return f", by {signal.Signals(code - 128).name}" if code > 128 else ""
    except ValueError:
        return ""


@dataclasses.dataclass
class Done:
    code: int  # 128 + a signal where one ended it
    out: str
    late: bool  # it was ended because its time was over
    long: bool  # it was ended because it wrote without an end
    hoarded: bool = False  # it came to the limit of its memory

    def said(self) -> str:
        lines = self.out.strip().splitlines()
        return lines[-1] if lines else f"it ended with {self.code}"


class Running:
    """A program that was started in a sandbox; close() or finish() ends all of it. `seconds` is then what it took of this machine."""

    def __init__(self, command, mounts: Mounts, limits: Limits, environment=None, pass_fds=(), out=True):
        self.began_s = time.monotonic()
        self.deadline = self.began_s + limits.wall_s
        with tempfile.TemporaryFile() as filter_file:
            write_filter(limits, filter_file)
            filter_file.seek(0)
            self.told, tells = os.pipe()
            self.cage = Cage(limits.memory_bytes if limits.processes else DATA_BYTES, 2 * THREADS)
            words = wrapped(command, mounts, limits, environment or {}, filter_file.fileno(), tells)
            # It joins the group by itself, before there is anything to be counted.
            joining = ["/bin/sh", "-c", 'n=$1; shift; while [ "$n" -gt 0 ]; do echo $$ 2>/dev/null >"$1"; shift; n=$((n - 1)); done; '
                       'exec "$@"', "sh", str(len(self.cage.joins)), *map(str, self.cage.joins)]
            lifeline, self.lifeline = os.pipe()
            supervising = [sys.executable, "-I", "-S", SUPERVISOR, str(lifeline), str(tells)]
            self.process = subprocess.Popen([*supervising, *joining, *words], stdin=subprocess.DEVNULL, cwd="/", start_new_session=True,
                                            pass_fds=(*pass_fds, filter_file.fileno(), tells, lifeline),
                                            stdout=subprocess.PIPE if out else subprocess.DEVNULL,
                                            stderr=subprocess.STDOUT if out else subprocess.DEVNULL)
            os.close(tells)
            os.close(lifeline)
        self.said = b""
        self.first = self.status("child-pid", wait=True)

    def status(self, name: str, wait: bool = False) -> float | None:
        """bubblewrap's own status, which nobody inside can forge: the number of the first process, and the command's exit
        code once it had started."""
        while True:
            for line in self.said.splitlines():
                with contextlib.suppress(ValueError):
                    if name in (found := json.loads(line)):
                        return found[name]
            if not wait or not (got := os.read(self.told, 4096)):
                return None
            self.said += got

    def finish(self) -> Done:
        """Waits for its end, or for the end of its time or of our patience with its output."""
        found, late, long = b"", False, False
        try:
            if self.process.stdout:
                with selectors.DefaultSelector() as selector:
                    selector.register(self.process.stdout, selectors.EVENT_READ)
                    while True:
                        left = self.deadline - time.monotonic()
                        if left <= 0 or not selector.select(left):
                            late = True
                            break
                        got = os.read(self.process.stdout.fileno(), 65536)
                        if not got:
                            break
                        found += got
                        if len(found) > OUTPUT_BYTES:
                            long = True
                            break
            if not late and not long:
                self.process.wait(max(self.deadline - time.monotonic(), 0.01))
        except subprocess.TimeoutExpired:
            late = True
        finally:
            ended = None if late or long else self.status("exit-code", wait=True)
            hoarded = self.cage.was_full()
            self.close()
        code, text = self.process.returncode, found.decode("utf-8", "replace")
        if code == 1 and ended is None and not late and not long:
            raise Failure(f"the sandbox could not be made: {text.strip()[:300]}")
        return Done(128 - code if code < 0 else code, text, late, long, hoarded)

    def kill(self):
        """Its first process takes all others with it. Not all of them end with bubblewrap: --die-with-parent forgets a
        process that becomes another user, or asks the kernel to. For any thread: readers of its output see the end of
        it."""
        if self.process.returncode is None or self.process.returncode < 0:
            with contextlib.suppress(ProcessLookupError):
                if self.first:
                    os.kill(self.first, signal.SIGKILL)
            with contextlib.suppress(ProcessLookupError):
                os.killpg(self.process.pid, signal.SIGKILL)

    def close(self):
        if self.process.poll() is None or self.process.returncode < 0:
            self.kill()
            self.process.wait()
        self.first = None
        if self.process.stdout:
            self.process.stdout.close()
        if self.told is not None:
            # Of one that was ended, or slept, the clock's: no more than a busy machine makes of it.
            self.seconds = max(self.status("processor-s", wait=self.process.returncode >= 0) or 0, (time.monotonic() - self.began_s) / CLOCK_FACTOR)
            os.close(self.told)
            os.close(self.lifeline)
            self.told = None
            self.cage.close()


def run(command, mounts: Mounts, limits: Limits) -> Done:
    return Running(command, mounts, limits).finish()


def wrapped(command, mounts: Mounts, limits: Limits, environment: dict, filter_fd: int, told_fd: int) -> list[str]:
    words = ["prlimit", f"--as={limits.memory_bytes}", f"--cpu={int(limits.cpu_s) + 1}:{int(limits.cpu_s) + 3}", f"--fsize={FILE_BYTES}", "--core=0",
             "--memlock=0", "--msgqueue=0", "--sigpending=256", f"--nofile={OPEN_FILES if limits.device else 256}", "--", "bwrap",
             *own_world(), "--die-with-parent", "--new-session", "--as-pid-1", "--hostname", "grade", "--clearenv"]
    for name, value in ({"PATH": "/usr/bin:/bin", "HOME": "/tmp", "LANG": "C.UTF-8", "TMPDIR": "/tmp", "MESA_SHADER_CACHE_DISABLE": "true",
                         "LP_NUM_THREADS": min(cores(), 8), "LIGHTWALK_SANDBOXED": "1"} | environment).items():
        words += ["--setenv", name, str(value)]
    for path in SYSTEM:
        if os.path.islink(path):
            words += ["--symlink", os.readlink(path), path]
        elif os.path.exists(path):
            words += [*parents(Path(path)), "--ro-bind", path, path]
    words += ["--perms", "0755", "--dir", "/dev"]
    for path in DEVICES:
        words += ["--dev-bind", path, path]
    words += ["--proc", "/proc"]
    for path in COVERED:
        if os.path.isdir(path):
            words += ["--size", "4096", "--tmpfs", path, "--remount-ro", path]
    # A file without a byte in it takes the kernel's memory all the same: a student's code has no folder to write in.
    words += ["--perms", "1777", "--size", str(TMP_BYTES), "--tmpfs", "/tmp"] if limits.processes else ["--dir", "/tmp"]
    return words + mounts.words + ["--remount-ro", "/", "--chdir", "/tmp", "--seccomp", str(filter_fd), "--json-status-fd", str(told_fd),
                                   "--", *becoming_nobody(limits), *[str(word) for word in command]]


def own_world() -> list[str]:
    """Namespaces. Root needs no user namespace, in which it would stay root; it keeps the capabilities to change its user."""
    if drops_root():
        return ["--unshare-ipc", "--unshare-pid", "--unshare-net", "--unshare-uts", "--unshare-cgroup-try",
                "--cap-drop", "ALL", "--cap-add", "CAP_SETUID", "--cap-add", "CAP_SETGID"]
    return ["--unshare-all", "--unshare-user", "--uid", "1000", "--gid", "1000", "--cap-drop", "ALL"]


def becoming_nobody(limits: Limits) -> list[str]:
    """How many threads a user may have is counted over all of a user's, in a world of users of its own over those in it."""
    who = []
    if drops_root():
        user = NOBODY if limits.processes else own_user()
        who = ["setpriv", f"--reuid={user}", f"--regid={user}", "--clear-groups"]
        if user == NOBODY:
            return who
    return [*who, "prlimit", f"--nproc={THREADS}", *(() if limits.processes else (f"--data={DATA_BYTES}",)), "--"]


def own_user() -> int:
    """Nobody's number, and of few sandboxes at a time."""
    table = Path("/proc/self/uid_map").read_text(encoding="utf-8")
    user = OWN_USERS[(os.getpid() * 64 + next(NUMBERS)) % len(OWN_USERS)]
    return user if is_mapped(user, table) and is_mapped(user, Path("/proc/self/gid_map").read_text(encoding="utf-8")) else NOBODY
