"""Episodes of all environments, recorded: a replay comes to the same bits after each step, for any number of workers. With EPISODES, a folder, the recordings are
written there, so that tests/determinism/targets.sh replays them on other processors."""
import os
import pathlib
import unittest

import islet

TASKS = "cart_pole acrobot lunar_lander bipedal_walker car_racing pusher grasping stacking".split()
STEPS = 150


def episode(name, seed):
    """A recording of so many steps with random actions, and the world's hash after them. What ends starts anew."""
    with islet.envs.make(name) as env:
        env.action_space.seed(seed)
        env.reset(seed=seed)
        env.world.start_recording()
        for _ in range(STEPS):
            _, _, terminated, truncated, _ = env.step(env.action_space.sample())
            if terminated or truncated:
                env.reset()
        return env.world.stop_recording(), env.world.hash()


class Episodes(unittest.TestCase):
    def test_a_replay_comes_to_the_same_bits(self):
        folder = os.environ.get("EPISODES")
        for name in TASKS:
            with self.subTest(name):
                recording, hash_after = episode(name, 7)
                for workers in (1, 2):
                    world, result = islet.replay(recording, workers=workers)
                    self.assertEqual(result.end, islet.ReplayEnd.complete)
                    self.assertGreaterEqual(result.steps, STEPS)
                    self.assertEqual(world.hash(), hash_after)
                if folder:
                    pathlib.Path(folder).mkdir(parents=True, exist_ok=True)
                    pathlib.Path(folder, name + ".recording").write_bytes(recording)

    def test_the_same_seed_gives_the_same_recording(self):
        self.assertEqual(episode("lunar_lander", 3), episode("lunar_lander", 3))
        self.assertNotEqual(episode("lunar_lander", 3), episode("lunar_lander", 4))

    def test_a_world_of_many_is_recorded_beside_the_others(self):
        envs = islet.envs.make_vec("cart_pole", 20, workers=2)
        envs.action_space.seed(1)
        envs.reset(seed=1)
        for k in (3, 17):
            envs.fleet[k].start_recording()
        for _ in range(STEPS):  # poles fall, and the next step starts anew
            envs.step(envs.action_space.sample())
        for k in (3, 17):
            world, result = islet.replay(envs.fleet[k].stop_recording())
            self.assertEqual(result.end, islet.ReplayEnd.complete)
            self.assertEqual(world.hash(), envs.fleet[k].hash())
        envs.close()

    def test_a_world_that_becomes_a_copy_is_no_longer_recorded(self):
        world = islet.World()
        fleet = islet.Fleet(world, 3)
        with self.assertRaises(islet.Error):
            fleet[1].stop_recording()
        fleet[1].start_recording()
        fleet.step()
        fleet.fork([0, 0, 2])
        fleet.step()
        with self.assertRaisesRegex(islet.Error, "copy"):
            fleet[1].stop_recording()
        fleet[1].start_recording()
        fleet.step()
        self.assertEqual(islet.replay(fleet[1].stop_recording())[1].steps, 1)


if __name__ == "__main__":
    unittest.main()
