"""A box on the floor, to be grasped and lifted."""
from __future__ import annotations

import numpy

import islet
from islet.envs.gripper import HALF, RAIL, Gripper, apart, observation_space

HIGH = 1.0  # m, above the floor: where the box is wanted


class Grasping(Gripper):
    __doc__ = f"""A gripper fetches a box, which stands somewhere on the floor.

    {Gripper.__doc__.strip()}
    Reward: minus a tenth of the distance from the box to between the fingers (m), plus how high it is (m), and 10 for the end.
    Terminated: the box, held by both fingers, is 1 m above the floor, or it has left the rail's reach (-10).
    """

    name = "grasping"
    single_observation_space = observation_space(1)

    def place(self, k: int, world: islet.World, random: numpy.random.Generator) -> None:
        self.put(world, [random.uniform(-1.5, 1.5)])

    def lifted(self) -> numpy.ndarray:
        """Whether each box is held up high."""
        return (self.seen["cube0"][:, 1] - numpy.float32(HALF) > HIGH) & (self.seen["touch0"][:, 0] > 0) & (self.seen["touch1"][:, 0] > 0)

    def judge(self) -> tuple:
        cube = self.seen["cube0"]
        done, lost = self.lifted(), abs(cube[:, 0]) > RAIL + 0.3
        rewards = (cube[:, 1] - HALF).astype(float) - 0.1 * apart(cube, self.tips())
        return rewards + 10 * done - 10.0 * lost, done | lost

    def notes(self) -> dict:
        return {"lifted": self.lifted()}
