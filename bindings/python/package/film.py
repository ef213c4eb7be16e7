"""Films of worlds: pages that play back what happened, in any browser and in notebooks."""
from __future__ import annotations

import base64
import html
import json
import os
import struct
from typing import Any, List, Optional, Sequence, Tuple

LOOKS = {"static_body": 0, "kinematic": 1, "dynamic": 2}
FARTHEST = 1.0e4  # m: shapes that go on farther do not widen the view


class Film:
    """What a world, a scene or the world of an environment looked like at some moments. The page that shows it needs nothing else, and no network.

    film = islet.Film(islet.Scene("pyramid"))
    film.run(120)
    film.save("pyramid.html")
    """

    title = "Islet"
    dt = 1 / 60  # s, between two moments

    def __init__(self, of: Any, dt: Optional[float] = None, title: Optional[str] = None, view: Optional[Sequence] = None) -> None:
        """of     a World, a Scene, or an environment of islet.envs; what it looks like now is the first moment
        dt     s, between two moments; a scene's own if not given, else 1/60
        title  of the page
        view   m, the box that is shown; if not given, a scene's own, the one that an environment shows at each moment, or all that is there at the first
        """
        self._of = of
        self._world = getattr(of, "world", of)
        self.dt = float(dt if dt is not None else getattr(of, "dt", 1 / 60))
        if not 0 < self.dt < float("inf"):
            raise ValueError("dt must be above 0 s")
        self.title = str(title if title is not None else getattr(of, "name", "") or "Islet")
        self._view = view if view is not None else getattr(of, "view", None)
        self._views: List[Tuple[int, List[float]]] = []  # from which moment on: what is shown
        self._models: List[list] = []  # each the outlines of a body's shapes, and its look
        self._numbers: dict = {}  # of the models
        self._known: dict = {}  # by body: its shapes and type when it was last looked at, and the number of its model
        self._casts: List[Tuple[int, List[int]]] = []  # from which moment on: the number of each slot's model, -1 where there is no body
        self._poses: List[bytes] = []
        self.take()

    def __len__(self) -> int:
        """How many moments there are."""
        return len(self._poses)

    def take(self) -> None:
        """Adds what the world looks like now."""
        world, cast = self._world, []
        poses = world.poses()
        for slot in range(len(poses)):
            body = world.body_at(slot)
            cast.append(self._model_of(body) if body else -1)
        while cast and cast[-1] == -1:
            cast.pop()
        if not self._casts or self._casts[-1][1] != cast:
            self._casts.append((len(self._poses), cast))
        self._poses.append(poses[:len(cast)].astype("<f4").tobytes())
        if not self._views or self._moves():
            shown = self._shown()
            if not self._views or self._views[-1][1] != shown:
                self._views.append((len(self._poses) - 1, shown))

    def run(self, steps: int) -> None:
        """Takes steps of dt of the world or the scene, and each moment after one."""
        for _ in range(steps):
            if self._of is self._world:
                self._world.step(self.dt)
            else:
                self._of.step()
            self.take()

    def html(self) -> str:
        """The page."""
        with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "film.html"), encoding="utf-8") as file:
            page = file.read()
        data = {"title": self.title, "dt": self.dt, "views": self._views, "models": self._models, "casts": self._casts,
                "poses": base64.b64encode(b"".join(self._poses)).decode(), "moments": len(self._poses)}
        text = json.dumps(data, separators=(",", ":")).replace("<", "\\u003c")  # no tag can begin within the script
        head, rest = page.split("{{title}}")
        before, after = rest.split("{{film}}")
        return head + html.escape(self.title) + before + text + after

    def save(self, path: Any) -> None:
        """Writes the page to a file."""
        with open(path, "w", encoding="utf-8") as file:
            file.write(self.html())

    def _repr_html_(self) -> str:
        return f'<iframe srcdoc="{html.escape(self.html())}" sandbox="allow-scripts" style="width:100%;height:480px;border:0"></iframe>'

    def __repr__(self) -> str:
        return f"<islet.Film of {len(self)} moments>"

    def _model_of(self, body: Any) -> int:
        shapes = self._world.shapes(body)
        key = (tuple((shape.index1, shape.generation) for shape in shapes), self._world.type(body))
        if self._known.get(body, (None,))[0] != key:
            model = [LOOKS[self._world.type(body).name], *filter(None, (outline(self._world, shape) for shape in reversed(shapes)))]
            text = json.dumps(model)
            if text not in self._numbers:
                self._numbers[text] = len(self._models)
                self._models.append(model)
            self._known[body] = key, self._numbers[text]
        return self._known[body][1]

    def _moves(self) -> bool:
        """Whether the view is an environment's, which may follow what moves."""
        return self._view is None and hasattr(self._of, "vector")

    def _shown(self) -> List[float]:
        """m, of the last moment: left, bottom, right, top."""
        view = self._of.vector.view_of(0) if self._moves() else self._view
        if view is not None:
            (left, bottom), (right, top) = view
            return [float(left), float(bottom), float(right), float(top)]
        xs, ys = [], []
        rows = struct.iter_unpack("<4f", self._poses[0])
        for number, (x, y, c, s) in zip(self._casts[0][1], rows):
            for radius, *points in self._models[number][1:] if number >= 0 else ():
                for px, py in points:
                    at_x, at_y = x + c * px - s * py, y + s * px + c * py
                    if abs(at_x) < FARTHEST and abs(at_y) < FARTHEST:
                        xs += [at_x - radius, at_x + radius]
                        ys += [at_y - radius, at_y + radius]
        if not xs:
            return [-10.0, -1.0, 10.0, 11.0]
        edge = 0.5 + 0.02 * (max(xs) - min(xs))
        return [min(xs) - edge, min(ys) - edge, max(xs) + edge, max(ys) + edge]


def outline(world: Any, shape: Any) -> Optional[list]:
    """[radius, point, ...] in the body's frame, m: one point is a circle, two are a capsule or a line, more a polygon with rounded corners."""
    circle = world.circle(shape)
    if circle is not None:
        return [circle.radius, list(circle.center)]
    polygon = world.polygon(shape)
    if polygon is not None:
        return [polygon.radius, *map(list, polygon.vertices[:polygon.count])]
    capsule = world.capsule(shape)
    if capsule is not None:
        return [capsule.radius, list(capsule.point1), list(capsule.point2)]
    chain = world.chain_segment(shape)
    segment = chain.segment if chain is not None else world.segment(shape)
    if segment is not None:
        return [0.0, list(segment.point1), list(segment.point2)]
    half = world.half_space(shape)
    if half is None:
        return None
    # A line so long that no view ends it.
    x, y = half.normal
    return [0.0, [x * half.offset - y * FARTHEST, y * half.offset + x * FARTHEST], [x * half.offset + y * FARTHEST, y * half.offset - x * FARTHEST]]
