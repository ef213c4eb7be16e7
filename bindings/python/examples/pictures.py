#!/usr/bin/env python3
"""Draws the pictures of docs/environments.md, but for the learning curves (curve.py).

    pictures.py FOLDER        writes environments.svg and walking.svg; the walker is that of docs/learning/bipedal_walker.json
"""
import os
import re
import sys

import numpy

from islet import envs

import train

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", "..", ".."))
WIDE, HIGH, GAP = 300, 200, 8  # px, of one of the pictures side by side
# What is shown: so many steps with an action that follows from the step and the observation.
PLAY = {
    "cart_pole": (12, lambda i, o: i % 2),
    "acrobot": (55, lambda i, o: 2 if o[5] > 0.5 * o[4] else 0),
    "lunar_lander": (80, lambda i, o: 2 if o[3] < -0.7 else 0),
    "bipedal_walker": (12, lambda i, o: numpy.array([0.3, -0.4, -0.5, -0.2], numpy.float32)),
    "car_racing": (60, lambda i, o: numpy.array([1.5 * (o[6:10].sum() - o[1:5].sum()), 0.5], numpy.float32)),
    "pusher": (38, lambda i, o: numpy.array([0.9, 0, 0], numpy.float32)),
    "grasping": (40, lambda i, o: numpy.array([5 * o[10], -0.8, -1], numpy.float32)),
    "stacking": (34, lambda i, o: numpy.array([5 * o[10], -0.8, -1], numpy.float32)),
}


def inner(picture, x, y, wide, high, crop):
    """What a picture shows, in a rectangle of another; `crop` is what of it, in its own units."""
    body = re.sub(r"^<svg[^>]*>|</svg>\s*$", "", picture.strip())
    body = re.sub(r"<title></title>", "", body)
    return f'<svg x="{x}" y="{y}" width="{wide}" height="{high}" viewBox="{crop}" preserveAspectRatio="xMidYMid slice">{body}</svg>'


def sheet(wide, high, parts):
    size = f'viewBox="0 0 {wide} {high}" width="{wide}"'
    return "\n".join([f'<svg xmlns="http://www.w3.org/2000/svg" {size} font-family="sans-serif" font-size="13" fill="#2b333b">',
                      f'<rect width="{wide}" height="{high}" fill="#fff"/>', *parts, "</svg>", ""])


def crop_of(view):
    """The part of a picture above its caption: pictures are 12000 units wide."""
    (left, low), (right, top) = view
    return f"0 0 12000 {12000 * (top - low) / (right - left):.0f}"


def all_of_them():
    parts = []
    for i, name in enumerate(envs.names()):
        env = envs.make(name, render_mode="svg")
        observation, _ = env.reset(seed=6)
        steps, action = PLAY[name]
        for step in range(steps):
            observation = env.step(action(step, observation))[0]
        x, y = i % 4 * (WIDE + GAP), i // 4 * (HIGH + 24)
        parts.append(inner(env.render(), x, y, WIDE, HIGH, crop_of(env.vector.view_of(0))))
        parts.append(f'<text x="{x + WIDE / 2:.0f}" y="{y + HIGH + 16}" text-anchor="middle">{name}</text>')
    return sheet(4 * (WIDE + GAP) - GAP, 2 * (HIGH + 24), parts)


def walk():
    """A walker that has learned, at several moments."""
    policy = train.Policy(envs.make_vec("bipedal_walker"))
    policy.load(os.path.join(ROOT, "docs", "learning", "bipedal_walker.json"))
    env = envs.make("bipedal_walker", render_mode="svg")
    observation, info = env.reset(seed=1 << 32)
    parts = []
    for step in range(181):
        if step % 20 == 0 and len(parts) < 16:
            i = len(parts) // 2
            x, y = i % 4 * (WIDE + GAP), i // 4 * (HIGH + 24)
            parts.append(inner(env.render(), x, y, WIDE, HIGH, crop_of(env.vector.view_of(0))))
            parts.append(f'<text x="{x + WIDE / 2:.0f}" y="{y + HIGH + 16}" text-anchor="middle">{step / 50:.1f} s, {info["distance"]:.1f} m</text>')
        observation, _, _, _, info = env.step(policy.actions(observation[None], policy.weights)[0])
    return sheet(4 * (WIDE + GAP) - GAP, 2 * (HIGH + 24), parts)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    for name, text in (("environments", all_of_them()), ("walking", walk())):
        with open(os.path.join(sys.argv[1], name + ".svg"), "w", encoding="utf-8") as file:
            file.write(text)


if __name__ == "__main__":
    main()
