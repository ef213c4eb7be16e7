"""Many environments at once, with the interface of gymnasium.vector.VectorEnv: worlds of a fleet, actions in and observations out as arrays."""
from __future__ import annotations

import enum
from typing import Any, Optional, Sequence, Union

import numpy

import islet
from islet.envs.base import ClosedEnvironment, ResetNeeded
from islet.envs.spaces import Space, refuse

WIDTHS = {"position": 2, "rotation": 2, "velocity": 2, "angular_velocity": 1, "joint": 2, "touching": 1, "ray": 1}  # columns of a sense


class AutoresetMode(enum.Enum):
    """When an environment that has ended starts again, as in gymnasium.vector."""
    NEXT_STEP = "NextStep"  # in the step after its end
    DISABLED = "Disabled"  # when reset() is told to; until then it stays as it is, with reward 0


class VectorEnv:
    """What all environments share. An environment's own class says what its world is, how worlds start, what actions do, and what is seen and rewarded.

    An episode that has ended starts again in the next step, which ignores its action, and returns the first observation, reward 0 and neither end.
    (With AutoresetMode.DISABLED, it waits for reset().) Arrays that are returned are the caller's own.
    """

    # What each environment says.
    name = ""
    dt = 1 / 50  # s, of a step of the world
    repeat = 1  # steps of the world in a step of the environment
    max_episode_steps = 500  # after which an episode is truncated
    view: Any = ((-3, -1), (3, 3))  # m, what pictures show
    single_action_space: Space
    single_observation_space: Space

    spec = None

    def build(self) -> islet.World:
        """The world of which all are copies. Names what is driven and seen with drive() and sense()."""
        raise NotImplementedError

    def place(self, k: int, world: islet.World, random: numpy.random.Generator) -> None:
        """Gives world k, which is as it was built, its start."""

    def begin(self, which: numpy.ndarray) -> None:
        """Begins what is remembered of these environments, whose worlds have been placed and seen."""

    def act(self, actions: numpy.ndarray) -> None:
        """Sets self.control, a column for each drive."""
        raise NotImplementedError

    def look(self) -> numpy.ndarray:
        """The observations, from self.seen."""
        raise NotImplementedError

    def judge(self) -> tuple:
        """(rewards, terminated) of the step that was taken."""
        raise NotImplementedError

    def notes(self) -> dict:
        """More about each environment, for infos: {name: array}."""
        return {}

    # What all do.

    def __init__(self, num_envs: int = 1, workers: int = 1, render_mode: Optional[str] = None, max_episode_steps: Optional[int] = None,
                 autoreset_mode: Union[AutoresetMode, str] = AutoresetMode.NEXT_STEP) -> None:
        self.metadata = {"render_modes": ["svg"], "render_fps": round(1 / (self.dt * self.repeat)), "autoreset_mode": AutoresetMode(autoreset_mode)}
        if render_mode is not None and render_mode not in self.metadata["render_modes"]:
            raise ValueError(f"render_mode must be None or one of {self.metadata['render_modes']}")
        if max_episode_steps is not None:
            self.max_episode_steps = whole(max_episode_steps, "max_episode_steps")
        self.num_envs = num_envs = whole(num_envs, "num_envs")
        self.render_mode = render_mode
        self.action_space = self.single_action_space.batch(num_envs)
        self.observation_space = self.single_observation_space.batch(num_envs)
        self.closed = False
        self._drives: list = []
        self._senses: list = []
        self._columns: dict = {}
        self._width = 0
        world = self.build()
        self._start = world.save()
        self.fleet = islet.Fleet(world, num_envs, workers=workers, drives=self._drives, senses=self._senses)
        self.control = numpy.zeros((num_envs, len(self._drives)), numpy.float32)
        self._raw = numpy.zeros((num_envs, self._width), numpy.float32)
        self._name_columns()
        self.np_random: list = [None] * num_envs
        self.steps = numpy.zeros(num_envs, numpy.int64)  # of each episode so far
        self._over = numpy.zeros(num_envs, bool)
        self._started = False

    @property
    def unwrapped(self) -> VectorEnv:
        return self

    def drive(self, kind: str, **fields: Any) -> int:
        """One more column of self.control (islet.Drive). Returns its number."""
        self._drives.append(islet.Drive(kind, **fields))
        return len(self._drives) - 1

    def sense(self, name: str, kind: str, **fields: Any) -> None:
        """Fills self.seen[name], an array of num_envs rows (islet.Sense)."""
        self._senses.append(islet.Sense(kind, **fields))
        self._columns[name] = slice(self._width, self._width + WIDTHS[kind])
        self._width += WIDTHS[kind]

    def between(self, first: str, last: str) -> numpy.ndarray:
        """What the senses from one to another see, side by side."""
        return self._raw[:, self._columns[first].start:self._columns[last].stop]

    def check_open(self) -> None:
        if self.closed:
            raise ClosedEnvironment("the environment is closed")

    def reset(self, *, seed: Union[None, int, Sequence[Optional[int]]] = None, options: Optional[dict] = None) -> tuple:
        """Starts episodes: (observations, infos). Environment k has the seed's k-th number, or, of one number, seed + k. `options` may have a "reset_mask",
        an array of bool: only these start again.
        """
        self.check_open()
        which = self._reset_mask(options)
        seeds = self._seeds(seed)
        for k, number in enumerate(seeds):
            if which[k] and (number is not None or self.np_random[k] is None):
                self.np_random[k] = numpy.random.Generator(numpy.random.PCG64(number))
        self._restart(which)
        self._over[which] = False
        self._started = True
        return self._observations(), self._infos()

    def step(self, actions: Any) -> tuple:
        """(observations, rewards, terminated, truncated, infos). Actions that are not of the space raise islet.Error and change nothing."""
        self.check_open()
        if not self._started:
            raise ResetNeeded("call reset() before the first step")
        self.act(self.action_space.taken(actions, "actions"))
        again = self._over
        self.advance(~again if again.any() else None)
        restarts = self.metadata["autoreset_mode"] is AutoresetMode.NEXT_STEP
        if restarts:
            self._restart(again)
        rewards, terminated = self.judge()
        self.steps += ~again
        terminated = terminated & ~again
        truncated = (self.steps >= self.max_episode_steps) & ~again
        self._over = terminated | truncated if restarts else terminated | truncated | again
        return self._observations(), numpy.where(again, 0.0, rewards), terminated, truncated, self._infos()

    def advance(self, mask: Optional[numpy.ndarray]) -> None:
        """Steps the worlds with self.control, and fills self.seen."""
        self.fleet.step(self.control, self.dt, self.repeat, mask, self._raw)

    def picture(self, k: int) -> str:
        """World k as an SVG document."""
        return self.fleet[k].svg(self.view_of(k), self.name.replace("_", " "), self.dt, joints=False)

    def view_of(self, k: int) -> Any:
        return self.view

    def render(self) -> Optional[tuple]:
        """A picture of each, as SVG documents, if render_mode is "svg"."""
        self.check_open()
        return None if self.render_mode is None else tuple(self.picture(k) for k in range(self.num_envs))

    def close(self) -> None:
        self.closed = True

    def _name_columns(self) -> None:
        self.seen = {name: self._raw[:, columns] for name, columns in self._columns.items()}

    def __getstate__(self) -> dict:
        return {name: value for name, value in self.__dict__.items() if name != "seen"}

    def __setstate__(self, state: dict) -> None:
        self.__dict__.update(state)
        self._name_columns()

    def _observations(self) -> numpy.ndarray:
        """What look() gives, as an array that is nobody else's."""
        return numpy.array(self.look(), numpy.float32)

    def _infos(self) -> dict:
        infos = {}
        for name, values in self.notes().items():
            infos[name] = numpy.array(values)
            infos["_" + name] = numpy.ones(self.num_envs, bool)
        return infos

    def _restart(self, which: numpy.ndarray) -> None:
        if not which.any():
            return
        for k in numpy.flatnonzero(which):
            self.fleet.reset(k, self._start)
            self.place(k, self.fleet[k], self.np_random[k])
        self.steps[which] = 0
        self.fleet.observe(which, self._raw)
        self.begin(which)

    def _reset_mask(self, options: Optional[dict]) -> numpy.ndarray:
        if options is not None and not isinstance(options, dict):
            raise TypeError(f"options must be a dict or None, not {options!r}")
        mask = (options or {}).get("reset_mask")
        if mask is None:
            return numpy.ones(self.num_envs, bool)
        if not isinstance(mask, numpy.ndarray) or mask.dtype != bool or mask.shape != (self.num_envs,) or not mask.any():
            refuse("out_of_range", f"reset_mask must be an array of bool of shape ({self.num_envs},), one of them true")
        if not self._started and not mask.all():
            raise ResetNeeded("the first reset starts all environments")
        return mask

    def _seeds(self, seed: Union[None, int, Sequence[Optional[int]]]) -> Sequence[Optional[int]]:
        if seed is None:
            return [None] * self.num_envs
        seeds = [int(seed) + k for k in range(self.num_envs)] if is_whole(seed) else list(seed) if isinstance(seed, (list, tuple, numpy.ndarray)) else []
        if len(seeds) != self.num_envs or any(s is not None and (not is_whole(s) or s < 0) for s in seeds):
            refuse("out_of_range", f"seed must be a number of at least 0, or {self.num_envs} of them")
        return seeds

    def __repr__(self) -> str:
        return f"<islet.envs.{type(self).__name__}: {self.num_envs} environments>"


def is_whole(number: Any) -> bool:
    return isinstance(number, (int, numpy.integer)) and not isinstance(number, bool)


def whole(number: Any, name: str) -> int:
    """A number of at least 1."""
    if not is_whole(number) or number < 1:
        refuse("out_of_range", f"{name} must be a whole number of at least 1, not {number!r}")
    return int(number)


# -- for environments ---------------------------------------------------------------------------------------------------------------------


def turned(q: Any, x: Any, y: Any) -> tuple:
    """The vector (x, y) turned by q = (cosine, sine)."""
    return q[0] * x - q[1] * y, q[1] * x + q[0] * y


def columns(*parts: numpy.ndarray) -> numpy.ndarray:
    """Arrays of one number or more for each environment, side by side."""
    return numpy.concatenate([part if part.ndim == 2 else part[:, None] for part in parts], axis=1)
