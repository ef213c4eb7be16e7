"""The rules of Gymnasium's interface (gymnasium.Env and gymnasium.vector.VectorEnv, version 1), as a checker that needs no Gymnasium.

check_env(make) and check_vector(make) take a function that makes the environment anew, and raise AssertionError where it breaks a rule.
"""
import inspect
import pickle

import numpy

import islet
from islet import envs

STEPS = 60


def same(a, b):
    """The same bits."""
    return a.dtype == b.dtype and a.shape == b.shape and a.tobytes() == b.tobytes()


def raises(kind, call, *values, **named):
    try:
        call(*values, **named)
    except kind as error:
        return error
    raise AssertionError(f"no {kind.__name__}")


def actions_of(space, count, seed):
    space.seed(seed)
    return [space.sample() for _ in range(count)]


def is_observation(space, observation):
    assert type(observation) is numpy.ndarray, "an observation is an array"
    assert observation.dtype == space.dtype and observation.shape == space.shape, (observation.dtype, observation.shape, space)
    assert space.contains(observation), f"{observation} is outside {space.low} to {space.high}"
    assert observation.flags.owndata and observation.flags.writeable, "an observation is the caller's own"


def check_space(space):
    assert all(space.contains(space.sample()) for _ in range(20))
    first, second = actions_of(space, 5, 3), actions_of(space, 5, 3)
    assert all(numpy.array_equal(a, b) for a, b in zip(first, second)), "a seed decides samples"
    assert not all(numpy.array_equal(a, b) for a, b in zip(first, actions_of(space, 5, 4)))
    assert space == pickle.loads(pickle.dumps(space)) and not space.contains("x") and not space.contains(None)


def run(env, actions, seed=None):
    """All that an environment gives, with resets where episodes end."""
    observation, info = env.reset(seed=seed)
    log = [(observation.copy(), 0.0, False, False, dict(info))]
    for action in actions:
        observation, reward, terminated, truncated, info = env.step(action)
        log.append((observation.copy(), reward, terminated, truncated, dict(info)))
        if terminated or truncated:
            observation, info = env.reset()
            log.append((observation.copy(), 0.0, False, False, dict(info)))
    return log


def same_logs(a, b):
    return len(a) == len(b) and all(same(x[0], y[0]) and x[1:] == y[1:] for x, y in zip(a, b))


def check_spaces_and_signatures(env):
    for space in (env.action_space, env.observation_space):
        check_space(space)
    assert isinstance(env.metadata["render_modes"], list) and env.metadata["render_fps"] > 0
    parameters = inspect.signature(env.reset).parameters
    assert set(parameters) == {"seed", "options"} and all(p.kind == p.KEYWORD_ONLY and p.default is None for p in parameters.values())
    assert list(inspect.signature(env.step).parameters) in (["action"], ["actions"])
    assert env.unwrapped is env and env.spec is None


def check_order(make):
    env = make(max_episode_steps=2)
    action = env.action_space.sample()
    raises(envs.ResetNeeded, env.step, action)
    env.reset(seed=1)
    ends = [env.step(action)[2:4] for _ in range(2)]
    assert ends[1][1] is True and not ends[0][1], "time is up after max_episode_steps"
    raises(envs.ResetNeeded, env.step, action)
    env.reset()
    assert env.step(action)[3] is False, "each episode has its time"
    env.close()
    env.close()
    for call in (lambda: env.step(action), env.reset, env.render):
        raises(envs.ClosedEnvironment, call)
    with make() as inside:
        inside.reset()
    raises(envs.ClosedEnvironment, inside.reset)


def check_step(make):
    env = make()
    observation, info = env.reset(seed=5)
    is_observation(env.observation_space, observation)
    assert type(info) is dict
    for action in actions_of(env.action_space, STEPS, 5):
        kept, before = observation, observation.copy()
        given = numpy.array(action)
        observation, reward, terminated, truncated, info = env.step(action)
        is_observation(env.observation_space, observation)
        assert type(reward) is float and numpy.isfinite(reward) and type(terminated) is bool and type(truncated) is bool and type(info) is dict
        assert same(kept, before) and not numpy.shares_memory(kept, observation), "an observation stays as it was"
        assert numpy.array_equal(given, action), "an action is only read"
        if terminated or truncated:
            observation, info = env.reset()


def check_seeds(make):
    actions = actions_of(make().action_space, STEPS, 6)
    log = run(make(), actions, 7)
    assert same_logs(log, run(make(), actions, 7)), "a seed decides all"
    env = make()
    run(env, actions[:5], 9)
    assert same_logs(log, run(env, actions, 7)), "whatever was before"
    assert not same(log[0][0], make().reset(seed=8)[0]), "another seed starts otherwise"
    again = [make(), make()]
    firsts = [env.reset(seed=7)[0] for env in again]
    seconds = [env.reset()[0] for env in again]
    assert same(*firsts) and same(*seconds) and not same(firsts[0], seconds[0]), "without a seed chance goes on"
    assert not same(make().reset()[0], make().reset()[0]), "without any seed chance begins"
    twin, marred = make(), make()
    marred.reset(seed=7)[0][...] = 77
    twin.reset(seed=7)
    for action in actions[:10]:
        result = marred.step(action)
        assert same(result[0], twin.step(action)[0]), "what the caller does to an array is the caller's own affair"
        result[0][...] = 77
        if result[2] or result[3]:
            break


def check_bad_actions(make, wrong):
    env, twin = make(), make()
    good = env.action_space.sample()
    for e in (env, twin):
        e.reset(seed=4)
    for value, code in wrong:
        error = raises(islet.Error, env.step, value)
        assert error.code == code and islet.describe(code) in str(error), (value, error)
    a, b = env.step(good), twin.step(good)
    assert same(a[0], b[0]) and a[1:] == b[1:] and env.world.hash() == twin.world.hash(), "a refused action changes nothing"


def bad_actions(space):
    """(value, code) of what an action may not be."""
    out, nan = islet.ErrorCode.out_of_range, islet.ErrorCode.not_finite
    if isinstance(space, envs.Discrete):
        return [(space.n, out), (-1, out), (0.0, out), (numpy.nan, out), ("0", out), (None, out), ([0, 0], out), (True, out)]
    good = numpy.zeros(space.shape, numpy.float32)
    spoilt = [numpy.array(good) for _ in range(2)]
    spoilt[0][-1], spoilt[1][0] = numpy.nan, numpy.inf
    return [(spoilt[0], nan), (spoilt[1], nan), *((wrong, out) for wrong in (good[:-1], good[None], 0.0, None, "x", good.astype(complex), good > 0))]


def check_render(make):
    env = make()
    env.reset(seed=1)
    assert env.render_mode is None and env.render() is None
    for mode in env.metadata["render_modes"]:
        env = make(render_mode=mode)
        env.reset(seed=1)
        before = env.world.hash()
        picture = env.render()
        assert type(picture) is str and picture.startswith("<svg") and picture.rstrip().endswith("</svg>")
        assert env.world.hash() == before, "a picture changes nothing"
    raises(ValueError, make, render_mode="no such mode")


def check_env(make):
    check_spaces_and_signatures(make())
    check_order(make)
    check_step(make)
    check_seeds(make)
    check_bad_actions(make, bad_actions(make().action_space))
    check_render(make)


# -- vectors ------------------------------------------------------------------------------------------------------------------------------


def step_of(env, actions):
    before = env.num_envs
    observations, rewards, terminated, truncated, infos = env.step(actions)
    is_observation(env.observation_space, observations)
    assert rewards.shape == (before,) and rewards.dtype == numpy.float64 and numpy.isfinite(rewards).all()
    for flags in (terminated, truncated):
        assert flags.shape == (before,) and flags.dtype == bool
    for name, values in infos.items():
        assert len(values) == before and ("_" + name in infos or name.startswith("_"))
    return observations, rewards, terminated, truncated, infos


def check_vector_is_singles(make_vec, make, count=4, seed=20, limit=23):
    """A vector comes to the bits of single environments with the seeds that follow each other, which are reset in the step after their end."""
    many, singles = make_vec(count, max_episode_steps=limit), [make(max_episode_steps=limit) for _ in range(count)]
    observations, infos = many.reset(seed=seed)
    is_observation(many.observation_space, observations)
    ended = [False] * count
    for k, env in enumerate(singles):
        assert same(observations[k], env.reset(seed=seed + k)[0])
    restarts = 0
    for actions in actions_of(many.action_space, STEPS, 1):
        observations, rewards, terminated, truncated, infos = step_of(many, actions)
        for k, env in enumerate(singles):
            if ended[k]:
                wanted, restarts = (env.reset()[0], 0.0, False, False), restarts + 1
            else:
                wanted = env.step(actions[k])[:4]
            assert same(observations[k], wanted[0]), "rows are what single environments see"
            assert (rewards[k], terminated[k], truncated[k]) == wanted[1:]
            ended[k] = wanted[2] or wanted[3]
    assert restarts >= count, "each started again"


def check_vector_resets(make_vec):
    env = make_vec(3)
    assert env.metadata["autoreset_mode"] is envs.AutoresetMode.NEXT_STEP
    raises(envs.ResetNeeded, env.step, env.action_space.sample())
    raises(envs.ResetNeeded, env.reset, options={"reset_mask": numpy.array([True, False, True])})
    listed = env.reset(seed=[5, 9, 6])[0]
    by_one = make_vec(3).reset(seed=5)[0]
    assert same(listed[0], by_one[0]) and same(listed[2], by_one[1]) and not same(listed[1], by_one[2])
    before = env.step(env.action_space.sample())[0]
    after = env.reset(seed=[5, None, None], options={"reset_mask": numpy.array([True, False, False])})[0]
    assert same(after[0], listed[0]) and same(after[1:], before[1:]), "only those of the mask"
    hashes = env.fleet.hashes().tolist()
    for mask in ([True, False, False], numpy.zeros(3, bool), numpy.ones(2, bool), numpy.ones(3)):
        raises(islet.Error, env.reset, options={"reset_mask": mask})
    for seed in ([1, 2], -1, [0, 1, -1], ["a", 1, 2]):
        raises(islet.Error, env.reset, seed=seed)
    assert env.fleet.hashes().tolist() == hashes, "a refused reset changes nothing"
    waits = make_vec(3, max_episode_steps=40, autoreset_mode=envs.AutoresetMode.DISABLED)
    waits.reset(seed=1)
    ends, actions = numpy.zeros(3, int), actions_of(waits.action_space, 41, 1)
    for action in actions[:40]:
        last = step_of(waits, action)
        ends += last[2] | last[3]
    still = step_of(waits, actions[40])
    assert (ends == 1).all() and same(last[0], still[0]) and not (still[1].any() or still[2].any() or still[3].any()), "it waits for reset()"


def check_vector_bad_actions(make_vec):
    env, twin = make_vec(3), make_vec(3)
    for e in (env, twin):
        e.reset(seed=4)
    good = numpy.array(actions_of(env.action_space, 1, 2)[0])
    wrong = [good[:2], good[0], good[None], good.astype(complex), good.astype(str), None]
    if good.dtype.kind == "f":
        spoilt = good.copy()
        spoilt[2, 0] = numpy.nan
        assert raises(islet.Error, env.step, spoilt).code == islet.ErrorCode.not_finite
    else:
        wrong += [good.astype(float), good + 10, good - 10]
    for actions in wrong:
        error = raises(islet.Error, env.step, actions)
        assert error.code == islet.ErrorCode.out_of_range and islet.describe(error.code) in str(error)
    assert env.fleet.hashes().tolist() == twin.fleet.hashes().tolist()
    a, b = env.step(good), twin.step(good)
    assert same(a[0], b[0]) and same(a[1], b[1])


def check_vector_bits(make_vec):
    """Neither workers nor a way through pickle change what comes."""
    logs = []
    for workers in (1, 3):
        env = make_vec(9, workers=workers, max_episode_steps=15)
        env.reset(seed=3)
        log = []
        for i, actions in enumerate(actions_of(env.action_space, 40, 3)):
            if i == 20 and workers == 3:
                env = pickle.loads(pickle.dumps(env))
            log += step_of(env, actions)[:4]
        logs.append(log + [env.fleet.hashes()])
    assert all(same(a, b) for a, b in zip(*logs))


def check_vector(make_vec, make):
    env = make_vec(3)
    for space, single in ((env.action_space, env.single_action_space), (env.observation_space, env.single_observation_space)):
        check_space(space)
        assert space == single.batch(3) and space.shape == (3, *single.shape)
    assert env.num_envs == 3
    check_spaces_and_signatures(env)
    check_vector_is_singles(make_vec, make)
    check_vector_resets(make_vec)
    check_vector_bad_actions(make_vec)
    check_vector_bits(make_vec)
    env = make_vec(2, render_mode="svg")
    env.reset(seed=1)
    assert len(env.render()) == 2
    env.close()
    raises(envs.ClosedEnvironment, env.reset)
