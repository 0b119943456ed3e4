#!/bin/sh
# ncpost-parts.t - programs in parts and from a pass on: each part has the tool, speed, coolant and
# plane that the whole has at the same place, starts and ends in the clear, and together they cut
# all.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
# Paths here need not name a speed of the spindle and a tool: ncpost-missing.t has those that lack
# them.
ncpost() { command ncpost --no-spindle "$@"; }
cd "$TMP" || exit 1

# Four tools, two speeds, coolant on, mist and off, six passes; and the same leaning by two angles
work() { # AXIS1 AXIS2
	awk -v first="$1" -v second="$2" '
	function go(x, y, z) { printf "GOTO/%.3f,%.3f,%.3f,%s\n", x, y, z, axis }
	BEGIN {
		print "UNITS/MM\nMULTAX/ON"
		for (t = 1; t <= 4; t++) {
			axis = t < 3 ? first : second
			printf "LOADTL/%d\nCUTTER/%d\nSPINDL/RPM,%d,CLW\n", t, 4 + t, 1000 * t
			print t == 2 ? "COOLNT/MIST" : t == 4 ? "COOLNT/OFF" : "COOLNT/ON"
			for (k = 1; k <= 3; k++) {
				printf "$$-> PASS/%d\nRAPID\n", ++pass; go(10 * t, 5 * k, 60)
				print "FEDRAT/MMPM," 100 * pass
				for (i = 0; i < 9; i++) go(10 * t + i, 5 * k + (i % 2) / 3, -i / 5)
				if (k == 2) printf "SPINDL/RPM,%d,CCLW\n", 1000 * t + 500
				print "RAPID"; go(10 * t + 8, 5 * k, 60)
			}
		}
		print "FINI"
	}'
}
work 0,0,1 0,0,1 >flat.cl
work 0,0,1 0,0.6,0.8 >planes.cl

# Each place at feed with the tool, speed, sense, coolant and plane in force there
# shellcheck disable=SC2016
places='
	BEGIN { coolant = "M9" }
	function value(letter,  at) {
		at = match(" " $0 " ", " " letter "[-+]?[0-9.]+ ")
		return at ? substr(" " $0 " ", RSTART + 2, RLENGTH - 3) + 0 : now[letter]
	}
	/^\(|^;|^[0-9]+ ;/ { next }
	match($0, /(T|TOOL CALL )[0-9]+( D1)?( M6| Z)/) {
		tool = substr($0, RSTART); gsub(/[^0-9 ].*D1|[A-Z]|6$/, "", tool)
		match($0, /(T|CALL )[0-9]+/); tool = substr($0, RSTART, RLENGTH); gsub(/[^0-9]/, "", tool) }
	match($0, / S[0-9]+/) { speed = substr($0, RSTART + 2, RLENGTH - 2) }
	/ M[345]( |$)/ { match($0, / M[345]( |$)/); sense = substr($0, RSTART + 1, 2) }
	/ M[789]( |$)/ { match($0, / M[789]( |$)/); coolant = substr($0, RSTART + 1, 2) }
	/G68\.2|CYCLE800\(0|PLANE SPATIAL/ { plane = $0; sub(/^N?[0-9]+ /, "", plane) }
	/G28|G53|SUPA|M91|M6/ { next }
	/ G0( |$)|FMAX/ { rapid = 1 }
	/ G1( |$)/ || (/^[0-9]+ L/ && !/FMAX/) { rapid = 0 }
	/ [XYZABC][-+]?[0-9]/ && !/G68|PLANE/ {
		for (k = 1; k <= 5; k++) { l = substr("XYZAC", k, 1); now[l] = value(l) }
		if (!rapid) printf "%.3f %.3f %.3f %.3f %.3f T%s S%s %s %s %s\n", now["X"], now["Y"], now["Z"],
			now["A"], now["C"], tool, speed, sense, coolant, plane
	}'
among() { # the first file is part of the second, in its order
	awk 'NR == FNR { want[++n] = $0; next } $0 == want[i + 1] { i++ } END { print n - i }' "$1" "$2"
}
for control in fanuc siemens heidenhain linuxcnc; do
	for path in flat planes; do
		[ $control$path = linuxcncplanes ] && continue
		options=
		[ $path = planes ] && options=--plane
		# shellcheck disable=SC2086
		ncpost -q -c $control $options $path.cl >whole.nc
		awk "$places" whole.nc >whole
		for limit in 64 3k; do
			rm -f part-*
			# shellcheck disable=SC2086
			ncpost -q -c $control $options --split $limit -o part.nc $path.cl 2>err || cat err
			: >parts
			n=1
			while [ -e part-$n.nc ]; do
				awk "$places" part-$n.nc >>parts
				[ $control = linuxcnc ] || "$READBACK" -c $control part-$n.nc >rb 2>&1 || head -n 1 rb
				n=$((n + 1))
			done
			[ $n -gt 3 ] || echo "$control $path $limit: $n parts"
			left=$(among whole parts)
			[ "$left" = 0 ] ||
				echo "$control $path --split $limit: $left of $(wc -l <whole) places not there"
		done
		for pass in 1 2 6 12; do
			# shellcheck disable=SC2086
			ncpost -q -c $control $options --from $pass $path.cl >from.nc 2>err || cat err
			awk "$places" from.nc >from
			total=$(wc -l <whole)
			tail -n $((total - (pass - 1) * 9)) whole >later
			[ "$total" -eq 108 ] || echo "$control $path: $total places"
			left=$(among later from)
			[ "$left" = 0 ] || echo "$control $path --from $pass: $left places not there"
			[ "$(wc -l <from)" -le $(($(wc -l <later) + 1)) ] || echo "$control $path --from $pass: too many"
		done
	done
done >complaints
empty "parts and restarts have the whole's tool, speed, coolant and plane at every place" complaints

# statements alone make no part: many before the first motion, behind a tool and behind the last one
awk 'BEGIN { print "UNITS/MM\nLOADTL/1"
	for (i = 0; i < 100; i++) print "PPRINT BEFORE " i
	print "RAPID\nGOTO/0,0,9\nFEDRAT/100"; for (i = 0; i < 60; i++) print "GOTO/" i ",0,0"
	print "LOADTL/2"; for (i = 0; i < 40; i++) print "PPRINT BETWEEN " i
	print "RAPID\nGOTO/0,0,9"; for (i = 0; i < 60; i++) print "GOTO/" i ",0,0"
	for (i = 0; i < 60; i++) print "PPRINT BEHIND " i; print "FINI" }' >said.cl
status 1 "no room for what is said before the first motion" \
	ncpost -q -c fanuc --split 60 -o said.nc said.cl
rm -f said*.nc
status 0 "with room" ncpost -q -c fanuc --split 160 -o said.nc said.cl
for part in said-*.nc; do
	grep -Eq ' X[0-9]' "$part" || echo "$part goes nowhere"
done >nowhere
empty "each part goes somewhere" nowhere

# every part cuts, starts with a retract and ends with one: over tools, planes, turns back inside of
# cuts, and many rapids in a row
awk 'BEGIN { r = atan2(0, -1) / 180; t = 50 * r
	print "UNITS/MM\nMULTAX/ON\nCUTTER/8,4,0,4,0,0,60\nLOADTL/1\nSPINDL/RPM,8000,CLW\n$$-> CLOUDMILL/1"
	for (pass = 1; pass <= 3; pass++) {
		print "$$-> PASS/" pass
		for (i = 0; i < 25; i++) printf "RAPID\nGOTO/%d,%d,90,0,0,1\n", i, pass
		print "RAPID"
		for (k = 0; k <= 100; k++) { w = k * 10 * r; s = sin(t)
			if (k == 1) print "FEDRAT/MMPM,700"
			printf "GOTO/%.6f,%.6f,%.6f,%.9f,%.9f,%.9f\n", 30 * cos(w), 30 * sin(w), (k ? 0 : 60) - k / 9,
				s * cos(w), s * sin(w), cos(t) }
		printf "RAPID\nGOTO/%.6f,%.6f,70,%.9f,%.9f,%.9f\n", 40 * cos(w), 40 * sin(w),
			s * cos(w), s * sin(w), cos(t)
	}
	for (i = 0; i < 20; i++) printf "RAPID\nGOTO/%d,3,90,0,0,1\n", i
	print "FINI" }' >wound.cl
for control in fanuc siemens heidenhain linuxcnc; do
	for path in flat planes wound; do
		options="--set a.min=-30 --set c.min=-360 --set c.max=360"
		[ $path$control = planeslinuxcnc ] && continue
		[ $path = planes ] && options=--plane
		for limit in 70 131 3k; do
			rm -f part-*
			# shellcheck disable=SC2086
			ncpost -q -c $control $options --split $limit -o part.nc $path.cl 2>err || { cat err; continue; }
			n=1
			while [ -e part-$n.nc ]; do
				# without tool-centre-point control a rapid alone may be more blocks than a part has
				[ $control = linuxcnc ] ||
					grep -Eq '(^| )G0?1( |$)|^[0-9]+ L .*F[0-9]' part-$n.nc ||
					echo "$control $path $limit: part $n cuts nothing"
				[ "$(grep -Ec 'G28 *Z|G53.*Z0|SUPA.* Z|Z\+0 .*M91' part-$n.nc)" -ge 2 ] ||
					echo "$control $path $limit: part $n has no retract at one end"
				tcp=
				[ $control = linuxcnc ] && tcp=--no-tcp
				set -- --set a.min=-30 --set c.min=-360 --set c.max=360
				[ $path = planes ] && set -- --set a.min=-120
				"$READBACK" -c $control -m table-ac $tcp "$@" part-$n.nc >rb 2>&1 || head -n 1 rb
				[ $path = planes ] || grep -q 'beyond the travel 0' rb ||
					echo "$control $path $limit $n: $(grep axes: rb)"
				n=$((n + 1))
			done
			[ $n -gt 2 ] || echo "$control $path $limit: $n parts"
		done
	done
done >complaints
empty "every part cuts, and starts and ends in the clear" complaints

# a part that begins with another tool does not turn it at the speed of the one before
awk 'BEGIN { print "UNITS/MM\nCUTTER/6"; split("3 7 9", tool); split("4200 9000 1500", speed)
	for (t = 1; t <= 3; t++) {
		print "LOADTL/" tool[t] "\nSPINDL/RPM," speed[t] ",CLW\nRAPID\nGOTO/0,0,50\nFEDRAT/300"
		for (i = 0; i < 40; i++) print "GOTO/" i % 2 "," i ",-1"
		print "RAPID\nGOTO/0,40,50"
	}
	print "FINI" }' >tools.cl
for control in fanuc siemens heidenhain linuxcnc; do
	rm -f part-*
	ncpost -q -c $control --split 60 -o part.nc tools.cl
	cat part-*.nc | awk '{ for (i = 1; i <= NF; i++) {
			if ($i ~ /^T[0-9]+$/) tool = substr($i, 2)
			if ($0 ~ /TOOL CALL/ && $i == "CALL") tool = $(i + 1)
			if ($i ~ /^S[0-9]+$/ &&
				$i != (tool == 3 ? "S4200" : tool == 7 ? "S9000" : "S1500")) print tool, $0
		} if (/TOOL CALL|M6/) n++ } END { if (n < 4) print n " parts" }'
done >complaints
empty "each part has its tool's own speed" complaints

# an earlier run had more parts: a control would go on with them
rm -f part-*
ncpost -c fanuc --split 60 -o part.nc tools.cl 2>err
hasnt "parts that are all new" 'was there before' err
cp part-3.nc part-9.nc
mkfifo pipe
status 2 "parts of what is no file" ncpost -c fanuc --split 60 -o pipe tools.cl
has "are named" 'found -o pipe, which is no file' err
ok "and none is written" test ! -e pipe-1
run ncpost -c fanuc --split 400 -o part.nc tools.cl
has "parts of an earlier run are named" "part-[0-9].nc was there before and is no part of this" err

# A rapid move over two hills that is deleted, and the blocks numbered anew: the way at rapid is
# shorter than the head says, which of parts is that of the whole.
awk 'BEGIN { for (y = -8; y <= 8.001; y += 0.5) for (x = -20; x <= 20.001; x += 0.5) {
	d = x < 0 ? x + 10 : x - 10
	printf "%.5f %.5f %.5f\n", x, y, 20 - (d * d * d * d / 100 + y * y) / 12 } }' >hills.xyz
cloud2mesh -q -t 2 -o hills.ply hills.xyz
meshnorm -q -r 3 --scallop 0.2 --avoid -o hills.cl hills.ply
meshnorm -q -r 3 --scallop 0.5 --avoid --layers 2 --depth 1 -o layers.cl hills.ply
ncpost -q -c fanuc --split 150 -o layer.nc layers.cl
status 0 "a part that cuts in the upper layer alone" ncverify -g hills.xyz layer-2.nc
has "is told" 'notice: .*comes near no point of the part; another layer may' err
for control in fanuc siemens heidenhain linuxcnc; do
	machine=table-ac
	[ $control = linuxcnc ] && machine=linuxcnc-xyzac
	ncpost -q -c $control -m $machine -o hills.nc hills.cl
	status 0 "$control: a program over two hills" ncverify -q -g hills.xyz hills.nc
	rm -f hill-*
	ncpost -q -c $control -m $machine --split 600 -o hill.nc hills.cl
	for part in hill-*; do # beside which the others cut
		status 0 "$control: $part is accepted" ncverify -g hills.xyz "$part"
		has "$control: what it leaves is told" 'notice: .* left at .*; another part may cut it' err
		status 0 "$control: $part is accepted beside the whole path" \
			ncverify -g hills.xyz -p hills.cl "$part"
		has "$control: the rest of it is told" \
			'notice: .*leaves out line .* of the path, .*; another part may go there' err
	done
	status 3 "$control: nothing less may be left where it is said" \
		ncverify -q -g hills.xyz --left 0.3 hill-1.nc
	for k in 1 2 3; do # before the K-th cut from a rapid move
		awk -v k=$k -v h="$([ $control = heidenhain ] && echo 1)" '
			{ line[NR] = $0; rapid = / G0 |FMAX/ ? 1 : / G[123] | F[0-9]/ ? 0 : rapid }
			/ [XYZ][-+0-9.]/ && rapid { last = NR; lead = 1 }
			/ [XYZ][-+0-9.]/ && !rapid { if (lead && ++n == k) drop = last; lead = 0 }
			END { n = h ? 0 : 10; for (i = 1; i <= NR; i++) { $0 = line[i]
				if (i == drop) continue
				if (h ? /^[0-9]+ / : /^N[0-9]+/) {
					sub(h ? "^[0-9]+" : "^N[0-9]+", (h ? "" : "N") n); n += h ? 1 : 10 }
				print } }' hills.nc >bad.nc
		status 3 "$control: without the last of approach $k" ncverify -q -g hills.xyz -o verdict bad.nc
		has "... as its head says" '^fault .*its rapid moves are [0-9.]+ mm long, and [0-9.]+ by' verdict
	done
	ncverify -q --accept -g hills.xyz -o verdict bad.nc
	hasnt "$control: unless its head is left aside" 'rapid moves are' verdict
	ncpost -q -c $control -m $machine --from 15 -o from.nc hills.cl
	has "$control: from a pass on, which is said" '(From pass 15 on|FROM PASS 15 ON)' from.nc
	ncverify -q -g hills.xyz -o verdict from.nc
	hasnt "... is not as long" 'rapid moves are' verdict
	ncpost -q -c $control -m $machine --split 2000 -o half.nc hills.cl
	ncverify -q -g hills.xyz -o verdict half-1.nc
	hasnt "$control: nor is a part" 'rapid moves are' verdict
done

done_testing
