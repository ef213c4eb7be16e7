"""Players that follow a rule written by hand, one for each environment: from the observations of many environments to their actions."""
import numpy


def cart_pole(o):
    return (o[:, 2] + 0.5 * o[:, 3] + 0.1 * o[:, 0] + 0.2 * o[:, 1] > 0).astype(int)


def acrobot(o):
    """Torque in the direction in which the second link turns does work, which swings it up."""
    return numpy.where(o[:, 5] > 0.5 * o[:, 4], 2, 0)


def lunar_lander(o):
    """Leans toward the pad, and holds a speed of sinking that falls with the height."""
    x, y, vx, vy, angle, spin, left, right = o.T
    stands = (left > 0) | (right > 0)
    lean = numpy.where(stands, 0, (numpy.clip(0.5 * x + vx, -0.4, 0.4) - angle) * 0.5 - spin)
    lift = numpy.where(stands, -0.5 * vy, (0.55 * abs(x) - y) * 0.5 - 0.5 * vy)
    return numpy.where((lift > abs(lean)) & (lift > 0.05), 2, numpy.where(lean < -0.05, 3, numpy.where(lean > 0.05, 1, 0)))


def car_racing(o):
    """Steers to the side where the rays go farther; slows down where they do not go far ahead."""
    right, left, ahead = o[:, 1:5].sum(1), o[:, 6:10].sum(1), o[:, 4:7].min(1)
    return numpy.stack([numpy.clip(1.5 * (left - right), -1, 1), numpy.clip(2 * (0.3 + 0.9 * ahead - o[:, 11]), -1, 1)], 1)


def pusher(o):
    """Moves the tip to behind the puck, and through it to the goal."""
    lengths, out = (0.5, 0.5, 0.3), []
    for row in o.astype(float):
        turns, tip, puck, goal = row[:6].reshape(3, 2), row[9:11], row[11:13], row[15:17]
        way = goal - puck
        far = numpy.hypot(*way)
        way = way / max(far, 1e-6)
        gap = puck - tip
        behind = gap @ way > 0.95 * numpy.hypot(*gap)
        aside = gap - (gap @ way) * way
        velocity = min(2 * far, 0.3) * way + 5 * aside if behind else 3 * (puck - 0.3 * way - tip)
        velocity = velocity * min(1, 1.5 / max(numpy.hypot(*velocity), 1e-6)) * (far > 0.03)
        joints = numpy.cumsum([(0, 0)] + [length * turn for length, turn in zip(lengths, turns)], 0)[:3]
        arm = numpy.stack([[-(tip - joint)[1], (tip - joint)[0]] for joint in joints], 1)
        speeds = arm.T @ numpy.linalg.solve(arm @ arm.T + 0.01 * numpy.eye(2), velocity)
        out.append(numpy.clip(speeds / 2, -1, 1))
    return numpy.array(out)


def fetch(o, x, y):
    """Goes over the first box, down to it, closes, and carries it to (x, y); the actions, and whether it is held."""
    tip, box = o[:, :2], o[:, 10:12]
    held = (o[:, 8] > 0) & (o[:, 9] > 0) & (abs(box[:, 0]) < 0.1)
    over = abs(box[:, 0]) < 0.03
    low = over & (abs(box[:, 1]) < 0.06)
    travel = numpy.where(held, 3 * (x - tip[:, 0] - box[:, 0]), 5 * box[:, 0])
    lift = numpy.where(held, 4 * (y - tip[:, 1] - box[:, 1]), numpy.where(over, 5 * box[:, 1], 5 * (0.8 - tip[:, 1])))
    return numpy.clip(numpy.stack([travel, lift, numpy.where(held | low, 1.0, -1.0)], 1), -1, 1), held


def grasping(o):
    return fetch(o, o[:, 0], 2.0)[0]


def stacking(o):
    upper, lower = o[:, 10:17], o[:, 17:24]
    aside = lower[:, 0] - upper[:, 0]
    over = abs(aside) < 0.04
    height = lower[:, 2] + 0.15 + 0.3  # of the upper box, where it is wanted
    place = o[:, 0] + lower[:, 0]
    actions, held = fetch(o, place, numpy.where(over, height, height + 0.3))
    sideways = held & ~over & (upper[:, 2] + 0.15 < height + 0.15)
    actions[sideways, 0] = 0
    there = over & (abs(upper[:, 2] + 0.15 - height) < 0.02)
    actions[there] = numpy.stack([0 * aside, numpy.where(o[:, 4] < 0.01, 1.0, 0.0), -1 + 0 * aside], 1)[there]
    return actions


PLAYERS = {f.__name__: f for f in (cart_pole, acrobot, lunar_lander, car_racing, pusher, grasping, stacking)}
