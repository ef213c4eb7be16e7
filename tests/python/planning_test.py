"""What plans in Python comes to the bits of what plans in C++, through 49 000 futures of the arm and 20 000 of the walker. PLANNING names that program."""
import os
import subprocess
import sys
import unittest

from support import ROOT


def lines_of(*command):
    return subprocess.run(command, capture_output=True, text=True, timeout=100, check=True).stdout.splitlines()


class Planning(unittest.TestCase):
    def agrees(self, machine, lines):
        in_python = lines_of(sys.executable, os.path.join(ROOT, "bindings", "python", "examples", "planning.py"), machine)
        in_cpp = lines_of(os.environ["PLANNING"], machine)
        self.assertEqual(len(in_python), lines + 2)
        self.assertTrue(in_python[-1].startswith("state "))
        self.assertEqual(in_python[:lines] + in_python[-1:], in_cpp[:lines] + in_cpp[-1:])

    def test_the_arm_in_python_plans_as_in_cpp(self):
        self.agrees("arm", 8)

    def test_the_walker_in_python_plans_as_in_cpp(self):
        self.agrees("walker", 5)


if __name__ == "__main__":
    unittest.main()
