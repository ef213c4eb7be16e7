#!/usr/bin/env python3
"""Planning by forking worlds. For each decision 256 futures of 30 steps start as copies of the world as it is now, each with speeds of its own for the motors;
the best future says what the motors do next.

    planning.py [arm]     an arm with two links and two motors follows a point that moves on a circle
    planning.py walker    a hull on two legs with four motors walks, and does not fall

samples/programs/planning.cpp is the same program in C++, and comes to the same states.
"""
import sys

import numpy

import islet

FUTURES, HORIZON = 256, 30  # steps
F = numpy.float32  # as the engine counts


def add_motor(world, a, b, at_a, at_b, max_force, limit=()):
    return world.create_revolute_joint(body_a=a, body_b=b, frame_a={"position": at_a}, frame_b={"position": at_b}, limit=limit,
                                       motor={"enable": True, "max_force": max_force})


class Arm:
    """Two links in a row, the first on the ground; their motors have 40 and 20 N m. What it costs is how far the tip is from the goal."""

    dt, pieces, decision, rounds, width, mostly_little = F(1) / F(60), 3, 5, 2, F(3), False  # s, of a future, steps, of futures, rad/s
    length = 1  # m, of a link

    def __init__(self):
        self.world = islet.World(bodies=3, shapes=3, contacts=8, joints=2)
        ground, upper = self.world.create_body(), self.link(self.length / 2)
        self.hand = self.link(1.5 * self.length)
        self.motors = [add_motor(self.world, ground, upper, (0, 0), (-self.length / 2, 0), 40),
                       add_motor(self.world, upper, self.hand, (self.length / 2, 0), (-self.length / 2, 0), 20)]
        self.senses = [{"kind": "position", "body": self.hand}, {"kind": "rotation", "body": self.hand}]
        self.dial = islet.World(bodies=1)
        self.hand_of_dial = self.dial.create_body()

    def link(self, x):
        body = self.world.create_body(type="dynamic", position=(x, 0), enable_sleep=False)
        self.world.create_shape(body, islet.make_box(self.length / 2, 0.05), density=10, filter={"mask": 0})
        return body

    def tips(self, poses):
        """The hand's tip, from rows of x, y, cosine and sine of the last link."""
        return poses[:, :2] + F(self.length / 2) * poses[:, 2:]

    def goal(self, time):
        """The point to follow: on a circle of 0.5 m about (1, 0.5), once in 4 s. Sine and cosine are the engine's, the same on every machine."""
        self.dial.set_transform(self.hand_of_dial, ((0, 0), F(2) * F(numpy.pi) / F(4) * time))
        turn = self.dial.transform(self.hand_of_dial).q
        return numpy.array([F(1) + F(0.5) * F(turn.c), F(0.5) + F(0.5) * F(turn.s)], F)

    def costs(self, seen, time):
        off = self.tips(seen) - self.goal(time)
        return off[:, 0] * off[:, 0] + off[:, 1] * off[:, 1]


class Walker:
    """A hull of 1.15 m height on two legs, whose hips and knees have motors of 100 N m. It stands with bent knees, one foot before the other."""

    dt, pieces, decision, rounds, width, mostly_little = F(1) / F(40), 6, 5, 2, F(6), True
    leg_half = F(0.25)  # m, half a part of a leg

    def __init__(self):
        self.world = world = islet.World(bodies=6, shapes=6, contacts=32, joints=4, enable_sleep=False)
        ground = world.create_body()
        world.create_shape(ground, islet.make_offset_box(50, 1, ((40, -1), 0)), friction=1)
        own = {"group": -1}
        self.hull = world.create_body(type="dynamic", position=(0, 1.15))
        world.create_shape(self.hull, islet.make_box(0.4, 0.15), density=20, filter=own)
        self.motors = []
        for thigh_angle in (F(-0.2), F(0.4)):
            above, hip, x, y = self.hull, (0, -0.1), F(0), F(1.05)
            for angle, lower, upper in ((thigh_angle, -0.8, 1.1), (thigh_angle - F(0.3), -1.6, -0.1)):
                cosine, sine = map(F, islet.make_rot(angle))
                leg = world.create_body(type="dynamic", position=(x + self.leg_half * sine, y - self.leg_half * cosine), angle=angle)
                world.create_shape(leg, islet.make_box(0.06, self.leg_half), friction=1, density=10, filter=own)
                self.motors.append(add_motor(world, above, leg, hip, (0, self.leg_half), 100, (True, lower, upper)))
                x, y = x + F(2) * self.leg_half * sine, y - F(2) * self.leg_half * cosine
                above, hip = leg, (0, -self.leg_half)
        self.senses = [{"kind": kind, "body": self.hull} for kind in ("position", "rotation", "velocity", "angular_velocity")]

    def costs(self, seen, time):
        """Faster or slower than 1 m/s, low, leaning, spinning, and most of all fallen."""
        slow, low, lean, spin = seen[:, 4] - F(1), numpy.minimum(seen[:, 1] - F(1), F(0)), seen[:, 3], seen[:, 6]
        cost = slow * slow + F(300) * low * low + F(8) * lean * lean + F(0.05) * spin * spin
        return numpy.where(seen[:, 1] < F(0.75), cost + F(20), cost)


class Planner:
    def __init__(self, machine):
        self.machine = machine
        self.fleet = islet.Fleet(machine.world, FUTURES, drives=[islet.Drive("motor_speed", joint=joint) for joint in machine.motors], senses=machine.senses)
        self.best = numpy.zeros((machine.pieces, len(machine.motors)), F)  # rad/s, of each piece and motor
        self.state = 1
        self.time = F(0)  # s, of the machine's world

    def random(self, count):
        """Evenly spread over -1 to 1 (SplitMix64)."""
        golden = 0x9E3779B97F4A7C15
        z = numpy.array([(self.state + golden * (i + 1)) % 2**64 for i in range(count)], numpy.uint64)
        self.state = (self.state + golden * count) % 2**64
        z = (z ^ z >> numpy.uint64(30)) * numpy.uint64(0xBF58476D1CE4E5B9)
        z = (z ^ z >> numpy.uint64(27)) * numpy.uint64(0x94D049BB133111EB)
        return ((z ^ z >> numpy.uint64(31)) >> numpy.uint64(40)).astype(F) * F(2**-23) - F(1)

    def act(self):
        """Does for the time of a decision what the first piece of the best plan says: the best of 256 plans around the last one, of which future 0 keeps
        that."""
        machine, world = self.machine, self.machine.world
        image, width = world.save(), machine.width
        for _ in range(machine.rounds):
            tried = numpy.tile(self.best, (FUTURES, 1, 1))
            changes = self.random(tried[1:].size).reshape(tried[1:].shape)
            tried[1:] += width * (changes * changes * changes if machine.mostly_little else changes)
            self.best = tried[self.cheapest(image, tried)]
            width /= F(3)
        for joint, speed in zip(machine.motors, self.best[0]):
            motor = world.motor(joint)
            motor.speed = speed
            world.set_motor(joint, motor)
        if machine.decision == HORIZON // machine.pieces:  # the first piece is done
            self.best = numpy.concatenate([self.best[1:], self.best[-1:]])
        for _ in range(machine.decision):
            world.step(machine.dt)
            self.time += machine.dt

    def cheapest(self, image, tried):
        """Tries the plans."""
        self.fleet.reset(0, image)
        self.fleet.fork([0] * FUTURES)
        costs, dt = numpy.zeros(FUTURES, F), self.machine.dt
        for step in range(HORIZON):
            seen = self.fleet.step(numpy.ascontiguousarray(tried[:, step // (HORIZON // self.machine.pieces)]), dt=dt)
            costs += self.machine.costs(seen, self.time + dt * F(step + 1))
        return int(numpy.argmin(costs))


def follow():
    arm = Arm()
    planner, offs = Planner(arm), []
    for decided in range(96):
        planner.act()
        pose = arm.world.transform(arm.hand)
        off = float(numpy.linalg.norm(arm.tips(numpy.array([[*pose.p, *pose.q]], F))[0] - arm.goal(planner.time)))
        if decided % 12 == 11:
            print(f"{planner.time:4.1f} s: the tip is {1000 * off:5.1f} mm from its goal")
        if planner.time >= 2:  # it has got there
            offs.append(off)
    print(f"from 2 s on: {1000 * sum(offs) / len(offs):.1f} mm on average, {1000 * max(offs):.1f} mm at most")
    return arm


def walk():
    walker = Walker()
    planner, heights = Planner(walker), []
    for decided in range(40):
        planner.act()
        at = walker.world.position(walker.hull)
        heights.append(at.y)
        if decided % 8 == 7:
            print(f"{planner.time:4.1f} s: the hull is at ({at.x:.2f}, {at.y:.2f}) m")
    print(f"it walked {at.x:.2f} m, its hull never lower than {min(heights):.2f} m")
    return walker


def main():
    tasks = {"arm": follow, "walker": walk}
    name = sys.argv[1] if len(sys.argv) > 1 else "arm"
    if len(sys.argv) > 2 or name not in tasks:
        sys.exit("usage: planning.py [arm|walker]")
    print(f"state {tasks[name]().world.hash():016x}")


if __name__ == "__main__":
    main()
