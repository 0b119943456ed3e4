#!/bin/sh
# ncpost-selftest.t - the program that shows whether signs and centres of a machine are right: for
# every machine and control the tip stays where it is, and it starts and ends safely.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

# The reader wants a spindle that turns, which a self-test has not
spin() { # CONTROL
	case $1 in
	heidenhain) sed 's/TOOL CALL Z/TOOL CALL 1 Z S100/; 0,/FMAX M91/s// FMAX M91 M3/' ;;
	*) sed '0,/^\(N[0-9]* \)\(G9[01].*\)$/s//\1\2\nM3 S100/' ;;
	esac
}
checked=0
for machine in "$SRC"/machines/*.txt; do
	grep -q '= grbl' "$machine" && continue # too low for it
	machine=$(basename "$machine" .txt)
	for control in fanuc siemens heidenhain linuxcnc; do
		tcp=
		case $machine-$control in
		linuxcnc-*-linuxcnc) ;;
		linuxcnc-*) continue ;;
		*-linuxcnc) tcp=--no-tcp ;;
		esac
		for options in "" "--inch"; do
			# shellcheck disable=SC2086
			ncpost -q --self-test -c $control -m $machine $options >self.nc 2>err ||
				echo "$machine $control: $(cat err)"
			spin $control <self.nc >spun.nc
			"$READBACK" -c $control -m "$machine" $tcp spun.nc >rb 2>&1 ||
				echo "$machine $control $options: $(head -n 1 rb)"
			grep -q '^axes: 0 turns back.* beyond the travel 0, too fast 0' rb || [ -n "$options" ] ||
				echo "$machine $control $options: $(grep axes: rb)"
			# 50 mm down, and then the tip stays
			awk -v m="$machine $control $options" '/mm cut/ { way = $(NF - 2); found = 1 }
				END { if (!found || way < 49.9 || way > 53) print m ": the tip goes " way " mm" }' rb
			# what comes before the tip goes down: the retract; what is last: the retract, spindle off
			awk '/G28 *Z|G53.*Z|SUPA.* Z|Z\+0 .*M91/ { home = NR } /TIP STANDS|tip stands/ { down = NR; up = home }
				/M30| M2$|END PGM/ { if (!end) end = NR }
				END { if (!up || up > down || home < down || !end || home > end) exit 1 }' self.nc ||
				echo "$machine $control $options: no retract at both ends"
			checked=$((checked + 1))
		done
	done
done >complaints
empty "self-tests of all machines for all controls read back" complaints
below "and there are many" 100 "$checked"

# the directions that it tells are where the tool leans, by the formula of A and C
ncpost -q -c fanuc --self-test >self.nc
awk '/LEANS TO/ { side = $5 } { for (i = 1; i <= NF; i++) { if ($i ~ /^A/) a = substr($i, 2)
	if ($i ~ /^C[-0-9]/) c = substr($i, 2) } }
	/M0$/ && side { r = atan2(0, -1) / 180; x = sin(c * r) * sin(a * r); y = -cos(c * r) * sin(a * r)
		far = x * x > y * y ? (x > 0 ? "X+" : "X-") : (y > 0 ? "Y+" : "Y-")
		if (far != side) print "A" a " C" c ": " far ", said " side; side = "" ; n++ }
	END { if (n < 4) print n " directions" }' self.nc >wrong
empty "directions are as told" wrong

done_testing
