#!/bin/sh
# extremes.t - every option of every tool that takes a number, with numbers that nobody means: the
# tool ends within 5 s of processor time and 4 GB, with 0 and a result, with 3 and a reason, or with
# 1 or 2 and one line; no `nan` or `inf` is written.  EXTREMES: the numbers (default: two of them, and
# those at the end); `all`: eleven.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1
values=${EXTREMES:-1e-9 1e9}
[ "$values" != all ] || values='1e-300 1e-9 1e-3 1 37 1000 1e6 999999999 1e9 1e300 -1'

awk 'BEGIN { for (i = 0; i <= 16; i++) for (k = 0; k <= 12; k++) {
	x = 2.5 * i - 20; y = 2.5 * k - 15; print x, y, 10 - (x * x + y * y) / 120 } }' >cloud.xyz
cloud2mesh -q -t 4 cloud.xyz >mesh.ply
meshnorm -q -r 4 --rows mesh --fixed 0.1,0,1 mesh.ply >path.cl
biarcfit -q path.cl >arcs.cl
ncpost -q -c fanuc arcs.cl >program.nc
cp "$SRC/samples/saddle.nurbs" .

# numeric TOOL: its options with a number, each with the name of its value
numeric() {
	"$1" --help all | sed -nE 's/^  (-[A-Za-z], |    )(--[a-z-]+) ([^ ]+).*/\2 \3/p' |
		grep -E ' (MM|DEG|N|P|X|PX|PERCENT|RPM|MM/MIN|auto\|DEG|I,J,K|X,Y,Z|X,Y,Z,I,J,K,R|A:B|K/N|PASS|SPEC|X0,Y0,Z0,X1,Y1,Z1|N,N-M,\.\.\.)$' |
		grep -v '^--threads '
}

# spelled NAME VALUE: the number as the option takes it
spelled() {
	case $1 in
	I,J,K | X,Y,Z) echo "$2,$2,$2" ;;
	X,Y,Z,I,J,K,R) echo "0,0,$2,0,0,1,$2" ;;
	X0,*) echo "-$2,-$2,-$2,$2,$2,$2" ;;
	A:B) echo "0:$2" ;;
	K/N) echo "1/$2" ;;
	SPEC) echo "$2:$2" ;;
	*) echo "$2" ;;
	esac
}

# bad STATUS TOOL: what is wrong with a run that ended so
bad() {
	case $1 in
	0) ;;
	3) grep -qE "UNMET|refused" err out || [ -s err ] || echo "nothing told" ;;
	1) [ "$(grep -c "^$2: " err)" -eq "$(wc -l <err)" ] && [ "$(wc -l <err)" -eq 1 ] ||
		echo "$(wc -l <err) lines told, expected one" ;;
	2) [ "$(grep -c "^$2: " err)" -eq 1 ] || echo "wrong usage told otherwise" ;;
	*) echo "exit status $1" ;;
	esac
	! grep -qE '(^|[^a-zA-Z_])(nan|inf)([^a-zA-Z_]|$)' out || echo "nan or inf"
}

space=4000000 # kB; an address sanitizer takes terabytes for what it knows of the memory
! nm "$BIN/cloud2mesh" 2>/dev/null | grep -q __asan_init || space=unlimited

# bounded COMMAND...: in 5 s of processor time and 4 GB
bounded() {
	# shellcheck disable=SC3045 # every shell here has these
	(ulimit -t 5 && ulimit -v $space && exec "$@") >out 2>told </dev/null
	ended=$?
	grep -v 'WARNING: AddressSanitizer failed to allocate' told >err # it says so itself, too
	return $ended
}

# extremes COMMAND...: all its numeric options
extremes() {
	runs=0
	numeric "$1" >options
	: >found
	while read -r option name <&3; do
		for value in $values; do
			given=$(spelled "$name" "$value")
			bounded "$@" "$option" "$given"
			what=$(bad $? "$1")
			[ -z "$what" ] || echo "$option $given: $what" >>found
			runs=$((runs + 1))
		done
	done 3<options
	cp found err
	[ -s options ] && [ ! -s found ]
	result $? "$1: $runs numbers that nobody means"
}

extremes cloud2mesh -q -j 1 -t 4 cloud.xyz
extremes cloud2surf -q -j 1 -t 8 cloud.xyz
extremes nurbs2mesh -q -j 1 saddle.nurbs
extremes meshnorm -q -j 1 -r 4 --rows mesh mesh.ply
extremes planecut -q -j 1 -r 4 -s 6 mesh.ply
extremes biarcfit -q -j 1 path.cl
extremes bsplfit -q -j 1 path.cl
extremes ncpost -q -j 1 -c siemens arcs.cl
extremes ncverify -q -j 1 -c fanuc -r 4 -g cloud.xyz program.nc
extremes ncplot -q -j 1 path.cl

# one COMMAND...: numbers that go together, or that were slow
one() {
	bounded "$@"
	what=$(bad $? "$1")
	[ -z "$what" ]
	result $? "$*${what:+ ($what)}"
}
one cloud2mesh -q -j 1 -t 4 --extend 1000 cloud.xyz
one cloud2mesh -q -j 1 -t 1e-9 cloud.xyz
one cloud2mesh -q -j 1 -e 1e300 cloud.xyz
one cloud2mesh -q -j 1 -e 1e-9 cloud.xyz
# half of the points on an upright line: each had all others looked at, again and again
awk 'BEGIN { s = 1; for (i = 0; i < 70000; i++) { s = (s * 16807) % 2147483647
	if (i % 2) print 15, 15, s % 20000 / 1000
	else print s % 30000 / 1000, int(s / 30000) % 30000 / 1000, 0 } }' >tower.xyz
one cloud2mesh -q -j 1 -t 1 tower.xyz
one meshnorm -q -j 1 -r 4 --scallop 1e-9 mesh.ply
one meshnorm -q -j 1 -r 1e-3 mesh.ply
one meshnorm -q -j 1 -r 4 --rows mesh --layers 200 --depth 1000 mesh.ply
one planecut -q -j 1 -r 4 -s 6 --layers 200 --depth 1000 mesh.ply
one planecut -q -j 1 -r 4 --scallop 1e-9 mesh.ply
one planecut -q -j 1 -r 4 -s 1e-6 mesh.ply
one biarcfit -q -j 1 --min-length 100 -e 1e9 path.cl
one bsplfit -q -j 1 --min-length 100 -e 1e9 path.cl
one ncverify -q -j 1 -c fanuc -r 4 -g cloud.xyz --stock box --cell 1e-4 program.nc
one ncverify -q -j 1 -c fanuc -r 4 -g cloud.xyz --stock box,1e9 --cell 1 program.nc
one nurbs2mesh -q -j 1 -e 1e-9 saddle.nurbs
done_testing
