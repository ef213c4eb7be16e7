# Writes sources and all that they include as one text. Called by tools/amalgamate.sh, which sets:
#   engine   the folder engine/
#   roots    what to write, one path a line, from engine/
#   given    headers that the text gets elsewhere (they are in a file that it includes), one path a line
#   inner    if set, the namespace within islet::detail into which everything goes: a second copy, compiled for other instructions
#
# An include is replaced by the file, once; system headers are left as they are. The files must be as the engine's are: an include of a header by its path
# from the file's own folder or as islet/..., and never for the first time under a condition.

function fail(words) {
    print "amalgamate: " words > "/dev/stderr"
    failed = 1
    exit 1
}

# The path without its x/../ parts.
function plain(path) {
    while (sub(/[^\/.]+\/\.\.\//, "", path)) {}
    return path
}

function resolved(name, from) {
    if (name ~ /^islet\//) return "include/" name
    sub(/[^\/]*$/, "", from)
    return plain(from name)
}

# The text of a class template, for its specialisation of 8 or 16 lanes: declared here, defined with the copy for AVX2 or AVX-512.
function specialised(name, lanes, text) {
    text = class_text[name]
    if (text == "") fail("there is no class " name " to specialise")
    gsub(/ = width;/, " = " lanes ";", text)
    return where_there_are(lanes, "template <>\nstruct " name "<" lanes "> {" text)
}
function where_there_are(lanes, text) { return "#if ISLET_MAX_LANES >= " lanes "\n" text "\n#endif" }

function emit(path, depth, line, name, lanes, quoted, class, words, outside) {
    if (path in done) return
    if (depth > 0) fail(path " is first included under a condition")
    done[path] = 1
    print "\n// ---- engine/" path "\n"
    while ((getline line < (engine "/" path)) > 0) {
        if (line ~ /^#pragma once/) continue
        if (line ~ /^# *if/) ++level[path]
        if (line ~ /^# *endif/) --level[path]
        if (line ~ /^# *include *"/) {
            split(line, quoted, "\"")
            emit(resolved(quoted[2], path), level[path] + 0)
            continue
        }
        if (inner != "") {
            if (line ~ /^extern template /) continue
            # What islet's own classes have inline is there once already.
            if (line ~ /^namespace islet \{/) outside = 1
            if (outside) {
                if (line ~ /^}  \/\/ namespace islet$/) outside = 0
                continue
            }
            if (line ~ /^namespace / && line !~ /^namespace islet::detail \{/) fail(path " opens another namespace: " line)
            gsub(/detail::/, "detail::" inner "::", line)
            sub(/^namespace islet::detail \{/, "namespace islet::detail::" inner " {", line)
            sub(/^}  \/\/ namespace islet::detail/, "}  // namespace islet::detail::" inner, line)
        } else {
            # Class templates are remembered, for their specialisations.
            if (line ~ /^struct [A-Za-z]+ \{/) {
                split(line, words, " ")
                class = words[2]
                class_text[class] = ""
            } else if (class != "") {
                class_text[class] = class_text[class] "\n" line
                if (line ~ /^};/) class = ""
            }
            if (line ~ /^extern template [^(]*<(8|16)>/) {
                lanes = line ~ /<8>/ ? 8 : 16
                if (line ~ /^extern template struct /) {
                    name = line
                    gsub(/^extern template struct |<[0-9]+>;$/, "", name)
                    line = specialised(name, lanes)
                } else {
                    sub(/^extern template/, "template <>", line)
                    line = where_there_are(lanes, line)
                }
            }
        }
        print line
    }
    close(engine "/" path)
    if (level[path] != 0) fail(path " has conditions that do not end")
}

BEGIN {
    count = split(given, list, "\n")
    for (i = 1; i <= count; ++i) done[list[i]] = 1
    count = split(roots, list, "\n")
    for (i = 1; i <= count; ++i) emit(list[i], 0)
}
END { if (failed) exit 1 }
