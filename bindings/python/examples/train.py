#!/usr/bin/env python3
"""Learns to control an environment by an evolution strategy, with numpy alone.

    train.py ENVIRONMENT [--seed N] [--generations N] [--pairs N] [--workers N] [--save POLICY.json] [--csv FILE]
    train.py ENVIRONMENT --load POLICY.json [--film PAGE.html | --film FOLDER]

The method is augmented random search (Mania, Guy, Recht 2018), a simple evolution strategy. A policy is one matrix from observations, each brought to mean
0 and deviation 1, to actions. A generation tries pairs of policies, the present one plus and minus a random matrix, each in a world of its own of one
fleet. The policy then moves by what the better half of the pairs gained. The same seed gives the same bits on every machine, so nothing here depends on the
order in which a library adds, or on its sines and logarithms.
"""
import argparse
import json
import os
import sys
import time

import numpy

import islet
from islet import envs

# What each task wants: pairs of policies, generations, size of the random matrices, length of a move, steps of an episode while it learns.
PLANS = {
    "cart_pole": dict(pairs=8, generations=12, noise=0.1, rate=0.05),
    "acrobot": dict(generations=30),
    "bipedal_walker": dict(pairs=64, generations=100, noise=0.2, rate=0.1, steps=400),
    "lunar_lander": dict(pairs=32, generations=80, noise=0.3, rate=0.2, steps=350),
    "car_racing": dict(pairs=16, generations=12, noise=0.2, rate=0.2, steps=300),
}
PLAN = dict(pairs=64, generations=100, noise=0.1, rate=0.1)


class Policy:
    """Linear, and the mean and variance of all observations so far."""

    def __init__(self, env):
        self.discrete = isinstance(env.single_action_space, envs.Discrete)
        self.outputs = env.single_action_space.n if self.discrete else env.single_action_space.shape[0]
        self.inputs = env.single_observation_space.shape[0]
        self.weights = numpy.zeros((self.inputs + 1, self.outputs))
        self.count, self.mean, self.square = 0.0, numpy.zeros(self.inputs), numpy.ones(self.inputs)

    def scaled(self, observations):
        """With mean 0 and deviation 1."""
        deviation = numpy.sqrt(self.square / max(self.count, 1.0))
        return numpy.clip((observations - self.mean) / numpy.maximum(deviation, 1e-3), -5, 5)

    def learn_scale(self, observations):
        """Takes rows into account."""
        rows = float(len(observations))
        if rows == 0:
            return
        mean = numpy.add.accumulate(observations, 0)[-1] / rows
        gap = observations - mean
        square = numpy.add.accumulate(gap * gap, 0)[-1]
        apart, total = mean - self.mean, self.count + rows
        self.square = (self.square if self.count else 0.0) + square + apart * apart * (self.count * rows / total)
        self.mean = self.mean + apart * (rows / total)
        self.count = total

    def actions(self, observations, weights):
        """One row of actions for each observation, by one matrix for all, or one for each. Adds in a fixed order, which a matrix product would not."""
        x = self.scaled(observations.astype(float))
        out = numpy.zeros((len(x), self.outputs)) + weights[..., -1, :]
        for i in range(self.inputs):
            out += x[:, i:i + 1] * weights[..., i, :]
        if self.discrete:
            return numpy.argmax(out, axis=1)
        return numpy.clip(out, -1, 1).astype(numpy.float32)

    def save(self, name):
        """As JSON, whose numbers are exact."""
        with open(name, "w", encoding="utf-8") as file:
            lists = {key: getattr(self, key).tolist() for key in ("weights", "mean", "square")}
            file.write("{\n" + ",\n".join(f'"{key}": {json.dumps(value)}' for key, value in {"count": self.count, **lists}.items()) + "\n}\n")

    def load(self, name):
        with open(name, encoding="utf-8") as file:
            saved = json.load(file)
        arrays = {key: numpy.array(saved[key], float) for key in ("weights", "mean", "square")}
        if any(array.shape != getattr(self, key).shape for key, array in arrays.items()):
            sys.exit(f"{name} is a policy of another environment")
        self.count = float(saved["count"])
        self.__dict__.update(arrays)


def episodes(env, policy, weights, seeds, steps=None, seen=None):
    """The returns of one episode in each environment. `seen` gets observations for the policy's scale."""
    observations, _ = env.reset(seed=seeds)
    returns, alive = numpy.zeros(env.num_envs), numpy.ones(env.num_envs, bool)
    for _ in range(steps or env.max_episode_steps):
        if seen is not None:
            seen.append(observations[alive].astype(float))
        observations, rewards, terminated, truncated, infos = env.step(policy.actions(observations, weights))
        returns += numpy.where(alive, rewards, 0)
        alive &= ~(terminated | truncated)
        if not alive.any():
            break
    return returns


def noise_of(random, shape):
    """Nearly normal, from even numbers alone: those are the same bits everywhere."""
    return numpy.add.accumulate(random.uniform(-1, 1, (12, *shape)), 0)[-1] / 2


def learn(name, seed=1, workers=1, say=lambda text: None, **plan):
    """Returns the policy and the curve: for each generation its number, the steps taken so far, and the mean return of the present policy."""
    plan = {**PLAN, **PLANS.get(name, {}), **plan}
    pairs, steps = plan["pairs"], plan.get("steps")
    random = numpy.random.Generator(numpy.random.PCG64(seed))
    env = envs.make_vec(name, 2 * pairs, workers=workers, autoreset_mode="Disabled", **({"max_episode_steps": steps} if steps else {}))
    tests = envs.make_vec(name, 16, workers=workers, autoreset_mode="Disabled")
    policy, curve, taken = Policy(env), [], 0
    for generation in range(plan["generations"] + 1):
        value = mean_of(episodes(tests, policy, policy.weights, [int(s) for s in random.integers(1 << 31, size=16)]))
        curve.append((generation, taken, value))
        say(f"{name}: generation {generation}, {taken} steps, return {value:.1f}")
        if generation == plan["generations"]:
            return policy, curve
        noise = noise_of(random, (pairs, *policy.weights.shape))
        starts = [int(s) for s in random.integers(1 << 31, size=pairs)] * 2  # both of a pair start alike
        seen = []
        returns = episodes(env, policy, policy.weights + plan["noise"] * numpy.concatenate([noise, -noise]), starts, seen=seen)
        seen = numpy.concatenate(seen)
        taken += len(seen)
        plus, minus = returns[:pairs], returns[pairs:]
        best = numpy.argsort(-numpy.maximum(plus, minus), kind="stable")[:max(pairs // 2, 1)]
        policy.weights = policy.weights + plan["rate"] * gain(plus[best], minus[best], noise[best])
        policy.learn_scale(seen)


def gain(plus, minus, noise):
    """The mean of the random matrices, each weighed by what it gained, in deviations of the returns."""
    returns = numpy.concatenate([plus, minus])
    gap = returns - mean_of(returns)
    deviation = numpy.sqrt(mean_of(gap * gap))
    total = numpy.add.accumulate((plus - minus)[:, None, None] * noise, 0)[-1]
    return total / (len(plus) * max(float(deviation), 1e-6))


def mean_of(values):
    return float(numpy.add.accumulate(values)[-1]) / len(values)


def evaluate(name, policy, workers=1, count=100):
    """Mean, least and greatest return over episodes whose seeds learning did not use."""
    env = envs.make_vec(name, count, workers=workers, autoreset_mode="Disabled")
    returns = episodes(env, policy, policy.weights, [(1 << 32) + k for k in range(count)])
    return mean_of(returns), float(returns.min()), float(returns.max())


def write_csv(name, curve):
    with open(name, "w", encoding="utf-8") as file:
        file.write("generation,steps,return\n")
        for generation, taken, value in curve:
            file.write(f"{generation},{taken},{value!r}\n")


def main():
    parser = argparse.ArgumentParser(description="Learns to control an environment by an evolution strategy.")
    parser.add_argument("environment", choices=envs.names())
    parser.add_argument("--seed", type=int, default=1, help="decides all that is random (1)")
    parser.add_argument("--generations", type=int)
    parser.add_argument("--pairs", type=int, help="policies tried in a generation: two times so many")
    parser.add_argument("--noise", type=float, help="size of the random matrices")
    parser.add_argument("--rate", type=float, help="length of a move")
    parser.add_argument("--steps", type=int, help="of an episode while it learns")
    parser.add_argument("--workers", type=int, default=2, help="threads that step the worlds (2)")
    parser.add_argument("--save", metavar="FILE", help="writes the policy")
    parser.add_argument("--load", metavar="FILE", help="takes a policy instead of learning one")
    parser.add_argument("--csv", metavar="FILE", help="writes the learning curve")
    parser.add_argument("--film", metavar="PAGE.html", help="writes a page that plays an episode; or, into a folder, pictures of it")
    options = parser.parse_args()
    name, began = options.environment, time.perf_counter()
    if options.load:
        policy = Policy(envs.make_vec(name))
        policy.load(options.load)
    else:
        plan = {key: getattr(options, key) for key in ("generations", "pairs", "noise", "rate", "steps") if getattr(options, key) is not None}
        policy, curve = learn(name, options.seed, options.workers, lambda text: print(text, file=sys.stderr), **plan)
        print(f"learned for {time.perf_counter() - began:.0f} s")
        if options.csv:
            write_csv(options.csv, curve)
        if options.save:
            policy.save(options.save)
    print("return over 100 unseen seeds: mean {:.1f}, least {:.1f}, greatest {:.1f}".format(*evaluate(name, policy, options.workers)))
    if options.film:
        film(name, policy, options.film)


def film(name, policy, path):
    """An episode: a page that plays it, or a picture of each tenth step in a folder."""
    env = envs.make(name, render_mode="svg")
    observation, _ = env.reset(seed=1 << 32)
    page = islet.Film(env, env.vector.dt * env.vector.repeat, name.replace("_", " ")) if path.endswith(".html") else None
    if page is None:
        os.makedirs(path, exist_ok=True)
    over, step = False, 0
    while not over:
        if page is None and step % 10 == 0:
            with open(os.path.join(path, f"{name}_{step:04}.svg"), "w", encoding="utf-8") as file:
                file.write(env.render())
        observation, _, terminated, truncated, _ = env.step(policy.actions(observation[None], policy.weights)[0])
        over, step = terminated or truncated, step + 1
        if page is not None:
            page.take()
    if page is not None:
        page.save(path)


if __name__ == "__main__":
    main()
