#!/usr/bin/env bash
# ./artcal and ./check with apt, sudo, cmake and ctest replaced by stand-ins that write down how they were
# called: a copy of the commands in a folder whose name has a space, called from elsewhere.
set -euo pipefail
source_dir=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
project="$work/a project"
mkdir -p "$project/.ci" "$work/bin" "$work/else where"
cp "$source_dir"/{artcal,check,CMakeLists.txt,CMakePresets.json} "$project"
cp "$source_dir/.ci/run" "$project/.ci"
cp -r "$source_dir/cmake" "$project"
for folder in core acquisition fitting artefacts identification app; do
  mkdir "$project/$folder"
  touch "$project/$folder/CMakeLists.txt"
done
# shellcheck disable=SC2317  # the functions below are called through expect
export CALLS="$work/calls" PATH="$work/bin:$PATH" MISSING="" FAIL="" FAKE_ID=0

stand_in() { # NAME: the body comes from stdin
  { echo '#!/usr/bin/env bash'; echo "echo \"$1 \$*\" >>\"\$CALLS\""; cat; } >"$work/bin/$1"
  chmod +x "$work/bin/$1"
}
stand_in dpkg-query <<'S'
for package in "${@:4}"; do [[ " $MISSING " == *" $package "* ]] || echo "ii  $package"; done
S
stand_in apt-get <<'S'
echo "frontend=$DEBIAN_FRONTEND" >>"$CALLS"; echo "apt speaks"; [[ $FAIL != apt ]]
S
stand_in sudo <<'S'
"$@"
S
stand_in ccache <<'S'
S
stand_in cmake <<'S'
echo "cmake speaks"
if [[ $1 == --build ]]; then
  [[ $FAIL != build ]] || { echo "error: boom"; exit 1; }
  mkdir -p "$2/app"
  printf '#!/bin/bash\necho "in $PWD"\nprintf "<%%s>" "$@"\nexit 4\n' >"$2/app/artcal"
  chmod +x "$2/app/artcal"
else
  [[ $FAIL != configure ]] || { echo "no compiler"; exit 1; }
  mkdir -p "build/${*: -1}"
  touch "build/${*: -1}/build.ninja"
  echo "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" >"build/${*: -1}/CMakeCache.txt"
fi
S
stand_in ctest <<'S'
echo "100% tests passed"; exit 8
S

failures=0
expect() { # WHAT CONDITION…
  local what=$1
  shift
  if ! "$@"; then
    echo "FAILED: $what" >&2
    sed 's/^/    /' "$CALLS" "$work/out" "$work/err" >&2
    failures=$((failures + 1))
  fi
}
run() { # COMMAND…: leaves status, $work/out and $work/err
  : >"$CALLS"
  status=0
  (cd "$work/else where" && "$@") >"$work/out" 2>"$work/err" || status=$?
}
called() { grep -q -- "$1" "$CALLS"; }
not_called() { ! called "$1"; }
said() { grep -q -- "$1" "$work/err"; }

MISSING="libceres-dev ninja-build" run "$project/artcal" identify "my file.toml" --json -
expect "the program's exit code comes through" test "$status" = 4
expect "stdout holds the program's output alone" \
  test "$(cat "$work/out")" = "in $work/else where"$'\n'"<identify><my file.toml><--json><->"
expect "the missing packages are installed, no others" called "install --no-install-recommends libceres-dev ninja-build$"
expect "the package lists are fetched first" called "apt-get .* update"
expect "apt asks no questions" called "frontend=noninteractive"
expect "the release preset is configured" called "cmake --preset release"

run "$project/artcal" a
expect "a second call builds nothing" not_called .
expect "and runs" test "$status" = 4
expect "and says nothing" test ! -s "$work/err"

touch "$project/core/CMakeLists.txt"
run "$project/artcal"
expect "a changed source is built again" called "cmake --build"
expect "without configuring again" not_called "--preset"
expect "with nothing to install" not_called apt-get

touch "$project/app/new.cpp"
rm "$project/app/new.cpp"
run "$project/artcal"
expect "a source that went is noticed" called "cmake --build"

touch "$project/core/CMakeLists.txt"
FAIL=build run "$project/artcal"
expect "a failed build stops" test "$status" = 1
expect "and shows why" said "error: boom"
expect "and says so" said "the build failed"
run "$project/artcal"
expect "and is tried again" called "cmake --build"

touch "$project/CMakePresets.json"
FAIL=configure run "$project/artcal"
expect "a failed configuration stops" said "CMake could not configure"
MISSING="g++" FAIL=apt run "$project/artcal"
expect "a failed installation stops" said "apt could not install"
expect "and shows apt's words" said "apt speaks"

mv "$project" "$work/moved project"
project="$work/moved project"
touch "$project/CMakePresets.json"
run "$project/artcal"
expect "a moved folder is configured afresh" called "--fresh --preset release"

ln -s "$project/artcal" "$work/bin/artcal-link"
run artcal-link b
expect "a symbolic link to the command works" test "$status" = 4

MISSING="libgtest-dev" run "$project/artcal"
expect "running needs no test packages" not_called apt-get
MISSING="libgtest-dev" run "$project/.ci/run" -R core
expect "testing does" called "install --no-install-recommends libgtest-dev$"
expect "check builds dev" called "cmake --preset dev"
expect "arguments go to ctest" called "ctest --test-dir $project/build/dev .*-R core$"
expect "ctest's summary ends the output" grep -q "100% tests passed" "$work/out"
expect "ctest's exit code comes through" test "$status" = 8

if [[ $EUID -ne 0 ]]; then
  MISSING="g++" run "$project/check"
  expect "whoever is not root uses sudo" called "^sudo env"
fi
exit $((failures > 0))
