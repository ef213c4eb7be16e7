#!/usr/bin/env python3
"""Tries policies for a cart with a pole, from many starts, on a Dask cluster: a million steps of worlds, and the hash of each world at its end.

    rollouts.py --one-process                  here, without Dask
    rollouts.py [--workers 4] [--kill]         on worker processes of this machine, one of which is killed half-way
    rollouts.py --scheduler tcp://host:8786    on a cluster, whose workers need this package

All three print the same table. A world travels as a snapshot (it is pickled), a policy as four numbers. A share of the tasks is done twice, on two workers,
and their hashes are compared (islet.cluster). --traffic counts what Dask sends.
"""
import argparse
import hashlib
import os
import pickle
import signal
import sys
import time

import numpy

import islet
from islet.cluster import spread


def cart_and_pole():
    """A cart on a rail with a pole that stands on it: the world, and the ids of cart, pole and hinge."""
    world = islet.World(bodies=3, joints=2)
    ground = world.create_body()
    cart = world.create_body(type="dynamic", position=(0, 0), enable_sleep=False)
    world.create_shape(cart, islet.make_box(0.25, 0.1), density=20)
    pole = world.create_body(type="dynamic", position=(0, 0.5))
    world.create_shape(pole, islet.make_box(0.02, 0.5), density=5, filter={"mask": 0})
    world.create_prismatic_joint(body_a=ground, body_b=cart)
    hinge = world.create_revolute_joint(body_a=cart, body_b=pole, frame_b={"position": (0, -0.5)})
    return world, cart, pole, hinge


def rollout(world, cart, pole, hinge, policy, seeds, steps):
    """One policy from several starts: the hash of each world at its end, and the steps for which its pole stood. Depends on the arguments alone."""
    fleet = islet.Fleet(world, len(seeds), drives=[islet.Drive("force_x", body=cart, scale=20)],
                        senses=[{"kind": "position", "body": cart}, {"kind": "velocity", "body": cart}, {"kind": "joint", "joint": hinge}])
    image = world.save()
    for k, seed in enumerate(seeds):
        fleet.reset(k, image, seed, [islet.Variation(body=pole, angular_velocity=0.5), islet.Variation(body=cart, velocity=(0.3, 0))])
    seen = fleet.observe()
    actions = numpy.zeros((len(seeds), 1), numpy.float32)
    stood = numpy.zeros(len(seeds), numpy.int64)
    up = numpy.ones(len(seeds), bool)
    weights = numpy.array(policy, numpy.float32)
    for _ in range(steps):
        # One product and one sum after the other: a library's dot product may round differently on another machine.
        push = weights[0] * seen[:, 0] + weights[1] * seen[:, 2] + weights[2] * seen[:, 4] + weights[3] * seen[:, 5]
        actions[:, 0] = numpy.clip(push, -1, 1)
        fleet.step(actions, out=seen)
        up &= numpy.abs(seen[:, 4]) < 0.5
        stood += up
    return fleet.hashes().tolist(), stood.tolist()


def tasks_of(options):
    world, *ids = cart_and_pole()
    random = numpy.random.Generator(numpy.random.PCG64(1))
    policies = [[float(x) for x in random.uniform((-1, -1, -10, -3), (1, 1, 2, 1))] for _ in range(options.policies)]
    blocks = [range(first, min(first + options.block, options.seeds)) for first in range(0, options.seeds, options.block)]
    return [(world, *ids, policy, block, options.steps) for policy in policies for block in blocks], len(blocks)


def table_of(results, blocks):
    """A line for each policy: how long its poles stood, and the hash of its worlds' hashes."""
    lines, every = [], hashlib.sha256()
    for first in range(0, len(results), blocks):
        of_policy = hashlib.sha256()
        stood = []
        for hashes, steps in results[first:first + blocks]:
            for hash_ in hashes:
                of_policy.update(hash_.to_bytes(8, "little"))
                every.update(hash_.to_bytes(8, "little"))
            stood += steps
        lines.append(f"policy {first // blocks:3}  stood {sum(stood) / len(stood):7.1f} steps  hash {of_policy.hexdigest()[:16]}")
    return "\n".join(lines + [f"all worlds: {every.hexdigest()[:16]}"])


class CountMessages:
    """A plugin of Dask's workers that counts what they send. count_messages() is the same for this process: the client, and the scheduler of a local cluster."""

    def setup(self, worker):
        count_messages()


def count_messages():
    from distributed.comm import tcp
    if not hasattr(tcp, "islet_traffic"):
        tcp.islet_traffic = [0, 0]
        write = tcp.TCP.write

        async def counting(self, *arguments, **named):
            sent = await write(self, *arguments, **named)
            tcp.islet_traffic[0] += 1
            tcp.islet_traffic[1] += sent or 0
            return sent

        tcp.TCP.write = counting
    return list(tcp.islet_traffic)


class Watch:
    """Shows progress, and kills a worker half-way if that is wanted."""

    def __init__(self, client, options, steps):
        self.client, self.options, self.steps = client, options, steps
        self.start = self.shown = time.monotonic()
        self.victim = None
        self.state = None

    def __call__(self, state):
        self.state = state
        now = time.monotonic()
        if self.options.kill and self.victim is None and state.done >= state.tasks // 2:
            self.victim = sorted(self.client.run(os.getpid).items())[0]
            os.kill(self.victim[1], signal.SIGKILL)
            print(f"worker {self.victim[0]} killed after {state.done} of {state.tasks} tasks", file=sys.stderr)
        if now - self.shown > 1:
            self.shown = now
            done = self.steps * state.done / state.tasks
            print(f"{state.done} of {state.tasks} tasks, {state.agreed} done twice; {done / (now - self.start):,.0f} steps of worlds a second; "
                  f"{len(self.client.nthreads())} workers", file=sys.stderr)


def run_on(client, tasks, options):
    steps = options.policies * options.seeds * options.steps
    if options.traffic:
        before = count_messages()
        client.register_worker_plugin(CountMessages())
    watch = Watch(client, options, steps)
    processor = time.process_time()
    results = spread(client, rollout, tasks, twice=options.twice, progress=watch)
    seconds = time.monotonic() - watch.start
    state = watch.state
    print(f"{len(tasks)} tasks, {steps:,} steps of worlds in {seconds:.1f} s; {state.agreed} tasks were done twice, {state.elsewhere} of them on two workers, "
          "and all agree", file=sys.stderr)
    processor = time.process_time() - processor
    if options.traffic:
        here = [now - then for now, then in zip(count_messages(), before)]
        there = list(client.run(count_messages).values())
        sent = [sum(count) for count in zip(here, *there)]
        calls = len(tasks) + state.agreed
        who = "the client" if options.scheduler else "client and scheduler"  # the scheduler of a cluster elsewhere is not counted
        print(f"{who} sent {here[0]} messages, {here[1]:,} bytes; all together {sent[0]} messages, {sent[1]:,} bytes: "
              f"{sent[0] / calls:.1f} messages and {sent[1] / calls:,.0f} bytes a call. A task pickled has {len(pickle.dumps(tasks[0])):,} bytes, "
              f"a result {len(pickle.dumps(results[0])):,}. In all, {who} took {1e3 * processor / calls:.1f} ms of processor time a call.", file=sys.stderr)
    return results


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    where = parser.add_mutually_exclusive_group()
    where.add_argument("--one-process", action="store_true", help="without Dask")
    where.add_argument("--scheduler", help="address of a scheduler")
    where.add_argument("--workers", type=int, default=4, help="worker processes of a cluster on this machine")
    parser.add_argument("--kill", action="store_true", help="kill a worker of the cluster on this machine half-way")
    parser.add_argument("--traffic", action="store_true", help="count messages and bytes")
    parser.add_argument("--policies", type=int, default=50)
    parser.add_argument("--seeds", type=int, default=40, help="starts of each policy")
    parser.add_argument("--block", type=int, default=10, help="starts that one task takes")
    parser.add_argument("--steps", type=int, default=500, help="of each world")
    parser.add_argument("--twice", type=float, default=0.1, help="share of the tasks that are done on two workers")
    options = parser.parse_args()
    if options.kill and (options.one_process or options.scheduler):
        parser.error("--kill is for the cluster on this machine")
    tasks, blocks = tasks_of(options)
    if options.one_process:
        start = time.monotonic()
        results = [rollout(*task) for task in tasks]
        print(f"{len(tasks)} tasks in {time.monotonic() - start:.1f} s", file=sys.stderr)
    else:
        try:
            from distributed import Client, LocalCluster
        except ImportError:
            sys.exit("rollouts.py: this needs Dask: install python3-distributed (or pip's distributed), or use --one-process")
        if options.scheduler:
            with Client(options.scheduler) as client:
                results = run_on(client, tasks, options)
        else:
            with LocalCluster(n_workers=options.workers, threads_per_worker=1, dashboard_address=None, silence_logs=50) as cluster, Client(cluster) as client:
                results = run_on(client, tasks, options)
                client.wait_for_workers(options.workers, timeout=60)  # one that is about to start again does not like to be closed
    print(table_of(results, blocks))


if __name__ == "__main__":
    main()
