"""The environments: Gymnasium's rules, closed formulas of their physics, and that each can be solved."""
import functools
import math
import os
import subprocess
import sys
import unittest

import numpy

import islet
from env_players import PLAYERS, fetch
from env_rules import check_env, check_vector
from islet import envs
from support import ROOT

sys.path.insert(0, os.path.join(ROOT, "bindings", "python", "examples"))
import train  # noqa: E402


class Rules(unittest.TestCase):
    def test_every_environment_keeps_gymnasiums_rules(self):
        for name in envs.names():
            with self.subTest(name):
                check_env(functools.partial(envs.make, name))

    def test_every_vector_keeps_gymnasiums_rules(self):
        for name in envs.names():
            with self.subTest(name):
                check_vector(functools.partial(envs.make_vec, name), functools.partial(envs.make, name))

    def test_no_world_runs_out_of_room(self):
        for name in envs.names():
            env = envs.make_vec(name, 4)
            env.reset(seed=1)
            env.action_space.seed(1)
            for _ in range(100):
                env.step(env.action_space.sample())
                self.assertTrue(all(env.fleet[k].report().dropped_contacts == 0 for k in range(4)), name)
            self.assertTrue(all(env.fleet[k].validate() is None for k in range(4)), name)

    def test_what_there_is_not_is_refused(self):
        with self.assertRaisesRegex(ValueError, "cart_pole"):
            envs.make("kart_pole")
        with self.assertRaises(islet.Error):
            envs.make("cart_pole", max_episode_steps=0)
        for worlds in (0, -1, 2.5, "2", True, None):
            with self.subTest(worlds), self.assertRaisesRegex(islet.Error, "num_envs must be a whole number"):
                envs.make_vec("cart_pole", worlds)
        for steps in (0, 1.5, math.nan, "7", True):
            with self.subTest(steps), self.assertRaisesRegex(islet.Error, "max_episode_steps must be a whole number"):
                envs.make("cart_pole", max_episode_steps=steps)

    def test_a_refused_reset_changes_nothing(self):
        env = envs.make_vec("cart_pole", 2)
        env.reset(seed=1)
        before, random = env.fleet.hashes().tolist(), env.np_random[0].bit_generator.state
        for seed in (1.5, "1", -1, True, [1], [1, 2, 3], [1, -2], [1, 2.5], [True, 2], {1, 2}):
            with self.subTest(seed), self.assertRaisesRegex(islet.Error, "seed must be"):
                env.reset(seed=seed)
        with self.assertRaisesRegex(TypeError, "options must be a dict"):
            env.reset(seed=2, options=5)
        self.assertEqual((env.fleet.hashes().tolist(), env.np_random[0].bit_generator.state), (before, random))


class Physics(unittest.TestCase):
    """What the worlds do, against formulas. Bounds are those of the method, which sets speeds first and places after them, in steps of dt / 4."""

    def test_a_free_pole_falls_as_the_linear_equations_say(self):
        env = envs.make("cart_pole")
        env.reset(seed=1)
        env.vector.fleet.reset(0, env.vector._start)
        world, cart, pole = env.world, env.vector.cart, env.vector.pole
        lean, half, mass, heavy, g = 0.001, 0.5, 0.1, 1.0, 9.8
        world.set_transform(pole, (-half * -lean, half), -lean)
        # (M + m) x'' + m l a'' = 0 and 4/3 l a'' + x'' = g a, so a'' = k^2 a.
        k = math.sqrt(g / (half * (4 / 3 - mass / (heavy + mass))))
        # The engine sets speeds first and places after them, in steps of h: a' = a + h (w + h k^2 a).
        h, wanted, spin = 1 / 200, lean, 0.0
        for step in range(1, 41):
            world.step(1 / 50)
            for _ in range(4):
                spin += h * k * k * wanted
                wanted += h * spin
            self.assertAlmostEqual(-world.joint_position(env.vector.hinge), wanted, delta=0.01 * wanted, msg=f"step {step}")
        self.assertAlmostEqual(wanted, lean * math.cosh(k * 0.8), delta=0.05 * wanted)
        middle = (heavy * world.position(cart).x + mass * world.position(pole).x) / (heavy + mass)
        self.assertAlmostEqual(middle, mass * half * lean / (heavy + mass), delta=1e-5)  # no force from aside: the common centre stays

    def test_a_push_moves_the_cart_as_newton_says(self):
        env = envs.make("cart_pole")
        before, _ = env.reset(seed=3)
        after = env.step(1)[0]
        heavy, mass, half, g, f = 1.0, 0.1, 0.5, 9.8, 10.0
        _, v, a, w = before.tolist()
        inner = (f + mass * half * w * w * math.sin(a)) / (heavy + mass)
        turn = (g * math.sin(a) - math.cos(a) * inner) / (half * (4 / 3 - mass * math.cos(a) ** 2 / (heavy + mass)))
        push = inner - mass * half * turn * math.cos(a) / (heavy + mass)
        # The equations of Florian (2007). Within a step of 1/50 s the angle turns by less than 0.01 rad, which changes g sin(a) by 1 % of g.
        self.assertAlmostEqual(after[1] - v, push / 50, delta=0.01 * g / 50)
        self.assertAlmostEqual(after[3] - w, turn / 50, delta=0.03 * g / 50)

    def test_an_acrobot_without_torque_keeps_its_energy(self):
        env = envs.make("acrobot")
        env.reset(seed=1)
        task, world = env.vector, env.world
        for angles in ((1.5, 0.5), (2.5, -1.0), (0.3, 0.2)):
            task.pose(world, angles, (0.0, 0.0))
            start = self.energy(world, task)
            top = 9.8 * 4  # J, from hanging to standing: the links' middles rise by 1 and 3 m
            for _ in range(200):
                world.step(task.dt, 5)
                self.assertAlmostEqual(self.energy(world, task), start, delta=0.02 * top)

    def energy(self, world, task):
        total = 0.0
        for link in task.links:
            (vx, vy), w = world.linear_velocity(link), world.angular_velocity(link)
            total += 0.5 * (vx * vx + vy * vy) + 0.5 * w * w + 9.8 * world.position(link).y
        return total

    def test_small_swings_of_the_acrobot_have_its_two_frequencies(self):
        env = envs.make("acrobot")
        env.reset(seed=1)
        # M a'' = -K a of the links' angles in the world, with l = 1, lc = 1/2, m = I = 1.
        m = numpy.array([[1 + 0.25 + 1, 0.5], [0.5, 1.25]])
        k = 9.8 * numpy.array([[1.5, 0], [0, 0.5]])
        squares, modes = numpy.linalg.eig(numpy.linalg.solve(m, k))
        for square, mode in zip(squares, modes.T):
            swing = 0.02 * mode / abs(mode).max()
            env.vector.pose(env.world, (swing[0], swing[1] - swing[0]), (0.0, 0.0))
            steps = round(2 * math.pi / math.sqrt(square) / env.vector.dt)
            env.world.step(env.vector.dt, steps)  # one whole swing, to half a step
            back = [env.world.angle(link) for link in env.vector.links]
            self.assertTrue(numpy.allclose(back, swing, atol=0.02 * 0.02), (back, swing))

    def test_a_lander_without_engines_falls_freely(self):
        env = envs.make("lunar_lander")
        env.reset(seed=5)
        world, hull = env.world, env.vector.hull
        (x0, y0), (vx, vy) = world.position(hull), world.linear_velocity(hull)
        for step in range(1, 26):
            env.step(0)
            t, h = step / 50, 1 / 200
            x, y = world.position(hull)
            self.assertAlmostEqual(x, x0 + vx * t, delta=1e-3)
            self.assertAlmostEqual(y, y0 + vy * t - 5 * t * (t + h), delta=1e-3)

    def test_the_main_engine_lifts_the_lander_as_its_mass_says(self):
        env = envs.make("lunar_lander")
        env.reset(seed=5)
        world = env.world
        mass = sum(world.mass(body) for body in world.bodies())
        momentum = lambda: sum(world.mass(body) * world.linear_velocity(body).y for body in world.bodies())
        before = momentum()
        for _ in range(10):
            env.step(2)
        lift = 87.0 * math.cos(world.angle(env.vector.hull))
        self.assertAlmostEqual((momentum() - before) / 0.2, lift - 10 * mass, delta=0.01 * lift)

    def test_rewards_of_the_walker_add_up_to_its_way(self):
        env = envs.make("bipedal_walker")
        first, start = env.reset(seed=2)
        total, o, info = 0.0, first, start
        for _ in range(10):
            o, reward, terminated, _, info = env.step(numpy.zeros(4, numpy.float32))
            self.assertFalse(terminated)
            total += reward
        way = 130 / 30 * (info["distance"] - start["distance"]) - 5 * (abs(float(o[0])) - abs(float(first[0])))
        self.assertAlmostEqual(total, way, delta=1e-4)

    def test_a_walker_without_torque_falls_and_pays_for_it(self):
        env = envs.make("bipedal_walker")
        env.reset(seed=2)
        reward = terminated = truncated = False
        while not (terminated or truncated):
            _, reward, terminated, truncated, _ = env.step(numpy.zeros(4, numpy.float32))
        self.assertEqual((reward, terminated, truncated), (-100.0, True, False))

    def test_a_pushed_puck_slides_as_far_as_friction_lets_it(self):
        env = envs.make("pusher")
        env.reset(seed=1)
        world, puck, speed, slow = env.world, env.vector.puck, 1.0, 0.4 * 9.8
        x0, y0 = world.position(puck)
        world.set_linear_velocity(puck, (0, speed))
        world.step(1 / 50, 60)
        x, y = world.position(puck)
        self.assertAlmostEqual(x, x0, delta=1e-4)
        self.assertAlmostEqual(y - y0, speed * speed / (2 * slow), delta=speed / 200)  # what it goes in a step of the solver
        self.assertEqual(world.linear_velocity(puck), (0, 0))

    def test_a_car_gathers_speed_as_its_engine_and_drag_say(self):
        env = envs.make("car_racing")
        env.reset(seed=4)
        mass, drag, force = 500 + 4 * 20, 4 * 8.0, 2 * 1200.0
        for step in range(1, 21):
            o = env.step(numpy.array([0, 1], numpy.float32))[0]
            wanted = force / drag * (1 - math.exp(-drag * step / 20 / mass))
            self.assertAlmostEqual(10 * o[11], wanted, delta=0.01 * wanted)

    def test_no_wheel_pushes_more_than_its_grip(self):
        env = envs.make_vec("car_racing", 8)
        env.reset(seed=4)
        most = 0.0
        for actions in (numpy.array([[s, t]] * 8, numpy.float32) for s, t in 40 * [(0, 1)] + 20 * [(1, 1)] + 20 * [(-1, -1)]):
            env.step(actions)
            for x in (0, 3, 6, 8):
                most = max(most, float(numpy.hypot(env.control[:, x], env.control[:, x + 1]).max()))
        self.assertLessEqual(most, 1700 * (1 + 1e-6))
        self.assertGreater(most, 1699)

    def test_a_box_that_is_held_does_not_slip(self):
        env = envs.make("grasping")
        o, _ = env.reset(seed=1)
        for _ in range(100):  # fetched, and held half a metre up
            actions, held = fetch(o[None], o[None, 0], numpy.float32(0.65))
            o = env.step(actions[0].astype(numpy.float32))[0]
        self.assertTrue(held[0] and o[12] > 0.4)
        place = o[10:12].copy()
        for i in range(60):
            o = env.step(numpy.array([-numpy.sign(o[0]), (-1) ** (i // 10), 1], numpy.float32))[0]
            self.assertTrue(numpy.allclose(o[10:12], place, atol=0.005), (o[10:12], place))  # 5 mm, the engine's linear slop
        self.assertGreater(abs(float(o[2])) + abs(float(o[3])), 0.5)  # it did move


class Solved(unittest.TestCase):
    """That a task can be solved, and that its observations are enough, is shown by a player that follows a rule."""

    def play(self, name, count=20):
        env = envs.make_vec(name, count, workers=2, autoreset_mode="Disabled")
        observations, _ = env.reset(seed=100)
        returns, over = numpy.zeros(count), numpy.zeros(count, bool)
        while not over.all():
            actions = PLAYERS[name](observations).astype(env.action_space.dtype)
            observations, rewards, terminated, truncated, infos = env.step(actions)
            returns += rewards
            over |= terminated | truncated
        return returns, infos, env

    def test_the_pole_stays_up(self):
        self.assertTrue((self.play("cart_pole")[0] == 500).all())

    def test_the_acrobot_swings_up(self):
        self.assertTrue((self.play("acrobot")[0] > -300).all())

    def test_the_lander_lands(self):
        self.assertGreaterEqual(self.play("lunar_lander")[1]["landed"].sum(), 15)

    def test_the_car_drives_its_lap(self):
        self.assertTrue((self.play("car_racing")[1]["lap"] >= 1).all())

    def test_the_puck_gets_to_its_goal(self):
        self.assertGreaterEqual(self.play("pusher")[1]["there"].sum(), 15)

    def test_the_box_is_fetched(self):
        self.assertTrue(self.play("grasping")[1]["lifted"].all())

    def test_the_boxes_are_stacked(self):
        _, infos, env = self.play("stacking")
        self.assertTrue(infos["stacked"].all())
        for k in range(env.num_envs):
            upper, lower = (env.fleet[k].position(cube) for cube in env.cubes)
            self.assertAlmostEqual(upper.y - lower.y, 0.3, delta=0.02)


class Learning(unittest.TestCase):
    def test_the_same_seed_learns_the_same_bits(self):
        curves = []
        for workers, seed in ((1, 1), (2, 1), (1, 2)):
            policy, curve = train.learn("cart_pole", seed=seed, workers=workers, generations=3)
            curves.append((curve, policy.weights.tobytes()))
        self.assertEqual(curves[0], curves[1])
        self.assertNotEqual(curves[0], curves[2])

    def test_numpys_instruction_sets_change_nothing(self):
        program = "import train; policy, curve = train.learn('bipedal_walker', generations=1, pairs=4, steps=60); print(curve, policy.weights.tobytes().hex())"
        paths = os.pathsep.join([os.path.dirname(os.path.dirname(islet.__file__)), os.path.dirname(train.__file__)])
        said = [subprocess.run([sys.executable, "-W", "ignore", "-c", program], env={**os.environ, "PYTHONPATH": paths, "NPY_DISABLE_CPU_FEATURES": without},
                               stdout=subprocess.PIPE, check=True).stdout for without in ("", "AVX512F AVX2 FMA3")]
        self.assertGreater(len(said[0]), 1000)
        self.assertEqual(*said)

    def test_the_curves_of_the_manual_are_learned_again(self):
        for name, generations in (("cart_pole", 3), ("bipedal_walker", 2)):
            with open(os.path.join(ROOT, "docs", "learning", name + ".csv"), encoding="utf-8") as file:
                rows = [line.strip().split(",") for line in file][1:generations + 2]
            _, curve = train.learn(name, workers=2, generations=generations)
            self.assertEqual([(int(g), int(s), float(r)) for g, s, r in rows], curve)

    def test_the_walker_of_the_manual_walks(self):
        env = envs.make_vec("bipedal_walker", 10, autoreset_mode="Disabled")
        policy = train.Policy(env)
        policy.load(os.path.join(ROOT, "docs", "learning", "bipedal_walker.json"))
        observations, infos = env.reset(seed=1 << 33)
        feet, steps, fallen = numpy.zeros((10, 2)), 500, numpy.zeros(10, dtype=bool)
        for _ in range(steps):
            observations, _, terminated, _, infos = env.step(policy.actions(observations, policy.weights))
            fallen |= terminated
            feet += observations[:, [8, 13]]
        self.assertEqual(fallen.sum(), 0)
        self.assertGreater(infos["distance"][~fallen].min(), 10)  # m in 10 s: a person's walking speed
        self.assertGreater(feet[~fallen].min(), 0.1 * steps)  # on both legs

    def test_cart_pole_is_solved(self):
        policy, curve = train.learn("cart_pole", workers=2)
        self.assertLess(curve[0][2], 100)
        self.assertGreaterEqual(train.evaluate("cart_pole", policy)[0], 475)


if __name__ == "__main__":
    unittest.main()
