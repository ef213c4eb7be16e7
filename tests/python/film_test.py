"""Films: the page holds what the world was, moment by moment."""
import base64
import json
import os
import re
import tempfile
import unittest
from html.parser import HTMLParser

import numpy

import islet
from support import falling_boxes


def film_of(page):
    """What a page holds: its data, and for each moment the number of each slot's model and the poses."""
    data = json.loads(re.search(r'<script type="application/json" id="film">(.*?)</script>', page, re.DOTALL).group(1))
    poses, moments, casts = numpy.frombuffer(base64.b64decode(data["poses"]), "<f4").reshape(-1, 4), [], dict(map(tuple, ((i, c) for i, c in data["casts"])))
    at, cast = 0, None
    for i in range(data["moments"]):
        cast = casts.get(i, cast)
        moments.append((cast, poses[at:at + len(cast)]))
        at += len(cast)
    assert at == len(poses)
    return data, moments


class Films(unittest.TestCase):
    def test_moments_are_those_of_the_world(self):
        world, boxes = falling_boxes(3)
        film, wanted = islet.Film(world, dt=1 / 50), [world.poses()]
        for _ in range(20):
            world.step(1 / 50)
            film.take()
            wanted.append(world.poses())
        alone, _ = falling_boxes(3)
        other = islet.Film(alone, dt=1 / 50)
        other.run(20)
        self.assertEqual(film.html(), other.html())
        data, moments = film_of(film.html())
        self.assertEqual((len(film), data["dt"]), (21, 1 / 50))
        for (cast, poses), those in zip(moments, wanted):
            self.assertEqual(cast, [0, 1, 1, 1])
            self.assertTrue((poses == those).all())
        self.assertEqual(data["models"][1], [2, [0, [-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]]])

    def test_bodies_come_change_and_go(self):
        world, boxes = falling_boxes(3)
        film = islet.Film(world)
        world.destroy_body(boxes[1])
        film.take()
        ball = world.create_body(type="kinematic", position=(7, 8))
        world.create_shape(ball, islet.Circle((0, 1), 0.25))
        film.take()
        world.set_type(ball, "dynamic")
        film.take()
        data, moments = film_of(film.html())
        self.assertEqual([cast for cast, _ in moments], [[0, 1, 1, 1], [0, 1, -1, 1], [0, 1, 2, 1], [0, 1, 3, 1]])
        self.assertEqual(data["models"][2:], [[1, [0.25, [0, 1]]], [2, [0.25, [0, 1]]]])
        self.assertEqual(moments[2][1][2].tolist(), [7, 8, 1, 0])

    def test_every_scene_can_be_filmed(self):
        for name in islet.scenes():
            with self.subTest(name):
                scene = islet.Scene(name)
                film = islet.Film(scene)
                data, moments = film_of(film.html())
                self.assertEqual((data["title"], data["dt"]), (name, scene.dt))
                self.assertEqual(sum(number >= 0 for number in moments[0][0]), scene.world.body_count())

    def test_an_environment_can_be_filmed(self):
        env = islet.envs.make("bipedal_walker")
        env.reset(seed=1)
        film = islet.Film(env, dt=env.vector.dt)
        for _ in range(5):
            env.step(env.action_space.sample())
            film.take()
        data, moments = film_of(film.html())
        self.assertEqual(len(moments), 6)
        hull = env.vector.hull.slot
        for moment, (left, bottom, right, top) in data["views"]:  # which follow the walker
            self.assertAlmostEqual((left + right) / 2, moments[moment][1][hull][0], places=4)
        self.assertGreater(len(data["views"]), 1)

    def test_what_a_title_says_is_no_markup(self):
        title = "</script><b>&\"'{{film}}"
        page = islet.Film(islet.World(bodies=1), title=title).html()
        seen = []
        parser = HTMLParser()
        parser.handle_starttag = lambda tag, attributes: seen.append(tag)
        parser.feed(page)
        self.assertNotIn("b", seen)
        self.assertEqual(film_of(page)[0]["title"], title)
        self.assertNotIn("http", page.replace("http-equiv", ""))  # it needs no network

    def test_a_page_is_written_and_shown_in_notebooks(self):
        film = islet.Film(falling_boxes(2)[0])
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "film.html")
            film.save(path)
            with open(path, encoding="utf-8") as file:
                self.assertEqual(file.read(), film.html())
        self.assertTrue(film._repr_html_().startswith("<iframe srcdoc="))

    def test_bad_input_is_refused(self):
        world, _ = falling_boxes(1)
        for bad in (0, -1, float("nan"), float("inf")):
            with self.assertRaises(ValueError):
                islet.Film(world, dt=bad)
        with self.assertRaises((TypeError, ValueError)):
            islet.Film(world, view=5).html()
        with self.assertRaises(AttributeError):
            islet.Film(7)


if __name__ == "__main__":
    unittest.main()
