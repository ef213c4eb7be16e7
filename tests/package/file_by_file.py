#!/usr/bin/env python3
"""file_by_file.py ISLET BUILD: the build's compiler reads each file of ISLET by itself that the build has compiled together with others (as a unity build does)
or not at all, with the build's own flags and warnings. A file that needs what another includes is found so. It writes no code.

The engine is left out: tests/determinism/by_hand.sh compiles each of its files, by both compilers.
"""
import concurrent.futures
import json
import os
import re
import shlex
import subprocess
import sys

islet, build = (os.path.realpath(path) for path in sys.argv[1:3])
only_where_many_are_one = "-Wno-shadow"


def commands():
    """Each file that is to be read, with its command as a list of words and the folder to run that in; once, whatever the number of its targets."""
    found = {}
    with open(os.path.join(build, "compile_commands.json"), encoding="utf-8") as file:
        entries = json.load(file)
    for entry in entries:
        words = shlex.split(entry["command"])
        folder, place = entry["directory"], words.index("-o")
        source, written = entry["file"], os.path.join(folder, words[place + 1])
        words = [word for word in words[:place] + words[place + 2:] if word not in ("-c", source, only_where_many_are_one)]
        if re.search(r"/unity_\d+_cxx\.cxx$", source):
            with open(source, encoding="utf-8") as file:
                sources = re.findall(r'^#include "(.*)"', file.read(), re.MULTILINE)
        else:
            sources = [] if os.path.exists(written) else [source]
        for each in sources:
            if "cmake_pch" not in each and not each.startswith(os.path.join(islet, "engine", "src")):
                found.setdefault(each, (words + ["-fsyntax-only", each], folder))
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
    sys.exit(f"{len(failed)} of {len(asked)} files cannot be read by themselves")
print(f"ok: {len(asked)} files")
