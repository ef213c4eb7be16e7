"""Points, poses and the exception: what is as plain in Python as it can be."""
from __future__ import annotations

from typing import NamedTuple


class Vec2(NamedTuple):
    """A point or direction, metres unless said otherwise. Every pair of numbers will do for one."""
    x: float = 0.0
    y: float = 0.0


class Rot(NamedTuple):
    """A rotation as cosine and sine of its angle. Where one is wanted, an angle (rad) will do."""
    c: float = 1.0
    s: float = 0.0


class Transform(NamedTuple):
    """A pose: rotate by q, then move by p (metres)."""
    p: Vec2 = Vec2()
    q: Rot = Rot()


class Aabb(NamedTuple):
    """An axis-aligned box, m: lower <= upper on both axes."""
    lower: Vec2 = Vec2()
    upper: Vec2 = Vec2()


class Error(ValueError):
    """A call that the engine refused: nothing has changed. `code` says which rule was broken, and the message how to keep it."""

    def __init__(self, message: str, code: object = None) -> None:
        super().__init__(message)
        self.code = code

    def __reduce__(self):
        return type(self), (str(self), self.code)
