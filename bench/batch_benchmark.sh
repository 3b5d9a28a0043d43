#!/usr/bin/env bash
# Recordings a second, start to end with SQLite: a folder of simulated ball bars of 400 readings, each of an arm of its own,
# by `artcal batch`, and side by side the first of them by one `artcal identify` each.
#   bench/batch_benchmark.sh [PROGRAM [RECORDINGS [FOLDER]]]
# A folder that is named is filled where it is not yet and kept, so that another program is measured on the same files.
set -euo pipefail
root=$(dirname -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")")
program=${1:-$root/build/release/app/artcal}
count=${2:-1000}
folder=${3:-}
if [[ -z $folder ]]; then
  folder=$(mktemp -d)
  trap 'rm -rf -- "$folder"' EXIT
fi
alone=$((count < 50 ? count : 50))

make_archive() {
  mkdir -p "$folder/plan" "$folder/archive"
  cp "$root"/examples/simulate/{arm,bar}.toml "$folder/plan"
  sed 's/^random = 7/random = 4/' "$root/examples/simulate/plan.toml" >"$folder/plan/plan.toml"
  seq "$count" | xargs -P "$(nproc)" -I{} "$program" simulate "$folder/plan/plan.toml" --seed {} --threads 1 -q \
    -o "$folder/archive/{}" --force
}

per_second() { # NAME COUNT COMMAND…
  local name=$1 done=$2 times
  shift 2
  times=$( { TIMEFORMAT='%R %U %S'; time "$@" >/dev/null 2>&1; } 2>&1)
  awk -v name="$name" -v n="$done" '{ printf "%-28s %8.1f a second   %6.2f ms CPU each\n", name, n / $1, 1000 * ($2 + $3) / n }' <<<"$times"
}

identify_each() {
  seq "$alone" | xargs -P "$(nproc)" -I{} "$program" identify "$folder/archive/{}/recording.toml" --no-leave-out -q
}

[[ $(find "$folder/archive" -maxdepth 1 -mindepth 1 2>/dev/null | wc -l) == "$count" ]] || make_archive
rm -f "$folder"/results.sqlite*
per_second "batch" "$count" "$program" batch "$folder/archive" --store "$folder/results.sqlite" -q
per_second "batch --resume" "$count" "$program" batch "$folder/archive" --store "$folder/results.sqlite" --resume -q
per_second "identify, a process each" "$alone" identify_each
