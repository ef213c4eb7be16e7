"""A pole on a cart, to be kept upright by pushing the cart."""
from __future__ import annotations

import numpy

import islet
from islet.envs.spaces import Box, Discrete
from islet.envs.vector import VectorEnv, columns, turned

CART, POLE = 1.0, 0.1  # kg
HALF = 0.5  # m, half the pole's length
FARTHEST = 2.4  # m, of the cart from the middle
STEEPEST = 0.20943951  # rad, 12 degrees, of the pole
PUSH = 10.0  # N
TOP = 0.1  # m, half the cart's height


class CartPole(VectorEnv):
    """The classic task of Barto, Sutton and Anderson (1983), with the sizes of Gymnasium's CartPole-v1.

    Actions: 0 pushes the cart to the left, 1 to the right, with 10 N.
    Observations: the cart's position (m) and speed (m/s), the pole's angle (rad, positive to the right) and speed (rad/s).
    Reward: 1 a step. Terminated: the cart is farther than 2.4 m from the middle, or the pole leans by more than 12 degrees.
    """

    name = "cart_pole"
    dt = 1 / 50
    max_episode_steps = 500
    view = ((-2.7, -1.2), (2.7, 2.4))
    single_action_space = Discrete(2)
    single_observation_space = Box(numpy.array([-2 * FARTHEST, -numpy.inf, -2 * STEEPEST, -numpy.inf], numpy.float32),
                                   numpy.array([2 * FARTHEST, numpy.inf, 2 * STEEPEST, numpy.inf], numpy.float32))

    def build(self) -> islet.World:
        world = islet.World(bodies=3, shapes=3, contacts=8, joints=2, gravity=(0, -9.8), enable_sleep=False)
        nothing = {"mask": 0}
        rail = world.create_body()
        world.create_shape(rail, islet.make_box(FARTHEST + 0.25, 0.02), filter=nothing)
        self.cart = world.create_body(type="dynamic")
        world.create_shape(self.cart, islet.make_box(0.25, TOP), filter=nothing)
        world.set_mass(self.cart, (CART, (0, 0), 0))
        self.pole = world.create_body(type="dynamic", position=(0, HALF))
        world.create_shape(self.pole, islet.make_box(0.03, HALF), filter=nothing)
        world.set_mass(self.pole, (POLE, (0, 0), POLE * HALF * HALF / 3))
        self.slide = world.create_prismatic_joint(body_a=rail, body_b=self.cart)
        self.hinge = world.create_revolute_joint(body_a=self.cart, body_b=self.pole, frame_b={"position": (0, -HALF)})
        self.drive("force_x", body=self.cart, scale=PUSH)
        self.sense("cart", "joint", joint=self.slide)
        self.sense("pole", "joint", joint=self.hinge)
        return world

    def place(self, k: int, world: islet.World, random: numpy.random.Generator) -> None:
        x, speed, lean, spin = random.uniform(-0.05, 0.05, 4)
        world.set_transform(self.cart, (x, 0), 0)
        world.set_linear_velocity(self.cart, (speed, 0))
        up = turned(islet.make_rot(-lean), 0, HALF)
        world.set_transform(self.pole, (x + up[0], up[1]), -lean)
        world.set_linear_velocity(self.pole, (speed + spin * up[1], -spin * up[0]))
        world.set_angular_velocity(self.pole, -spin)

    def act(self, actions: numpy.ndarray) -> None:
        self.control[:, 0] = 2 * actions - 1

    def look(self) -> numpy.ndarray:
        return columns(self.seen["cart"], -self.seen["pole"])

    def judge(self) -> tuple:
        far = abs(self.seen["cart"][:, 0]) > FARTHEST
        return numpy.ones(self.num_envs), far | (abs(self.seen["pole"][:, 0]) > STEEPEST)
