#!/usr/bin/env python3
"""What a step costs from Python: a fleet's, and one world's.

    PYTHONPATH=build/release/python bindings/python/bench.py [WORLDS [ROUNDS]]        1024 and 5 by default

The worlds are those of tools/bench/fleet.cpp (build/release/tools/bench/fleet_bench), pyramids of 3 and 10 boxes, and of 45 with five balls beside. Rounds of
both ways take turns; the table shows medians. What Python adds to a call is the time of a fleet's step that steps no world (all are masked), and what it adds
to one world's step is the difference of 1000 steps in one call and in 1000 calls.
"""
import statistics
import sys
import time

import numpy

import islet

STEPS = 20


def pyramid(rows, balls):
    bodies = rows * (rows + 1) // 2 + balls + 1
    world = islet.World(bodies=bodies, shapes=bodies, contacts=4 * bodies, geometries=4, enable_sleep=False)
    world.create_shape(world.create_body(), islet.make_offset_box(50, 1, ((0, -1), 0)))
    for row in range(rows):
        for i in range(rows - row):
            box = world.create_body(type="dynamic", position=(i + 0.5 * (row - rows), 0.5 + row))
            world.create_shape(box, islet.make_box(0.5, 0.5))
    for i in range(balls):
        world.create_shape(world.create_body(type="dynamic", position=(rows + 2 * i, 0.5)), islet.Circle((0, 0), 0.5))
    return world


def seconds(call):
    begin = time.perf_counter()
    call()
    return time.perf_counter() - begin


def main():
    worlds = int(sys.argv[1]) if len(sys.argv) > 1 else 1024
    rounds = int(sys.argv[2]) if len(sys.argv) > 2 else 5
    print(f"{worlds} worlds; medians of {rounds} rounds of {STEPS} steps")
    print("| boxes, balls | steps of worlds a second | a fleet's step, us | a call, us | of it, % | one world's step, us | a call more, us |")
    for rows, balls in ((2, 0), (4, 0), (9, 5)):
        world = pyramid(rows, balls)
        body = world.bodies()[1]
        fleet = islet.Fleet(world, worlds, drives=[islet.Drive("force_x", body=body)], senses=[islet.Sense("position", body=body)])
        actions, out, none = numpy.zeros((worlds, 1), numpy.float32), numpy.zeros((worlds, 2), numpy.float32), numpy.zeros(worlds, bool)
        steps, calls, one, many = [], [], [], []
        for _ in range(rounds):
            steps.append(seconds(lambda: [fleet.step(actions, out=out) for _ in range(STEPS)]) / STEPS)
            calls.append(seconds(lambda: [fleet.step(actions, mask=none, out=out) for _ in range(STEPS)]) / STEPS)
            one.append(seconds(lambda: world.step(count=1000)) / 1000)
            many.append(seconds(lambda: [world.step() for _ in range(1000)]) / 1000)
        step, call = statistics.median(steps), statistics.median(calls)
        more = statistics.median(b - a for a, b in zip(one, many))
        print(f"| {rows * (rows + 1) // 2}, {balls} | {worlds / step:.0f} | {1e6 * step:.1f} | {1e6 * call:.2f} | {100 * call / step:.2f} "
              f"| {1e6 * statistics.median(one):.2f} | {1e6 * more:.2f} |")


if __name__ == "__main__":
    main()
