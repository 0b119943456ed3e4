#!/bin/sh
# all-bad.t - bad machine files and bad CL files, the pages in bad/: each is refused with one line
# that says where, what was found and what was expected, and nothing is written.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
# Paths here need not name a speed of the spindle and a tool: ncpost-missing.t has those that lack them.
ncpost() { command ncpost --no-spindle "$@"; }
cd "$TMP" || exit 1

# The cases of a page into files, their names into a list
pages() { # KIND
	awk -v kind="$1" '
		/^== / { file = sprintf("%s-%03d", kind, ++n); print file "\t" substr($0, 4) >(kind ".list")
			printf "" >file; next }
		{ print >file }' "$SRC/tests/data/bad/$1.txt"
}
pages machines
pages paths
printf 'GOTO/0,0,9\nFINI\n' >good.cl
printf 'GOTO/0,0,9\nGOTO/\000\001\002\nFINI\n' >paths-900
printf 'paths-900\tbytes of no text\n' >>paths.list
head -c 3000 "$BIN/ncpost" >paths-901
printf 'paths-901\ta program of the machine\n' >>paths.list
printf 'name = A\n\000\001\n' >machines-900
printf 'machines-900\tbytes of no text\n' >>machines.list
{ printf 'GOTO/'; head -c 300000 /dev/zero | tr '\000' 9; printf ',0,0\nFINI\n'; } >paths-902
printf 'paths-902\ta number of 300000 digits\n' >>paths.list

refused() { # NAME PLACE COMMAND...
	name=$1
	place=$2
	shift 2
	run "$@"
	[ "$got" -eq 1 ] || echo "$name: exit $got"
	[ ! -s out ] || echo "$name: something was written"
	[ "$(wc -l <err)" -eq 1 ] || echo "$name: more or less than one line: $(head -c 300 err)"
	grep -Eq "^ncpost: $place.*(found|cannot open|ends ).*" err || echo "$name: $(head -c 200 err)"
	[ "$(wc -c <err)" -le 420 ] || echo "$name: a very long line"
}
while IFS='	' read -r file name; do
	cp "$file" bad.txt
	refused "$name" '[./]*bad\.txt:[1-9][0-9]*: ' ncpost -q -c fanuc -m ./bad.txt good.cl
done <machines.list >complaints
empty "machine files: $(wc -l <machines.list), each refused in its line" complaints
while IFS='	' read -r file name; do
	cp "$file" bad.cl
	refused "$name" 'bad\.cl:([1-9][0-9]*:)? ' ncpost -q -c fanuc bad.cl
done <paths.list >complaints
empty "CL files: $(wc -l <paths.list), each refused in its line" complaints
while IFS='	' read -r file name; do
	cp "$file" bad.cl
	refused "$name" 'bad\.cl:([1-9][0-9]*:)? ' ncpost -q -c siemens -o part.mpf bad.cl
	[ ! -e part.mpf ] || echo "$name: left a file"
done <paths.list >complaints
empty "nor is a file left" complaints
below "cases on both pages" 100 "$(cat machines.list paths.list | wc -l)"

# Every key of the manual: from the command line it says what it says in a file, and nonsense is
# refused by the name of the option, as wrong usage
cat >keys <<'END'
name = Mill 7
control = siemens
type = head-table
axes = C A
axis.A = -1 0 0
axis.B = 0 -1 0
axis.C = 0 0 -1
centre.A = 0 0 20
centre.B = 1 2 3
centre.C = 5 0 0
tcp = no
cycles = no
cutcom = yes
tap = M29 S{rpm}
plane = yes
plane.on = G68.2 X0
plane.off = G69
feeds = combined
feed.max = 300
arcs = no
arcs.space = yes
splines = no
vectors = no
x.min = -300
x.max = 300
y.min = -300
y.max = 300
z.min = -300
z.max = 300
a.min = -40
a.max = 40
b.min = -40
b.max = 40
c.min = -200
c.max = 200
rapid = 5000
a.rapid = 900
b.rapid = 900
c.rapid = 900
retract = 33
offset = G55
home = G53 Z-1.
start = M11
end = M12
tool.change = T{tool} M16
tcp.on = G43.4 H9
tcp.off = G49.1
smooth = yes
smooth.on = G5.1 Q1
smooth.off = G5.1 Q0
number.step = 5
number.max = 999
digits.linear = 4
digits.angle = 4
digits.vector = 7
digits.knot = 4
digits.feed = 2
arcs.tcp = no
dwell = G4 P{seconds}
x.acceleration = 2000
y.acceleration = 2000
z.acceleration = 2000
a.acceleration = 500
b.acceleration = 500
c.acceleration = 500
x.jerk = 30000
y.jerk = 30000
z.jerk = 30000
a.jerk = 9000
b.jerk = 9000
c.jerk = 9000
smoothing = 0.1
tcp.frame = stands
length.off = z
length.off.z = 300
rotary.words = 0-360
tool.names = yes
tool.next = yes
tool.stop = yes
tool.1.length = 90
tool.1.name = BALL8
tools = lengths.tbl
offset.1 = G56
aux.1 = M88
safe = G69
clamp.on = M10
clamp.off = M11
coolant.on = M50
coolant.mist = M52
coolant.off = M59
coolant.thru = M51
coolant.air = M53
spindle.cw = M13
spindle.ccw = M14
spindle.off = M15
stop = M0
stop.optional = M1
block.skip = yes
slows = no
END
sed -n 's/\\&//g; s/^\.It Cm \([a-z.A-Z ,]*\)= .*/\1/p' "$SRC/man/cloudmill-machine.5" | tr -d ' ' |
	sed 's/NsArn/1/; s/NsCm//' | tr , '\n' | grep -v '^include$' | sort >told
printf '1 90\n' >lengths.tbl
sed 's/ =.*//' keys | sort >known
same "every key of the manual is tried" told known
path=$SRC/tests/data/golden/shapes.cl
: >complaints

# alike FILE FILE: the same program, whatever its head says of where the keys are from
alike() {
	grep -Ev '^(N[0-9]+ )?\((MACHINE|SET): ' "$1" >one.body
	grep -Ev '^(N[0-9]+ )?\((MACHINE|SET): ' "$2" | cmp -s - one.body
}
while read -r line; do
	printf 'include = table-ac\n%s\n' "$line" >one.txt
	ncpost -q -c fanuc -m ./one.txt -o file.nc "$path" 2>err
	file=$?
	ncpost -q -c fanuc --set "$line" -o set.nc "$path" 2>err
	[ $? -eq $file ] || echo "$line: another exit status"
	[ $file -ne 0 ] || alike file.nc set.nc || echo "$line: not as in a file"
	[ $file -eq 0 ] || [ $file -eq 3 ] || grep -Eq "one within its travel|no angles of" err ||
		echo "$line: exit $file"
	key=${line%% *}
	case $key in
	name | offset | home | start | end | tap | dwell | tool.change | tool.1.name | offset.1 | aux.1 | safe | coolant.* | spindle.* | stop* | *.on | *.off) bad= ;;
	tool.1.length | tools) continue ;;
	control | axes) continue ;;
	*) bad=x ;;
	esac
	run ncpost -q -c fanuc --set "$key = $bad" "$path"
	[ "$got" -eq 2 ] || echo "$key = $bad: exit $got"
	grep -q "^ncpost: --set: .*$key" err || echo "$key = $bad: $(cat err)"
done <keys >complaints
empty "every key by --set" complaints

# What a file may be: a mark of UTF-8 at its start, lines of DOS, no end of the last one, no key
for text in '\357\273\277retract = 60\n' 'retract = 60\r\n' 'retract = 60' '\n\t\nretract=60 # mm' \
	'include = table-ac\r\n\r\nretract = 60\r\n'; do
	# shellcheck disable=SC2059
	printf "$text" >fine.txt
	ncpost -q -c fanuc -m ./fine.txt -o fine.nc good.cl || echo "$text"
	ncpost -q -c fanuc --set retract=60 -o set.nc good.cl
	alike set.nc fine.nc || echo "$text: another program"
done >complaints 2>&1
empty "files of all systems" complaints

done_testing
