# shellcheck shell=bash disable=SC2154,SC2016
# What ./artcal and ./check share: installing what is missing, configuring, building. Sourced by both,
# with `root` set to the project's folder. Everything here speaks to stderr: stdout is the program's.

say() { printf 'artcal: %s\n' "$*" >&2; }
fail() {
  say "$*"
  exit 1
}

# The packages to have for `$1`: release or dev.
wanted_packages() {
  awk -v all="$1" '/^\[/ { if (all != "dev") exit; next } { sub(/#.*/, ""); for (i = 1; i <= NF; ++i) print $i }' \
    "$root/cmake/packages.txt"
}

missing_packages() {
  comm -23 <(wanted_packages "$1" | sort) \
    <(wanted_packages "$1" | xargs dpkg-query -W -f '${db:Status-Abbrev} ${Package}\n' 2>/dev/null |
      awk '$1 == "ii" || $1 == "hi" { print $2 }' | sort)
}

install_packages() {
  if ! command -v dpkg-query apt-get >/dev/null; then
    return 0 # not Debian: what is missing, CMake will say
  fi
  local missing as_root=() log="$root/build/install.log"
  mapfile -t missing < <(missing_packages "$1")
  if ((${#missing[@]} == 0)); then
    return 0
  fi
  local apt=(env DEBIAN_FRONTEND=noninteractive apt-get -q -y -o DPkg::Lock::Timeout=600)
  if ((EUID != 0)); then
    command -v sudo >/dev/null ||
      fail "packages are missing and there is no sudo; as root, run: apt-get install --no-install-recommends ${missing[*]}"
    as_root=(sudo)
  fi
  say "installing ${#missing[@]} packages with apt (log: build/install.log): ${missing[*]}"
  if ! { "${as_root[@]}" "${apt[@]}" update &&
    "${as_root[@]}" "${apt[@]}" install --no-install-recommends "${missing[@]}"; } >"$log" 2>&1 </dev/null; then
    tail -n 30 "$log" >&2
    fail "apt could not install what artcal needs; see above, then run the same command again"
  fi
}

# One job a core, but no more than fit into memory: a source file takes up to 1.5 GB.
job_count() {
  local by_memory cores
  cores=$(nproc)
  by_memory=$(awk '/^MemAvailable:/ { print int($2 / 1500000) }' /proc/meminfo 2>/dev/null)
  by_memory=${by_memory:-$cores}
  ((by_memory < cores)) && cores=$by_memory
  echo $((cores > 0 ? cores : 1))
}

# Ninja's count of steps: on a terminal on one line, in a log a line every ten seconds.
show_progress() {
  if [[ -t 2 ]]; then
    awk '/^\[[0-9]+\/[0-9]+\]/ { printf "\r%s\033[K", $1 > "/dev/stderr" } END { printf "\r\033[K" > "/dev/stderr" }'
    return
  fi
  local line next=$((SECONDS + 10))
  while IFS= read -r line; do
    if ((SECONDS >= next)) && [[ $line =~ ^\[[0-9]+/[0-9]+\] ]]; then
      say "building, step ${BASH_REMATCH[0]}"
      next=$((SECONDS + 10))
    fi
  done
}

# The first errors of a compiler, which come with many lines around them; else the end of the log.
show_errors() {
  grep -m 5 -E '(^|[: ])(fatal )?error:|undefined reference|^ninja: error' "$1" | cut -c 1-300 >&2 || tail -n 20 "$1" >&2
}

configure() {
  local preset=$1 folder="$root/build/$1" fresh=()
  # A folder that was copied or moved still names the old place.
  if [[ -f $folder/CMakeCache.txt ]] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$folder/CMakeCache.txt"; then
    fresh=(--fresh)
  fi
  if [[ -f $folder/build.ninja && $folder/build.ninja -nt $root/CMakePresets.json && ${#fresh[@]} -eq 0 ]]; then
    return 0
  fi
  (cd "$root" && cmake "${fresh[@]}" --preset "$preset")
}

# build_preset PRESET [TARGET]: installs, configures and builds; on return the preset's folder is up to date.
build_preset() {
  local preset=$1 folder="$root/build/$1" log="$root/build/$1.log" target=()
  [[ -n ${2:-} ]] && target=(--target "$2")
  mkdir -p "$root/build" 2>/dev/null || fail "cannot write to $root; copy the project to a folder of your own"
  exec 9>"$root/build/.lock"
  flock 9 # two calls at once: the second waits and finds everything built
  install_packages "$preset"
  if [[ -z ${CMAKE_CXX_COMPILER_LAUNCHER:-} ]] && ccache --print-stats >/dev/null 2>&1; then
    export CMAKE_CXX_COMPILER_LAUNCHER=ccache
    # Without these it does not serve what is compiled with precompiled headers.
    export CCACHE_SLOPPINESS=${CCACHE_SLOPPINESS:-pch_defines,time_macros}
  fi
  say "building the $preset preset (log: build/$preset.log)"
  if ! configure "$preset" >"$log" 2>&1; then
    tail -n 30 "$log" >&2
    fail "CMake could not configure the build; see above (on another system than Debian 12, install what cmake/packages.txt lists)"
  fi
  # The stamp is as old as the start of the build, so that whatever changes meanwhile is newer.
  touch "$folder/.building"
  if ! cmake --build "$folder" "${target[@]}" --parallel "$(job_count)" 2>&1 | tee -a "$log" | show_progress; then
    show_errors "$log"
    fail "the build failed; see above and build/$preset.log"
  fi
  mv "$folder/.building" "$folder/.built"
  exec 9>&-
}
