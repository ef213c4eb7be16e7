#!/usr/bin/env python3
"""Planning by forking worlds: an arm with two links and two motors follows a point that moves on a circle.

For each decision 256 futures of 30 steps start as copies of the arm as it is now, each with speeds of its own for the motors; the best future says what the
motors do next. samples/programs/planning.cpp is the same program in C++, and comes to the same state.
"""
import numpy

import islet

FUTURES, HORIZON, PIECES, ROUNDS, DECISION = 256, 30, 3, 2, 5  # steps: a future has 3 pieces of 10; a decision lasts 5
F = numpy.float32  # as the engine counts
DT, LENGTH = F(1) / F(60), 1  # s, m


def make_arm():
    """Two links in a row, the first on the ground; their motors have 40 and 20 N m. The world, the last link, shoulder and elbow."""
    world = islet.World(bodies=3, shapes=3, contacts=8, joints=2)

    def link(x):
        body = world.create_body(type="dynamic", position=(x, 0), enable_sleep=False)
        world.create_shape(body, islet.make_box(LENGTH / 2, 0.05), density=10, filter={"mask": 0})
        return body

    def hinge(a, b, at, max_force):
        return world.create_revolute_joint(body_a=a, body_b=b, frame_a={"position": (at, 0)}, frame_b={"position": (-LENGTH / 2, 0)},
                                           motor={"enable": True, "max_force": max_force})

    ground, upper, hand = world.create_body(), link(LENGTH / 2), link(1.5 * LENGTH)
    return world, hand, hinge(ground, upper, 0, 40), hinge(upper, hand, LENGTH / 2, 20)


def tips(poses):
    """The hand's tip, from rows of x, y, cosine and sine of the last link."""
    return poses[:, :2] + F(LENGTH / 2) * poses[:, 2:]


DIAL = islet.World(bodies=1)
HAND_OF_DIAL = DIAL.create_body()


def goal(time):
    """The point to follow: on a circle of 0.5 m about (1, 0.5), once in 4 s. Sine and cosine are the engine's, the same on every machine."""
    DIAL.set_transform(HAND_OF_DIAL, ((0, 0), F(2) * F(numpy.pi) / F(4) * time))
    turn = DIAL.transform(HAND_OF_DIAL).q
    return numpy.array([F(1) + F(0.5) * F(turn.c), F(0.5) + F(0.5) * F(turn.s)], F)


class Planner:
    def __init__(self, world, hand, shoulder, elbow):
        self.fleet = islet.Fleet(world, FUTURES, drives=[islet.Drive("motor_speed", joint=shoulder), islet.Drive("motor_speed", joint=elbow)],
                                 senses=[{"kind": "position", "body": hand}, {"kind": "rotation", "body": hand}])
        self.best = numpy.zeros((PIECES, 2), F)  # rad/s, of each piece and motor
        self.state = 1

    def random(self, count):
        """Evenly spread over -1 to 1 (SplitMix64)."""
        golden = 0x9E3779B97F4A7C15
        z = numpy.array([(self.state + golden * (i + 1)) % 2**64 for i in range(count)], numpy.uint64)
        self.state = (self.state + golden * count) % 2**64
        z = (z ^ z >> numpy.uint64(30)) * numpy.uint64(0xBF58476D1CE4E5B9)
        z = (z ^ z >> numpy.uint64(27)) * numpy.uint64(0x94D049BB133111EB)
        return ((z ^ z >> numpy.uint64(31)) >> numpy.uint64(40)).astype(F) * F(2**-23) - F(1)

    def decide(self, world, time):
        """The best of twice 256 plans around the last one. Future 0 keeps the plan."""
        image = world.save()
        for width in (F(3), F(1)):
            tried = numpy.tile(self.best, (FUTURES, 1, 1))
            tried[1:] += width * self.random((FUTURES - 1) * PIECES * 2).reshape(FUTURES - 1, PIECES, 2)
            self.best = tried[self.cheapest(image, tried, time)]
        return self.best

    def cheapest(self, image, tried, time):
        """Tries the plans: the future whose tip stays nearest to the goal."""
        self.fleet.reset(0, image)
        self.fleet.fork([0] * FUTURES)
        costs = numpy.zeros(FUTURES, F)
        for step in range(HORIZON):
            poses = self.fleet.step(numpy.ascontiguousarray(tried[:, step // (HORIZON // PIECES)]), dt=DT)
            off = tips(poses) - goal(time + DT * F(step + 1))
            costs += off[:, 0] * off[:, 0] + off[:, 1] * off[:, 1]
        return int(numpy.argmin(costs))


def main():
    world, hand, *joints = make_arm()
    planner = Planner(world, hand, *joints)
    time, seen = F(0), []
    for decided in range(96):
        plan = planner.decide(world, time)
        for joint, speed in zip(joints, plan[0]):
            motor = world.motor(joint)
            motor.speed = speed
            world.set_motor(joint, motor)
        for _ in range(DECISION):
            world.step(DT)
            time += DT
        pose = world.transform(hand)
        off = float(numpy.linalg.norm(tips(numpy.array([[*pose.p, *pose.q]], F))[0] - goal(time)))
        if decided % 12 == 11:
            print(f"{time:4.1f} s: the tip is {1000 * off:5.1f} mm from its goal")
        if time >= 2:  # it has got there
            seen.append(off)
    print(f"from 2 s on: {1000 * sum(seen) / len(seen):.1f} mm on average, {1000 * max(seen):.1f} mm at most")
    print(f"state {world.hash():016x}")


if __name__ == "__main__":
    main()
