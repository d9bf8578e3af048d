# shellcheck shell=bash disable=SC2046,SC2086,SC2116  # lists of processes are split on purpose
# Sourced: a real Slurm of some nodes on loopback, wholly below one folder; nothing under /etc, no
# fixed ports, no control groups. Needs slurmctld, slurmd, slurm-client and munge.

# cluster_up FOLDER NODES: starts it and chooses it for sbatch and its like.
cluster_up() {
  cluster=$1
  local nodes=$2 host base node
  host=$(hostname -s)
  base=$(free_ports $((nodes + 2)))
  mkdir -p "$cluster"/{log,state,spool,run} && mkdir -m 700 "$cluster/munge"
  (umask 077 && head -c 1024 /dev/urandom >"$cluster/munge/munge.key")
  write_configuration "$nodes" "$host" "$base"
  export SLURM_CONF=$cluster/slurm.conf SBATCH_PARTITION=test
  start munged munged --foreground --force --key-file="$cluster/munge/munge.key" \
    --socket="$cluster/run/munge.socket" --pid-file="$cluster/munge/pid" \
    --log-file="$cluster/munge/log" --seed-file="$cluster/munge/seed"
  wait_until 10 test -S "$cluster/run/munge.socket"
  start slurmctld slurmctld -D -c
  for node in $(seq "$nodes"); do
    mkdir "$cluster/spool/n$node"
    start "n$node" slurmd -D -N "n$node"
  done
  wait_until 30 nodes_are_idle "$nodes"
}

# cluster_down: cancels what runs and ends every process of the cluster. Safe to call twice.
cluster_down() {
  [ -n "${cluster:-}" ] || return 0
  timeout 10 scancel --user "$(id -un)" 2>/dev/null || true
  sleep 1
  local name
  for name in "$cluster"/run/*.started; do
    [ -e "$name" ] && end_tree KILL "$(<"$name")"
  done
  local jobs
  jobs=$(job_processes)
  end_tree KILL $(watchers $jobs) $jobs
  cluster=
}

# lose_node nK: ends the node's daemon and everything it runs, as if its power failed.
lose_node() {
  local jobs victims
  jobs=$(job_processes "$1")
  victims=$(echo $(watchers $jobs) $(tree "$(<"$cluster/run/$1.started")" $jobs))
  kill -STOP $victims 2>/dev/null || true # at once: none may tell of another's end
  kill -KILL $victims 2>/dev/null || true
  rm "$cluster/run/$1.started"
}

write_configuration() {
  cat >"$cluster/slurm.conf" <<CONF
ClusterName=test
SlurmctldHost=$2(127.0.0.1)
SlurmctldPort=$3
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthType=auth/munge
CredType=cred/munge
# A job that is started again waits until its old credential has expired: 2 minutes by default.
AuthInfo=socket=$cluster/run/munge.socket,cred_expire=5
# Without these it listens on every address.
CommunicationParameters=NoInAddrAny,NoCtldInAddrAny
StateSaveLocation=$cluster/state
SlurmdSpoolDir=$cluster/spool/%n
SlurmctldPidFile=$cluster/run/slurmctld.pid
SlurmdPidFile=$cluster/run/%n.pid
SlurmctldLogFile=$cluster/log/slurmctld
SlurmdLogFile=$cluster/log/%n
MpiDefault=none
SwitchType=switch/none
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SchedulerParameters=sched_interval=1,sched_min_interval=0,batch_sched_delay=0,bf_interval=1,requeue_delay=1
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
MessageTimeout=3
TCPTimeout=1
SlurmdTimeout=6
KillWait=2
ReturnToService=2
SlurmdParameters=config_overrides
PropagateResourceLimits=NONE
NodeName=n[1-$1] NodeHostname=$2 NodeAddr=127.0.0.1 Port=[$(($3 + 1))-$(($3 + $1))] CPUs=1 State=UNKNOWN
PartitionName=test Nodes=ALL Default=YES State=UP
CONF
  printf 'CgroupAutomount=no\nConstrainCores=no\nConstrainRAMSpace=no\n' >"$cluster/cgroup.conf"
}

# start NAME COMMAND...: in a session of its own; its process id is kept.
start() {
  local name=$1
  shift
  setsid "$@" </dev/null >"$cluster/log/$name.out" 2>&1 &
  echo $! >"$cluster/run/$name.started"
  disown # its end is nothing to tell of
}

nodes_are_idle() { [ "$(sinfo -h -o '%T %D' 2>/dev/null)" = "idle $1" ]; }

# wait_until SECONDS COMMAND...
wait_until() {
  local end=$((SECONDS + $1))
  shift
  until "$@"; do
    [ $SECONDS -lt $end ] || { echo "error: in vain waited for: $*" >&2; return 1; }
    sleep 0.1
  done
}

# tree PID...: these processes and all below them.
tree() {
  local pid
  for pid in "$@"; do
    echo "$pid"
    tree $(ps -o pid= --ppid "$pid")
  done
}

end_tree() {
  local signal=$1
  shift
  kill "-$signal" $(tree "$@") 2>/dev/null || true
}

# job_processes [NODE]: the processes that belong to this cluster's jobs, on one node or all.
job_processes() {
  local process variables
  for process in /proc/[0-9]*; do
    variables=$(tr '\0' '\n' 2>/dev/null <"$process/environ") || continue
    grep -qxF "SLURM_CONF=$cluster/slurm.conf" <<<"$variables" || continue
    grep -q '^SLURM_JOB_ID=' <<<"$variables" || continue
    [ $# -eq 0 ] || grep -qx "SLURMD_NODENAME=$1" <<<"$variables" || continue
    echo "${process#/proc/}"
  done
}

# watchers PID...: the slurmstepds that would report how these ended; no daemon's children.
watchers() {
  [ $# -eq 0 ] || ps -o pid=,args= -p "$(ps -o ppid= -p "$*" | xargs | tr ' ' ',')" |
    awk '$2 == "slurmstepd:" { print $1 }'
}

# free_ports COUNT: the first of so many free neighbours.
free_ports() {
  python3 - "$1" <<'PYTHON'
import random, socket, sys

count = int(sys.argv[1])
for _ in range(200):
    base = random.randrange(20000, 31000)  # below the ports that the system itself hands out
    sockets = [socket.socket() for _ in range(count)]
    try:
        for port, one in enumerate(sockets, base):
            one.bind(("127.0.0.1", port))
        print(base)
        break
    except OSError:
        pass
    finally:
        for one in sockets:
            one.close()
else:
    sys.exit("error: no free ports")
PYTHON
}
