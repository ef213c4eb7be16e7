"""Spaces of actions and observations, with the interface of gymnasium.spaces: what an environment takes and gives."""
from __future__ import annotations

from typing import Any, Optional

import numpy

from islet import _islet
from islet.plain import Error


def refuse(code: str, detail: str) -> None:
    """Raises islet.Error: the detail, and the engine's sentence about the code."""
    number = _islet.ErrorCode[code]
    raise Error(f"{detail}: {_islet.describe(number)}", number)


class Space:
    """A set of arrays of one shape and type. `sample` draws one at random, from a generator that `seed` starts again."""

    def __init__(self, shape: tuple, dtype: Any, seed: Optional[int] = None) -> None:
        self.shape = tuple(shape)
        self.dtype = numpy.dtype(dtype)
        self._random: Optional[numpy.random.Generator] = None
        if seed is not None:
            self.seed(seed)

    @property
    def np_random(self) -> numpy.random.Generator:
        if self._random is None:
            self.seed()
        return self._random

    def seed(self, seed: Optional[int] = None) -> Any:
        """Starts the generator again; without a seed, by chance. Returns the seed."""
        sequence = numpy.random.SeedSequence(seed)
        self._random = numpy.random.Generator(numpy.random.PCG64(sequence))
        return sequence.entropy

    def sample(self) -> Any:
        raise NotImplementedError

    def contains(self, x: Any) -> bool:
        raise NotImplementedError

    def __contains__(self, x: Any) -> bool:
        return self.contains(x)


class Box(Space):
    """Arrays of real numbers between two bounds, each a number or an array. Where a bound is infinite there is none."""

    def __init__(self, low: Any, high: Any, shape: Optional[tuple] = None, dtype: Any = numpy.float32, seed: Optional[int] = None) -> None:
        if shape is None:
            shape = numpy.broadcast(numpy.asarray(low), numpy.asarray(high)).shape
        super().__init__(shape, dtype, seed)
        self.low = numpy.broadcast_to(numpy.asarray(low, self.dtype), self.shape).copy()
        self.high = numpy.broadcast_to(numpy.asarray(high, self.dtype), self.shape).copy()
        if not (self.low <= self.high).all():
            refuse("out_of_range", "low must be at most high")

    def is_bounded(self, manner: str = "both") -> bool:
        below, above = bool(numpy.isfinite(self.low).all()), bool(numpy.isfinite(self.high).all())
        return {"both": below and above, "below": below, "above": above}[manner]

    def sample(self) -> numpy.ndarray:
        """Even between bounds, exponential beyond one of them, normal without any."""
        random, low, high = self.np_random, numpy.isfinite(self.low), numpy.isfinite(self.high)
        made = random.normal(size=self.shape)
        far = random.exponential(size=self.shape)
        even = random.uniform(size=self.shape)
        bottom, top = numpy.where(low, self.low, 0).astype(float), numpy.where(high, self.high, 0).astype(float)
        made = numpy.where(low & ~high, bottom + far, made)
        made = numpy.where(high & ~low, top - far, made)
        made = numpy.where(low & high, bottom + even * (top - bottom), made)
        return numpy.clip(made.astype(self.dtype), self.low, self.high)

    def contains(self, x: Any) -> bool:
        x = numpy.asarray(x) if not isinstance(x, numpy.ndarray) else x
        return (x.dtype.kind in "fiu" and numpy.can_cast(x.dtype, self.dtype) and x.shape == self.shape
                and bool((x >= self.low).all() and (x <= self.high).all()))

    def taken(self, x: Any, name: str = "action") -> numpy.ndarray:
        """The array as numbers of this space: real numbers of the shape, finite, cut to the bounds. Raises islet.Error for others."""
        x = _array(x, self.shape, name, "fiu", "real numbers")
        if not numpy.isfinite(x).all():
            refuse("not_finite", name)
        return numpy.clip(x, self.low, self.high).astype(self.dtype)

    def batch(self, n: int) -> Box:
        """The space of n of these, one a row."""
        return Box(numpy.stack([self.low] * n), numpy.stack([self.high] * n), (n, *self.shape), self.dtype)

    def __repr__(self) -> str:
        return f"Box({self.low.min()}, {self.high.max()}, {self.shape}, {self.dtype})"

    def __eq__(self, other: Any) -> bool:
        return (isinstance(other, Box) and self.shape == other.shape and self.dtype == other.dtype
                and bool((self.low == other.low).all() and (self.high == other.high).all()))


class Discrete(Space):
    """The whole numbers from 0 to n - 1."""

    def __init__(self, n: int, seed: Optional[int] = None) -> None:
        super().__init__((), numpy.int64, seed)
        self.n = int(n)

    def sample(self) -> numpy.int64:
        return numpy.int64(self.np_random.integers(self.n))

    def contains(self, x: Any) -> bool:
        if isinstance(x, bool) or not isinstance(x, (int, numpy.integer, numpy.ndarray)):
            return False
        x = numpy.asarray(x)
        return x.dtype.kind in "iu" and x.shape == () and 0 <= int(x) < self.n

    def taken(self, x: Any, name: str = "action") -> numpy.ndarray:
        return _chosen(x, (), self.n, name)

    def batch(self, n: int) -> MultiDiscrete:
        return MultiDiscrete([self.n] * n)

    def __repr__(self) -> str:
        return f"Discrete({self.n})"

    def __eq__(self, other: Any) -> bool:
        return isinstance(other, Discrete) and self.n == other.n


class MultiDiscrete(Space):
    """Arrays of whole numbers, each from 0 to one less than its own bound."""

    def __init__(self, nvec: Any, seed: Optional[int] = None) -> None:
        self.nvec = numpy.array(nvec, numpy.int64)
        super().__init__(self.nvec.shape, numpy.int64, seed)

    def sample(self) -> numpy.ndarray:
        return self.np_random.integers(self.nvec)

    def contains(self, x: Any) -> bool:
        x = numpy.asarray(x) if not isinstance(x, numpy.ndarray) else x
        return x.dtype.kind in "iu" and x.shape == self.shape and bool((x >= 0).all() and (x < self.nvec).all())

    def taken(self, x: Any, name: str = "actions") -> numpy.ndarray:
        return _chosen(x, self.shape, self.nvec, name)

    def __repr__(self) -> str:
        return f"MultiDiscrete({self.nvec.tolist()})"

    def __eq__(self, other: Any) -> bool:
        return isinstance(other, MultiDiscrete) and self.shape == other.shape and bool((self.nvec == other.nvec).all())


def _array(x: Any, shape: tuple, name: str, kinds: str, what: str) -> numpy.ndarray:
    x = numpy.asarray(x)
    if x.dtype.kind not in kinds or x.shape != shape:
        refuse("out_of_range", f"{name} must be {what} of shape {shape}, not {x.dtype} of shape {x.shape}")
    return x


def _chosen(x: Any, shape: tuple, n: Any, name: str) -> numpy.ndarray:
    x = _array(x, shape, name, "iu", "whole numbers")
    if not ((x >= 0).all() and (x < n).all()):
        refuse("out_of_range", f"{name} must be from 0 to {int(numpy.max(n)) - 1}")
    return x.astype(numpy.int64)
