"""What the tests of the package share: small worlds, and the golden hashes."""
import os

import islet

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def golden_hashes():
    """{scene: [(steps, hash)]} of tests/determinism/golden.txt."""
    table = {}
    with open(os.path.join(ROOT, "tests", "determinism", "golden.txt"), encoding="utf-8") as file:
        for line in file:
            if not line.startswith("#"):
                scene, steps, hash_ = line.split()
                table.setdefault(scene, []).append((int(steps), int(hash_, 16)))
    return table


def falling_boxes(count=3, **options):
    """A floor and boxes above it: the world and the boxes."""
    world = islet.World(bodies=count + 1, **options)
    world.create_shape(world.create_body(), islet.make_offset_box(50, 1, ((0, -1), 0)))
    boxes = [world.create_body(type="dynamic", position=(0.1 * i, 1 + 1.5 * i)) for i in range(count)]
    for box in boxes:
        world.create_shape(box, islet.make_box(0.5, 0.5))
    return world, boxes


def cart_and_pole():
    """A cart on a rail with a pole that stands on it: the world, cart, pole and hinge."""
    world = islet.World(bodies=3, joints=2)
    ground = world.create_body()
    cart = world.create_body(type="dynamic", position=(0, 0), enable_sleep=False)
    world.create_shape(cart, islet.make_box(0.25, 0.1), density=20)
    pole = world.create_body(type="dynamic", position=(0, 0.5))
    world.create_shape(pole, islet.make_box(0.02, 0.5), density=5, filter={"mask": 0})
    world.create_prismatic_joint(body_a=ground, body_b=cart)
    hinge = world.create_revolute_joint(body_a=cart, body_b=pole, frame_b={"position": (0, -0.5)})
    return world, cart, pole, hinge
