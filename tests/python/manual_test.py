"""The examples of docs/python.md, docs/sweeps.md and docs/environments.md run as they stand there, one after another."""
import os
import re
import unittest

from support import ROOT, falling_boxes


class Manual(unittest.TestCase):
    def run_examples(self, page, least):
        with open(os.path.join(ROOT, "docs", page), encoding="utf-8") as file:
            blocks = re.findall(r"^```python\n(.*?)^```$", file.read(), re.DOTALL | re.MULTILINE)
        self.assertGreaterEqual(len(blocks), least)
        names = {}
        for block in blocks:
            exec(compile(block, block, "exec"), names)
        return names

    def test_the_examples_run(self):
        self.run_examples("python.md", 4)
        self.run_examples("environments.md", 2)

    def test_those_of_sweeps_do(self):
        names = self.run_examples("sweeps.md", 1)
        world, _ = falling_boxes()
        self.assertEqual(names["fall"](world.copy(), 0), world.hash())


if __name__ == "__main__":
    unittest.main()
