#!/bin/bash
# A Slurm job array that runs an archive, one part a task, each into a store of its own:
#
#     sbatch --array=0-7 artcal-array.sh /archive /results
#     artcal store merge /results/all.sqlite /results/shard-*.sqlite
#
# artcal takes the part from SLURM_ARRAY_TASK_ID and _COUNT. A task that was killed, or whose node was lost, is put back
# by Slurm (--requeue) and goes on where it was (--resume); the same array again does what is new. Recordings that were
# refused make a task end with exit code 3; they are in the store, and all others as well.
# For one common store give postgresql://… in place of the file and leave out the merging.
#SBATCH --job-name=artcal
#SBATCH --array=0-7
#SBATCH --cpus-per-task=1
#SBATCH --requeue
#SBATCH --open-mode=append
set -eu
archive=$1 results=$2
mkdir -p "$results"
exec "${ARTCAL:-artcal}" batch "$archive" --store "$results/shard-$SLURM_ARRAY_TASK_ID.sqlite" --resume \
  --jobs "${SLURM_CPUS_PER_TASK:-1}"
