"""An arm seen from above, to push a puck to a goal."""
from __future__ import annotations

import numpy

import islet
from islet.envs.spaces import Box
from islet.envs.vector import VectorEnv, columns, turned

LINKS = (0.5, 0.5, 0.3)  # m
THICK = 0.04  # m, half a link's width
SPEED, STRENGTH = 2.0, 20.0  # rad/s, N m: of the motors
PUCK, MASS = 0.12, 0.5  # m, kg
SLIDING = 0.4 * MASS * 9.8  # N, that holds the puck on the table
NEAR = 0.05  # m, from the puck to the goal: it is there


class Pusher(VectorEnv):
    """An arm of three links on a table pushes a puck, as in Gymnasium's Pusher, but in the plane. Each seed has its own places.

    Actions: the speeds of the three motors, from -1 to 1 (2 rad/s).
    Observations: cosine and sine of each link's angle in the world, the three hinges' speeds (rad/s); the places of the tip, the puck and the goal and the
    velocity of the puck (m, m/s; the base is at 0, 0).
    Reward: minus the distance from the puck to the goal, minus half the distance from the tip to the puck (m), minus 0.05 times the sum of the actions'
    squares. Never terminated. infos["there"] says whether the puck is within 5 cm of the goal.
    """

    name = "pusher"
    dt = 1 / 50
    repeat = 2
    max_episode_steps = 150
    view = ((-2.1, -1.4), (2.1, 1.4))
    single_action_space = Box(-1, 1, (3,))
    single_observation_space = Box(-numpy.inf, numpy.inf, (17,))

    def build(self) -> islet.World:
        world = islet.World(bodies=6, shapes=7, contacts=32, joints=4, gravity=(0, 0), enable_sleep=False)
        table = world.create_body()
        world.create_shape(table, islet.Circle(radius=0.1), filter={"mask": 0})
        self.links = []
        x = 0.0
        for i, length in enumerate(LINKS):
            link = world.create_body(type="dynamic", position=(x + length / 2, 0))
            shape = islet.Capsule((-length / 2, 0), (length / 2, 0), THICK)
            world.create_shape(link, shape, density=10, friction=0.2, filter={"group": -1})
            above, end = (self.links[-1], LINKS[i - 1] / 2) if i else (table, 0)
            joint = world.create_revolute_joint(body_a=above, body_b=link, frame_a={"position": (end, 0)}, frame_b={"position": (-length / 2, 0)},
                                                limit=(i > 0, -2.6, 2.6), motor=(True, 0, STRENGTH))
            self.links.append(link)
            self.drive("motor_speed", joint=joint, scale=SPEED)
            self.sense(f"turn{i}", "rotation", body=link)
            self.sense(f"joint{i}", "joint", joint=joint)
            x += length
        self.puck = world.create_body(type="dynamic", position=(1, 1), bullet=False)
        world.create_shape(self.puck, islet.Circle(radius=PUCK), friction=0.2)
        world.set_mass(self.puck, (MASS, (0, 0), MASS * PUCK * PUCK / 2))
        world.create_motor_joint(body_a=table, body_b=self.puck, max_force=SLIDING, max_torque=SLIDING * PUCK * 2 / 3, collide_connected=False)
        self.goal = world.create_body(position=(-1, 1))
        world.create_shape(self.goal, islet.Circle(radius=NEAR), sensor=True, sensor_events=False, filter={"mask": 0})
        self.sense("tip", "position", body=self.links[-1])
        self.sense("puck", "position", body=self.puck)
        self.sense("speed", "velocity", body=self.puck)
        self.sense("goal", "position", body=self.goal)
        self.effort = numpy.zeros(self.num_envs)
        return world

    def place(self, k: int, world: islet.World, random: numpy.random.Generator) -> None:
        # The arm starts to one side, bent; the puck is in front of it, the goal on the other side.
        angle, x, y = -1.2 + random.uniform(-0.2, 0.2), 0.0, 0.0
        for link, length, bend in zip(self.links, LINKS, (0.0, 0.6, 0.6)):
            angle += bend
            half = turned(islet.make_rot(angle), length / 2, 0)
            world.set_transform(link, (x + half[0], y + half[1]), angle)
            x, y = x + 2 * half[0], y + 2 * half[1]
        far, turn = random.uniform(0.65, 0.9), random.uniform(0.7, 1.3)
        world.set_transform(self.puck, turned(islet.make_rot(turn), far, 0), 0)
        far, turn = random.uniform(0.65, 0.9), random.uniform(1.8, 2.4)
        world.set_transform(self.goal, turned(islet.make_rot(turn), far, 0), 0)

    def act(self, actions: numpy.ndarray) -> None:
        self.control[:] = actions
        a = actions.astype(float)
        self.effort = 0.05 * (a[:, 0] * a[:, 0] + a[:, 1] * a[:, 1] + a[:, 2] * a[:, 2])

    def _tip(self) -> numpy.ndarray:
        return self.seen["tip"] + self.seen["turn2"] * numpy.float32(LINKS[-1] / 2)

    def look(self) -> numpy.ndarray:
        see = self.seen
        return columns(*[see[f"turn{i}"] for i in range(3)], *[see[f"joint{i}"][:, 1] for i in range(3)], self._tip(), see["puck"], see["speed"], see["goal"])

    def judge(self) -> tuple:
        puck = self.seen["puck"].astype(float)
        rewards = -_distance(puck, self.seen["goal"]) - 0.5 * _distance(puck, self._tip()) - self.effort
        return rewards, numpy.zeros(self.num_envs, bool)

    def notes(self) -> dict:
        return {"there": _distance(self.seen["puck"].astype(float), self.seen["goal"]) < NEAR}


def _distance(a: numpy.ndarray, b: numpy.ndarray) -> numpy.ndarray:
    x, y = a[:, 0] - b[:, 0], a[:, 1] - b[:, 1]
    return numpy.sqrt(x * x + y * y)
