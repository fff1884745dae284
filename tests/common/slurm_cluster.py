"""A cluster of Slurm on this one machine, for tests: a real munged and slurmctld, and two nodes with a slurmd each. It needs Debian's
slurm-wlm and munge, and root; no systemd."""

import contextlib
import os
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path

REAL = Path(__file__).resolve().parents[2]
CONF = """ClusterName=one
SlurmctldHost={host}(127.0.0.1)
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CredType=cred/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SlurmUser=root
SlurmctldPort={port}
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.%n.pid
SlurmdSpoolDir={folder}/spool.%n
StateSaveLocation={folder}/state
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.%n.log
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
MpiDefault=none
SwitchType=switch/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SchedulerParameters=sched_interval=1,batch_sched_delay=0
MailProg=/bin/true
NodeName=n[1-2] NodeHostname={host} NodeAddr=127.0.0.1 Port=[{first}-{last}] CPUs=2 RealMemory=16000 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def why_not() -> str:
    """Why there can be no cluster here; empty where there can."""
    missing = [name for name in ("munged", "slurmctld", "slurmd", "sbatch") if not shutil.which(name, path=os.environ["PATH"] + ":/usr/sbin")]
    if missing:
        return f"there is no {', '.join(missing)}: apt-get install --no-install-recommends slurm-wlm munge"
    return "" if os.geteuid() == 0 else "slurmd starts jobs as root alone"


def free_ports(count: int) -> int:
    """The first of so many neighbouring ports that nobody listens on."""
    for first in range(17000 + os.getpid() % 5000 * 4, 65000, count):
        with contextlib.suppress(OSError), contextlib.ExitStack() as open_ports:
            for port in range(first, first + count):
                one = open_ports.enter_context(socket.socket())
                one.bind(("127.0.0.1", port))
            return first
    raise OSError("no port is free")


class Cluster:
    """with Cluster() as cluster: os.environ then makes sbatch and squeue talk to it."""

    def __enter__(self):
        self.kept = contextlib.ExitStack()
        self.folder = Path(self.kept.enter_context(tempfile.TemporaryDirectory(prefix="lightwalk.slurm.", ignore_cleanup_errors=True)))
        self.folder.chmod(0o755)
        (self.folder / "state").mkdir()
        key = self.folder / "key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o600)
        port = free_ports(3)
        for name in ("n1", "n2"):
            (self.folder / f"spool.{name}").mkdir()
        conf = self.folder / "slurm.conf"
        conf.write_text(CONF.format(folder=self.folder, host=socket.gethostname().partition(".")[0], port=port, first=port + 1, last=port + 2))
        self.before = dict(os.environ)
        os.environ["SLURM_CONF"] = str(conf)
        os.environ["PATH"] += ":/usr/sbin"
        self.daemons = []
        try:
            self.start("munged", "--foreground", "--force", f"--key-file={key}", f"--socket={self.folder}/munge.socket",
                       f"--pid-file={self.folder}/munged.pid", f"--log-file={self.folder}/munged.log", f"--seed-file={self.folder}/seed")
            self.until(lambda: (self.folder / "munge.socket").exists(), "munged")
            self.start("slurmctld", "-D", "-f", conf)
            for name in ("n1", "n2"):
                self.start("slurmd", "-D", "-N", name, "-f", conf)
            self.until(lambda: self.say("sinfo", "-h", "-o", "%T %D") == "idle 2", "Slurm")
        except BaseException:
            self.__exit__()
            raise
        return self

    def start(self, *words):
        self.daemons.append(subprocess.Popen([*map(str, words)], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                             stderr=subprocess.DEVNULL, start_new_session=True))

    def until(self, holds, what: str, most_s: float = 30):
        end = time.monotonic() + most_s
        while not holds():
            if time.monotonic() > end:
                logs = "\n".join(path.read_text(errors="replace")[-800:] for path in self.folder.glob("*.log"))
                raise TimeoutError(f"{what} did not come within {most_s:g} s: {logs}")
            time.sleep(0.05)

    @staticmethod
    def say(*words) -> str:
        return subprocess.run(words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout.strip()

    def __exit__(self, *_):
        self.say("scancel", "--user=root")
        for daemon in reversed(self.daemons):
            with contextlib.suppress(ProcessLookupError):
                daemon.terminate()
            try:
                daemon.wait(10)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()
        os.environ.clear()
        os.environ.update(self.before)
        self.kept.close()


def make_class(folder: Path, count: int):
    """Submissions of an exercise that is judged in a moment; every third is wrong, every seventh is as it was handed out, and no
    two others are alike."""
    from graded_class import PLACES, right
    text, starter = right("02.lambert"), (REAL / PLACES["02.lambert"]).read_text()
    for i in range(count):
        path = folder / f"student {i:03}" / PLACES["02.lambert"]
        path.parent.mkdir(parents=True)
        own = (text.replace("max(", "min(") if i % 3 == 2 else text) + f"// of student {i}\n"
        path.write_text(starter if i % 7 == 3 else own)


def process_of(shard: str) -> int | None:
    """The number of the process that makes a shard."""
    for path in Path("/proc").glob("[0-9]*"):
        with contextlib.suppress(OSError):
            words = (path / "cmdline").read_bytes().split(b"\0")
            if shard.encode() in words and any(word.endswith(b"cli.py") for word in words):
                return int(path.name)
    return None


def grade(folder: Path, out: Path, *words) -> subprocess.Popen:
    return subprocess.Popen([sys.executable, REAL / "common/course/cli.py", "grade", folder, "--out", out, *words], text=True,
                            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE)


def kill_and_drain(cluster: Cluster, running: subprocess.Popen, of: int) -> tuple[str, str]:
    """Kills a part at its work and drains a node for a second; what the command printed, and its messages."""
    victim = []

    def found():
        victim[:] = filter(None, [process_of(f"2/{of}")])
        return victim or running.poll() is not None
    cluster.until(found, "part 2", 120)
    time.sleep(0.3)  # half way
    os.kill(victim[0], signal.SIGKILL)
    cluster.say("scontrol", "update", "nodename=n2", "state=drain", "reason=test")
    cluster.until(lambda: "drain" in cluster.say("sinfo", "-h", "-n", "n2", "-o", "%T"), "a drained node")
    time.sleep(1)
    cluster.say("scontrol", "update", "nodename=n2", "state=resume")
    return running.communicate()


def files(folder: Path) -> dict[str, bytes]:
    return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}
