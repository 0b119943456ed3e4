#!/bin/sh
# ncverify-rounding.t - a program that lets the control leave the path at corners by more than its
# head says: by what stands in the block that says so, in the program's unit.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

awk 'BEGIN { for (x = -6; x <= 6; x += 0.4) for (y = -6; y <= 6; y += 0.4)
	print x, y, sin(x / 3) * cos(y / 4) }' >scan.xyz
cloud2mesh -q -o scan.ply scan.xyz
meshnorm -q -r 2 --scallop 0.05 --avoid -o path.cl scan.ply

program() { # CONTROL ARGS...
	control=$1
	shift
	ncpost -q -m table-ac -c "$control" "$@" -o good.nc path.cl
	status 0 "$control $*: a program" ncverify -q -g scan.xyz good.nc
}
refused() { # WHAT: bad.nc
	status 3 "$control: $1" ncverify -g scan.xyz bad.nc
	has "... which is told" 'corners may be rounded by .*, the head says at most 0.0[0-9]* mm' err
}
amid() { # BLOCK: behind the 200th of good.nc
	sed "200a\\
$1" good.nc >bad.nc
}

for unit in "" --inch; do
	program linuxcnc $unit
	sed 's/ G64 P[0-9.]*/ G64 P0.2/' good.nc >bad.nc
	refused "0.2 in its head"
	sed 's/ G64 P[0-9.]*/ G64/' good.nc >bad.nc
	refused "any length"
	has "... as it is" 'G64 without P' err
	amid 'G64 P5'
	refused "5 amid it"
	sed 's/ G64 P[0-9.]*/ G64 P0.00005/' good.nc >bad.nc
	status 0 "less than its head says" ncverify -q -g scan.xyz bad.nc
done
program mach3 --set smooth=yes
program haas --set smooth=yes
sed 's/G187 P3 E[0-9.]*/G187 P3 E1./' good.nc >bad.nc
refused "G187"
program siemens --set smooth=yes
sed 's/CYCLE832([0-9.]*,11/CYCLE832(5,11/' good.nc >bad.nc
refused "CYCLE832"
program siemens
amid 'G641 ADIS=5'
refused "ADIS"
for block in CTOL=1 'COMPCAD CTOL=1 OTOL=10' 'G642 CTOL=1'; do
	amid "$block"
	refused "$block"
done
for block in OTOL=10 ATOL=10; do
	amid "$block"
	status 3 "siemens: $block" ncverify -g scan.xyz bad.nc
	has "... which is told" 'the axis may turn 10 degrees off the path.s, expected 2 at most' err
done
program heidenhain --set smooth=yes
sed 's/\(CYCL DEF 32.1 T\)0[0-9.]*/\15/' good.nc >bad.nc
refused "CYCL DEF 32"
done_testing
