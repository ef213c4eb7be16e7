#!/usr/bin/env bash
# first_command_test.sh ROOT [FOLDER]: the first command of README.md, in a fresh copy of the tree in FOLDER, as a new user gives it: it builds, runs, and draws
# the scene. Takes four minutes of processor time without a compiler's cache, so tools/test.sh --all alone runs it.
set -euo pipefail

root=$(cd "$1" && pwd)
command=$(sed -n 's/^\(\.\/tools\/run\.sh [a-z_]*\).*/\1/p' "$root/README.md" | head -n 1)
[ -n "$command" ] || { printf 'README.md has no such command\n'; exit 1; }
folder=${2:-$(mktemp -d)}
rm -rf "$folder"
mkdir -p "$folder"
trap 'rm -rf "$folder"' EXIT
(cd "$root" && tar --exclude=./build --exclude='./build-*' --exclude=./.git --exclude=node_modules -cf - .) | tar -xf - -C "$folder"
cd "$folder"
output=$($command)
printf '%s\n' "$output"
grep -q 'check passed' <<<"$output"
grep -q '</svg>' "$(sed -n 's/^picture: //p' <<<"$output")"
