#!/usr/bin/env bash
# A picture in shards on a Slurm cluster: one array task a shard, then one job that joins them.
#
#     shards=$(sbatch --parsable --array=1-64 docs/scale/slurm.sh scene.json /shared/out)
#     sbatch --dependency=afterok:$shards --wrap "raywalk merge /shared/out/*.part -o /shared/out/picture.png"
#
#SBATCH --job-name=raywalk
#SBATCH --cpus-per-task=8
#SBATCH --mem=4G
#SBATCH --time=02:00:00
# A task whose node fails, or that is preempted, is begun again and goes on from its checkpoint.
#SBATCH --requeue
set -u
scene=$1
folder=$2
mkdir -p "$folder"
raywalk render "$scene" --shard "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT" --resume --threads "$SLURM_CPUS_PER_TASK" \
    --progress never --output "$folder/$SLURM_ARRAY_TASK_ID.part"
code=$?
# 3: the machine said no (memory, disk, a file that can't be read): another node may do better. Anything else would be the same there.
if [ "$code" = 3 ]; then scontrol requeue "${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID"; fi
exit "$code"
