"""The film made by a real Slurm on this machine, with a part that is killed and a node that is drained: the same bytes as in one run."""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "common"))
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "common/course"))
import slurm_cluster  # noqa: E402
from picture_drawing import BUILD, BUILT, HAS_SOLUTION  # noqa: E402

REAL = Path(__file__).resolve().parents[2]
FILM = Path(__file__).resolve().parent / "short.film"
WORDS = ["--scene", str(FILM), "--size", "48x27", "--fps", "6"]
PARTS = 3


@unittest.skipIf(slurm_cluster.why_not(), slurm_cluster.why_not())
@unittest.skipUnless(BUILT and HAS_SOLUTION and BUILD == REAL / "build", "needs the programs and the reference solutions in build")
class Filmed(unittest.TestCase):
    def test_by_slurm_and_by_hand(self):
        made = Path(self.enterContext(tempfile.TemporaryDirectory()))
        with slurm_cluster.Cluster() as cluster:
            running = subprocess.Popen([sys.executable, REAL / "common/course/cli.py", "run", "19", "--film", made / "slurm.raw", *WORDS, "--slurm",
                                        "--shards", str(PARTS)], text=True, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                       stderr=subprocess.PIPE)
            _, said = slurm_cluster.kill_and_drain(cluster, running, PARTS)
        self.assertEqual(running.returncode, 0, said)
        self.assertRegex(said, rf"job \d+: {PARTS} parts; build/slurm/film/film.sbatch")
        self.assertRegex(said, rf"part 2 of {PARTS} died: submitted again")
        whole = subprocess.run([BUILD / "chapters" / "19_ambiance", "--film", made / "whole.raw", *WORDS], capture_output=True, text=True)
        self.assertEqual(whole.returncode, 0, whole.stderr)
        self.assertEqual((made / "slurm.raw").read_bytes(), (made / "whole.raw").read_bytes())
        self.assertEqual(os.path.getsize(made / "whole.raw"), 30 * 48 * 27 * 4)


if __name__ == "__main__":
    unittest.main()
