#!/usr/bin/env python3
"""uncompiled.py ISLET BUILD: the build's compiler reads each file of ISLET that the build has a command for and has not compiled, with the build's own flags
and warnings. It writes no code.

So a compiler whose build makes a part of the tests only has still seen all files. (Whether a file needs what another includes, which a unity build hides, is
what the optimised build finds: it compiles file by file what users build, and for tools/test.sh --release all. tests/determinism/by_hand.sh does so with the
engine, by both compilers.)
"""
import concurrent.futures
import json
import os
import shlex
import subprocess
import sys

islet, build = (os.path.realpath(path) for path in sys.argv[1:3])


def commands():
    """Each file that is to be read, with its command as a list of words and the folder to run that in; once, whatever the number of its targets."""
    found = {}
    with open(os.path.join(build, "compile_commands.json"), encoding="utf-8") as file:
        entries = json.load(file)
    for entry in entries:
        words = shlex.split(entry["command"])
        folder, place = entry["directory"], words.index("-o")
        source, written = entry["file"], os.path.join(folder, words[place + 1])
        if not os.path.exists(written):
            words = [word for word in words[:place] + words[place + 2:] if word not in ("-c", source)]
            found.setdefault(source, (words + ["-fsyntax-only", source], folder))
    return found


def read(words_and_folder):
    words, folder = words_and_folder
    return subprocess.run(words, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)


asked = commands()
with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
    results = list(pool.map(read, asked.values()))
failed = [result for result in results if result.returncode != 0]
for result in failed[:20]:
    print(result.stdout)
if not asked or failed:
    sys.exit(f"{len(failed)} of {len(asked)} files cannot be read")
print(f"ok: {len(asked)} files")
