"""Work on many machines by Dask (python3-distributed), where results are hashes that must agree.

    from distributed import Client
    from islet.cluster import spread

    def work(world, seed):               # a world travels as a snapshot
        world.step(count=seed)
        return world.hash()

    hashes = spread(Client("tcp://scheduler:8786"), work, [(world, seed) for seed in range(1000)], twice=0.1)

Islet gives the same bits on every machine, so a task that was done twice on two workers must have given equal results. spread() does a share of the tasks
twice, and raises Disagreement if two results differ: a worker with broken memory, or with another build of a program, is found in the run itself.
"""
import uuid


class Disagreement(RuntimeError):
    """Two workers gave different results for one task."""


class Progress:
    """How far spread() is."""

    def __init__(self, tasks, repeats):
        self.tasks = tasks  #: how many there are
        self.repeats = repeats  #: how many of them are done twice
        self.done = 0  #: tasks, without those done a second time
        self.agreed = 0  #: tasks that were done twice with equal results
        self.elsewhere = 0  #: of these, those done by two different workers


def _do(work, task):
    """Runs on a worker: its address, and the task's result."""
    from distributed import get_worker
    return get_worker().address, work(*task)


def spread(client, work, tasks, twice=0.1, retries=3, progress=None):
    """Calls work(*task) for each task on the workers of a dask.distributed Client, and returns the results in the order of the tasks.

    work     a function. It and its arguments are pickled; worlds travel as snapshots. It must depend on its arguments alone.
    twice    the share of the tasks, 0 to 1, that are done a second time on another worker, if there is one. Results are compared by ==.
    retries  how often a task that raises is tried again. Tasks of a worker that died are given to others in any case.
    progress called with a Progress after each result.

    Raises Disagreement, and what `work` raises.
    """
    from distributed import as_completed

    tasks = list(tasks)
    if not 0 <= twice <= 1:
        raise ValueError("twice must be from 0 to 1")
    repeated = {i for i in range(len(tasks)) if int((i + 1) * twice) > int(i * twice)}
    state = Progress(len(tasks), len(repeated))
    name = uuid.uuid4().hex[:8]
    open_tasks = {}  # by the key of its future: the task's number, and who has done it before

    def submit(i, before=None):
        others = [address for address in client.nthreads() if address != before] if before else []
        where = {"workers": others, "allow_other_workers": True} if others else {}
        future = client.submit(_do, work, tasks[i], key=f"islet-{name}-{i}{'-again' if before else ''}", pure=False, retries=retries, **where)
        open_tasks[future.key] = i, before
        return future

    results = [None] * len(tasks)
    waiting = as_completed([submit(i) for i in range(len(tasks))])
    for future in waiting:
        i, before = open_tasks.pop(future.key)
        address, result = future.result()
        future.release()
        if before is None:
            results[i] = result
            state.done += 1
            if i in repeated:
                waiting.add(submit(i, address))
        elif result != results[i]:
            raise Disagreement(f"task {i}: {before} and {address} do not agree")
        else:
            state.agreed += 1
            state.elsewhere += address != before
        if progress is not None:
            progress(state)
    return results
