"""Two boxes on the floor, to be stacked by a gripper."""
from __future__ import annotations

import numpy

import islet
from islet.envs.gripper import HALF, RAIL, Gripper, apart, observation_space, rest

STILL = 10  # steps that the upper box must rest


class Stacking(Gripper):
    __doc__ = f"""A gripper puts the first box on the second one, and lets go.

    {Gripper.__doc__.strip()}
    Reward: minus a tenth of the distance from the first box to between the fingers (m), minus its distance from its place on the second box (m), and 10 for
    the end. Terminated: the first box has rested on the second for 10 steps without the fingers, or a box has left the rail's reach (-10).
    """

    name = "stacking"
    boxes = 2
    max_episode_steps = 500
    single_observation_space = observation_space(2)

    def build(self) -> islet.World:
        world = super().build()
        self.still = numpy.zeros(self.num_envs, int)
        return world

    def place(self, k: int, world: islet.World, random: numpy.random.Generator) -> None:
        left, right = random.uniform(-1.5, -0.6), random.uniform(0.6, 1.5)
        self.put(world, [left, right] if random.random() < 0.5 else [right, left])

    def begin(self, which: numpy.ndarray) -> None:
        self.still[which] = 0

    def judge(self) -> tuple:
        see = self.seen
        upper, lower = see["cube0"], see["cube1"]
        wanted = lower + numpy.array([0, 2 * HALF], numpy.float32)
        free = (see["touch0"][:, 0] == 0) & (see["touch1"][:, 0] == 0)
        on_it = (abs(upper[:, 1] - wanted[:, 1]) < 0.02) & (abs(upper[:, 0] - wanted[:, 0]) < HALF) & rest(see["speed0"]) & free
        self.still = numpy.where(on_it, self.still + 1, 0)
        done = self.still >= STILL
        lost = (abs(upper[:, 0]) > RAIL + 0.3) | (abs(lower[:, 0]) > RAIL + 0.3)
        return -0.1 * apart(upper, self.tips()) - apart(upper, wanted) + 10 * done - 10.0 * lost, done | lost

    def notes(self) -> dict:
        return {"stacked": self.still >= STILL}
