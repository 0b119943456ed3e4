#!/bin/sh
# ncpost-matrix.t - CL files of CAM systems for every control and nine machines: each program is read
# back by the tests' own reader of CL files and programs; what a machine cannot do is refused by one
# line that says why, and nothing is written.
#
# Without more, each file and control has one of the machines in turn.  All of them, and other files:
#
#	CLOUDMILL_MATRIX=all CLOUDMILL_CL="FOLDER ..." sh tests/tool/ncpost-matrix.t
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
ncpost() { command ncpost --no-spindle "$@"; }
machines="table-ac table-bc head-table-bc head-ca head-cb nutating-head nutating-head-table nutating-table
	table-ac-notcp"
folders=${CLOUDMILL_CL:-$SRC/tests/data/cl}
cd "$TMP" || exit 1

# What a refusal may say: the machine's travel, or a path that no control can be given.
reasons='expected (its|one within its) travel|which no angles of .* reach'

: >compared
: >refused
one() { # FILE CONTROL MACHINE: nothing where all is well
	ncpost -q -c "$2" -m "$3" -o part.nc "$1" 2>err
	got=$?
	what="$(basename "$1") for $2 on $3"
	if [ $got -eq 0 ]; then
		echo "$what" >>compared
		set -- "$1" "$2" "$3" --path "$1" -e 0.0062 --axis 0.052
		[ "$2" = linuxcnc ] && set -- "$@" --no-tcp
		grep -Eq ' G(73|83) |CYCLE83|CYCL DEF 20[35]' part.nc && set -- "$@" --no-steps
		file=$1 control=$2 machine=$3
		shift 3
		"$READBACK" -c "$control" -m "$machine" "$@" part.nc >"read" 2>&1 && return
		echo "$what: $(grep '^readback: ' read | head -n 1)"
	elif [ -e part.nc ]; then
		echo "$what: exit $got, and something is written"
	elif [ "$(wc -l <err)" -ne 1 ] || ! grep -Eq "$reasons" err; then
		echo "$what: exit $got: $(head -n 3 err)"
	else
		sed "s|^ncpost: .*/|$what: |" err >>refused
	fi
	rm -f part.nc
}
turn=0
for folder in $folders; do
	for file in "$folder"/*.ncl "$folder"/*.cls "$folder"/*.cldata "$folder"/*.apt "$folder"/*.cl; do
		[ -e "$file" ] || continue
		for control in fanuc siemens heidenhain linuxcnc; do
			k=0
			for machine in $machines; do
				k=$((k + 1))
				[ -n "$CLOUDMILL_MATRIX" ] || [ $k -eq $((turn % 9 + 1)) ] || continue
				one "$file" $control $machine
			done
			turn=$((turn + 1))
		done >wrong
		empty "$(basename "$file"): every program that is written is read back" wrong
	done
done
echo "# $(wc -l <compared) programs compared, $(wc -l <refused) refused"
sed 's/^/# /' refused
below "programs" 20 "$(wc -l <compared)"

# The comparison can fail: another path's program is another path
ncpost -q -c fanuc -o part.nc "$SRC/tests/data/cl/nx.cls"
status 3 "a program of another path is none of this one" "$READBACK" -c fanuc -m table-ac \
	--path "$SRC/tests/data/cl/solidworks.apt" -e 0.0062 --axis 0.052 part.nc

done_testing
