"""Tests of --slurm: its script, its refusals, and a class graded by a real Slurm on this machine, with a part that is
killed and a node that is drained. The cluster is a real munged and slurmctld, and two nodes with a slurmd each; it needs Debian's
slurm-wlm and munge, and root; no systemd."""

import argparse
import contextlib
import os
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path
from unittest import mock

from graded_class import PLACES, REAL, right, why_not
from many import slurm
from tree import Failure, UsageError

COUNT, PARTS = 12, 3
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


def why_no_cluster() -> str:
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


def words_of(*words) -> argparse.Namespace:
    parser = argparse.ArgumentParser()
    slurm.add_arguments(parser)
    parser.add_argument("--shard")
    parser.add_argument("--merge")
    return parser.parse_args(words)


class Script(unittest.TestCase):
    def test_a_person_can_read_it(self):
        text = slurm.script("grade", ["grade", "a class", "--chapter", "02"], Path("/f"), 16, ["--partition=short", "-t", "60"], Path("/home of"))
        self.assertEqual(text.splitlines()[1], "# ./course grade 'a class' --chapter 02, in 16 parts: one for each task of this array job.")
        for line in ("#SBATCH --array=1-16", "#SBATCH --partition=short -t 60", "#SBATCH --mem=8G", "#SBATCH --requeue",
                     '#SBATCH --chdir="/home of"', "#SBATCH --output=/f/grade.%a.log",
                     f"exec {REAL}/course grade 'a class' --chapter 02 --shard \"$SLURM_ARRAY_TASK_ID/16\" --out /f"):
            self.assertIn(line, text.splitlines())
        self.assertNotIn("--time", text)
        self.assertEqual(subprocess.run(["bash", "-n"], input=text, text=True).returncode, 0)

    def test_the_words_of_a_part(self):
        for words in (["--slurm"], ["--slurm=--mem=1G -t 3"], ["--slurm", "--mem=1G -t 3"], ["--shards", "4", "--slurm"], ["--shards=4"],
                      ["--out", "x y"]):
            self.assertEqual(slurm.without(["grade", "c", *words, "--json"], "--slurm", "--shards", "--out"), ["grade", "c", "--json"])

    def test_a_bad_word_is_one_line(self):
        with mock.patch("shutil.which", lambda name: "/bin/true"):
            slurm.check_arguments(words_of("--slurm=--partition=short --mem=16G", "--shards", "8"))
            for words, said in ((["--slurm", "class"], "put --slurm last"), (["--slurm=--array=3"], "--array is set by the course"),
                                (["--slurm=--x='"], "No closing quotation"), (["--slurm", "--shard", "1/2"], "leave out --shard"),
                                (["--shards", "4"], "give both"), (["--slurm", "--shards", "0"], "expected 1 to 1000")):
                with self.assertRaisesRegex(UsageError, said):
                    slurm.check_arguments(words_of(*words))
        with mock.patch("shutil.which", lambda name: None), self.assertRaisesRegex(UsageError, "no sbatch.*slurm-client"):
            slurm.check_arguments(words_of("--slurm"))

    def test_what_slurm_refuses_is_said(self):
        folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        (folder / "sbatch").write_text("#!/bin/sh\necho 'sbatch: error: invalid partition specified: short' >&2; exit 1\n")
        (folder / "sbatch").chmod(0o755)
        with mock.patch.dict(os.environ, PATH=f"{folder}:{os.environ['PATH']}"), \
                self.assertRaisesRegex(Failure, "invalid partition specified: short"):
            slurm.submit(Path("x.sbatch"), [1], 1)


@unittest.skipIf(why_no_cluster(), why_no_cluster())
@unittest.skipIf(why_not(), why_not())
class Graded(unittest.TestCase):
    def test_by_slurm_and_by_hand(self):
        """A part is killed at its work and a node drained; the table is that of one run."""
        parts, made = PARTS, Path(self.enterContext(tempfile.TemporaryDirectory()))
        make_class(made / "class", COUNT)
        words = ["--chapter", "02"]
        with Cluster() as cluster:
            running = grade(made / "class", made / "slurm", *words, "--slurm", "--shards", str(parts))
            printed, said = kill_and_drain(cluster, running, parts)
        self.assertEqual(running.returncode, 0, said)
        self.assertRegex(said, rf"job \d+: {parts} parts; build/slurm/grade/grade.sbatch")
        self.assertRegex(said, rf"part 2 of {parts} died: submitted again")
        self.assertRegex(said, rf"grade, Slurm {parts}/{parts}")
        whole, _ = grade(made / "class", made / "whole", *words).communicate()
        self.assertEqual(printed, whole)
        self.assertEqual(files(made / "slurm"), files(made / "whole"))
