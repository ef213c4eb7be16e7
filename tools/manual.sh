#!/usr/bin/env bash
# Builds the manual as a site: a static folder, build/manual/site, that any server of files can serve.
#   tools/manual.sh [--base /PATH/] [--serve [PORT]]
#     --base    the path under which the folder will be served (/)
#     --serve   serves it on this machine when it is built (8090)
# Pages are those of docs/; the reference is made from bindings/api.json. Installs with apt what compiles WebAssembly, Python and Node.js, and by npm VitePress.
set -euo pipefail
# shellcheck source=tools/lib.sh
. "$(dirname "$0")/lib.sh"

base=/ port=
while [ $# -gt 0 ]; do
    case $1 in
    --base)
        [[ ${2-} =~ ^/([A-Za-z0-9._-]+/)*$ ]] || die "$0: --base needs a path such as /islet/"
        base=$2
        shift
        ;;
    --serve)
        port=8090
        if [[ ${2-} =~ ^[0-9]+$ ]]; then
            port=$2
            shift
        fi
        ;;
    -h | --help)
        sed -n '2,6s/^# \{0,1\}//p' "$0"
        exit 0
        ;;
    *) die "$0: unknown option $1; there are --base and --serve" ;;
    esac
    shift
done

need_wasm_tools
if [ ${#missing[@]} -gt 0 ]; then install_missing; fi
# The sandbox's WebAssembly has the scenes that pages show.
scenes=$root/build/js/sandbox/simd.wasm
if [ ! -e "$scenes" ] || [ -n "$(find "$root"/engine/{include,src} "$root"/bindings/{c,js/src} "$root"/samples/{harness,prefabs,scenes} -type f -newer "$scenes" -print -quit)" ]; then
    "$root/samples/sandbox/build.sh"
fi
cd "$root/tools/manual"
if [ ! node_modules/.package-lock.json -nt package-lock.json ]; then npm ci --no-audit --no-fund >&2; fi
./pages.py "$root/build/manual/pages"
ln -sfn "$root/tools/manual/node_modules" "$root/build/manual/node_modules" # where pages look for Vue
npx tsc --noEmit
ISLET_MANUAL_BASE=$base npx vitepress build . >"$root/build/manual/log" 2>&1 || {
    cat "$root/build/manual/log" >&2
    exit 1
}
printf 'manual: %s\n' "$root/build/manual/site"
if [ -n "$port" ]; then
    printf 'http://localhost:%s%s (Ctrl-C ends it)\n' "$port" "$base"
    ISLET_MANUAL_BASE=$base exec npx vitepress preview . --port "$port" --base "$base"
fi
