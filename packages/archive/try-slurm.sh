#!/bin/sh
# A real Slurm on this machine, of one node, and a run of the archive on it through dask-jobqueue. By hand, as root, in a container or a machine that
# you can throw away: apt-get install slurm-wlm munge; pip install 'volume-view-archive[slurm]' and volume-view-prepare on the PATH, or PREPARE set.
#   try-slurm.sh FOLDER SITE
set -eu
node=$(hostname -s)
mkdir -p /etc/slurm /run/munge /var/spool/slurmd /var/spool/slurmctld
[ -f /etc/munge/munge.key ] || mungekey
chown -R munge /etc/munge /run/munge /var/lib/munge /var/log/munge
pgrep -x munged >/dev/null || su -s /bin/sh munge -c munged
cat >/etc/slurm/slurm.conf <<CONF
ClusterName=one
SlurmctldHost=$node
SlurmUser=root
AuthType=auth/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmdSpoolDir=/var/spool/slurmd
StateSaveLocation=/var/spool/slurmctld
ReturnToService=2
NodeName=$node CPUs=$(nproc) RealMemory=2000 State=UNKNOWN
PartitionName=all Nodes=$node Default=YES MaxTime=INFINITE State=UP
CONF
pgrep -x slurmctld >/dev/null || slurmctld
pgrep -x slurmd >/dev/null || slurmd
for _ in 1 2 3 4 5 6 7 8 9 10; do sinfo -h -o %t | grep -q idle && break; sleep 1; done
sinfo
python3 -m volume_view_archive "$1" --out "$2" --cluster slurm --workers 2 ${PREPARE:+--prepare "$PREPARE"} \
  --slurm '{"queue": "all", "memory": "900MB", "walltime": "00:20:00", "interface": "lo"}' -- --poster 0 &
run=$!
sleep 15
squeue
wait $run
