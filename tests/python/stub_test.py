"""The stub (__init__.pyi) names what the module has, and nothing else."""
import ast
import enum
import os
import unittest

import islet


def members(body):
    return {n.name for n in body if isinstance(n, (ast.FunctionDef, ast.ClassDef))} | {
        n.target.id for n in body if isinstance(n, ast.AnnAssign)} | {t.id for n in body if isinstance(n, ast.Assign) for t in n.targets}


class Stub(unittest.TestCase):
    def setUp(self):
        folder = os.path.dirname(islet.__file__)
        self.assertTrue(os.path.exists(os.path.join(folder, "py.typed")))
        with open(os.path.join(folder, "__init__.pyi"), encoding="utf-8") as file:
            self.tree = ast.parse(file.read())

    def test_names_are_those_of_the_module(self):
        aliases = {t.id for n in self.tree.body if isinstance(n, ast.Assign) for t in n.targets}
        self.assertEqual(members(self.tree.body) - aliases, set(islet.__all__))

    def test_members_are_those_of_the_classes(self):
        for node in self.tree.body:
            if not isinstance(node, ast.ClassDef) or node.name in ("Vec2", "Rot", "Transform", "Aabb", "Error"):
                continue
            cls = getattr(islet, node.name)
            if issubclass(cls, enum.Enum):
                self.assertEqual({n for n in members(node.body)}, set(cls.__members__), node.name)
            else:
                public = {name for name in dir(cls) if not name.startswith("_")}
                self.assertEqual({name for name in members(node.body) if not name.startswith("_")}, public, node.name)


if __name__ == "__main__":
    unittest.main()
