"""A hull on two legs with four motors, to walk over uneven ground."""
from __future__ import annotations

import numpy

import islet
from islet.envs.spaces import Box
from islet.envs.vector import VectorEnv, columns, turned

SCALE = 30.0  # the sizes of Gymnasium's BipedalWalker-v3 are given in pixels: so many are a metre
HULL = [(-30, 9), (6, 9), (34, 1), (34, -8), (-30, -8)]
HIP_DOWN, LEG, THICK = 8 / SCALE, 34 / SCALE, 8 / SCALE  # m: from the hull's origin down to the hips; a leg part's length and width
TORQUE = 80.0  # N m, of each motor
HIP_SPEED, KNEE_SPEED = 4.0, 6.0  # rad/s, that the motors aim at
RANGE = 160 / SCALE  # m, of the rays
RAYS = 10
PIECE = 14 / SCALE  # m, a piece of ground
PIECES, FLAT = 150, 20  # of the ground, of its flat beginning
START = 10  # pieces from the ground's beginning to the start
END = (PIECES - 10) * PIECE  # m
PROGRESS = 130 / SCALE  # reward for a metre


class BipedalWalker(VectorEnv):
    """The task of Gymnasium's BipedalWalker-v3, with its sizes.

    Actions: four numbers from -1 to 1, for the hip and the knee of each leg: the sign is the motor's direction, the rest its share of 80 N m.
    Observations: the hull's angle and speeds, the angle and speed of each hip and knee, whether each foot touches the ground, and how far 10 rays from the
    hull go, as fractions of 5.3 m. Speeds are scaled to be about 1.
    Reward: 130/30 for a metre forward, -5 for a radian that the hull leans more, a little less for effort; -100 for a fall. Terminated: the hull touches the
    ground, or the walker leaves it at either end.
    """

    name = "bipedal_walker"
    dt = 1 / 50
    max_episode_steps = 1000
    single_action_space = Box(-1, 1, (4,))
    single_observation_space = Box(numpy.array([-numpy.inf] * 14 + [0] * RAYS, numpy.float32), numpy.array([numpy.inf] * 14 + [1] * RAYS, numpy.float32))

    def build(self) -> islet.World:
        world = islet.World(bodies=7, shapes=PIECES + 8, contacts=64, joints=5, enable_sleep=False)
        own = {"category": 2, "mask": 1}
        self.earth = world.create_body()
        post = world.create_body()  # what the hull's angle is seen from
        self.hull = world.create_body(type="dynamic", position=self.height())
        world.create_shape(self.hull, islet.make_polygon([(x / SCALE, y / SCALE) for x, y in HULL]), density=5, friction=0.1, filter=own)
        self.legs = []
        joints = []
        for side in (-1, 1):
            above, hip = self.hull, {"position": (0, -HIP_DOWN)}
            for part, width, lower, upper in (("hip", THICK, -0.8, 1.1), ("knee", 0.8 * THICK, -1.6, -0.1)):
                leg = world.create_body(type="dynamic", position=self.height())
                world.create_shape(leg, islet.make_box(width / 2, LEG / 2), density=1, friction=0.2, filter=own)
                joints.append(world.create_revolute_joint(body_a=above, body_b=leg, frame_a=hip, frame_b={"position": (0, LEG / 2)},
                                                          limit=(True, lower, upper), motor=(True, 0, 0)))
                self.legs.append(leg)
                above, hip = leg, {"position": (0, -LEG / 2)}
        angle = world.create_angle_joint(body_a=post, body_b=self.hull)
        self.sense("angle", "joint", joint=angle)
        self.sense("place", "position", body=self.hull)
        self.sense("velocity", "velocity", body=self.hull)
        self.sense("fell", "touching", body=self.hull)
        for i, joint in enumerate(joints):
            self.sense(f"joint{i}", "joint", joint=joint)
            self.drive("motor_speed", joint=joint, scale=HIP_SPEED if i % 2 == 0 else KNEE_SPEED)
            self.drive("motor_force", joint=joint, scale=TORQUE)
        for i in (1, 3):
            self.sense(f"foot{i}", "touching", body=self.legs[i])
        for i in range(RAYS):
            down = turned(islet.make_rot(1.5 * i / RAYS), 0, -RANGE)
            self.sense(f"ray{i}", "ray", body=self.hull, translation=down, filter={"mask": 1})
        self.progress = numpy.zeros(self.num_envs)
        self.effort = numpy.zeros(self.num_envs)
        self.pose(world)
        return world

    def height(self) -> tuple:
        return START * PIECE, 2 * LEG + HIP_DOWN

    def pose(self, world: islet.World) -> None:
        """Stands the walker at its start, knees bent a little."""
        x, y = self.height()
        world.set_transform(self.hull, (x, y), 0)
        for first, lean in ((0, 0.05), (2, -0.05)):
            top = (x, y - HIP_DOWN)
            for leg, angle in ((self.legs[first], lean), (self.legs[first + 1], lean - 0.2)):
                half = turned(islet.make_rot(angle), 0, -LEG / 2)
                world.set_transform(leg, (top[0] + half[0], top[1] + half[1]), angle)
                top = (top[0] + 2 * half[0], top[1] + 2 * half[1])

    def place(self, k: int, world: islet.World, random: numpy.random.Generator) -> None:
        rise = random.uniform(-1, 1, PIECES) / SCALE
        points, y, slope = [], 0.0, 0.0
        for i in range(PIECES + 1):
            points.append((i * PIECE, y))
            if i >= FLAT:
                slope = 0.8 * slope + (0.01 if y < 0 else -0.01) + rise[i - 1]
                y += slope
        world.create_chain(self.earth, points[::-1], friction=2.5)  # solid on its right: above
        world.set_linear_velocity(self.hull, (random.uniform(-0.1, 0.1), 0))

    def begin(self, which: numpy.ndarray) -> None:
        self.progress[which] = self._progress()[which]

    def _progress(self) -> numpy.ndarray:
        return PROGRESS * self.seen["place"][:, 0].astype(float) - 5 * abs(self.seen["angle"][:, 0].astype(float))

    def act(self, actions: numpy.ndarray) -> None:
        self.control[:, 0::2] = numpy.sign(actions)
        self.control[:, 1::2] = abs(actions)
        self.effort = 0.00035 * TORQUE * (abs(actions[:, 0]) + abs(actions[:, 1]) + abs(actions[:, 2]) + abs(actions[:, 3])).astype(float)

    def look(self) -> numpy.ndarray:
        see = self.seen
        parts = [see["angle"][:, 0], see["angle"][:, 1] * 0.04, see["velocity"] * numpy.array([0.12, 0.08], numpy.float32)]
        for first in (0, 2):
            hip, knee = see[f"joint{first}"], see[f"joint{first + 1}"]
            parts += [hip[:, 0], hip[:, 1] / numpy.float32(HIP_SPEED), knee[:, 0] + 1, knee[:, 1] / numpy.float32(KNEE_SPEED), see[f"foot{first + 1}"]]
        return columns(*parts, self.between("ray0", f"ray{RAYS - 1}"))

    def judge(self) -> tuple:
        now = self._progress()
        rewards = now - self.progress - self.effort
        self.progress = now
        x = self.seen["place"][:, 0]
        lost = (self.seen["fell"][:, 0] > 0) | (x < 0)
        return numpy.where(lost, -100.0, rewards), lost | (x > END)

    def notes(self) -> dict:
        return {"distance": self.seen["place"][:, 0] - numpy.float32(self.height()[0])}

    def view_of(self, k: int) -> tuple:
        x, y = self.seen["place"][k].tolist()
        return (x - 4.2, y - 3.6), (x + 4.2, y + 2)
