"""One environment at a time, with the interface of gymnasium.Env. It is a vector of one (vector.py) without the resets that come by themselves."""
from __future__ import annotations

from typing import Any, Optional

import numpy


class ResetNeeded(RuntimeError):
    """A step before the first reset, or after the episode's end."""


class ClosedEnvironment(RuntimeError):
    """A call after close()."""


def of_one(infos: dict) -> dict:
    """What a vector's infos tell of its only environment."""
    return {name: values[0].item() for name, values in infos.items() if not name.startswith("_")}


class Env:
    """reset() starts an episode, and step(action) goes on with it until it is terminated (the task came to an end) or truncated (time is up).

    Arrays that it returns are the caller's own. `vector` has the fleet and its world.
    """

    spec = None

    def __init__(self, vector: Any, render_mode: Optional[str] = None) -> None:
        if vector.num_envs != 1:
            raise ValueError("an Env is a vector of one")
        if render_mode is not None and render_mode not in vector.metadata["render_modes"]:
            raise ValueError(f"render_mode must be None or one of {vector.metadata['render_modes']}")
        self.vector = vector
        self.render_mode = render_mode
        self.metadata = {name: value for name, value in vector.metadata.items() if name != "autoreset_mode"}
        self.action_space = vector.single_action_space
        self.observation_space = vector.single_observation_space
        self._goes_on = False

    @property
    def unwrapped(self) -> Env:
        return self

    @property
    def world(self) -> Any:
        """The islet.World."""
        return self.vector.fleet[0]

    @property
    def np_random(self) -> numpy.random.Generator:
        return self.vector.np_random[0]

    def reset(self, *, seed: Optional[int] = None, options: Optional[dict] = None) -> tuple:
        """Starts an episode: (observation, info). A seed decides this episode and all that follow it; without one, chance goes on."""
        observations, infos = self.vector.reset(seed=seed, options=options)
        self._goes_on = True
        return observations[0].copy(), of_one(infos)

    def step(self, action: Any) -> tuple:
        """(observation, reward, terminated, truncated, info). An action that is not of the space raises islet.Error and changes nothing."""
        self.vector.check_open()
        if not self._goes_on:
            raise ResetNeeded("call reset() before the first step and after the last one of an episode")
        action = self.action_space.taken(action)
        observations, rewards, terminated, truncated, infos = self.vector.step(action[None])
        self._goes_on = not (terminated[0] or truncated[0])
        return observations[0].copy(), float(rewards[0]), bool(terminated[0]), bool(truncated[0]), of_one(infos)

    def render(self) -> Optional[str]:
        """A picture as an SVG document, if render_mode is "svg"."""
        self.vector.check_open()
        return None if self.render_mode is None else self.vector.picture(0)

    def close(self) -> None:
        self.vector.close()

    def __enter__(self) -> Env:
        return self

    def __exit__(self, *_: Any) -> bool:
        self.close()
        return False

    def __repr__(self) -> str:
        return f"<islet.envs.{type(self.vector).__name__}>"
