#!/usr/bin/env python3
"""Draws learning curves as one SVG picture.

    curve.py TITLE=FILE.csv... >PICTURE.svg        files of train.py --csv
"""
import csv
import sys

WIDE, HIGH, LEFT, RIGHT, TOP, BOTTOM = 420, 260, 52, 12, 34, 40


def ticks(top, low=0.0):
    """Four to eight round numbers that cover low to top."""
    step = 1.0
    while (top - low) / step > 8:
        step *= 2 if str(int(step))[0] != "2" else 2.5
    first = int(low // step)
    return [step * i for i in range(first, first + 12) if step * (i - 1) < top]


def number(value):
    return f"{value / 1e6:g} M" if abs(value) >= 1e6 else f"{value / 1e3:g} k" if abs(value) >= 1e4 else f"{value:g}"


def panel(title, rows, x0):
    steps, values = [float(r["steps"]) for r in rows], [float(r["return"]) for r in rows]
    across, up = ticks(max(steps)), ticks(max(values), min(0.0, min(values)))
    right, low, high = max(steps), up[0], up[-1]

    def at(step, value):
        return (x0 + LEFT + (WIDE - LEFT - RIGHT) * step / right, HIGH - BOTTOM - (HIGH - TOP - BOTTOM) * (value - low) / (high - low))

    out = [f'<text x="{x0 + WIDE / 2:.0f}" y="18" text-anchor="middle" font-weight="bold">{title}</text>']
    for value in up:
        (x, y), (end, _) = at(0, value), at(right, value)
        out.append(f'<path d="M{x:.1f} {y:.1f}H{end:.1f}" stroke="#d5dbe2"/><text x="{x - 6:.1f}" y="{y + 4:.1f}" text-anchor="end">{number(value)}</text>')
    for step in across:
        if step <= right:
            x, y = at(step, low)
            out.append(f'<path d="M{x:.1f} {y:.1f}v4" stroke="#7d8894"/><text x="{x:.1f}" y="{y + 16:.1f}" text-anchor="middle">{number(step)}</text>')
    line = " ".join(f"{x:.1f},{y:.1f}" for x, y in (at(s, v) for s, v in zip(steps, values)))
    out.append(f'<polyline points="{line}" fill="none" stroke="#2f6fb0" stroke-width="2" stroke-linejoin="round"/>')
    out.append(f'<text x="{x0 + WIDE / 2:.0f}" y="{HIGH - 6}" text-anchor="middle">steps taken; up: mean return of 16 episodes</text>')
    return out


def main():
    panels = [argument.split("=", 1) for argument in sys.argv[1:]]
    if not panels or any(len(p) != 2 for p in panels):
        sys.exit(__doc__)
    wide = WIDE * len(panels)
    print(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {wide} {HIGH}" width="{wide}" font-family="sans-serif" font-size="11" fill="#2b333b">')
    print(f'<rect width="{wide}" height="{HIGH}" fill="#fff"/>')
    for i, (title, name) in enumerate(panels):
        with open(name, encoding="utf-8", newline="") as file:
            print("\n".join(panel(title, list(csv.DictReader(file)), i * WIDE)))
    print("</svg>")


if __name__ == "__main__":
    main()
