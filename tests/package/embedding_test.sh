#!/usr/bin/env bash
# embedding_test.sh CMAKE COMPILER ISLET BUILD PROGRAM: builds the project in embedding/ into BUILD, runs its programs, and wants the same
# words from its same_bits as from PROGRAM. The project is one that compiles many files as one, which is quicker, and users do it.
set -euo pipefail

cmake=$1 compiler=$2 islet=$3 build=$4 program=$5

rm -rf "$build"
"$cmake" -S "$(dirname "$0")/embedding" -B "$build" -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=Release -DCMAKE_UNITY_BUILD=ON -DISLET_FOLDER="$islet"
"$cmake" --build "$build"
"$build/example"
diff <("$program") <("$build/same_bits")
