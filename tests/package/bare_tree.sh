#!/usr/bin/env bash
# Installs the package into a bare Debian 12 tree and does the main job there, with no source tree near.
# bare_tree.sh ARTCAL.deb: needs root, debootstrap and the network; some minutes. Exit code 77: it cannot be done here.
set -euo pipefail
package=$(readlink -f "$1")
if [[ $EUID -ne 0 ]] || ! command -v debootstrap >/dev/null; then
  echo "This test needs root and debootstrap" >&2
  exit 77
fi
tree=$(mktemp -d)
trap 'umount "$tree/proc" 2>/dev/null || true; rm -rf "$tree"' EXIT
mirror=${ARTCAL_DEBIAN_MIRROR:-http://deb.debian.org/debian}
debootstrap --variant=minbase bookworm "$tree" "$mirror" >"$tree.log" 2>&1 || { tail -5 "$tree.log" >&2; exit 77; }
cp "$package" "$tree/tmp/artcal.deb"
cp /etc/resolv.conf "$tree/etc/resolv.conf"
[[ -e /etc/apt/apt.conf ]] && cp /etc/apt/apt.conf "$tree/etc/apt/apt.conf"
mount -t proc proc "$tree/proc" 2>/dev/null || true
inside() { chroot "$tree" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }
inside apt-get -qq update
inside apt-get -qq -y install --no-install-recommends /tmp/artcal.deb >"$tree.log" 2>&1 || { tail -20 "$tree.log" >&2; exit 1; }
inside artcal --version
inside sh -ec 'cd /root && cp -r /usr/share/artcal/examples . &&
  artcal identify examples/ball-bar/recording.toml -o arm.toml --json result.json --report report.html &&
  artcal convert result.json --csv --part lengths -o lengths.csv && test "$(wc -l <lengths.csv)" -gt 10 &&
  artcal verify examples/iso10360-12/recording.toml --arm arm.toml --quiet
  artcal batch examples --store s.sqlite --quiet || test $? = 1  # one of the examples does not conform
  artcal store dump s.sqlite | grep -q recordings'
for file in man1/artcal-identify.1.gz; do test -s "$tree/usr/share/man/$file"; done
# minbase leaves out documentation only where dpkg is told to
test -s "$tree/usr/share/doc/artcal/README.md"
test -s "$tree/usr/share/bash-completion/completions/artcal"
rm -f "$tree.log"
echo "installed, identified, verified"
