"""The arm that plans in Python comes to the bits of the one in C++, through 49 000 worlds' futures. PLANNING names that program."""
import os
import subprocess
import sys
import unittest

from support import ROOT


def lines_of(*command):
    return subprocess.run(command, capture_output=True, text=True, timeout=100, check=True).stdout.splitlines()


class Planning(unittest.TestCase):
    def test_python_plans_as_cpp_does(self):
        in_python = lines_of(sys.executable, os.path.join(ROOT, "bindings", "python", "examples", "planning.py"))
        in_cpp = lines_of(os.environ["PLANNING"])
        self.assertEqual(len(in_python), 10)
        self.assertTrue(in_python[-1].startswith("state "))
        self.assertEqual(in_python[:8] + in_python[-1:], in_cpp[:8] + in_cpp[-1:])


if __name__ == "__main__":
    unittest.main()
