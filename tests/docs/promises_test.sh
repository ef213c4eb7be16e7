#!/usr/bin/env bash
# promises_test.sh ROOT: each row of docs/promises.md names a page that exists and at least one test or script, and all of these exist.
#   `folder.Suite.Test`, `folder.Suite.*`    a GoogleTest in tests/FOLDER (a.b: tests/a/b); a name before a slash is that of an instance
#   `folder.name`                            a test that some CMakeLists.txt adds under this name
#   `path/of/a/file`                         a script or program, from the root
# shellcheck disable=SC2016  # what stands in single quotes is for grep
set -euo pipefail

root=$(cd "$1" && pwd)
# shellcheck source=tests/docs/pages.sh
. "$(dirname "$0")/pages.sh"
table=$root/docs/promises.md

# has_test FOLDER SUITE TEST
has_test() {
    local test=$3
    [ "$test" != '*' ] || test='[A-Za-z0-9_]+'
    grep -qrE "TEST(_F|_P)?\($2, *$test\)" "$root/tests/$1" --include='*.cpp'
}

# exists NAME
exists() {
    local name=$1 folder suite test
    case $name in
    */*.*.* | *.*.*) # an instance: physics.Rooms/Continuous.*
        if [[ $name =~ ^([a-z_]+(\.[a-z_]+)?)\.([A-Za-z0-9_]+/)?([A-Z][A-Za-z0-9_]*)\.([A-Za-z0-9_]+|\*)$ ]]; then
            folder=${BASH_REMATCH[1]//.//} suite=${BASH_REMATCH[4]} test=${BASH_REMATCH[5]}
            has_test "$folder" "$suite" "$test"
            return
        fi
        ;;
    esac
    [ ! -e "$root/$name" ] || return 0
    [[ $name =~ ^[a-z_.]+$ ]] && grep -qrE "NAME $name( |\$)" "$root/tests" --include=CMakeLists.txt
}

rows=0
while IFS='|' read -r _ statement page holders _; do
    rows=$((rows + 1))
    page=$(sed -n 's/.*(\([A-Za-z0-9.\/-]*\.md\)).*/\1/p' <<<"$page")
    if [ -z "$page" ] || [ ! -e "$root/docs/$page" ]; then complain "no page is named for:$statement"; fi
    mapfile -t names < <(grep -oE '`[^`]+`' <<<"$holders" | tr -d '`' || true)
    [ ${#names[@]} -gt 0 ] || complain "no test is named for:$statement"
    for name in "${names[@]}"; do exists "$name" || complain "there is no $name, for:$statement"; done
done < <(grep '^|' "$table" | grep -v -E '^\| *(statement|-)')

printf '%d promises checked\n' "$rows"
[ "$rows" -gt 40 ] && [ "$failures" -eq 0 ]
