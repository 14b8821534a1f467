#!/bin/sh
# Runs a render node of a cluster whose members are given out by a scheduler, until it gets a signal.
#
#   node.sh FOLDER [options of "lightning node"]
#
# FOLDER is shared by all machines. It has the cluster's certificate, cluster.p12, and while a node runs, a file *.node with its
# address. A node joins the nodes whose files it finds. LIGHTNING is the program (default: lightning), LIGHTNING_BIND the address of this
# machine in the farm's network (default: its first one), LIGHTNING_PORT the port (default: 7800).
set -eu
folder=$1
shift
bind=${LIGHTNING_BIND:-$(hostname -I | cut -d' ' -f1)}
port=${LIGHTNING_PORT:-7800}
own=$folder/$bind-$port.node
log=$folder/$bind-$port.log

# The own file is written before the others are read: of two nodes that start at the same moment, one at least finds the other.
echo "$bind:$port" > "$own.tmp"
mv "$own.tmp" "$own"
for file in "$folder"/*.node; do
    set -- "$@" --join "$(cat "$file")"
done
"${LIGHTNING:-lightning}" node --certificate "$folder/cluster.p12" --bind "$bind" --port "$port" "$@" > "$log" 2>&1 &
node=$!
stop() {
    rm -f "$own"
    kill "$node" 2> /dev/null || true
}
trap 'stop; wait "$node" || true; exit 0' TERM INT HUP
status=0
wait "$node" || status=$?
stop
cat "$log" >&2
exit "$status"
