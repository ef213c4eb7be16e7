#!/usr/bin/env bash
# What the engine's archive asks of its surroundings: five functions that every C library and most compilers' runtimes have. The prefabs' archive may ask for
# the engine's functions too: so it needs no heap.
#   symbols_test.sh libislet.a [NM]
#   symbols_test.sh libislet_prefabs.a NM libislet.a
set -euo pipefail

archive=$1
nm=${2:-nm}
engine=${3:-}
allowed='memcpy memmove memset memcmp sqrtf'

# Each object's undefined names, less what another object of the archive, or the engine, defines. The global offset table is the linker's own.
defined=$("$nm" --defined-only --format=posix "$archive" ${engine:+"$engine"} | awk 'NF > 1 { print $1 }' | sort -u)
undefined=$("$nm" --undefined-only --format=posix "$archive" | awk 'NF > 1 { print $1 }' | sort -u | grep -v '^_GLOBAL_OFFSET_TABLE_$' || true)
outside=$(comm -13 <(printf '%s\n' "$defined") <(printf '%s\n' "$undefined") | grep . || true)
bad=$(comm -13 <(tr ' ' '\n' <<<"$allowed" | sort) <(printf '%s\n' "$outside") | grep . || true)

printf 'undefined in %s: %s\n' "$(basename "$archive")" "$(tr '\n' ' ' <<<"$outside")"
status=0
if [ -n "$bad" ]; then
    printf 'it must not need:\n%s\n' "$bad" | c++filt
    "$nm" --undefined-only -A "$archive" | grep -F -w "$bad" | c++filt
    status=1
fi

# Of a function that is inline in several objects the linker keeps one copy. If that were one compiled for AVX2 or AVX-512, the engine would crash on
# a processor without it: so such an object must define nothing that another object defines too.
names() {
    "$nm" --defined-only --format=posix "$archive" |
        awk -v wanted="$1" -v is="$2" '/:$/ { wide = $0 ~ wanted } NF > 1 && wide == is && $2 ~ /[A-Zu]/ { print $1 }' | sort -u
}
for wide in avx2 avx512; do
    shared=$(comm -12 <(names "_$wide" 1) <(names "_$wide" 0) | grep . || true)
    if [ -n "$shared" ]; then
        printf 'defined for %s and elsewhere too:\n%s\n' "$wide" "$shared" | c++filt
        status=1
    fi
done

# A fused operation rounds once where others round twice. (AVX-512 has such operations of its own, which no flag takes away.)
if [ "$(uname -m)" = x86_64 ] && [ "$nm" = nm ]; then
    fused=$(objdump -d --no-show-raw-insn "$archive" | grep -E '\<vfn?m(add|sub)' | head -n 5 || true)
    if [ -n "$fused" ]; then
        printf 'fused operations:\n%s\n' "$fused"
        status=1
    fi
fi
exit "$status"
