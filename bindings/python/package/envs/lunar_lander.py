"""A lander with three engines, to be set down on a flat pad of the moon."""
from __future__ import annotations

import numpy

import islet
from islet.envs.spaces import Box, Discrete
from islet.envs.vector import VectorEnv, columns

SCALE = 30.0  # pixels of Gymnasium's LunarLander-v3 in a metre
HULL = [(-14, 17), (-17, 0), (-17, -10), (17, -10), (17, 0), (14, 17)]
LEG_AWAY, LEG_DOWN, LEG_HALF = 20 / SCALE, 18 / SCALE, (2 / SCALE, 8 / SCALE)  # m
LEG_SPRING = (True, 8, 2, 0)  # 8 Hz, damping ratio 2: what holds a leg
MAIN, SIDE, SIDE_UP = 87.0, 12.0, 14 / SCALE  # N, N, m: how far above the middle the side engines are
WIDE, HIGH = 10.0, 20 / 3  # m: half the ground, and the unit of heights
REST = LEG_DOWN + LEG_HALF[1]  # m, from the ground to the middle of a lander that stands
FLAT = (4, 6)  # the pad lies between these points of the ground
STILL = 25  # steps after which a lander that stands still has landed


class LunarLander(VectorEnv):
    """The task of Gymnasium's LunarLander-v3, with its sizes. The engines push evenly.

    Actions: 0 nothing, 1 an engine that pushes to the left and turns to the left, 2 the main engine, 3 one that pushes and turns to the right.
    Observations: place beside the pad, velocity, angle and angular velocity, all scaled to be about 1, and whether each leg touches the ground.
    Reward: how much nearer, slower, and more upright the lander gets, 10 for each leg on the ground, -0.3 for a step of the main engine and -0.03 for one of
    the others. At the end +100 for a lander at rest, -100 for one that crashed or flew away. Terminated: the hull touches the ground, the lander is farther
    than 10 m aside, or has stood still on both legs for half a second.
    """

    name = "lunar_lander"
    dt = 1 / 50
    max_episode_steps = 1000
    view = ((-1.14 * WIDE, -4), (1.14 * WIDE, 11.2))
    single_action_space = Discrete(4)
    single_observation_space = Box(numpy.array([-numpy.inf] * 6 + [0, 0], numpy.float32), numpy.array([numpy.inf] * 6 + [1, 1], numpy.float32))

    def build(self) -> islet.World:
        world = islet.World(bodies=6, shapes=24, contacts=64, joints=3, enable_sleep=False)
        own = {"category": 2, "mask": 1}
        self.earth = world.create_body()
        post = world.create_body()  # what the angle is seen from
        self.hull = world.create_body(type="dynamic", position=(0, 10))
        world.create_shape(self.hull, islet.make_polygon([(x / SCALE, y / SCALE) for x, y in HULL]), density=5, friction=0.1, filter=own)
        self.legs = []
        for side in (-1, 1):
            leg = world.create_body(type="dynamic", position=(side * LEG_AWAY, 10 - LEG_DOWN))
            world.create_shape(leg, islet.make_box(*LEG_HALF), density=5, filter=own)
            # A leg turns about the hull's middle. It gives way outward, and its spring pulls it back.
            limit = (True, 0, 0.5) if side > 0 else (True, -0.5, 0)
            world.create_revolute_joint(body_a=self.hull, body_b=leg, frame_b={"position": (-side * LEG_AWAY, LEG_DOWN)}, limit=limit,
                                        spring=LEG_SPRING)
            self.legs.append(leg)
        angle = world.create_angle_joint(body_a=post, body_b=self.hull)
        for kind in ("force_x", "force_y", "torque"):
            self.drive(kind, body=self.hull)
        self.sense("place", "position", body=self.hull)
        self.sense("velocity", "velocity", body=self.hull)
        self.sense("angle", "joint", joint=angle)
        self.sense("turn", "rotation", body=self.hull)
        self.sense("crash", "touching", body=self.hull)
        self.sense("left", "touching", body=self.legs[0])
        self.sense("right", "touching", body=self.legs[1])
        self.shaping, self.fuel = numpy.zeros(self.num_envs), numpy.zeros(self.num_envs)
        self.still = numpy.zeros(self.num_envs, int)
        return world

    def place(self, k: int, world: islet.World, random: numpy.random.Generator) -> None:
        rough = random.uniform(-HIGH / 2, HIGH / 2, 13)
        heights = (rough[:-2] + rough[1:-1] + rough[2:]) / 3
        heights[FLAT[0]:FLAT[1] + 1] = 0
        points = [(-1.2 * WIDE + 0.24 * WIDE * i, y) for i, y in enumerate(heights)]
        world.create_chain(self.earth, points[::-1], friction=0.1)  # solid on its right: above
        velocity = random.uniform(-4, 4, 2)
        for body in (self.hull, *self.legs):
            world.set_linear_velocity(body, velocity)

    def begin(self, which: numpy.ndarray) -> None:
        self.shaping[which] = self._shaping()[which]
        self.still[which] = 0

    def act(self, actions: numpy.ndarray) -> None:
        cosine, sine = self.seen["turn"][:, 0], self.seen["turn"][:, 1]
        up = numpy.where(actions == 2, numpy.float32(MAIN), numpy.float32(0))
        right = numpy.float32(SIDE) * ((actions == 3).astype(numpy.float32) - (actions == 1))
        self.control[:, 0] = cosine * right - sine * up
        self.control[:, 1] = sine * right + cosine * up
        self.control[:, 2] = -SIDE_UP * right
        self.fuel = numpy.where(actions == 2, 0.3, numpy.where(actions == 0, 0.0, 0.03))

    def look(self) -> numpy.ndarray:
        place, velocity, angle = self.seen["place"], self.seen["velocity"], self.seen["angle"]
        return columns(place[:, 0] / numpy.float32(WIDE), (place[:, 1] - numpy.float32(REST)) / numpy.float32(HIGH), velocity[:, 0] * numpy.float32(WIDE / 50),
                       velocity[:, 1] * numpy.float32(HIGH / 50), angle[:, 0], angle[:, 1] * numpy.float32(0.4), self.seen["left"], self.seen["right"])

    def _shaping(self) -> numpy.ndarray:
        x, y, vx, vy, angle, _, left, right = self.look().astype(float).T
        return -100 * numpy.sqrt(x * x + y * y) - 100 * numpy.sqrt(vx * vx + vy * vy) - 100 * abs(angle) + 10 * left + 10 * right

    def judge(self) -> tuple:
        now = self._shaping()
        rewards = now - self.shaping - self.fuel
        self.shaping = now
        velocity, spin = self.seen["velocity"], self.seen["angle"][:, 1]
        slow = (velocity[:, 0] * velocity[:, 0] + velocity[:, 1] * velocity[:, 1] < 0.0025) & (abs(spin) < 0.05)
        stands = slow & (self.seen["left"][:, 0] > 0) & (self.seen["right"][:, 0] > 0)
        self.still = numpy.where(stands, self.still + 1, 0)
        lost = (self.seen["crash"][:, 0] > 0) | (abs(self.seen["place"][:, 0]) > WIDE)
        landed = ~lost & (self.still >= STILL)
        return numpy.where(lost, -100.0, numpy.where(landed, 100.0, rewards)), lost | landed

    def notes(self) -> dict:
        return {"landed": self.still >= STILL}
