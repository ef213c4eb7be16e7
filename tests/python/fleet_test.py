"""Fleet, as Python has it: what numpy's arrays hold, what is refused, and that worlds come to what they come to by themselves."""
import math
import pickle
import unittest

import numpy

import islet
from support import cart_and_pole


def make_fleet(worlds=16, workers=1):
    world, cart, pole, hinge = cart_and_pole()
    fleet = islet.Fleet(world, worlds, workers=workers, drives=[islet.Drive("force_x", body=cart, scale=10)],
                        senses=[{"kind": "position", "body": cart}, {"kind": "joint", "joint": hinge}, {"kind": "angular_velocity", "body": pole}])
    return fleet, world, (cart, pole, hinge)


def pushes(worlds, seed=1):
    return numpy.random.default_rng(seed).uniform(-1, 1, (worlds, 1)).astype(numpy.float32)


class Fleets(unittest.TestCase):
    def test_each_world_comes_to_what_a_world_by_itself_comes_to(self):
        fleet, prototype, (cart, pole, hinge) = make_fleet()
        actions = pushes(16)
        for _ in range(30):
            observations = fleet.step(actions)
        for k in (0, 7, 15):
            alone = prototype.copy()
            for _ in range(30):
                alone.apply_force_to_center(cart, (numpy.float32(10) * actions[k, 0], 0))
                alone.step()
            self.assertEqual(fleet[k].hash(), alone.hash())
            wanted = [*alone.position(cart), alone.joint_position(hinge), alone.joint_speed(hinge), alone.angular_velocity(pole)]
            self.assertEqual(list(observations[k]), wanted)

    def test_workers_change_nothing(self):
        hashes = []
        for workers in (1, 2, 5):
            fleet, _, _ = make_fleet(37, workers)
            for _ in range(10):
                fleet.step(pushes(37), repeat=2)
            hashes.append(fleet.hashes().tolist())
        self.assertEqual(len(set(hashes[0])), 37)
        self.assertEqual(hashes[0], hashes[1])
        self.assertEqual(hashes[0], hashes[2])

    def test_masked_worlds_and_their_rows_stay(self):
        fleet, _, _ = make_fleet(4)
        mask = numpy.array([True, False, True, False])
        out = numpy.full((4, 5), 7, numpy.float32)
        before = fleet.hashes()
        self.assertIs(fleet.step(pushes(4), mask=mask, out=out), out)
        self.assertEqual((fleet.hashes() != before).tolist(), mask.tolist())
        self.assertTrue((out[~mask] == 7).all() and (out[mask] != 7).any())

    def test_forks_copies_and_resets(self):
        fleet, prototype, (_, pole, _) = make_fleet(4)
        fleet.step(pushes(4))
        hashes = fleet.hashes()
        fleet.fork([1, 1, 2, 2])
        self.assertEqual(fleet.hashes().tolist(), [hashes[k] for k in (1, 1, 2, 2)])
        fleet.copy(0, 3)
        self.assertEqual(fleet[3].hash(), hashes[1])
        image = prototype.save()
        fleet.reset(0, image)
        self.assertEqual(fleet[0].hash(), prototype.hash())
        variations = [{"body": pole, "angle": 0.1}]
        for k, seed in ((1, 5), (2, 5), (3, 6)):
            fleet.reset(k, image, seed, variations)
        self.assertEqual(fleet[1].hash(), fleet[2].hash())
        self.assertNotEqual(fleet[1].hash(), fleet[3].hash())
        self.assertEqual(fleet[-1].hash(), fleet[3].hash())

    def test_pickles_go_on_alike(self):
        fleet, _, _ = make_fleet(5, 2)
        fleet.step(pushes(5))
        again = pickle.loads(pickle.dumps(fleet))
        self.assertEqual((len(again), again.workers, again.drives, again.senses), (5, 2, fleet.drives, fleet.senses))
        self.assertTrue((again.step(pushes(5, 2)) == fleet.step(pushes(5, 2))).all())
        self.assertEqual(again.hashes().tolist(), fleet.hashes().tolist())

    def test_a_world_keeps_its_fleet(self):
        world = make_fleet(3)[0][2]
        world.step(count=5)
        self.assertIsNone(world.validate())

    def refused(self, fleet, call, *values, code=islet.ErrorCode.out_of_range, **named):
        before = fleet.hashes().tolist()
        with self.assertRaises(islet.Error) as caught:
            call(*values, **named)
        self.assertEqual(caught.exception.code, code)
        self.assertEqual(fleet.hashes().tolist(), before)

    def refused_by_python(self, error, fleet, call, *values, **named):
        """With a sentence about the array alone."""
        before = fleet.hashes().tolist()
        with self.assertRaisesRegex(error, "^(actions|mask|out) must be a C-contiguous array of .* of shape [^:]*$") as caught:
            call(*values, **named)
        self.assertNotIsInstance(caught.exception, islet.Error)
        self.assertEqual(fleet.hashes().tolist(), before)

    def test_bad_arrays_are_refused_and_change_nothing(self):
        fleet, _, _ = make_fleet(4)
        good = pushes(4)
        for actions in (good.astype(float), good.astype(numpy.int32), good.tolist(), good.astype(">f4")):
            self.refused_by_python(TypeError, fleet, fleet.step, actions)
        for actions in (pushes(5), good[:, 0], numpy.zeros((4, 2), numpy.float32), numpy.zeros((8, 1), numpy.float32)[::2]):
            self.refused_by_python(ValueError, fleet, fleet.step, actions)
        for value in (math.nan, math.inf):
            bad = good.copy()
            bad[3, 0] = value
            self.refused(fleet, fleet.step, bad, code=islet.ErrorCode.not_finite)
        self.refused(fleet, fleet.step, good, dt=0, code=islet.ErrorCode.bad_time_step)
        self.refused(fleet, fleet.step, good, repeat=0)
        self.refused_by_python(ValueError, fleet, fleet.step, good, mask=numpy.ones(3, bool))
        self.refused_by_python(TypeError, fleet, fleet.step, good, mask=numpy.ones(4, float))
        for out in (numpy.zeros((4, 4), numpy.float32), numpy.zeros((5, 4), numpy.float32).T):
            self.refused_by_python(ValueError, fleet, fleet.step, good, out=out)
        self.refused_by_python(TypeError, fleet, fleet.step, good, out=numpy.zeros((4, 5)))
        frozen = numpy.zeros((4, 5), numpy.float32)
        frozen.flags.writeable = False
        self.refused_by_python(ValueError, fleet, fleet.step, good, out=frozen)
        self.refused(fleet, fleet.fork, [1, 0, 2, 3])
        self.refused(fleet, fleet.fork, [0, 1])
        self.refused(fleet, fleet.fork, [0, 0, 0, -1])
        with self.assertRaises(IndexError):
            fleet.copy(0, 4)
        with self.assertRaises(IndexError):
            fleet[4]

    def test_images_of_other_worlds_are_refused(self):
        fleet, prototype, (cart, _, _) = make_fleet(2)
        fleet.step(pushes(2))
        large = islet.World(bodies=50)
        for i in range(50):
            large.create_body(position=(i, 0))
        self.refused(fleet, fleet.reset, 0, large.save(), code=islet.ErrorCode.image_too_large)
        self.refused(fleet, fleet.reset, 0, prototype.save()[:-8], code=islet.ErrorCode.truncated_image)
        self.refused(fleet, fleet.reset, 0, prototype.save(), 1, [{"body": cart, "angle": -1}])
        self.refused(fleet, fleet.reset, 0, prototype.save(), 1, [{"body": cart, "angle": math.nan}], code=islet.ErrorCode.not_finite)

    def test_a_column_without_its_body_or_joint_is_refused(self):
        fleet, world, (cart, _, hinge) = make_fleet(2)
        wrong = [("drives", islet.Drive("force_x"), r"drives\[1\]\.body of kind force_x"), ("drives", {"kind": "motor_speed", "body": cart}, r"drives\[1\]\.joint"),
                 ("senses", islet.Sense("joint", body=cart), r"senses\[1\]\.joint"), ("senses", {"kind": "ray", "joint": hinge}, r"senses\[1\]\.body of kind ray")]
        for name, column, words in wrong:
            with self.subTest(words):
                before = getattr(fleet, name)
                with self.assertRaisesRegex(islet.Error, words) as caught:
                    setattr(fleet, name, [before[0], column])
                self.assertEqual(caught.exception.code, islet.ErrorCode.null_id)
                self.assertEqual(getattr(fleet, name), before)
                with self.assertRaisesRegex(islet.Error, words):
                    islet.Fleet(world, 2, **{name: [before[0], column]})
        fleet[0].destroy_body(cart)  # what is gone from a world is another matter
        fleet.step(pushes(2))

    def test_sizes_are_checked(self):
        world, _, _, _ = cart_and_pole()
        for worlds, workers in ((0, 1), ((1 << 20) + 1, 1), (2, 0), (2, 65)):
            with self.assertRaises(islet.Error):
                islet.Fleet(world, worlds, workers=workers)
        with self.assertRaises(TypeError):
            islet.Fleet(world, 2, drives=[{"kind": "force_x", "bodi": 1}])


if __name__ == "__main__":
    unittest.main()
