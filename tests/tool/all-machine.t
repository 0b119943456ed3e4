#!/bin/sh
# all-machine.t - the options -m, --set and -c mean the same in every tool that takes them: the same
# messages, the same exit status, the same list of controls.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1
golden=$SRC/tests/data/golden

# tool TOOL ARGS...: runs a tool on what it wants else; a later option overrules an earlier one
tool() {
	name=$1
	shift
	case $name in
	ncpost) ncpost -c fanuc "$@" "$golden/shapes.cl" ;;
	ncverify) ncverify -c fanuc -g scan.xyz -r 4 "$@" shapes.nc ;;
	esac
}

ncpost -q -c fanuc -o shapes.nc "$golden/shapes.cl"
awk 'BEGIN { for (x = -20; x <= 20; x++) for (y = -20; y <= 20; y++) print x, y, -30 }' >scan.xyz
echo 'frob = 1' >frob.txt

takers=
for path in "$BIN"/*; do
	"$path" --help all | grep -q -e '--set KEY=VALUE' && takers="$takers ${path##*/}"
done
ok "ncpost and ncverify take --set" test "$takers" = " ncpost ncverify"

while IFS='|' read -r want desc args; do
	for name in $takers; do
		# shellcheck disable=SC2086
		status "$want" "$name: $desc" tool "$name" $args
		sed "s/^$name: //; /^try /d" err >"said.$name"
	done
	same "$desc: the same message" said.ncpost said.ncverify
done <<'END'
2|a key that is none|--set frob=1
2|a value that is no number|--set a.max=x
2|no value|--set a.max=
2|no key|--set nonsense
2|a value out of its bounds|--set digits.linear=12
2|keys that do not go together|--set a.min=200
2|a control that is none|--set control=nosuch
2|two axes alike|--set axes=AA
2|a template with an unknown word|--set end={frob}
2|a choice of control that is none|-c nosuch
1|a machine that is not there|-m no-such-machine
1|a machine file with a key that is none|-m ./frob.txt
1|and a good key set|-m ./frob.txt --set a.max=90
END
status 1 "ncplot: a machine that is not there" ncplot -m no-such-machine shapes.nc
mkfifo pipe.txt # nobody writes to it: not waited for
status 1 "ncpost: a machine by a pipe" ncpost -m ./pipe.txt -o none shapes.cl
has "is told" 'pipe.txt: found a pipe, expected a file' err
status 0 "ncpost: the last one counts" tool ncpost --set a.max=50 --set a.max=90

# one list: of -c's help, of its message, of a machine file's
ncpost -c nosuch 2>said
names=$(sed -n 's/.*expected \([^ ]*\) or a control file.*/\1/p' said)
ok "the controls are listed" test "$(echo "$names" | tr '|' '\n' | wc -l)" -ge 4
for name in $takers; do
	"$name" --help all >help
	has "$name: -c is there" '^  -c, --control CONTROL' help
	tool "$name" --set control=nosuch 2>said
	has "$name: so has the key control" "expected $(echo "$names" | sed 's/|/\\|/g')" said
done
for control in $(echo "$names" | tr '|' ' '); do
	status 0 "$control: is written" ncpost -c "$control" --set control="$control" -o one "$golden/shapes.cl"
	ncverify -q -c "$control" -g scan.xyz -r 4 one >verdict 2>said
	has "$control: is read" "$control" verdict
done

done_testing
