# Bytes of flash that one library has in an image, from GNU ld's map:
#
#   awk -v library=NAME.a [-v optimised=1] -f share.awk FILE.map
#
# optimised: whatever was made at the link (-flto) is the library's.

function number(hex,    i, n) {
    n = 0
    for (i = 3; i <= length(hex); ++i) n = 16 * n + index("0123456789abcdef", substr(hex, i, 1)) - 1
    return n
}

/^Linker script and memory map/ { mapped = 1 }
/^\.bss|^\.stack|^\/DISCARD\// { mapped = 0 }

# A section's name may stand on a line of its own; then come address, size and file.
mapped && (index($0, library "(") || (optimised && /\.ltrans\.o$/)) {
    for (i = 1; i < NF; ++i) {
        if ($i ~ /^0x/ && $(i + 1) ~ /^0x/) {
            sum += number($(i + 1))
            break
        }
    }
}

END { print sum + 0 }
