import enum
from typing import Any, Callable, Iterable, Mapping, NamedTuple, Sequence, Union, overload

import numpy
import numpy.typing

from islet import envs as envs

Point = Sequence[float]
Rotation = Union[float, Sequence[float]]
Pose = Sequence[Any]
Box = Sequence[Sequence[float]]
Floats = numpy.typing.NDArray[numpy.float32]
Convex = Union["ShapeProxy", "Circle", "Capsule", "Segment", "Polygon"]
Geometry = Union["Circle", "Polygon", "Capsule", "Segment", "ChainSegment", "HalfSpace"]
JointDef = Union["RevoluteJointDef", "PrismaticJointDef", "DistanceJointDef", "WeldJointDef", "WheelJointDef", "MotorJointDef", "MouseJointDef",
                 "PulleyJointDef", "GearJointDef", "AngleJointDef"]

__version__: str

class Vec2(NamedTuple):
    """A point or direction, metres unless said otherwise. Every pair of numbers will do for one."""
    x: float = ...
    y: float = ...

class Rot(NamedTuple):
    """A rotation as cosine and sine of its angle. Where one is wanted, an angle (rad) will do."""
    c: float = ...
    s: float = ...

class Transform(NamedTuple):
    """A pose: rotate by q, then move by p (metres)."""
    p: Vec2 = ...
    q: Rot = ...

class Aabb(NamedTuple):
    """An axis-aligned box, m: lower <= upper on both axes."""
    lower: Vec2 = ...
    upper: Vec2 = ...

class Error(ValueError):
    """A call that the engine refused: nothing has changed. `code` says which rule was broken, and the message how to keep it."""
    code: ErrorCode
    def __init__(self, message: str, code: object = None) -> None: ...

# TYPES

class World:
    """A world: one block of memory that holds bodies, shapes and joints, and steps them."""
    def __init__(self, *, bodies: int = 256, shapes: int = ..., contacts: int = ..., joints: int = ..., geometries: int = 0, hits: int = 0,
                 capacity: Capacity = ..., workers: int = 1, **options: WorldDef) -> None:
        """A world with room for so many objects. Without `shapes`, `joints` and `contacts`, there is room for a shape and a joint a body, and for 5 contacts
        a shape. A `capacity` says how many joints there are.
        """
    @property
    def workers(self) -> int:
        """Threads that step the world."""
    @property
    def error(self) -> ErrorCode:
        """The last error."""
    def step(self, dt: float = 1 / 60, count: int = 1) -> None:
        """Advances time by dt seconds, `count` times. Other threads of Python run meanwhile. Where there is no room for a contact or an event, the step
        goes on, and a RuntimeWarning says so.
        """
    def hash(self) -> int:
        """Hash of all state that affects the future. Worlds with equal hashes have equal futures."""
    def save(self) -> bytes:
        """A snapshot of the world."""
    def restore(self, image: Any) -> None:
        """Takes the world back to a snapshot, of which nothing is used before all of it is found sound."""
    def copy(self) -> World:
        """A world of its own that is now the same."""
    def validate(self) -> str | None:
        """Checks every internal invariant: None, or a sentence that says what is broken. Slow."""
    def poses(self, out: Floats | None = None) -> Floats:
        """x, y, cosine and sine of each body, a row for each slot (zeros where there is no body)."""
    def velocities(self, out: Floats | None = None) -> Floats:
        """Velocity x, y and angular velocity of each body, a row for each slot (zeros where there is no body)."""
    def set_hooks(self, *, filter: Callable[[ShapeId, ShapeId], bool] | None = None, pre_solve: Callable[[PreSolve], None] | None = None,
                  mix_friction: Callable[[float, int, float, int], float] | None = None,
                  mix_restitution: Callable[[float, int, float, int], float] | None = None) -> None:
        """Functions that steps call, to let you decide something; those not given are taken away. `filter` says whether two shapes may meet; `pre_solve`
        sees contacts of shapes with ShapeDef.pre_solve and may change them for this step; the others give the friction and the restitution of two
        materials. They may read the world. What one raises is raised again after the step. Hooks are no part of the state: hashes, snapshots, copies and
        fleets do not have them.
        """
    def step_mover(self, state: MoverState, mover: MoverDef = ..., dt: float = 1 / 60, collides: Callable[[Surface], bool] | None = None,
                   **options: MoverInput) -> None:
        """Moves a character mover by dt seconds, once after each step of the world. Changes its MoverState. `collides` says of each surface that the
        mover's filter finds whether it stands in the way; it may read the world. Where it raises, so does this, and all surfaces not asked about stand in
        the way.
        """
    def start_recording(self) -> None:
        """Records from now on every call that changes the world, and what its fleet does with it. To become a copy of another world ends the recording."""
    def stop_recording(self) -> bytes:
        """Ends the recording; its bytes, for `islet replay`."""
    def svg(self, view: Box | None = None, title: str = "", dt: float = 1 / 60, joints: bool = True) -> str:
        """A picture: an SVG document. Of the box `view`, or of all shapes, with joints or without."""
    def _repr_svg_(self) -> str: ...
    def __copy__(self) -> World: ...
    def __deepcopy__(self, memo: Any) -> World: ...
    def create_body(self, definition: BodyDef | None = None, **options: BodyDef) -> BodyId:
        """Makes a body from a BodyDef, or from fields of one."""
    def create_shape(self, body: BodyId, shape: Geometry, definition: ShapeDef | None = None, **options: ShapeDef) -> ShapeId:
        """Gives a body a shape, with the fields of a ShapeDef."""
    def create_chain(self, body: BodyId, points: Iterable[Point], loop: bool = False, definition: ShapeDef | None = None, **options: ShapeDef) -> list[ShapeId]:
        """A chain of ChainSegments through points, all or nothing, which collides on the right of its direction. Returns their ids."""
    def create_joint(self, definition: JointDef) -> JointId:
        """Makes the joint of a RevoluteJointDef or another of the JointDefs."""
    def create_revolute_joint(self, **options: RevoluteJointDef) -> JointId: ...
    def create_prismatic_joint(self, **options: PrismaticJointDef) -> JointId: ...
    def create_distance_joint(self, **options: DistanceJointDef) -> JointId: ...
    def create_weld_joint(self, **options: WeldJointDef) -> JointId: ...
    def create_wheel_joint(self, **options: WheelJointDef) -> JointId: ...
    def create_motor_joint(self, **options: MotorJointDef) -> JointId: ...
    def create_mouse_joint(self, **options: MouseJointDef) -> JointId: ...
    def create_pulley_joint(self, **options: PulleyJointDef) -> JointId: ...
    def create_gear_joint(self, **options: GearJointDef) -> JointId: ...
    def create_angle_joint(self, **options: AngleJointDef) -> JointId: ...
    def explode(self, definition: ExplosionDef | None = None, **options: ExplosionDef) -> None:
        """Pushes the shapes of dynamic bodies away from a point."""
    def apply_wind(self, shape: ShapeId, definition: WindDef | None = None, **options: WindDef) -> None:
        """Wind on a shape during the next step."""
    def set_solver(self, definition: SolverDef | None = None, **options: SolverDef) -> None:
        """Changes settings of the solver: a SolverDef, or the fields to change."""
    def overlap_box(self, box: Box, filter: QueryFilter = ...) -> list[ShapeId]:
        """The shapes whose tight box overlaps a box."""
    def overlap_shape(self, shape: Convex, filter: QueryFilter = ...) -> list[ShapeId]:
        """The shapes that share a point with a shape, which stands in the world."""
    def overlap_point(self, point: Point, filter: QueryFilter = ...) -> list[ShapeId]:
        """The shapes that contain a point."""
    def cast_ray_all(self, origin: Point, translation: Point, filter: QueryFilter = ...) -> list[QueryHit]:
        """All hits of a ray, first ones first."""
    def cast_shape_all(self, shape: Convex, translation: Point, filter: QueryFilter = ...) -> list[QueryHit]:
        """All hits of a shape that moves, first ones first."""
    def surfaces_near(self, shape: Convex, within: float, filter: QueryFilter = ...) -> list[Surface]:
        """The surfaces no farther than `within` (m) from a shape in the world, the closest first."""
    def sensor_overlaps(self, sensor: ShapeId) -> list[ShapeId]:
        """The shapes that overlap a sensor."""
    def contacts(self, of: BodyId | ShapeId = ...) -> list[ContactInfo]:
        """The touching contacts of a body or a shape, newest first; without one, all of the world."""
    def bodies(self) -> list[BodyId]:
        """All bodies, by slot."""
    def shapes(self, body: BodyId = ...) -> list[ShapeId]:
        """The shapes of a body, newest first; without one, all of the world."""
    def joints(self, body: BodyId = ...) -> list[JointId]:
        """The joints of a body, newest first; without one, all of the world."""
    # METHODS

class Fleet:
    """Many worlds that start as copies of one world and step together."""
    def __init__(self, world: World, worlds: int, workers: int = 1, drives: Iterable[Drive | Mapping[str, Any]] = (),
                 senses: Iterable[Sense | Mapping[str, Any]] = ()) -> None:
        """Makes `worlds` copies of a world, stepped by so many threads."""
    drives: list[Drive]
    senses: list[Sense]
    @property
    def columns(self) -> int:
        """Columns of the observations."""
    @property
    def workers(self) -> int:
        """Threads that step the worlds."""
    def __len__(self) -> int: ...
    def __getitem__(self, k: int) -> World:
        """World k, which can be read and changed like any other."""
    def step(self, actions: Floats | None = None, dt: float = 1 / 60, repeat: int = 1, mask: Any = None, out: Floats | None = None) -> Floats:
        """Applies the actions, an array of float32 of shape (worlds, drives), steps `repeat` times, and observes: an array of float32 of shape
        (worlds, columns). Worlds where the mask is 0 stay as they are, and so do their rows in `out`. None without senses.
        """
    def observe(self, mask: Any = None, out: Floats | None = None) -> Floats:
        """Observes without a step."""
    def reset(self, k: int, image: Any, seed: int = 0, variations: Iterable[Variation | Mapping[str, Any]] = ()) -> None:
        """Takes world k back to a snapshot, and changes bodies at random: the same seed gives the same changes."""
    def copy(self, source: int, target: int) -> None:
        """Makes world `target` a copy of world `source`."""
    def fork(self, parents: Iterable[int]) -> None:
        """Makes each world k a copy of world parents[k], at once. A parent stays as it is: parents[parents[k]] is parents[k]."""
    def hashes(self) -> numpy.typing.NDArray[numpy.uint64]:
        """The hash of each world."""

class Scene:
    """A scene of the catalogue with its script. step() runs both; world.step() only the world."""
    def __init__(self, name: str) -> None: ...
    def step(self, count: int = 1) -> None:
        """Takes steps of `dt`, with what the script does before and after each."""
    @property
    def world(self) -> World: ...
    @property
    def name(self) -> str: ...
    @property
    def dt(self) -> float:
        """s"""
    @property
    def steps(self) -> int:
        """How long it runs in the manual and in tests."""
    @property
    def view(self) -> Aabb:
        """m, what a picture shows."""
    def svg(self) -> str:
        """A picture: an SVG document."""
    def _repr_svg_(self) -> str: ...

class Film:
    """What a world, a scene or the world of an environment looked like at some moments. The page that shows it needs nothing else, and no network."""
    title: str
    dt: float
    def __init__(self, of: Any, dt: float | None = None, title: str | None = None, view: Box | None = None) -> None:
        """Of a World, a Scene, or an environment of islet.envs: what it looks like now is the first moment. dt (s) is the time between two moments, a scene's
        own if not given, else 1/60. `view` (m) is the box that is shown: if not given, a scene's own, the one that an environment shows at each moment, or
        all that is there at the first.
        """
    def __len__(self) -> int: ...
    def take(self) -> None:
        """Adds what the world looks like now."""
    def run(self, steps: int) -> None:
        """Takes steps of dt of the world or the scene, and each moment after one."""
    def html(self) -> str:
        """The page."""
    def save(self, path: Any) -> None:
        """Writes the page to a file."""
    def _repr_html_(self) -> str: ...

def scenes() -> dict[str, str]:
    """The scenes of the catalogue: a line about each by its name."""

def make_polygon(points: Iterable[Point], radius: float = 0) -> Polygon:
    """The convex hull of at least 3 points (8 corners at most), rounded by a radius (m)."""

def make_proxy(shape: Convex) -> ShapeProxy:
    """The proxy of a circle, a capsule, a segment or a polygon."""

def delta(before: Any, after: Any) -> bytes:
    """What changed between two snapshots, packed: apply(before, delta) gives `after` again."""

def apply(before: Any, delta: Any) -> bytes:
    """The snapshot to which a delta leads from the snapshot `before`."""

def read_snapshot(image: Any) -> SnapshotInfo:
    """What a snapshot says about itself."""

def read_recording(recording: Any) -> RecordingInfo:
    """What a recording says about itself."""

def replay(recording: Any, steps: int | None = None, workers: int = 1, memory_limit: int = 2_000_000_000) -> tuple[World, ReplayResult]:
    """Makes the calls of a recording again, in a world of its own, up to and including so many steps. Returns the world and a ReplayResult: whether each step
    came out as recorded. A recording whose world needs more than memory_limit bytes is refused.
    """

def describe(code: ErrorCode) -> str:
    """A sentence that says what was wrong and how to fix it."""

# FUNCTIONS
