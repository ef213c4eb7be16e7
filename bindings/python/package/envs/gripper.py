"""A gripper on a rail, and boxes on a floor: what grasping and stacking share."""
from __future__ import annotations

import numpy

import islet
from islet.envs.spaces import Box
from islet.envs.vector import VectorEnv, columns

RAIL, REACH = 2.0, 1.84  # m: half the rail, and how far the palm comes down from its highest place
TOP = 2.4  # m, the palm's highest place above the floor
PALM = (0.42, 0.08)  # m, half its size
FINGER = (0.05, 0.22)  # m
OPEN = 0.32  # m, how far a finger's middle is from the palm's when it is open
TRAVEL, LIFT, CLOSE = 1.5, 1.2, 0.8  # m/s at most
DRIVE, GRIP = 300.0, 60.0  # N
HALF = 0.15  # m, half a box
TIP = PALM[1] + 2 * FINGER[1]  # m, from the palm's middle down to the tips


class Gripper(VectorEnv):
    """Actions: the speeds of the carriage (to the right, 1.5 m/s), the palm (up, 1.2 m/s) and the fingers (together, 0.8 m/s), from -1 to 1.

    Observations: place (m) and velocity (m/s) of the middle between the fingers' tips, how far each finger is closed (m) and how fast (m/s), whether each
    touches something, and for each box its place beside the tips (m), height above the floor (m), cosine and sine of its angle, and velocity (m/s).
    """

    dt = 1 / 50
    repeat = 2
    max_episode_steps = 300
    view = ((-2.5, -0.5), (2.5, 2.85))
    boxes = 1
    single_action_space = Box(-1, 1, (3,))

    def build(self) -> islet.World:
        n = self.boxes
        world = islet.World(bodies=7 + n, shapes=7 + n, contacts=64, joints=5, enable_sleep=False)
        earth = world.create_body()
        world.create_shape(earth, islet.make_offset_box(4, 0.5, ((0, -0.5), 0)))
        nothing = {"mask": 0}
        rail = world.create_body(position=(0, TOP))
        world.create_shape(rail, islet.make_box(RAIL, 0.04), filter=nothing)

        def part(place: tuple, shape: islet.Polygon, **material: object) -> islet.BodyId:
            body = world.create_body(type="dynamic", position=place, gravity_scale=0, fixed_rotation=True)
            world.create_shape(body, shape, density=40, **material)
            return body

        carriage = part((0, TOP), islet.make_box(0.2, 0.1), filter=nothing)
        self.palm = part((0, TOP), islet.make_box(*PALM), filter={"group": -1})
        down, right, up = -(PALM[1] + FINGER[1]), 0.0, 1.5707964
        fingers = [part((side * OPEN, TOP + down), islet.make_rounded_box(FINGER[0] - 0.02, FINGER[1] - 0.02, 0.02), filter={"group": -1}, friction=1.0)
                   for side in (-1, 1)]
        travel = world.create_prismatic_joint(body_a=rail, body_b=carriage, limit=(True, -RAIL, RAIL), motor=(True, 0, DRIVE))
        lift = world.create_prismatic_joint(body_a=carriage, body_b=self.palm, frame_a={"angle": up}, frame_b={"angle": up}, limit=(True, -REACH, 0),
                                            motor=(True, 0, DRIVE))
        self.drive("motor_speed", joint=travel, scale=TRAVEL)
        self.drive("motor_speed", joint=lift, scale=LIFT)
        closing = []
        for side, finger in zip((-1, 1), fingers):
            angle = right if side < 0 else 3.1415927
            closing.append(world.create_prismatic_joint(body_a=self.palm, body_b=finger, frame_a={"position": (side * OPEN, down), "angle": angle},
                                                        frame_b={"angle": angle}, limit=(True, 0, OPEN - FINGER[0]), motor=(True, 0, GRIP)))
            self.drive("motor_speed", joint=closing[-1], scale=CLOSE)
        world.create_gear_joint(joint1=closing[0], joint2=closing[1], ratio=-1)  # both close by the same way
        self.sense("palm", "position", body=self.palm)
        self.sense("velocity", "velocity", body=self.palm)
        for i in range(2):
            self.sense(f"finger{i}", "joint", joint=closing[i])
        for i in range(2):
            self.sense(f"touch{i}", "touching", body=fingers[i])
        self.cubes = []
        for i in range(n):
            cube = world.create_body(type="dynamic", position=(-1 + 2.0 * i, HALF))
            world.create_shape(cube, islet.make_box(HALF, HALF), density=10, friction=0.8)
            self.cubes.append(cube)
            self.sense(f"cube{i}", "position", body=cube)
            self.sense(f"turn{i}", "rotation", body=cube)
            self.sense(f"speed{i}", "velocity", body=cube)
        return world

    def put(self, world: islet.World, places: list) -> None:
        """Puts the boxes on the floor at these x (m)."""
        for cube, x in zip(self.cubes, places):
            world.set_transform(cube, (x, HALF), 0)

    def act(self, actions: numpy.ndarray) -> None:
        self.control[:, :3] = actions
        self.control[:, 3] = actions[:, 2]

    def tips(self) -> numpy.ndarray:
        """m, the middle between the tips of the fingers, a row for each environment."""
        return self.seen["palm"] - numpy.array([0, TIP - HALF], numpy.float32)

    def look(self) -> numpy.ndarray:
        see, tips = self.seen, self.tips()
        of_cubes = []
        for i in range(self.boxes):
            cube = see[f"cube{i}"]
            of_cubes += [cube - tips, cube[:, 1] - numpy.float32(HALF), see[f"turn{i}"], see[f"speed{i}"]]
        return columns(tips, see["velocity"], see["finger0"], see["finger1"], see["touch0"], see["touch1"], *of_cubes)


def observation_space(boxes: int) -> Box:
    """Of so many boxes."""
    low, high = numpy.full(10 + 7 * boxes, -numpy.inf, numpy.float32), numpy.full(10 + 7 * boxes, numpy.inf, numpy.float32)
    low[8:10], high[8:10] = 0, 1
    return Box(low, high)


def apart(a: numpy.ndarray, b: numpy.ndarray) -> numpy.ndarray:
    """The distance of two points, for each environment."""
    gap = a.astype(float) - b
    return numpy.sqrt(gap[:, 0] * gap[:, 0] + gap[:, 1] * gap[:, 1])


def rest(speed: numpy.ndarray) -> numpy.ndarray:
    """Whether each velocity is below 5 cm/s."""
    return speed[:, 0] * speed[:, 0] + speed[:, 1] * speed[:, 1] < numpy.float32(0.0025)
