"""`islet sweep` on a cluster: its shards are tasks of Dask, each done by the program `islet` on a worker.

    python3 -m islet.sweep --scheduler tcp://host:8786 hello --vary friction=0.1:0.9:9 --seeds 100

All options of `islet sweep` follow as they are. The program must be on each worker's PATH, or where --program says. A share of the shards is made twice, on
two workers, and must come out the same. The table and its hash are those of one process.
"""
import argparse
import os
import subprocess
import sys
import tempfile


def make_shard(program, arguments, file, shard, shards):
    """Runs on a worker: the manifest of one shard. `file`: name and text of a scene in a file, or None."""
    with tempfile.TemporaryDirectory() as folder:
        if file is not None:
            with open(os.path.join(folder, file[0]), "w", encoding="utf-8") as out:
                out.write(file[1])
        command = [program, "sweep", *arguments, "--jobs", "1", "--shards", str(shards), "--shard", str(shard), "--manifest", "part.json"]
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            return {"error": done.stderr.strip() or f"{program} ended with status {done.returncode}"}
        with open(os.path.join(folder, "part.json"), encoding="utf-8") as made:
            return {"manifest": made.read()}


def stop(why):
    sys.stderr.write(f"islet.sweep: {why}\n")
    sys.exit(2)


def parse(arguments):
    parser = argparse.ArgumentParser(prog="python3 -m islet.sweep", description=__doc__.splitlines()[0], epilog="All other options are those of `islet sweep`.",
                                     allow_abbrev=False)
    parser.add_argument("--scheduler", required=True, help="address of Dask's scheduler")
    parser.add_argument("--program", default="islet", help="the program `islet`, here and on the workers")
    parser.add_argument("--shards", type=int, help="how many tasks; four for each thread of the workers if not given")
    parser.add_argument("--twice", type=float, default=0.1, help="the share of the shards that are made on two workers and compared")
    parser.add_argument("--json", action="store_true")
    parser.add_argument("--csv")
    parser.add_argument("--plot")
    for option in ("--jobs", "--shard", "--manifest", "--merge"):
        parser.add_argument(option, dest="refused", action="append", help=argparse.SUPPRESS)
    own, rest = parser.parse_known_args(arguments)
    if own.refused:
        parser.error("--jobs, --shard, --manifest and --merge are for sweeps without a scheduler")
    if own.shards is not None and own.shards < 1:
        parser.error("--shards must be at least 1")
    if not 0 <= own.twice <= 1:
        parser.error("--twice must be from 0 to 1")
    return own, rest


def scene_file(arguments):
    """The scene in a file that the arguments name, as name and text, and the arguments with that name."""
    for i, argument in enumerate(arguments):
        if argument.endswith(".json"):
            with open(argument, encoding="utf-8") as file:
                return (os.path.basename(argument), file.read()), arguments[:i] + [os.path.basename(argument)] + arguments[i + 1:]
    return None, arguments


def main(arguments=None):
    own, rest = parse(sys.argv[1:] if arguments is None else arguments)
    try:
        from distributed import Client
    except ImportError:
        stop("this needs Dask: install python3-distributed (or pip's distributed)")
    from islet.cluster import Disagreement, spread

    try:
        file, rest = scene_file(rest)
        client = Client(own.scheduler, timeout=20)
    except OSError as error:  # also if nobody answers
        stop(error)
    with client:
        threads = sum(client.nthreads().values())
        if threads == 0:
            stop(f"the scheduler {own.scheduler} has no workers")
        shards = own.shards or 4 * threads

        def show(state):
            if sys.stderr.isatty():
                sys.stderr.write(f"\rshard {state.done} of {shards}, {state.agreed} made twice")

        try:
            parts = spread(client, make_shard, [(own.program, rest, file, shard, shards) for shard in range(shards)], own.twice, progress=show)
        except Disagreement as error:
            stop(error)
    if sys.stderr.isatty():
        sys.stderr.write("\r" + " " * 60 + "\r")
    for part in parts:
        if "error" in part:
            sys.stderr.write(part["error"] + "\n")
            sys.exit(2)
    with tempfile.TemporaryDirectory() as folder:
        paths = []
        for shard, part in enumerate(parts):
            paths.append(os.path.join(folder, f"{shard}.json"))
            with open(paths[-1], "w", encoding="utf-8") as out:
                out.write(part["manifest"])
        command = [own.program, "sweep", *(["--json"] if own.json else []), *(["--csv", own.csv] if own.csv else []), *(["--plot", own.plot] if own.plot else []),
                   "--merge", *paths]
        sys.exit(subprocess.run(command, check=False).returncode)


if __name__ == "__main__":
    main()
