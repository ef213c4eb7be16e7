"""What the engine asks of Python: hooks and a mover's filter. And bytes: deltas, recordings and their replays."""
import threading
import unittest

import islet
from support import falling_boxes


def slope_and_box(**options):
    """A box on a slope of half a radian: the world and the box."""
    world = islet.World(bodies=2, **options)
    world.create_shape(world.create_body(), islet.make_offset_box(20, 1, ((0, 0), 0.5)), pre_solve=True)
    box = world.create_body(type="dynamic", position=(-0.72, 1.317), angle=0.5)
    world.create_shape(box, islet.make_box(0.5, 0.5), friction=0)
    return world, box


class Hooks(unittest.TestCase):
    def test_a_filter_decides_who_meets_and_may_read_the_world(self):
        world, boxes = falling_boxes(2)
        asked = []

        def floor_only(a, b):
            asked.append({world.body(a), world.body(b)})
            return not asked[-1] <= set(boxes)

        world.set_hooks(filter=floor_only)
        world.step(count=120)
        self.assertIn(set(boxes), asked)
        for box in boxes:  # through each other, and onto the floor
            self.assertAlmostEqual(world.position(box).y, 0.5, delta=0.02)
        world.set_hooks()
        asked.clear()
        world.step(count=10)
        self.assertEqual(asked, [])

    def test_pre_solve_changes_a_contact(self):
        slides, sliding = slope_and_box()
        slides.step(count=120)
        stays, staying = slope_and_box()

        def glue(contact):
            self.assertGreaterEqual(contact.contact.point_count, 1)
            contact.friction = 5

        stays.set_hooks(pre_solve=glue)
        before = stays.position(staying)
        stays.step(count=120)
        after = stays.position(staying)
        self.assertLess(abs(after.x - before.x) + abs(after.y - before.y), 0.1)
        self.assertGreater(abs(slides.position(sliding).x - before.x), 3)

    def test_pre_solve_lets_pass(self):
        world, box = slope_and_box()

        def away(contact):
            contact.enabled = False

        world.set_hooks(pre_solve=away)
        world.step(count=120)
        self.assertLess(world.position(box).y, -10)

    def test_materials_are_mixed_on_any_worker(self):
        hashes = []
        for workers in (1, 3):
            world = islet.World(bodies=33, workers=workers)
            world.create_shape(world.create_body(), islet.make_offset_box(90, 1, ((0, -1), 0)), material=1)
            for i in range(32):
                ball = world.create_body(type="dynamic", position=(2 * i, 1), enable_sleep=False)
                world.create_shape(ball, islet.Circle(radius=0.5), material=i)
            world.set_hooks(mix_restitution=lambda a, first, b, second: 0.9 if first % 2 == 0 or second % 2 == 0 else 0.0)
            world.step(count=45)
            hashes.append(world.hash())
            heights = [y for x, y, _, _ in world.poses()[1:]]
            self.assertGreater(min(heights[0::2]), 0.6)  # these bounce
            self.assertLess(max(heights[1::2]), 0.55)
        self.assertEqual(hashes[0], hashes[1])

    def test_what_a_hook_raises_is_raised_after_the_step(self):
        world, boxes = falling_boxes(2)
        calls = []

        def broken(a, b):
            calls.append(1)
            raise KeyError("lost")

        world.set_hooks(filter=broken)
        with self.assertRaisesRegex(KeyError, "lost"):
            world.step(count=200)
        self.assertEqual(len(calls), 1)
        steps = world.step_count()
        world.set_hooks(filter=lambda a, b: "no word of yes or no")
        self.assertIsNone(world.validate())
        world.set_hooks()
        world.step()
        self.assertEqual(world.step_count(), steps + 1)

    def test_a_hook_changes_nothing(self):
        world, boxes = falling_boxes(2)
        refused = []

        def meddles(a, b):
            try:
                world.set_linear_velocity(boxes[0], (9, 9))
            except islet.Error as error:
                refused.append(error.code)
            return True

        world.set_hooks(filter=meddles)
        plain, _ = falling_boxes(2)
        for each in (world, plain):
            each.step(count=90)
        self.assertEqual(set(refused), {islet.ErrorCode.in_step})
        self.assertEqual(world.hash(), plain.hash())

    def test_another_thread_is_refused_while_a_hook_runs(self):
        world, _ = falling_boxes(1)
        codes = []

        def elsewhere():
            try:
                world.hash()
            except islet.Error as error:
                codes.append(error.code)

        def asks(a, b):
            thread = threading.Thread(target=elsewhere)
            thread.start()
            thread.join()
            return True

        world.set_hooks(filter=asks)
        world.step(count=60)
        self.assertEqual(set(codes), {islet.ErrorCode.in_step})

    def test_what_is_no_function_is_refused(self):
        world, _ = falling_boxes(1)
        with self.assertRaises(TypeError):
            world.set_hooks(filter=3)
        with self.assertRaises(TypeError):
            world.set_hooks(lambda a, b: True)
        fleet = islet.Fleet(world, 2)
        with self.assertRaises(islet.Error):
            fleet[0].set_hooks(filter=lambda a, b: True)


class Mover(unittest.TestCase):
    def arena(self):
        world = islet.World(bodies=2)
        ground = world.create_body()
        world.create_shape(ground, islet.make_offset_box(50, 1, ((0, -1), 0)))
        wall = world.create_shape(world.create_body(position=(5, 1)), islet.make_box(0.5, 1.5))
        return world, wall

    def walk(self, world, steps, **options):
        hero = islet.MoverState(position=(0, 0.5))
        for _ in range(steps):
            world.step()
            world.step_mover(hero, walk=4, **options)
        return hero

    def test_it_walks_to_a_wall(self):
        world, _ = self.arena()
        hero = self.walk(world, 120)
        self.assertAlmostEqual(hero.position.x, 4.5 - 0.3, delta=0.02)
        self.assertAlmostEqual(hero.position.y, 0, delta=0.03)
        self.assertTrue(hero.ground)
        self.assertEqual(hero.squeezed, 0)

    def test_its_filter_lets_it_through(self):
        world, wall = self.arena()
        seen = set()

        def collides(surface):
            seen.add(surface.shape)
            return surface.shape != wall

        hero = self.walk(world, 120, collides=collides)
        self.assertGreater(hero.position.x, 6)
        self.assertIn(wall, seen)

    def test_what_the_filter_raises_is_raised(self):
        world, _ = self.arena()
        with self.assertRaises(ZeroDivisionError):
            self.walk(world, 60, collides=lambda surface: 1 / 0)

    def test_bad_input_is_refused_and_changes_nothing(self):
        world, _ = self.arena()
        hero = islet.MoverState(position=(0, 0.5))
        for bad in ({"walk": float("nan")}, {"jump": -1}, {"dt": 0}, {"mover": islet.MoverDef(up=(0, 2))}):
            with self.subTest(bad), self.assertRaises(islet.Error):
                world.step_mover(hero, **bad)
        for bad in ({"state": {"position": (0, 1)}}, {"state": hero, "run": 3}, {"state": hero, "collides": 7}):
            with self.subTest(bad), self.assertRaises(TypeError):
                world.step_mover(**bad)
        self.assertEqual(hero.position, (0, 0.5))


class Bytes(unittest.TestCase):
    def test_deltas_lead_from_one_image_to_the_other(self):
        world, _ = falling_boxes(20)
        before = world.save()
        world.step(count=30)
        after = world.save()
        delta = islet.delta(before, after)
        self.assertLess(len(delta), len(after))
        self.assertEqual(islet.apply(before, delta), after)
        self.assertEqual(islet.apply(after, islet.delta(after, before)), before)
        empty = islet.World(bodies=1).save()
        self.assertEqual(islet.apply(empty, islet.delta(empty, after)), after)
        with self.assertRaises(islet.Error) as caught:
            islet.apply(after, delta)
        self.assertEqual(caught.exception.code, islet.ErrorCode.wrong_delta)
        for bad in (b"", b"x" * 100, delta[:-1]):
            with self.subTest(bad[:5]), self.assertRaises(islet.Error):
                islet.apply(before, bad)

    def test_images_say_what_they_hold(self):
        world, _ = falling_boxes(3)
        info = islet.read_snapshot(world.save())
        self.assertEqual((info.capacity.bodies, info.used.bodies, info.bytes), (4, 4, len(world.save())))
        with self.assertRaises(islet.Error):
            islet.read_snapshot(b"no image")

    def recorded(self):
        world, boxes = falling_boxes(5)
        world.start_recording()
        world.step(count=20)
        world.set_linear_velocity(boxes[0], (3, 0))
        world.step(count=20)
        return world, world.stop_recording()

    def test_a_recording_comes_out_the_same(self):
        world, recording = self.recorded()
        for workers in (1, 2):
            again, result = islet.replay(recording, workers=workers)
            self.assertEqual(result.end, islet.ReplayEnd.complete)
            self.assertEqual((again.hash(), result.steps), (world.hash(), 40))
        half, result = islet.replay(recording, steps=20)
        self.assertEqual((result.end, half.step_count()), (islet.ReplayEnd.stopped, 20))
        self.assertEqual(islet.read_recording(recording).capacity.bodies, 6)

    def test_what_is_no_recording_or_asks_too_much_is_refused(self):
        _, recording = self.recorded()
        for bad in (b"", b"y" * 200, recording[:50]):
            with self.subTest(bad[:5]), self.assertRaises(islet.Error):
                islet.replay(bad)
        with self.assertRaisesRegex(islet.Error, "memory_limit"):
            islet.replay(recording, memory_limit=1000)
        damaged = bytearray(recording)
        damaged[-9] ^= 1
        _, result = islet.replay(damaged)
        self.assertNotEqual(result.end, islet.ReplayEnd.complete)


if __name__ == "__main__":
    unittest.main()
