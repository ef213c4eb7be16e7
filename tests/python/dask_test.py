"""Worlds on several worker processes of Dask: the same tables as from one process, though a worker is killed; and liars are found.

Left out where python3-distributed is missing. ISLET names the program `islet`.
"""
import os
import pickle
import subprocess
import sys
import tempfile
import unittest

try:
    from distributed import Client, LocalCluster
except ImportError:
    print("left out: Dask is missing; install python3-distributed")
    sys.exit(77)

from islet.cluster import Disagreement, spread
from support import ROOT, falling_boxes

ROLLOUTS = os.path.join(ROOT, "bindings", "python", "examples", "rollouts.py")


def fall(world, steps):
    world.step(count=steps)
    return world.hash()


def lie(number):
    return number, os.getpid()


def fail(number):
    raise ValueError(f"no {number}")


def run(*command, **options):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=200, check=False, **options)


class Rollouts(unittest.TestCase):
    def test_a_worker_killed_half_way_changes_nothing(self):
        size = ["--policies", 6, "--seeds", 20, "--block", 5, "--steps", 150]
        alone = run(sys.executable, ROLLOUTS, "--one-process", *size)
        self.assertEqual(alone.returncode, 0, alone.stderr)
        together = run(sys.executable, ROLLOUTS, "--workers", 3, "--kill", "--twice", 0.25, *size)
        self.assertEqual(together.returncode, 0, together.stderr)
        self.assertEqual(together.stdout, alone.stdout)
        self.assertEqual(len(alone.stdout.splitlines()), 7)
        self.assertIn("killed after 12 of 24 tasks", together.stderr)
        self.assertIn("6 tasks were done twice", together.stderr)
        self.assertIn("all agree", together.stderr)


class Spread(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.cluster = LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None, silence_logs=50)
        cls.client = Client(cls.cluster)

    @classmethod
    def tearDownClass(cls):
        cls.client.close()
        cls.cluster.close()

    def test_worlds_travel_and_results_keep_their_order(self):
        world, _ = falling_boxes(4)
        seen = []
        found = spread(self.client, fall, [(world, steps) for steps in range(20)], twice=0.5, progress=lambda state: seen.append((state.done, state.agreed, state.elsewhere)))
        wanted = [fall(pickle.loads(pickle.dumps(world)), steps) for steps in range(20)]
        self.assertEqual(found, wanted)
        self.assertEqual(len(set(found)), 20)
        self.assertEqual(seen[-1], (20, 10, 10), "tasks, those done twice, and those done twice by two workers")

    def test_results_that_differ_are_found(self):
        with self.assertRaisesRegex(Disagreement, "task 3: tcp://.* and tcp://.* do not agree"):
            spread(self.client, lie, [(number,) for number in range(4)], twice=0.25)
        self.assertEqual(len(spread(self.client, lie, [(1,)], twice=0)), 1)

    def test_what_a_task_raises_is_raised(self):
        with self.assertRaisesRegex(ValueError, "no 7"):
            spread(self.client, fail, [(7,)], retries=0)
        with self.assertRaisesRegex(ValueError, "twice must be"):
            spread(self.client, fall, [], twice=2)
        self.assertEqual(spread(self.client, fall, []), [])

    def sweep(self, *words, scheduler=None):
        """`islet sweep`, here or on the cluster. The program starts `python3`, which must be the one that has Islet."""
        if scheduler:
            words = [*words, "--scheduler", scheduler]
        with tempfile.TemporaryDirectory() as folder:
            os.symlink(sys.executable, os.path.join(folder, "python3"))
            return run(os.environ["ISLET"], "sweep", *words, env={**os.environ, "PATH": folder + ":" + os.environ["PATH"]})

    def test_a_sweep_on_the_cluster_is_the_sweep_of_one_process(self):
        if "ISLET" not in os.environ:
            self.skipTest("no program islet")
        here = self.cluster.scheduler_address
        sweep = ["card_house", "--vary", "friction=0.2:0.8:3", "--vary", "substeps=2,4", "--seeds", 3, "--steps", 30]
        alone, together = self.sweep(*sweep), self.sweep(*sweep, scheduler=here)
        self.assertEqual((together.returncode, together.stderr), (0, ""))
        self.assertEqual(together.stdout, alone.stdout)
        self.assertIn("18 runs (6 points, 3 seeds)", alone.stdout)
        self.assertEqual(self.sweep(*sweep, "--json", "--shards", 5, scheduler=here).stdout, self.sweep(*sweep, "--json").stdout)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "drop.json")
            with open(path, "w", encoding="utf-8") as file:
                file.write('{"steps": 5, "bodies": [{"type": "dynamic", "shapes": [{"circle": {}}]}]}')
            self.assertIn("hash of all", self.sweep(path, "--vary", "gravity=1,2", scheduler=here).stdout)

    def test_wrong_sweeps_are_refused_with_a_sentence(self):
        if "ISLET" not in os.environ:
            self.skipTest("no program islet")
        here = self.cluster.scheduler_address
        for words, sentence in ((["hello", "--vary", "frictn=1"], "near names: friction"), (["helo"], "near names: hello"),
                                (["hello", "--manifest", "x"], "without a scheduler"), (["missing.json"], "No such file")):
            refused = self.sweep(*words, scheduler=here)
            self.assertEqual(refused.returncode, 2, refused.stderr)
            self.assertIn(sentence, refused.stderr)


if __name__ == "__main__":
    unittest.main()
