# Deepest use of the stack, from GCC's call graphs (-fcallgraph-info=su):
#
#   awk -v root=FOLDER [-v start=FUNCTION] -f stack.awk FILE.ci...        prints: bytes, and the path that needs them, as mangled names
#
# FOLDER is where the project stands: the graphs name its files from wherever they were compiled. FUNCTION is where the path begins, anywhere if not given.
#
# Exit status 1, with the reason on standard error, where no bound can be given: a recursion, a stack frame of variable size, or a call through a
# pointer that is no hook of the user's. What a hook needs is the user's to add; so is what memcpy and its like need, a few words.

# The value of a field: name: "value".
function field(name,    at, rest) {
    at = index($0, name ": \"")
    if (at == 0) return ""
    rest = substr($0, at + length(name) + 3)
    return substr(rest, 1, index(rest, "\"") - 1)
}

# The user's hooks are called by names that say so, or are handed a context of the user's as the last thing. `place` is file:line:column.
function is_hook(place,    part, file, line, i) {
    split(place, part, ":")
    file = part[1]
    sub(/^(\.\.\/)+/, root "/", file)
    for (i = 1; i <= part[2]; ++i)
        if ((getline line < file) <= 0) break
    close(file)
    return line ~ /_hook\(|context\)/
}

function fail(text) {
    print text > "/dev/stderr"
    failed = 1
}

/^node:/ {
    name = field("title")
    label = field("label")
    if (match(label, /[0-9]+ bytes \([a-z,]*\)/)) {
        split(substr(label, RSTART, RLENGTH), words, " ")
        if (words[1] + 0 > frame[name] + 0) frame[name] = words[1] + 0
        if (!(name in known)) names[++count] = name
        known[name] = 1
        if (words[3] ~ /dynamic/) fail("a stack frame of variable size: " name)
    }
}

/^edge:/ {
    from = field("sourcename")
    to = field("targetname")
    if (to == "__indirect_call") {
        if (!is_hook(field("label"))) fail("a call through a pointer: " from " at " field("label"))
    } else if (!((from, to) in seen)) {
        seen[from, to] = 1
        calls[from, ++call_count[from]] = to
    }
}

function depth(name,    i, d, deepest) {
    if (name in result) return result[name]
    if (name in open) {
        fail("a recursion through " name)
        return 0
    }
    open[name] = 1
    for (i = 1; i <= call_count[name]; ++i) {
        d = depth(calls[name, i])
        if (d > deepest) {
            deepest = d
            next_of[name] = calls[name, i]
        }
    }
    delete open[name]
    result[name] = frame[name] + deepest
    return result[name]
}

END {
    for (i = 1; i <= count; ++i) {
        if (depth(names[i]) > most && (start == "" || names[i] == start)) {
            most = result[names[i]]
            where = names[i]
        }
    }
    printf "%d", most
    for (; where != ""; where = next_of[where]) printf " %s", where
    printf "\n"
    exit failed
}
