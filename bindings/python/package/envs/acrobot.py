"""Two links that hang from a hinge, to be swung up by a motor between them."""
from __future__ import annotations

import numpy

import islet
from islet.envs.spaces import Box, Discrete
from islet.envs.vector import VectorEnv, columns, turned

LENGTH = 1.0  # m, of a link
MASS, INERTIA = 1.0, 1.0  # kg, kg m^2 about a link's middle
TORQUE = 1.0  # N m
FASTEST = (12.566371, 28.274334)  # rad/s, 4 pi and 9 pi: faster ones are seen as these


class Acrobot(VectorEnv):
    """The classic task of Sutton (1996), with the sizes of Gymnasium's Acrobot-v1.

    Actions: the torque at the middle hinge is -1, 0 or 1 N m.
    Observations: cosine and sine of the first link's angle (from hanging) and of the second's (from the first), both speeds (rad/s).
    Reward: -1 a step, 0 for the last. Terminated: the tip is more than 1 m above the upper hinge.
    """

    name = "acrobot"
    dt = 1 / 50
    repeat = 10
    max_episode_steps = 500
    view = ((-3.6, -2.4), (3.6, 2.4))
    single_action_space = Discrete(3)
    single_observation_space = Box(numpy.array([-1, -1, -1, -1, -FASTEST[0], -FASTEST[1]], numpy.float32),
                                   numpy.array([1, 1, 1, 1, *FASTEST], numpy.float32))

    def build(self) -> islet.World:
        world = islet.World(bodies=3, shapes=3, contacts=8, joints=2, gravity=(0, -9.8), enable_sleep=False)
        nothing = {"mask": 0}
        base = world.create_body()
        world.create_shape(base, islet.make_box(0.15, 0.05), filter=nothing)
        self.links, self.hinges = [], []
        for i in range(2):
            link = world.create_body(type="dynamic", position=(0, -LENGTH * (i + 0.5)))
            world.create_shape(link, islet.Capsule((0, -LENGTH / 2), (0, LENGTH / 2), 0.06), filter=nothing)
            world.set_mass(link, (MASS, (0, 0), INERTIA))
            self.hinges.append(world.create_revolute_joint(body_a=self.links[0] if i else base, body_b=link, frame_a={"position": (0, -LENGTH / 2 * i)},
                                                           frame_b={"position": (0, LENGTH / 2)}))
            self.links.append(link)
            self.sense(f"turn{i}", "rotation", body=link)
            self.sense(f"hinge{i}", "joint", joint=self.hinges[i])
        self.drive("joint_torque", joint=self.hinges[1], scale=TORQUE)
        return world

    def place(self, k: int, world: islet.World, random: numpy.random.Generator) -> None:
        angles, speeds = random.uniform(-0.1, 0.1, 2), random.uniform(-0.1, 0.1, 2)
        self.pose(world, angles, speeds)

    def pose(self, world: islet.World, angles: tuple, speeds: tuple) -> None:
        """Sets the angles (rad) and speeds (rad/s): the first link's from hanging, the second's from the first."""
        x = y = vx = vy = angle = spin = 0.0
        for i, link in enumerate(self.links):
            angle, spin = angle + angles[i], spin + speeds[i]
            half = turned(islet.make_rot(angle), 0, -LENGTH / 2)
            world.set_transform(link, (x + half[0], y + half[1]), angle)
            world.set_linear_velocity(link, (vx - spin * half[1], vy + spin * half[0]))
            world.set_angular_velocity(link, spin)
            x, y, vx, vy = x + 2 * half[0], y + 2 * half[1], vx - 2 * spin * half[1], vy + 2 * spin * half[0]

    def act(self, actions: numpy.ndarray) -> None:
        self.control[:, 0] = actions - 1

    def look(self) -> numpy.ndarray:
        first, second = self.seen["turn0"], self.seen["turn1"]
        cosine = first[:, 0] * second[:, 0] + first[:, 1] * second[:, 1]
        sine = first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]
        speeds = [numpy.clip(self.seen[f"hinge{i}"][:, 1], -FASTEST[i], FASTEST[i]) for i in range(2)]
        return numpy.clip(columns(first, cosine, sine, *speeds), self.single_observation_space.low, self.single_observation_space.high)

    def judge(self) -> tuple:
        up = -self.seen["turn0"][:, 0] - self.seen["turn1"][:, 0] > 1
        return numpy.where(up, 0.0, -1.0), up
