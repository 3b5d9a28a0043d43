#!/usr/bin/env bash
# How long a report of many readings takes to open: a simulated recording of 100,000 readings on ball bars, identified,
# reported, and opened in a Chromium without a window (and without a graphics card), a few times, each with a fresh profile.
#   bench/report_opening.sh [PROGRAM [PLACEMENTS [TIMES [PAGE.html]]]]
# A placement is 1,000 readings. A page that is named is opened as it is, and nothing is made. Prints, each time, wall
# seconds from when the page was asked for (the browser running) until the figures in view are drawn, the CPU time until
# then, and how busy the machine is. HEIGHT=20000 makes the screen so high that all of them are in view. On a busy
# machine: chrt -r 5 bench/report_opening.sh, as root.
set -euo pipefail
root=$(dirname -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")")
program=$(readlink -f -- "${1:-$root/build/release/app/artcal}")
placements=${2:-100}
times=${3:-5}
page=${4:-}
folder=$(mktemp -d)
browser=
trap '[[ -z $browser ]] || kill -- "-$browser" 2>/dev/null || true; rm -rf -- "$folder"' EXIT

if [[ -z $page ]]; then
  cp "$root"/examples/simulate/{arm,bar}.toml "$folder"
  sed "s/^random = 7/random = $placements/; s/^pattern = \"iso25\"/&\nrepeats = 10/" "$root/examples/simulate/plan.toml" \
    >"$folder/plan.toml"
  "$program" simulate "$folder/plan.toml" -o "$folder/made" -q
  "$program" identify "$folder/made/recording.toml" --no-leave-out -q --json "$folder/result.json"
  page=$folder/report.html
  "$program" report "$folder/result.json" -o "$page" -q
fi

# A copy that tells the console when it is done; the page's own policy would not let that script run.
sed -e 's/<meta http-equiv="Content-Security-Policy"[^>]*>//' -e 's#</body>#<script>\
  const told = setInterval(() => {\
    const {drawn, milliseconds} = document.documentElement.dataset;\
    if (drawn) { clearInterval(told); console.log(`drawn after ${milliseconds} ms`); }\
  }, 10);</script></body>#' "$page" >"$folder/timed.html"
printf 'page of %s bytes, load %s\n' "$(stat -c %s "$page")" "$(cut -d' ' -f1-3 /proc/loadavg)"

cpu_seconds() {
  local pid
  for pid in $(ps -o pid= -g "$browser"); do
    cut -d')' -f2 "/proc/$pid/stat" 2>/dev/null || true
  done | awk -v hz="$(getconf CLK_TCK)" '{ ticks += $12 + $13 } END { printf "%.2f", ticks / hz }'
}

open_once() {
  local out=$folder/console before
  : >"$out"
  # The browser is up and idle before the page is asked for.
  printf '<meta http-equiv="refresh" content="3;url=%s">' "$2" >"$folder/start.html"
  setsid chromium --headless --no-sandbox --disable-dev-shm-usage --enable-unsafe-swiftshader --window-size="1200,${HEIGHT:-900}" \
    --remote-debugging-port=0 --enable-logging=stderr --user-data-dir="$folder/profile-$1" "file://$folder/start.html" \
    >/dev/null 2>"$out" &
  browser=$!
  sleep 2.5
  before=$(cpu_seconds)
  for _ in {1..600}; do
    if grep -q 'drawn after' "$out"; then
      break
    fi
    sleep 0.1
  done
  printf '%-24s %s s of CPU by all processes of the browser\n' \
    "$(grep -o 'drawn after [0-9]* ms' "$out" || echo 'NOT DRAWN in a minute')" \
    "$(awk -v now="$(cpu_seconds)" -v before="$before" 'BEGIN { print now - before }')"
  kill -- "-$browser" 2>/dev/null || true
  wait "$browser" 2>/dev/null || true
  browser=
}

for time in $(seq "$times"); do
  open_once "$time" timed.html
done
printf 'load %s\n' "$(cut -d' ' -f1-3 /proc/loadavg)"
