#!/usr/bin/env bash
# examples/slurm on a cluster of one machine that this test starts: munge, slurmctld and slurmd of Debian's packages, on
# sockets and ports of their own. An array of eight, one task killed and put back, merged: the same bytes as one process.
# Ends with 77, which ctest counts as skipped, where the daemons are not installed.
set -euo pipefail
artcal=$1 source_dir=$2
for program in munged mungekey slurmctld slurmd sbatch scontrol squeue; do
  if ! PATH="$PATH:/usr/sbin" command -v "$program" >/dev/null; then
    echo "SLURM IS NOT INSTALLED ($program): nothing was tested on it" >&2
    exit 77
  fi
done
export PATH="$PATH:/usr/sbin"
work=$(mktemp -d /tmp/artcal-slurm-XXXXXX)
chmod 755 "$work"
started=()
finish() {
  for ((i = ${#started[@]} - 1; i >= 0; --i)); do
    kill "${started[i]}" 2>/dev/null || true
    wait "${started[i]}" 2>/dev/null || true
  done
  rm -rf "$work"
}
trap finish EXIT
fail() {
  echo "FAILED: $*" >&2
  tail -n 20 "$work"/*.log >&2 || true
  exit 1
}
wait_until() { # SECONDS WHAT COMMAND…
  local end=$((SECONDS + $1)) what=$2
  shift 2
  until "$@" >/dev/null 2>&1; do
    ((SECONDS < end)) || fail "$what"
    sleep 0.1
  done
}

me=$(id -un)
mkdir -p "$work"/{state,spool,munge,archive,results}
chmod 755 "$work/munge"
mungekey --create --keyfile "$work/munge.key"
munged --foreground --force --socket "$work/munge/socket" --key-file "$work/munge.key" --pid-file "$work/munge/pid" \
  --log-file "$work/munge/log" --seed-file "$work/munge/seed" >"$work/munged.log" 2>&1 &
started+=($!)
wait_until 20 "munge does not answer" munge --socket "$work/munge/socket" --no-input

host=$(hostname -s)
port=$((20000 + RANDOM % 20000))
cat >"$work/slurm.conf" <<C
ClusterName=artcal
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$port
SlurmdPort=$((port + 1))
SlurmUser=$me
SlurmdUser=$me
AuthType=auth/munge
CredType=cred/munge
AuthInfo=socket=$work/munge/socket,cred_expire=5
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
SwitchType=switch/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=1,batch_sched_delay=0
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
SlurmctldLogFile=$work/slurmctld.log
SlurmdLogFile=$work/slurmd.log
SlurmdParameters=config_overrides
ReturnToService=2
KillWait=1
NodeName=$host NodeAddr=127.0.0.1 CPUs=8 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=10 State=UP
C
# Nothing here is confined, but slurmd loads a plugin all the same: this one starts where no cgroups are mounted too.
echo "CgroupPlugin=cgroup/v1" >"$work/cgroup.conf"
export SLURM_CONF=$work/slurm.conf
slurmctld -D -f "$SLURM_CONF" >"$work/slurmctld.out.log" 2>&1 &
started+=($!)
wait_until 30 "slurmctld does not answer" scontrol ping
slurmd -D -f "$SLURM_CONF" >"$work/slurmd.out.log" 2>&1 &
started+=($!)
wait_until 30 "the node does not come up" bash -c "sinfo -h -o %T | grep -q idle"

for ((i = 0; i < 48; ++i)); do
  cp -r "$source_dir/examples/two-socket-bar" "$work/archive/$i"
  printf 'date = 2026-%02d-%02d\n' $((1 + i / 28)) $((1 + i % 28)) | cat - "$source_dir/examples/two-socket-bar/recording.toml" \
    >"$work/archive/$i/recording.toml"
done
echo broken >"$work/archive/5/recording.toml"

cd "$work"
job=$(ARTCAL=$artcal sbatch --parsable --export=ALL --output="$work/task-%a.log" "$source_dir/examples/slurm/artcal-array.sh" \
  "$work/archive" "$work/results")
wait_until 60 "no task has begun to write" compgen -G "$work/results/shard-*.sqlite"
victim=$(compgen -G "$work/results/shard-*.sqlite" | head -n 1 | sed 's/.*shard-\(.*\)\.sqlite/\1/')
scontrol requeue "${job}_$victim"
put_back() { scontrol show job "${job}_$victim" | grep -q "Restarts=1"; }
wait_until 30 "task $victim was not put back" put_back
# Slurm lets a task that was put back wait until its credential has expired: two minutes, or what cred_expire says.
wait_until 60 "task $victim cannot be started" scontrol update "JobId=${job}_$victim" StartTime=now
done_all() { [[ -z $(squeue -h -j "$job" 2>/dev/null) ]]; }
wait_until 200 "the array does not end" done_all

[[ $(compgen -G "$work/results/shard-*.sqlite" | wc -l) -eq 8 ]] || fail "there are not eight stores"
"$artcal" store merge -q "$work/all.sqlite" "$work"/results/shard-*.sqlite
status=0
"$artcal" batch "$work/archive" --store "$work/single.sqlite" -q || status=$?
((status == 3)) || fail "the single process ended with $status"
"$artcal" store dump "$work/all.sqlite" >"$work/all.txt"
"$artcal" store dump "$work/single.sqlite" >"$work/single.txt"
cmp "$work/all.txt" "$work/single.txt" || fail "the array's results are others than those of one process"
[[ $(grep -c '^\["files"' "$work/all.txt") -eq 48 ]] || fail "not every recording is there"
echo "array of 8, task $victim put back, $(wc -l <"$work/all.txt") rows alike"
