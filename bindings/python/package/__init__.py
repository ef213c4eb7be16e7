"""Islet, a 2D physics engine in one fixed block of memory: the same bits on every machine.

    import islet

    world = islet.World(bodies=64)
    floor = world.create_body()
    world.create_shape(floor, islet.make_offset_box(20, 1, ((0, -1), 0)))
    ball = world.create_body(type='dynamic', position=(0, 5))
    world.create_shape(ball, islet.Circle(radius=0.5), restitution=0.5)
    world.step(count=60)
    print(world.position(ball))

Metres, kilograms, seconds and radians. A call that fails raises islet.Error and changes nothing.
"""
from islet import _islet
from islet._islet import *  # noqa: F401,F403
from islet._islet import __version__
from islet.film import Film
from islet.plain import Aabb, Error, Rot, Transform, Vec2

__all__ = sorted([name for name in dir(_islet) if not name.startswith("_")] + ["Aabb", "Error", "Film", "Rot", "Transform", "Vec2", "__version__"])

for _name in __all__:  # one package, wherever its parts are made
    if isinstance(globals()[_name], type):
        globals()[_name].__module__ = "islet"
del _name


def __getattr__(name):
    """islet.envs is imported where it is used."""
    if name != "envs":
        raise AttributeError(f"module 'islet' has no attribute {name!r}")
    import importlib
    return importlib.import_module("islet.envs")
