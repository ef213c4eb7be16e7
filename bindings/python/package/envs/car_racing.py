"""A car seen from above, to be driven once around a track as fast as it can."""
from __future__ import annotations

from typing import Optional

import numpy

import islet
from islet.envs.spaces import Box
from islet.envs.vector import VectorEnv, columns

POINTS = 64  # of the track's middle line
RADIUS, HALF_WIDTH = 40.0, 4.0  # m
WAVES = ((2, 0.16), (3, 0.1), (4, 0.06))  # how often the track bends in and out on a lap, and by how much of the radius at most
HALF_LENGTH, HALF_CAR = 1.8, 0.7  # m, of the chassis
MASS, WHEEL = 500.0, 20.0  # kg, of the chassis and of a wheel
AXLES = ((1.3, 0.75), (1.3, -0.75), (-1.3, 0.75), (-1.3, -0.75))  # m, where the wheels are
LOCK, STEERING = 0.5, 4.0  # rad, rad/s: how far and how fast the front wheels turn
GRIP = 1700.0  # N, that a wheel can push at most
ENGINE, BRAKE = 1200.0, 1500.0  # N, of each rear wheel; of each wheel
STIFF = 3000.0  # N s/m: sideways push of a wheel for each m/s that it slides
DRAG = 8.0  # N s/m, of each wheel's rolling
SIGHT, RAYS = 25.0, 11  # m; rays over half a turn
LAP = 1000.0  # reward for a lap
ROTS = [islet.make_rot(i * 6.2831853 / POINTS) for i in range(POINTS)]
COS, SIN = (numpy.array([q[i] for q in ROTS], float) for i in range(2))


def make_track(random: numpy.random.Generator) -> numpy.ndarray:
    """The middle line: points (m) of a loop to the left."""
    radius = numpy.ones(POINTS)
    for count, size in WAVES:
        across, along = random.uniform(-size, size, 2)
        at = (count * numpy.arange(POINTS)) % POINTS
        radius = radius + across * COS[at] + along * SIN[at]
    return RADIUS * numpy.stack([radius * COS, radius * SIN], 1)


def directions(track: numpy.ndarray) -> numpy.ndarray:
    """The unit vectors along a middle line."""
    along = numpy.roll(track, -1, 0) - numpy.roll(track, 1, 0)
    return along / numpy.sqrt(along[:, :1] * along[:, :1] + along[:, 1:] * along[:, 1:])


class CarRacing(VectorEnv):
    """A car with four wheels on a track between two walls. Each seed has a track of its own.

    Wheels push forward and sideways, together with no more than their grip. The front wheels steer; the rear wheels drive.
    Actions: steering from -1 (right) to 1 (left), and from -1 (brake) to 1 (full throttle).
    Observations: how far 11 rays go from the car, from its right to its left, as fractions of 25 m; the speeds forward and to the left (10 m/s); the rate
    of turning (rad/s); the angle of the front wheels (rad).
    Reward: 1000 for a lap, by the way along the middle line; -0.1 a step; -1 for a step in which the car touches a wall. Terminated: a lap is done.
    """

    name = "car_racing"
    dt = 1 / 60
    repeat = 3
    max_episode_steps = 1000
    view = ((-84, -56), (84, 56))
    single_action_space = Box(-1, 1, (2,))
    single_observation_space = Box(numpy.array([0] * RAYS + [-numpy.inf] * 4, numpy.float32), numpy.array([1] * RAYS + [numpy.inf] * 4, numpy.float32))

    def build(self) -> islet.World:
        world = islet.World(bodies=7, shapes=2 * POINTS + 8, contacts=128, joints=4, gravity=(0, 0), enable_sleep=False)
        self.walls = world.create_body()
        self.car = world.create_body(type="dynamic")
        world.create_shape(self.car, islet.make_box(HALF_LENGTH, HALF_CAR), density=MASS / (4 * HALF_LENGTH * HALF_CAR), friction=0.1, filter={"category": 2})
        self.wheels, self.steering = [], []
        for i, place in enumerate(AXLES):
            wheel = world.create_body(type="dynamic", position=place)
            world.create_shape(wheel, islet.make_box(0.35, 0.15), density=WHEEL / 0.21, filter={"category": 2, "mask": 0})
            front = i < 2
            lock = LOCK if front else 0
            joint = world.create_revolute_joint(body_a=self.car, body_b=wheel, frame_a={"position": place}, limit=(True, -lock, lock), motor=(front, 0, 500))
            self.wheels.append(wheel)
            self.drive("force_x", body=wheel)
            self.drive("force_y", body=wheel)
            self.sense(f"turn{i}", "rotation", body=wheel)
            self.sense(f"velocity{i}", "velocity", body=wheel)
            if front:
                self.steering.append(joint)
                self.drive("motor_speed", joint=joint)
                self.sense(f"steering{i}", "joint", joint=joint)
        self.sense("place", "position", body=self.car)
        self.sense("turn", "rotation", body=self.car)
        self.sense("velocity", "velocity", body=self.car)
        self.sense("spin", "angular_velocity", body=self.car)
        self.sense("hit", "touching", body=self.car)
        for i in range(RAYS):
            cosine, sine = islet.make_rot((i / (RAYS - 1) - 0.5) * 3.1415927)
            self.sense(f"ray{i}", "ray", body=self.car, translation=(SIGHT * cosine, SIGHT * sine), filter={"mask": 1})
        n = self.num_envs
        self.track, self.along = numpy.zeros((n, POINTS, 2)), numpy.zeros((n, POINTS, 2))
        self.way, self.length = numpy.zeros((n, POINTS)), numpy.ones(n)  # m: of each point along the middle line, and of the lap
        self.progress, self.at = numpy.zeros(n), numpy.zeros(n)  # m: since the start, and along the middle line
        self.wanted, self.throttle = numpy.zeros(n, numpy.float32), numpy.zeros(n, numpy.float32)
        return world

    def place(self, k: int, world: islet.World, random: numpy.random.Generator) -> None:
        track = make_track(random)
        along = directions(track)
        left = numpy.stack([-along[:, 1], along[:, 0]], 1) * HALF_WIDTH
        # A chain is solid on the right of its direction: the inner wall goes as the track does, the outer one against it.
        world.create_chain(self.walls, (track + left).tolist(), loop=True, friction=0.1)
        world.create_chain(self.walls, (track - left)[::-1].tolist(), loop=True, friction=0.1)
        pieces = numpy.roll(track, -1, 0) - track
        lengths = numpy.sqrt(pieces[:, 0] * pieces[:, 0] + pieces[:, 1] * pieces[:, 1])
        ends = numpy.add.accumulate(lengths)
        self.track[k], self.along[k], self.length[k] = track, along, ends[-1]
        self.way[k, 0], self.way[k, 1:] = 0, ends[:-1]
        (x, y), (c, s) = track[0].tolist(), along[0].tolist()
        for body, place in ((self.car, (0, 0)), *zip(self.wheels, AXLES)):
            world.set_transform(body, (x + c * place[0] - s * place[1], y + s * place[0] + c * place[1]), islet.angle_of((c, s)))

    def begin(self, which: numpy.ndarray) -> None:
        self.progress[which] = 0
        self.at[which] = self._along()[which]

    def _along(self) -> numpy.ndarray:
        """m, how far along the middle line the cars are, from 0 to the lap's length or a little beyond."""
        away = self.seen["place"][:, None, :].astype(float) - self.track
        nearest = numpy.argmin(away[:, :, 0] * away[:, :, 0] + away[:, :, 1] * away[:, :, 1], axis=1)
        rows = numpy.arange(self.num_envs)
        gap, along = away[rows, nearest], self.along[rows, nearest]
        return self.way[rows, nearest] + gap[:, 0] * along[:, 0] + gap[:, 1] * along[:, 1]

    def act(self, actions: numpy.ndarray) -> None:
        self.wanted, self.throttle = actions[:, 0] * numpy.float32(LOCK), actions[:, 1]

    def advance(self, mask: Optional[numpy.ndarray]) -> None:
        for _ in range(self.repeat):
            self._push()
            self.fleet.step(self.control, self.dt, 1, mask, self._raw)

    def _push(self) -> None:
        """The forces of the wheels, and how fast the front ones turn."""
        column = 0
        f = numpy.float32
        for i in range(4):
            front = i < 2
            c, s = self.seen[f"turn{i}"].T
            vx, vy = self.seen[f"velocity{i}"].T
            forward, aside = c * vx + s * vy, c * vy - s * vx
            gas = f(0) if front else f(ENGINE) * numpy.maximum(self.throttle, f(0))
            brake = numpy.minimum(f(STIFF) * abs(forward), f(BRAKE) * numpy.maximum(-self.throttle, f(0)))
            ahead = gas - numpy.sign(forward) * brake - f(DRAG) * forward
            across = f(-STIFF) * aside
            share = f(GRIP) / numpy.maximum(numpy.sqrt(ahead * ahead + across * across), f(GRIP))
            ahead, across = ahead * share, across * share
            self.control[:, column] = c * ahead - s * across
            self.control[:, column + 1] = s * ahead + c * across
            column += 2
            if front:
                self.control[:, column] = numpy.clip((self.wanted - self.seen[f"steering{i}"][:, 0]) * f(20), f(-STEERING), f(STEERING))
                column += 1

    def look(self) -> numpy.ndarray:
        c, s = self.seen["turn"].T
        vx, vy = self.seen["velocity"].T
        ten = numpy.float32(0.1)
        return columns(self.between("ray0", f"ray{RAYS - 1}"), (c * vx + s * vy) * ten, (c * vy - s * vx) * ten, self.seen["spin"],
                       self.seen["steering0"][:, 0])

    def judge(self) -> tuple:
        at = self._along()
        way = at - self.at
        way = way - self.length * numpy.rint(way / self.length)
        self.at = at
        self.progress = self.progress + way
        rewards = LAP * way / self.length - 0.1 - (self.seen["hit"][:, 0] > 0)
        return rewards, self.progress >= self.length

    def notes(self) -> dict:
        return {"lap": self.progress / self.length}
