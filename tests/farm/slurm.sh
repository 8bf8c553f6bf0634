#!/bin/sh
# Renders 64 tiles on the 4 nodes of a Slurm cluster of its own, as README.txt says: an array of
# tasks and a merge that waits for them. One task fails at first, a node dies under one, and one is
# cancelled: then the merge refuses, and the task is run again. The merged picture is compared with
# a single run. slurm.sh PROGRAM; ends with status 77 where Slurm is not installed.
program=${1:?the program}
here=$(CDPATH= cd -- "$(dirname -- "$0")" && pwd) || exit 1
tiles=64 arguments='-input scene.txt -size 160 120 -bounces 8'
failing=5 dying=20 cancelled=33

for tool in munged slurmctld slurmd sbatch; do
  PATH=$PATH:/usr/sbin command -v $tool >/dev/null && continue
  echo "skipped: $tool is not installed (Debian: apt-get install slurm-wlm munge)"
  exit 77
done
if [ "$(id -u)" -ne 0 ]; then
  echo 'skipped: slurmd, which starts the nodes of the cluster, has to be run by root'
  exit 77
fi
PATH=$PATH:/usr/sbin
work=$(mktemp -d /tmp/farm.XXXXXX) || exit 1
cluster=$work/cluster

finish() {
  sh "$here/cluster.sh" down "$cluster"
  sleep 1
  rm -rf "$work"
}
trap finish EXIT

fail() {
  echo "failed: $1"
  tail -n 20 "$cluster/slurmctld.log" "$work"/*.log 2>/dev/null
  exit 1
}

# wait_for SECONDS COMMAND...: until it succeeds.
wait_for() {
  left=$(($1 * 5))
  shift
  until "$@" >/dev/null 2>&1; do
    left=$((left - 1))
    [ $left -gt 0 ] || fail "waited in vain for: $*"
    sleep 0.2
  done
}

ended() { ! squeue -h -j "$1" | grep -q .; }

parent() { ps -o ppid= -p "$1" | tr -d ' '; }

# The program; but one task fails the first time, and two wait for what is done to them.
write_program() {
  cat >"$work/raytracer" <<END
#!/bin/sh
case "\$*" in
  *'-tile $failing $tiles'*) [ -e failed ] || { : >failed && exit 1; } ;;
  *'-tile $dying $tiles'*) [ -e dying ] || { echo \$\$ \$SLURMD_NODENAME >dying && exec sleep 600; } ;;
  *'-tile $cancelled $tiles'*) [ -e waiting ] || { : >waiting && exec sleep 600; } ;;
esac
exec '$program' "\$@"
END
  chmod +x "$work/raytracer"
}

# The node's daemon, the one that looks after the task, and the task's processes, all at once.
kill_node() {
  read -r process node <dying
  shell=$(parent "$process")
  kill -9 "$(cat "$cluster/$node.pid")" "$(parent "$shell")" "$shell" "$process"
}

sh "$here/cluster.sh" up "$(mkdir "$cluster" && echo "$cluster")" 4 || fail 'the cluster'
export SLURM_CONF="$cluster/slurm.conf"
cd "$work" || exit 1
cp "$here"/../../scenes/*.obj "$here"/*.sbatch .
cp "$here/../../scenes/06_mirror_balls.txt" scene.txt
write_program
export RAYTRACER="$work/raytracer"

# The recipe of README.txt. $arguments is a list of words.
job=$(sbatch --parsable --array=1-$tiles tile.sbatch $tiles $arguments) || fail 'sbatch'
merge=$(sbatch --parsable --dependency=afterany:"$job" merge.sbatch out.tga) || fail 'sbatch'

wait_for 120 [ -s dying ]
kill_node
wait_for 120 [ -e waiting ]
scancel "${job}_$cancelled"
wait_for 300 ended "$job"
wait_for 60 ended "$merge"
[ ! -e out.tga ] || fail 'a picture was merged although a tile is missing'
# Tile 33 of 64 in 120 rows: from 32 * 120 / 64 = 60 to 33 * 120 / 64 - 1, rounded down: 60.
grep -q 'no part holds row 60; ' merge.log || fail 'the merge does not name the missing row'
[ "$(ls parts | wc -l)" -eq $((tiles - 1)) ] || fail 'more tiles are missing than the cancelled one'
[ -e failed ] || fail 'no task had to be tried again'

# The cancelled task again, and the merge.
job=$(sbatch --parsable --array=$cancelled tile.sbatch $tiles $arguments) || fail 'sbatch'
merge=$(sbatch --parsable --dependency=afterok:"$job" merge.sbatch out.tga) || fail 'sbatch'
wait_for 120 ended "$job"
wait_for 60 ended "$merge"

"$program" $arguments -output whole.tga || fail 'the single run'
cmp out.tga whole.tga || fail 'the merged picture is another one than that of a single run'
echo "Slurm: $tiles tiles on 4 nodes, one tried again, one after its node had died, one cancelled" \
  'and run again; the merged picture is that of a single run'
