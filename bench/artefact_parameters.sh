#!/usr/bin/env bash
# What artefact parameters, many artefacts and many placements cost: CPU and wall time of `artcal identify` on simulated
# recordings, beside another build of the program on the same files in the same run.
#   bench/artefact_parameters.sh [PROGRAM [OTHER_PROGRAM [FOLDER]]]
# A recording on which the other program takes more than LIMIT seconds (300) is given up there.
set -euo pipefail
root=$(dirname -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")")
program=${1:-$root/build/release/app/artcal}
other=${2:-}
folder=${3:-}
limit=${LIMIT:-300}
if [[ -z $folder ]]; then
  folder=$(mktemp -d)
  trap 'rm -rf -- "$folder"' EXIT
fi
mkdir -p "$folder"

plate() { # NAME COLUMNS ROWS STEP
  printf 'schema = "artcal-artefact/1"\nname = "%s"\ntype = "sphere plate"\nunits = { length = "mm" }\nexpansion_per_K = 11.5e-6\n' "$1"
  printf '[uncertainty]\nat = { rule = "sqrt(a^2 + (b*L)^2)", a = "0.6 um", b = "1.0 um/m", k = 2 }\n'
  awk -v columns="$2" -v rows="$3" -v step="$4" 'BEGIN {
    srand(5); diameter = step < 36 ? 0.6 * step : 22
    for (i = 0; i < columns; ++i) for (j = 0; j < rows; ++j)
      printf "\n[[feature]]\nname = \"%d.%d\"\nkind = \"sphere\"\ndiameter = %g\nat = [%.4f, %.4f, %.4f]\n", i, j, diameter,
        i * step + 0.04 * (rand() - 0.5), j * step + 0.04 * (rand() - 0.5), 0.02 * (rand() - 0.5) }'
}

pair() { # NAME LENGTH
  printf 'schema = "artcal-artefact/1"\nname = "%s"\nunits = { length = "mm" }\n' "$1"
  printf '[[feature]]\nname = "0"\nkind = "point"\n[[feature]]\nname = "1"\nkind = "point"\n'
  printf '[[distance]]\nbetween = ["0", "1"]\nvalue = %s\nU = 0.002\nk = 2\n' "$2"
}

seats() {
  printf 'schema = "artcal-artefact/1"\nname = "seats"\nunits = { length = "mm" }\n[uncertainty]\nat = { U = "1.5 um", k = 2 }\n'
  local seat
  for seat in "A 0, 0, 0" "B 300.0021, 0, 0" "C 300.0008, 199.9967, 0.0041" "D -0.0015, 200.0012, 0.0026" "E 150.0043, 100.0009, 60.0031"; do
    printf '[[feature]]\nname = "%s"\nkind = "point"\nat = [%s]\n' "${seat%% *}" "${seat#* }"
  done
}

begin() { # CASE ARTEFACT_FILE…; what follows on standard input is the rest of the plan
  local name=$1 files
  shift
  files=$(printf '"%s", ' "$@")
  mkdir -p "$folder/plans/$name"
  cp "$root/examples/simulate/arm.toml" "$folder/plans/$name"
  {
    printf 'schema = "artcal-plan/1"\nname = "%s"\narm = "arm.toml"\nartefacts = [%s]\nseed = 3\n' "$name" "${files%, }"
    printf 'artefact_errors = true\nunits = { length = "mm", angle = "deg" }\n'
    printf '[errors]\nlength = "0.3 mm"\nangle = "0.1 deg"\nexact = ["a6", "d6", "d1", "theta1"]\n%s\n' "${errors:-}"
    printf '[noise]\nencoder = "2 arcsec"\nprobing = "3 um"\n'
    cat
  } >"$folder/plans/$name/plan.toml"
}

probe() { # ARTEFACT PLACEMENTS POINTS
  printf '[[placement]]\nartefact = "%s"\nname = "%s"\nrandom = %d\n' "$1" "$1" "$2"
  printf '[[probing]]\nartefact = "%s"\npattern = "spread"\npoints = %d\n' "$1" "$3"
}

make_plans() {
  local bar="ball bar 1000" names=() i
  probe plate 7 9 | begin plate plate.toml
  plate plate 5 5 100 >"$folder/plans/plate/plate.toml"
  { probe "$bar" 7 20; probe plate 7 9; probe seats 7 12; probe table 7 50; } | begin four bar.toml plate.toml seats.toml table.toml
  errors=$'first_harmonic = "3 arcsec"\nsecond_harmonic = "1 arcsec"'
  { probe "$bar" 7 20; probe plate 7 9; } | begin auto bar.toml plate.toml
  errors=
  for i in four auto; do
    cp "$folder/plans/plate/plate.toml" "$root/examples/simulate/bar.toml" "$folder/plans/$i"
  done
  seats >"$folder/plans/four/seats.toml"
  printf 'schema = "artcal-artefact/1"\nname = "table"\nunits = { length = "mm" }\n[[feature]]\nname = "top"\nkind = "plane"\n' \
    >"$folder/plans/four/table.toml"
  mapfile -t names < <(seq 490)
  for i in "${names[@]}"; do probe "$i" 1 2; done | begin pairs "${names[@]/%/.toml}"
  for i in "${names[@]}"; do pair "$i" "$((100 + 7919 * i % 500)).0$((i % 10))" >"$folder/plans/pairs/$i.toml"; done
  probe plate 7 5 | begin plate300 plate.toml
  plate plate 15 20 30 >"$folder/plans/plate300/plate.toml"
  probe "$bar" 300 5 | begin bar300 bar.toml
  cp "$root/examples/simulate/bar.toml" "$folder/plans/bar300"
}

seconds() { # PROGRAM ARGUMENT…: wall and CPU time
  local times
  if times=$( { TIMEFORMAT='%R %U %S'; time timeout "$limit" "$@" >/dev/null 2>&1; } 2>&1); then
    awk '{ printf "%.2f %.2f", $1, $2 + $3 }' <<<"$times"
  else
    printf -- '- -'
  fi
}

measure() { # CASE TITLE ARGUMENT…
  local name=$1 title=$2 recording="$folder/recordings/$1/recording.toml" wall cpu other_wall=- other_cpu=-
  shift 2
  if [[ ! -e $recording ]]; then
    mkdir -p "$folder/recordings"
    "$program" simulate "$folder/plans/$name/plan.toml" -q -o "$folder/recordings/$name"
  fi
  read -r wall cpu <<<"$(seconds "$program" identify "$recording" -q "$@")"
  if [[ -n $other ]]; then
    read -r other_wall other_cpu <<<"$(seconds "$other" identify "$recording" -q "$@")"
  fi
  awk -v title="$title" -v readings="$(($(wc -l <"${recording%/*}/readings.csv") - 1))" -v wall="$wall" -v cpu="$cpu" \
    -v other="$other_wall" -v other_cpu="$other_cpu" 'BEGIN {
      ratio = cpu > 0 && other_cpu != "-" ? sprintf("%.1f", other_cpu / cpu) : "-"
      printf "| %s | %d | %s | %s | %s | %s | %s |\n", title, readings, wall, cpu, other, other_cpu, ratio }'
}

make_plans
echo "| recording | readings | wall, s | CPU, s | other: wall, s | CPU, s | ratio of CPU |"
echo "|---|---|---|---|---|---|---|"
measure plate "5 x 5 plate, 75 artefact parameters, seven placements"
measure four "ball bar, plate, seats and plane together"
measure auto "ball bar and plate, \`--model auto\`" --model auto
measure pairs "490 artefacts of one pair of points"
measure plate300 "plate of 300 balls, seven placements"
measure bar300 "ball bar in 300 placements"
