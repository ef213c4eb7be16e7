# Shared by the tests of the manual: what its pages are, and what is in them. Meant to be sourced, by bash.
# shellcheck shell=bash

# pages ROOT: README.md and every page of docs/.
pages() { printf '%s\n' "$1/README.md" "$1"/docs/*.md; }

# blocks LANGUAGE PAGE: the lines of the page's fenced blocks of that language.
blocks() { awk -v language="$1" '/^```/ { inside = !inside && $0 == "```" language; next } inside' "$2"; }

# prose PAGE: the page without its fenced blocks.
prose() { awk '/^```/ { inside = !inside; print ""; next } { print inside ? "" : $0 }' "$1"; }

failures=0
complain() {
    printf '%s\n' "$*"
    failures=$((failures + 1))
}
