"""Environments for learning, with Gymnasium's interface: worlds with an action to take, an observation to see and a reward.

    env = islet.envs.make("cart_pole")
    observation, info = env.reset(seed=1)
    observation, reward, terminated, truncated, info = env.step(env.action_space.sample())

make_vec() makes many that step together, as a fleet. Gymnasium itself is not needed. The same seeds and actions give the same bits on every machine.
"""
from __future__ import annotations

from typing import Any, Optional

from islet.envs.acrobot import Acrobot
from islet.envs.base import ClosedEnvironment, Env, ResetNeeded
from islet.envs.bipedal_walker import BipedalWalker
from islet.envs.car_racing import CarRacing
from islet.envs.cart_pole import CartPole
from islet.envs.grasping import Grasping
from islet.envs.lunar_lander import LunarLander
from islet.envs.pusher import Pusher
from islet.envs.spaces import Box, Discrete, MultiDiscrete, Space
from islet.envs.stacking import Stacking
from islet.envs.vector import AutoresetMode, VectorEnv

ALL = {kind.name: kind for kind in (CartPole, Acrobot, LunarLander, BipedalWalker, CarRacing, Pusher, Grasping, Stacking)}

__all__ = ["ALL", "AutoresetMode", "Box", "ClosedEnvironment", "Discrete", "Env", "MultiDiscrete", "ResetNeeded", "Space", "VectorEnv",
           "make", "make_vec", "names"]


def names() -> list:
    """What make() and make_vec() know."""
    return list(ALL)


def make(name: str, render_mode: Optional[str] = None, **options: Any) -> Env:
    """An environment by its name. Options: max_episode_steps, after which an episode is truncated; those of its class."""
    return Env(_kind(name)(1, **options), render_mode)


def make_vec(name: str, num_envs: int = 1, workers: int = 1, **options: Any) -> VectorEnv:
    """So many environments that step together, on so many threads. The number of threads changes no bit."""
    return _kind(name)(num_envs, workers=workers, **options)


def _kind(name: str) -> Any:
    if name not in ALL:
        raise ValueError(f"there is no environment {name!r}; there are {', '.join(ALL)}")
    return ALL[name]
