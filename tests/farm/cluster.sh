#!/bin/sh
# A Slurm cluster on this machine, for tests: nodes of one processor each, all daemons our own and on
# the loopback, no database, no control groups. Nothing outside of FOLDER is changed.
#   cluster.sh up FOLDER NODES   starts it; clients then need SLURM_CONF=FOLDER/slurm.conf
#   cluster.sh down FOLDER       ends it
# FOLDER is new and has a short path, for sockets.
set -u
action=$1
folder=$2
host=$(hostname -s)
user=$(id -un)

write_configuration() {
  first=$((20000 + $$ % 20000)) # ports: the controller's, then one for each node
  cat >"$folder/slurm.conf" <<END
ClusterName=farm
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$first
SlurmUser=$user
SlurmdUser=$user
AuthType=auth/munge
AuthInfo=socket=$folder/munge.socket,cred_expire=5
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool/%n
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/%n.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=sched_min_interval=50000,batch_sched_delay=0
MpiDefault=none
ReturnToService=2
SlurmdTimeout=10
SlurmdParameters=config_overrides
NodeName=n[1-$nodes] NodeHostname=$host NodeAddr=127.0.0.1 Port=$((first + 1))-$((first + nodes)) CPUs=1 RealMemory=2000
PartitionName=render Nodes=ALL Default=YES MaxTime=INFINITE State=UP
END
}

start() {
  mkdir -p "$folder/state" || return
  for i in $(seq "$nodes"); do mkdir -p "$folder/spool/n$i" || return; done
  head -c 1024 /dev/urandom >"$folder/munge.key" && chmod 600 "$folder/munge.key" || return
  write_configuration
  munged --force --key-file="$folder/munge.key" --socket="$folder/munge.socket" \
    --pid-file="$folder/munged.pid" --log-file="$folder/munged.log" \
    --seed-file="$folder/munged.seed" || return
  export SLURM_CONF="$folder/slurm.conf"
  slurmctld || return
  for i in $(seq "$nodes"); do slurmd -N "n$i" || return; done
  for _ in $(seq 150); do
    [ "$(sinfo -h -t idle -o %D 2>/dev/null)" = "$nodes" ] && return
    sleep 0.2
  done
  sinfo
  return 1
}

stop() {
  for file in "$folder"/n*.pid "$folder/slurmctld.pid" "$folder/munged.pid"; do
    if [ -s "$file" ]; then kill "$(cat "$file")" 2>/dev/null; fi
  done
  return 0
}

case $action in
  up) nodes=$3 && start ;;
  down) stop ;;
esac
