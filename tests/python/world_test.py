"""World, as Python has it."""
import copy
import math
import pickle
import threading
import unittest

import numpy

import islet
from support import cart_and_pole, falling_boxes, golden_hashes


class TheSameBits(unittest.TestCase):
    def test_scenes_come_to_the_golden_hashes(self):
        golden = golden_hashes()
        for name in ("hello", "pyramid", "newtons_cradle", "chain_ball", "ragdoll", "gears"):
            with self.subTest(name):
                steps, wanted = golden[name][0]
                scene = islet.Scene(name)
                scene.step(steps)
                self.assertEqual(scene.world.hash(), wanted)

    def test_the_catalogue_is_the_golden_table(self):
        self.assertEqual(set(islet.scenes()), set(golden_hashes()))

    def test_workers_change_nothing(self):
        hashes = []
        for workers in (1, 3):
            world, _ = falling_boxes(12, workers=workers)
            world.step(count=60)
            self.assertEqual(world.workers, workers)
            hashes.append(world.hash())
        self.assertEqual(hashes[0], hashes[1])

    def test_a_body_in_free_fall_follows_the_formula(self):
        world = islet.World(gravity=(0, -8), bodies=1)
        ball = world.create_body(type="dynamic", position=(1, 100), linear_velocity=(2, 0))
        world.create_shape(ball, islet.Circle(radius=0.5))
        world.step(1 / 64, 64)
        x, y = world.position(ball)
        substep = 1 / 64 / 4
        self.assertAlmostEqual(x, 3, delta=1e-4)
        self.assertAlmostEqual(y, 100 - 4 - 4 * substep, delta=1e-3)  # speeds first, then places: h g t / 2 lower than the parabola

    def test_rotations_are_the_engines(self):
        world = islet.World(bodies=1)
        body = world.create_body(angle=0.7)
        self.assertEqual(islet.make_rot(0.7), world.transform(body).q)
        self.assertEqual(islet.angle_of(islet.make_rot(0.7)), world.angle(body))


class Objects(unittest.TestCase):
    def test_definitions_take_fields_by_name_or_whole(self):
        world = islet.World(bodies=4)
        by_name = world.create_body(type="kinematic", angle=0.5, user_data=7)
        whole = world.create_body(islet.BodyDef(type=islet.BodyType.kinematic, angle=0.5, user_data=7))
        changed = world.create_body(islet.BodyDef(type="kinematic", angle=0.5), user_data=8)
        self.assertEqual([world.user_data(b) for b in (by_name, whole, changed)], [7, 7, 8])
        self.assertEqual(world.type(by_name), islet.BodyType.kinematic)
        self.assertAlmostEqual(world.angle(changed), 0.5, places=6)

    def test_defaults_are_those_of_the_engine(self):
        self.assertEqual(islet.ShapeDef().friction, numpy.float32(0.6))
        self.assertEqual(islet.SolverDef().substeps, 4)
        self.assertEqual(islet.WorldDef().gravity, (0, -10))
        self.assertTrue(islet.WheelJointDef().spring.enable)
        self.assertEqual(islet.Filter().mask, 0xFFFFFFFF)

    def test_there_is_room_for_a_joint_a_body_unless_something_else_is_said(self):
        self.assertEqual(islet.World().capacity().joints, 256)
        self.assertEqual(islet.World(bodies=7, shapes=20).capacity().joints, 7)
        self.assertEqual(islet.World(bodies=7, joints=0).capacity().joints, 0)
        self.assertEqual(islet.World(bodies=7, joints=2).capacity().joints, 2)
        given = islet.World(bodies=7, joints=0).capacity()
        self.assertEqual(islet.World(capacity=given).capacity(), given)
        world = islet.World(bodies=2)
        a, b = world.create_body(), world.create_body(type="dynamic", position=(1, 0))
        world.create_revolute_joint(body_a=a, body_b=b)
        self.assertEqual(world.joint_count(), 1)

    def test_unknown_fields_and_names_are_refused(self):
        world = islet.World(bodies=2)
        with self.assertRaisesRegex(TypeError, "BodyDef has no field colour"):
            world.create_body(colour=1)
        with self.assertRaisesRegex(ValueError, "BodyType has no 'dinamic'; there are static_body, kinematic, dynamic"):
            world.create_body(type="dinamic")
        with self.assertRaisesRegex(TypeError, "BodyDef.position cannot be 5"):
            world.create_body(position=5)
        with self.assertRaises(TypeError):
            world.create_body(type=islet.JointType.weld)
        self.assertEqual(world.body_count(), 0)

    def test_ids_are_keys(self):
        world, boxes = falling_boxes(3)
        names = {box: i for i, box in enumerate(boxes)}
        self.assertEqual([names[b] for b in world.bodies()[1:]], [0, 1, 2])
        self.assertEqual(len({*boxes, *boxes}), 3)
        self.assertFalse(islet.BodyId())
        self.assertLess(boxes[0], boxes[1])
        self.assertEqual(pickle.loads(pickle.dumps(boxes[1])), boxes[1])
        self.assertNotEqual(boxes[0], islet.ShapeId(boxes[0].index1, boxes[0].generation))
        with self.assertRaises(AttributeError):
            boxes[0].index1 = 5

    def test_records_compare_print_and_pickle(self):
        spring = islet.JointSpring(True, hertz=4)
        self.assertEqual(spring, islet.JointSpring(enable=True, hertz=4))
        self.assertNotEqual(spring, islet.JointSpring(enable=True, hertz=5))
        self.assertEqual(repr(spring), "JointSpring(enable=True, hertz=4.0, damping_ratio=0.0, target=0.0)")
        self.assertEqual(pickle.loads(pickle.dumps(spring)), spring)
        definition = islet.RevoluteJointDef(motor={"enable": True, "speed": 3}, limit=(True, -1, 1))
        self.assertEqual((definition.motor.speed, definition.limit.upper), (3, 1))

    def test_every_type_of_joint_can_be_made(self):
        world, (a, b, c) = falling_boxes(3, joints=12)
        hinge = world.create_revolute_joint(body_a=a, body_b=b, motor=(True, 2, 10))
        made = [hinge, world.create_prismatic_joint(body_a=a, body_b=b), world.create_distance_joint(body_a=a, body_b=b, length=2),
                world.create_weld_joint(body_a=a, body_b=b), world.create_wheel_joint(body_a=a, body_b=b), world.create_motor_joint(body_a=a, body_b=b),
                world.create_mouse_joint(body=b, target=(0, 3), max_force=10),
                world.create_pulley_joint(body_a=a, body_b=b, ground_a=(-1, 9), ground_b=(1, 9)), world.create_joint(islet.AngleJointDef(body_a=a, body_b=b))]
        other = world.create_revolute_joint(body_a=a, body_b=c)
        made.append(world.create_gear_joint(joint1=hinge, joint2=other, ratio=-2))
        self.assertEqual({world.joint_type(j) for j in made}, set(islet.JointType))
        self.assertEqual(world.motor(hinge), islet.JointMotor(True, 2, 10))
        self.assertIn(hinge, world.joints(a))

    def test_shapes_come_back_as_they_were_made(self):
        world = islet.World(bodies=1, shapes=8)
        body = world.create_body()
        circle = world.create_shape(body, islet.Circle((1, 2), 0.5), friction=0.25)
        box = world.create_shape(body, islet.make_box(1, 2))
        chain = world.create_chain(body, [(-5, 0), (0, 0.5), (5, 0)])
        triangle = world.create_shape(body, islet.make_polygon([(0, 0), (1, 0), (0, 1)]))
        self.assertEqual(world.circle(circle).center, (1, 2))
        self.assertEqual(world.friction(circle), 0.25)
        self.assertIsNone(world.polygon(circle))
        self.assertEqual(world.polygon(box).count, 4)
        self.assertEqual(world.polygon(triangle).count, 3)
        self.assertEqual(len(chain), 2)
        self.assertEqual(set(world.shapes(body)), {circle, box, triangle, *chain})


class Errors(unittest.TestCase):
    def refused(self, code, call, *values, **named):
        with self.assertRaises(islet.Error) as caught:
            call(*values, **named)
        self.assertEqual(caught.exception.code, code)
        self.assertTrue(str(caught.exception))
        return str(caught.exception)

    def test_bad_input_raises_and_changes_nothing(self):
        world, boxes = falling_boxes(2)
        before = world.hash()
        codes = islet.ErrorCode
        self.refused(codes.bad_time_step, world.step, 0)
        self.refused(codes.bad_time_step, world.step, math.nan)
        self.refused(codes.null_id, world.position, islet.BodyId())
        self.refused(codes.not_finite, world.set_linear_velocity, boxes[0], (math.nan, 0))
        self.refused(codes.stale_id, world.destroy_body, islet.BodyId(boxes[0].index1, boxes[0].generation + 1))
        self.refused(codes.bodies_full, world.create_body)
        self.assertIn("density", self.refused(codes.out_of_range, world.create_shape, boxes[0], islet.Circle(), density=-1))
        self.refused(codes.bad_geometry, world.create_shape, boxes[0], islet.Circle(radius=-1))
        self.refused(codes.bad_geometry, islet.make_polygon, [(0, 0), (1, 1)])
        self.refused(codes.same_body, world.create_weld_joint, body_a=boxes[0], body_b=boxes[0])
        self.refused(codes.out_of_range, world.set_solver, substeps=0)
        self.refused(codes.not_an_image, world.restore, b"no snapshot, whatever it says" * 20)
        self.refused(codes.out_of_range, islet.World, bodies=4, max_speed=-1)
        self.refused(codes.out_of_range, islet.World, bodies=4, workers=0)
        self.refused(codes.bad_capacity, islet.World, bodies=1 << 30)
        self.assertEqual(world.hash(), before)
        self.assertIsNone(world.validate())

    def test_ids_of_another_world_are_refused(self):
        world, boxes = falling_boxes(2)
        other = islet.World(bodies=8)
        self.refused(islet.ErrorCode.stale_id, other.position, boxes[1])
        with self.assertRaises(TypeError):
            world.position(world.shapes(boxes[0])[0])

    def test_every_code_has_the_sentence_of_its_error(self):
        world, boxes = falling_boxes()
        with self.assertRaises(islet.Error) as caught:
            world.set_linear_velocity(boxes[0], (math.nan, 0))
        self.assertIn(islet.describe(caught.exception.code), str(caught.exception))
        codes = [code for code in islet.ErrorCode if code]
        self.assertEqual(len({islet.describe(code) for code in codes}), len(codes))

    def test_errors_pickle(self):
        try:
            islet.World(bodies=2).step(7)
        except islet.Error as error:
            again = pickle.loads(pickle.dumps(error))
            self.assertEqual((str(again), again.code), (str(error), islet.ErrorCode.bad_time_step))

    def test_a_contact_without_room_is_a_warning(self):
        world, _ = falling_boxes(6, contacts=1)
        with self.assertWarnsRegex(RuntimeWarning, "contacts"):
            world.step(count=120)
        self.assertEqual(world.step_count(), 120)

    def test_another_thread_cannot_use_a_world_in_a_step(self):
        world = islet.Scene("large_pyramid")
        seen = []
        thread = threading.Thread(target=lambda: world.step(20))
        thread.start()
        while thread.is_alive():
            try:
                world.world.hash()
            except islet.Error as error:
                seen.append(error.code)
                break
        thread.join()
        self.assertEqual(seen, [islet.ErrorCode.in_step])


class State(unittest.TestCase):
    def test_snapshots_pickles_and_copies_go_on_alike(self):
        world, _, _, _ = cart_and_pole()
        world.step(count=30)
        image = world.save()
        others = [pickle.loads(pickle.dumps(world)), copy.copy(world), copy.deepcopy(world), world.copy()]
        world.step(count=30)
        then = world.hash()
        for other in others:
            other.step(count=30)
            self.assertEqual(other.hash(), then)
        world.restore(image)
        world.step(count=30)
        self.assertEqual(world.hash(), then)
        world.restore(memoryview(b"x" + image)[1:])  # not aligned
        self.assertNotEqual(world.hash(), then)

    def test_damaged_snapshots_are_refused(self):
        world, _ = falling_boxes(2)
        world.step(count=5)
        image, before = world.save(), world.hash()
        for at in range(0, len(image), 97):
            damaged = bytearray(image)
            damaged[at] ^= 0x55
            try:
                world.restore(damaged)
            except islet.Error:
                pass
            self.assertEqual(world.hash(), before, f"byte {at}")
        with self.assertRaises(islet.Error):
            world.restore(image[:-8])

    def test_a_snapshot_of_a_larger_world_is_refused(self):
        large, _ = falling_boxes(20)
        small, _ = falling_boxes(2)
        before = small.hash()
        with self.assertRaises(islet.Error) as caught:
            small.restore(large.save())
        self.assertEqual(caught.exception.code, islet.ErrorCode.image_too_large)
        self.assertEqual(small.hash(), before)

    def test_arrays_hold_what_calls_tell(self):
        world, boxes = falling_boxes(4)
        world.destroy_body(boxes[1])
        world.step(count=20)
        poses, velocities = world.poses(), world.velocities()
        self.assertEqual((poses.shape, poses.dtype, velocities.shape), ((5, 4), numpy.float32, (5, 3)))
        for box in (boxes[0], boxes[2], boxes[3]):
            place, turn = world.transform(box)
            self.assertEqual(tuple(poses[box.slot]), (*place, *turn))
            self.assertEqual(tuple(velocities[box.slot]), (*world.linear_velocity(box), world.angular_velocity(box)))
        self.assertFalse(poses[boxes[1].slot].any())
        out = numpy.empty((5, 4), numpy.float32)
        self.assertIs(world.poses(out), out)
        self.assertTrue((out == poses).all())
        for wrong in (numpy.empty((5, 3), numpy.float32), numpy.empty((5, 4)), numpy.empty((4, 5), numpy.float32).T, [0]):
            with self.assertRaisesRegex((TypeError, ValueError), "^out must be a [^:]*$"):
                world.poses(wrong)

    def test_recordings_can_be_made(self):
        world, _ = falling_boxes(2)
        world.start_recording()
        world.step(count=10)
        recording = world.stop_recording()
        self.assertGreater(len(recording), len(world.save()))
        with self.assertRaises(islet.Error):
            world.stop_recording()


class Asking(unittest.TestCase):
    def test_queries_find_shapes(self):
        world, boxes = falling_boxes(1)
        shape = world.shapes(boxes[0])[0]
        hit = world.cast_ray((0, 10), (0, -20))
        self.assertEqual(hit.shape, shape)
        self.assertAlmostEqual(hit.point.y, 1.5, places=5)
        self.assertEqual(hit.normal, (0, 1))
        self.assertIsNone(world.cast_ray((0, 10), (0, 20)))
        self.assertEqual(len(world.cast_ray_all((0, 10), (0, -20))), 2)
        self.assertEqual(world.overlap_point((0, 1)), [shape])
        self.assertEqual(world.overlap_box(((-1, 0.6), (1, 2))), [shape])
        self.assertEqual(world.overlap_shape(islet.Circle((0, 2), 0.6)), [shape])
        self.assertEqual(world.cast_shape(islet.Circle((0, 5), 0.5), (0, -10)).shape, shape)
        self.assertIsNone(world.cast_ray((0, 10), (0, -20), islet.QueryFilter(mask=0)))
        self.assertAlmostEqual(islet.separation(islet.Circle((0, 0), 1), islet.Circle((3, 0), 1)).distance, 1, places=5)

    def test_events_tell_of_touches(self):
        world, boxes = falling_boxes(1)
        touches = []
        for _ in range(60):
            world.step()
            touches += world.begin_touch_events()
        self.assertEqual(len(touches), 1)
        self.assertIn(boxes[0], {world.body(touches[0].shape_a), world.body(touches[0].shape_b)})
        self.assertEqual(len(world.contacts(boxes[0])), 1)
        self.assertEqual(world.report().contacts, 1)

    def test_pictures_are_svg(self):
        world, _ = falling_boxes(3)
        picture = world._repr_svg_()
        self.assertTrue(picture.startswith("<svg ") and picture.rstrip().endswith("</svg>"))
        self.assertIn("4 bodies", picture)
        self.assertIn("<title>a &amp; b</title>", world.svg(title="a & b"))
        hinged, _, _, _ = cart_and_pole()
        mark = "#2f7d6b"  # the colour of joints
        self.assertIn(mark, hinged.svg())
        self.assertNotIn(mark, hinged.svg(joints=False))
        self.assertIn("<title>hello</title>", islet.Scene("hello").svg())


if __name__ == "__main__":
    unittest.main()
