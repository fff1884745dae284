"""Runs a program that is not trusted, in bubblewrap: no network, a system that cannot be written, a /tmp and process
numbers of its own, and limits of memory, time, processes and output. Without bubblewrap nothing runs.

Inside there is what Mounts names and no more; at its end nothing of it is left. It never runs as root: bubblewrap alone
gives a process of root's another number inside, but to the kernel, which owns /proc/sys and the device nodes, it stays
root. So where root grades, root makes the sandbox and its program becomes NOBODY before it starts.
"""

import contextlib
import dataclasses
import functools
import os
import platform
import re
import selectors
import shutil
import signal
import struct
import subprocess
import tempfile
import time
from pathlib import Path

from tree import BUILD, ROOT, Failure

PACKAGE = "bubblewrap"
SYSTEM = ("/usr", "/bin", "/sbin", "/lib", "/lib32", "/lib64", "/etc/alternatives", "/etc/ld.so.cache", "/etc/vulkan")
DEVICES = ("/dev/null", "/dev/zero", "/dev/full", "/dev/random", "/dev/urandom")
COVERED = ("/proc/sys", "/proc/irq", "/proc/bus", "/proc/fs", "/proc/acpi", "/proc/scsi")  # the machine's own settings
NOBODY = 65534  # who runs it where root asks for it
TMP_BYTES = 256 << 20
OUTPUT_BYTES = 1 << 20
FILE_BYTES = 64 << 20
OPEN_FILES = 64

# Linux system calls by machine: the audit number of the machine, then the calls. A thread may be started, a process not;
# and nothing that gives a process other rights, or memory that its limits do not count.
CALLS = {
    "x86_64": (0xC000003E, {"clone": 56, "fork": 57, "vfork": 58, "clone3": 435, "unshare": 272, "setns": 308,
                            "mount": 165, "ptrace": 101, "memfd_create": 319, "shmget": 29, "add_key": 248,
                            "request_key": 249, "keyctl": 250, "bpf": 321, "userfaultfd": 323, "perf_event_open": 298,
                            "io_uring_setup": 425, "process_vm_readv": 310, "process_vm_writev": 311}),
    "aarch64": (0xC00000B7, {"clone": 220, "clone3": 435, "unshare": 97, "setns": 268, "mount": 40, "ptrace": 117,
                             "memfd_create": 279, "shmget": 194, "add_key": 217, "request_key": 218, "keyctl": 219,
                             "bpf": 280, "userfaultfd": 282, "perf_event_open": 241, "io_uring_setup": 425,
                             "process_vm_readv": 270, "process_vm_writev": 271}),
}
EPERM, ENOSYS, CLONE_THREAD = 1, 38, 0x10000


@dataclasses.dataclass
class Limits:
    """Of each process: address space, processor time, size of a file it writes. `wall_s` is the whole run's."""

    memory_bytes: int
    wall_s: float
    processes: bool = False  # it may start others
    # It draws. Mesa 25 keeps a device's memory in a file without a name (memfd_create), which a process without a device
    # may not have: what is written there and not mapped is counted by no limit but that of a file's size, OPEN_FILES times.
    device: bool = False


class Mounts:
    """What there is beside the system, in order: a later one may lie in an earlier one."""

    def __init__(self):
        self.words = []

    def read(self, where: Path, seen: Path | None = None):
        """A file or folder that can be read, at the same place or at another."""
        self.words += [*parents(seen or where), "--ro-bind", str(where), str(seen or where)]

    def write(self, where: Path, seen: Path):
        """A folder that can be written. It is given to whoever writes there."""
        if drops_root():
            os.chown(where, NOBODY, NOBODY)
        self.words += [*parents(seen), "--bind", str(where), str(seen)]

    def empty(self, seen: Path):
        """A folder that is empty, whatever lies there."""
        self.words += [*parents(seen), "--size", str(1 << 20), "--tmpfs", str(seen)]


def parents(seen: Path) -> list[str]:
    """The folders on the way to a place: of itself bubblewrap makes them for root alone."""
    return [word for folder in reversed(Path(seen).parents[:-1]) for word in ("--perms", "0755", "--dir", str(folder))]


@functools.cache
def drops_root() -> bool:
    """Whether it is root that asks, of a system in which there is a NOBODY to become."""
    return os.geteuid() == 0 and all(is_mapped(NOBODY, Path(f"/proc/self/{kind}_map").read_text()) for kind in ("uid", "gid"))


def is_mapped(number: int, table: str) -> bool:
    """Of a user namespace's table: whether this user is somebody outside."""
    rows = [[int(word) for word in line.split()] for line in table.splitlines()]
    return any(first <= number < first + count for first, _, count in rows)


def require_readable(paths):
    """Raises Failure where what is to be seen in a sandbox can be read by root alone."""
    for path in paths if drops_root() else ():
        wanted = 0o005 if path.is_dir() else 0o004
        if path.stat().st_mode & wanted != wanted:
            raise Failure(f"{path} cannot be read by others, and students' code does not run as root: "
                          f"chmod -R o+rX {BUILD if path.is_relative_to(BUILD) else ROOT}")


def require():
    """Raises Failure, with what to do, where nothing can be contained on this machine."""
    if not shutil.which("bwrap"):
        raise Failure(f"students' code runs in bubblewrap alone, and it is not there: as root, apt-get install {PACKAGE}")
    if platform.machine() not in CALLS:
        raise Failure(f"no list of system calls for {platform.machine()}: there are {', '.join(CALLS)}")
    try:
        done = run(["/usr/bin/true"], Mounts(), Limits(1 << 30, 20))
        said = done.said() if done.code else ""
    except Failure as failure:
        said = str(failure)
    if said:
        raise Failure(f"bubblewrap cannot contain anything here, and students' code runs in it alone: {said}")


def seccomp(limits: Limits) -> bytes:
    """A filter of system calls, as the kernel takes it (struct sock_filter; see seccomp(2))."""
    allowed = (("clone", "clone3", "fork", "vfork") if limits.processes else ()) + (("memfd_create",) if limits.device else ())
    audit, calls = CALLS[platform.machine()]
    load, equal, at_least, any_bit, give = 0x20, 0x15, 0x35, 0x45, 0x06
    allow, refuse, kill = 0x7FFF0000, 0x00050000, 0x80000000
    code = [(load, 0, 0, 4), (equal, 1, 0, audit), (give, 0, 0, kill),
            (load, 0, 0, 0), (at_least, 0, 1, 0x40000000), (give, 0, 0, kill)]  # no x32
    for name, number in calls.items():
        if name in allowed:
            continue
        if name == "clone":
            code += [(equal, 0, 4, number), (load, 0, 0, 16), (any_bit, 1, 0, CLONE_THREAD),
                     (give, 0, 0, refuse | EPERM), (give, 0, 0, allow)]
        else:
            code += [(equal, 0, 1, number), (give, 0, 0, refuse | (ENOSYS if name == "clone3" else EPERM))]
    code.append((give, 0, 0, allow))
    return b"".join(struct.pack("<HBBI", *one) for one in code)


@dataclasses.dataclass
class Done:
    code: int  # 128 + a signal where one ended it
    out: str
    late: bool  # it was ended because its time was over
    long: bool  # it was ended because it wrote without an end

    def said(self) -> str:
        lines = self.out.strip().splitlines()
        return lines[-1] if lines else f"it ended with {self.code}"


class Running:
    """A program that was started in a sandbox; close() or finish() ends all of it."""

    def __init__(self, command, mounts: Mounts, limits: Limits, environment=None, pass_fds=(), out=True):
        self.deadline = time.monotonic() + limits.wall_s
        with tempfile.TemporaryFile() as filter_file:
            filter_file.write(seccomp(limits))
            filter_file.seek(0)
            told, tells = os.pipe()
            words = wrapped(command, mounts, limits, environment or {}, filter_file.fileno(), tells)
            self.process = subprocess.Popen(words, stdin=subprocess.DEVNULL, cwd="/", start_new_session=True,
                                            pass_fds=(*pass_fds, filter_file.fileno(), tells),
                                            stdout=subprocess.PIPE if out else subprocess.DEVNULL,
                                            stderr=subprocess.STDOUT if out else subprocess.DEVNULL)
            os.close(tells)
            with os.fdopen(told) as words:
                found = re.search(r'"child-pid": *(\d+)', words.read())
            self.first = int(found[1]) if found else 0

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
            self.close()
        code, text = self.process.returncode, found.decode("utf-8", "replace")
        if code == 1 and text.startswith("bwrap: "):
            raise Failure(f"the sandbox could not be made: {text.strip()}")
        return Done(128 - code if code < 0 else code, text, late, long)

    def kill(self):
        """Its first process takes all others with it, and not all of them end with bubblewrap: whoever becomes another
        user, or asks the kernel to, is forgotten by --die-with-parent. For any thread: whoever waits for its output sees
        the end of it."""
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
        self.first = 0
        if self.process.stdout:
            self.process.stdout.close()


def run(command, mounts: Mounts, limits: Limits, environment=None) -> Done:
    return Running(command, mounts, limits, environment).finish()


def wrapped(command, mounts: Mounts, limits: Limits, environment: dict, filter_fd: int, told_fd: int) -> list[str]:
    """The whole command line: limits, then the sandbox, then the command."""
    words = ["prlimit", f"--as={limits.memory_bytes}", f"--cpu={int(limits.wall_s) + 1}", f"--fsize={FILE_BYTES}",
             "--core=0", f"--nofile={OPEN_FILES if limits.device else 256}", "--", "bwrap", *own_world(), "--die-with-parent", "--new-session", "--as-pid-1",
             "--hostname", "grade", "--clearenv"]
    for name, value in ({"PATH": "/usr/bin:/bin", "HOME": "/tmp", "LANG": "C.UTF-8", "TMPDIR": "/tmp",
                        "LIGHTWALK_SANDBOXED": "1"} | environment).items():
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
    words += ["--perms", "1777", "--size", str(TMP_BYTES), "--tmpfs", "/tmp"]
    return words + mounts.words + ["--remount-ro", "/", "--chdir", "/tmp", "--seccomp", str(filter_fd), "--info-fd", str(told_fd), "--",
                    *becoming_nobody(), *[str(word) for word in command]]


def own_world() -> list[str]:
    """Namespaces. Root needs none of users, in which it would stay root; it keeps what it takes to become somebody."""
    if drops_root():
        return ["--unshare-ipc", "--unshare-pid", "--unshare-net", "--unshare-uts", "--unshare-cgroup-try",
                "--cap-drop", "ALL", "--cap-add", "CAP_SETUID", "--cap-add", "CAP_SETGID"]
    return ["--unshare-all", "--unshare-user", "--uid", "1000", "--gid", "1000", "--cap-drop", "ALL"]


def becoming_nobody() -> list[str]:
    return ["setpriv", f"--reuid={NOBODY}", f"--regid={NOBODY}", "--clear-groups"] if drops_root() else []
