"""What a program can do wrong to the package: it gets an exception, and nothing has changed."""
import gc
import multiprocessing
import pickle
import threading
import unittest
import warnings
import weakref

import numpy

import islet
from support import cart_and_pole, falling_boxes


def make_fleet(worlds=4, workers=1):
    world, cart, _, _ = cart_and_pole()
    return islet.Fleet(world, worlds, workers=workers, drives=[islet.Drive("force_x", body=cart)], senses=[islet.Sense("angular_velocity", body=cart)]), cart


def floats(count, offset):
    """A column of numbers that begin `offset` bytes after an aligned place."""
    return numpy.frombuffer(bytearray(4 * count + 8), numpy.float32, count, offset).reshape(count, 1)


class ObjectsThatWereNotMade(unittest.TestCase):
    def test_new_without_init(self):
        of_worlds = ("step", "hash", "save", "validate", "poses", "copy", "svg", "start_recording", "stop_recording", "body_count", "__repr__")
        for cls, uses in ((islet.World, of_worlds), (islet.Fleet, ("step", "observe", "hashes", "__len__", "__repr__")), (islet.Scene, ("step", "svg"))):
            for name in uses:
                with self.subTest(f"{cls.__name__}.{name}"), self.assertRaises(TypeError):
                    getattr(cls.__new__(cls), name)()
        for use in (lambda w: w.workers, lambda w: w.error, lambda w: w.set_hooks(), lambda w: w.create_body(), lambda w: islet.Fleet(w, 2), pickle.dumps,
                    lambda w: w.step_mover(islet.MoverState())):
            with self.subTest(use), self.assertRaises((TypeError, islet.Error)):
                use(islet.World.__new__(islet.World))
        for use in (lambda f: f[0], lambda f: f.reset(0, b""), lambda f: f.fork([]), lambda f: f.copy(0, 0), pickle.dumps, lambda f: setattr(f, "drives", [])):
            with self.subTest(use), self.assertRaises((TypeError, islet.Error)):
                use(islet.Fleet.__new__(islet.Fleet))

    def test_records_without_init_are_zero(self):
        for name in dir(islet):
            cls = getattr(islet, name)
            if isinstance(cls, type) and cls.__module__ == "islet" and hasattr(cls, "__reduce__") and type(cls).__name__ == "pybind11_type":
                if cls not in (islet.World, islet.Fleet, islet.Scene):
                    self.assertTrue(repr(cls.__new__(cls)), name)
        self.assertEqual(islet.BodyDef.__new__(islet.BodyDef).type, islet.BodyType.static_body)

    def test_damaged_pickles(self):
        world, _ = falling_boxes(3)
        world.step(count=20)
        fleet, _ = make_fleet()
        random = numpy.random.default_rng(1)
        for thing in (world, fleet, islet.RevoluteJointDef()):
            sound = pickle.dumps(thing)
            for at in random.integers(len(sound), size=150).tolist():
                damaged = bytearray(sound)
                damaged[at] ^= 1 << int(random.integers(8))
                if damaged[at] == 0x96:  # a bytearray of impossible size, of which Python itself complains on standard error
                    continue
                try:
                    made = pickle.loads(bytes(damaged))
                except Exception:  # whatever pickle meets
                    continue
                if type(made) is islet.World:
                    try:
                        self.assertIsNone(made.validate())
                    except TypeError:  # World.__init__ was not called
                        pass


class Arrays(unittest.TestCase):
    def refused(self, call, *values, **named):
        with self.assertRaises(ValueError) as caught:
            call(*values, **named)
        self.assertNotIsInstance(caught.exception, islet.Error)
        return str(caught.exception)

    def test_arrays_that_are_not_aligned(self):
        fleet, _ = make_fleet()
        before = fleet.hashes().tolist()
        self.assertIn("aligned", self.refused(fleet.step, floats(4, 1)))
        self.assertIn("aligned", self.refused(fleet.step, floats(4, 0), out=floats(4, 3)))
        world, _ = falling_boxes(3)
        self.refused(world.poses, numpy.frombuffer(bytearray(65), numpy.float32, 16, 1).reshape(4, 4))
        self.assertEqual(fleet.hashes().tolist(), before)

    def test_observations_do_not_overwrite_actions(self):
        fleet, _ = make_fleet()
        before = fleet.hashes().tolist()
        both = numpy.zeros((5, 1), numpy.float32)
        self.assertIn("share", self.refused(fleet.step, both[:4], out=both[1:]))
        self.assertIn("share", self.refused(fleet.step, both[:4], out=both[:4]))
        mask = numpy.ones(16, numpy.uint8)
        self.assertIn("share", self.refused(fleet.step, both[:4], mask=mask[:4], out=mask.view(numpy.float32).reshape(4, 1)))
        self.assertIn("share", self.refused(fleet.observe, mask=mask[:4], out=mask.view(numpy.float32).reshape(4, 1)))
        self.assertEqual(fleet.hashes().tolist(), before)


class Records(unittest.TestCase):
    def test_a_field_of_a_field_can_be_set(self):
        joint = islet.RevoluteJointDef()
        joint.motor.enable = True
        joint.motor.speed = 3
        joint.frame_a.position = (1, 2)
        self.assertEqual((joint.motor, joint.frame_a.position), (islet.JointMotor(True, 3), (1, 2)))
        motor = joint.motor
        del joint
        gc.collect()
        self.assertEqual(motor.speed, 3)
        other = islet.RevoluteJointDef(motor=motor)
        motor.speed = 4
        self.assertEqual(other.motor.speed, 3)

    def test_an_id_is_a_value(self):
        first, second = islet.BodyId(1, 1), islet.BodyId(2, 1)
        joint = islet.RevoluteJointDef(body_a=first)
        names = {joint.body_a: "a"}
        joint.body_a = second
        self.assertEqual(names[first], "a")


class InAHook(unittest.TestCase):
    def with_filter(self, use):
        """Steps a world whose filter uses it once, catching an islet.Error; the world, and what was caught."""
        world, _ = falling_boxes(2)
        caught, asked = [], []

        def hook(a, b):
            if not asked:
                asked.append(True)
                try:
                    use(world)
                except islet.Error as error:
                    caught.append(error.code)
            return True

        world.set_hooks(filter=hook)
        world.start_recording()
        world.step(count=60)
        self.assertTrue(asked)
        recording = world.stop_recording()
        world.set_hooks()
        plain, _ = falling_boxes(2)
        plain.step(count=60)
        self.assertEqual(world.hash(), plain.hash())
        self.assertEqual(islet.replay(recording)[1].end, islet.ReplayEnd.complete)
        return caught

    def test_what_wants_a_world_at_rest_is_refused(self):
        for use in (lambda w: w.step(), lambda w: w.hash(), lambda w: w.save(), lambda w: w.copy(), lambda w: pickle.dumps(w), lambda w: w.validate(),
                    lambda w: w.start_recording(), lambda w: w.stop_recording(), lambda w: w.set_hooks(), lambda w: w.restore(falling_boxes(2)[0].save()),
                    lambda w: islet.Fleet(w, 2)):
            with self.subTest(use), warnings.catch_warnings():
                warnings.simplefilter("error")
                self.assertEqual(self.with_filter(use), [islet.ErrorCode.in_step])

    def test_a_world_stays_busy_after_a_refused_step(self):
        """The filter asks for a step of the same world, and while the first step goes on another thread asks for the hash."""
        world, _ = falling_boxes(40)
        seen = []

        def hook(a, b):
            if not seen:
                try:
                    world.step()
                except islet.Error:
                    pass

                def look():
                    try:
                        seen.append(world.hash())
                    except islet.Error as error:
                        seen.append(error.code)
                thread = threading.Thread(target=look)
                thread.start()
                thread.join()
            return True

        world.set_hooks(filter=hook)
        world.step(count=30)
        self.assertEqual(seen, [islet.ErrorCode.in_step])

    def test_hooks_that_know_their_world_are_collected(self):
        class Filter:
            def __init__(self, world):
                self.world = world

            def __call__(self, a, b):
                return self.world.is_valid(a)

        world, _ = falling_boxes(2)
        world.set_hooks(filter=Filter(world))
        gc.collect()
        world.step(count=60)
        hook = Filter(world)
        world.set_hooks(filter=hook, pre_solve=hook)
        gone = weakref.ref(hook)
        del hook
        gc.collect()
        self.assertIsNotNone(gone())
        del world
        gc.collect()
        self.assertIsNone(gone())


class OtherThreads(unittest.TestCase):
    def test_columns_that_run_python_do_not_change_in_a_step(self):
        """The list of drives comes from a generator, in whose middle another thread begins a long step."""
        fleet, cart = make_fleet(64)
        going, codes = threading.Event(), []

        def drives():
            yield islet.Drive("force_y", body=cart)
            thread = threading.Thread(target=lambda: (going.set(), fleet.step(repeat=1000)))
            threads.append(thread)
            thread.start()
            going.wait()

        threads = []
        deadline = 200
        while deadline and not codes:
            deadline -= 1
            going.clear()
            try:
                fleet.drives = drives()
            except islet.Error as error:
                codes.append(error.code)
            for thread in threads:
                thread.join()
        self.assertEqual(codes, [islet.ErrorCode.in_step])

    def test_many_threads_at_one_fleet(self):
        fleet, _ = make_fleet(32, 2)
        failures = []

        def use():
            for _ in range(40):
                try:
                    fleet.step(numpy.ones((32, 1), numpy.float32))
                    fleet.hashes()
                    fleet.fork([0] * 32)
                    pickle.dumps(fleet)
                    fleet[3].step()
                except islet.Error as error:
                    if error.code != islet.ErrorCode.in_step:
                        failures.append(error)

        threads = [threading.Thread(target=use) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(failures, [])
        for k in range(32):
            self.assertIsNone(fleet[k].validate())


FLEET = None


def step_here(count):
    FLEET.step(numpy.ones((16, 1), numpy.float32), repeat=count)
    return FLEET.hashes().tolist()


def step_there(count):
    """In another process, in which the fleet ends too."""
    global FLEET
    hashes = step_here(count)
    FLEET = None
    return hashes


class OtherProcesses(unittest.TestCase):
    def test_a_forked_process_steps_with_threads_of_its_own(self):
        global FLEET
        FLEET, _ = make_fleet(16, 3)
        FLEET.step(numpy.ones((16, 1), numpy.float32))
        with multiprocessing.get_context("fork").Pool(1) as pool:
            there = pool.apply_async(step_there, [5]).get(timeout=60)
            pool.close()
            pool.join()
        self.assertEqual(step_here(5), there)
        FLEET = None


if __name__ == "__main__":
    unittest.main()
