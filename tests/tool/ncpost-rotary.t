#!/bin/sh
# ncpost-rotary.t - rotary motion: what it makes of paths whose tool axis turns.
# shellcheck disable=SC2016 # $ of CL files
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
# Paths here need not name a speed of the spindle and a tool: ncpost-missing.t has those that lack them.
ncpost() { command ncpost --no-spindle "$@"; }

# Plain points are read a quicker way than statements with a comment or in lower case: same program.
awk 'BEGIN {
	print "UNITS/MM\nMULTAX/ON\nCUTTER/8,4,0,4,0,0,60\n$$-> CLOUDMILL/1\nRAPID\nGOTO/0,0,60,0,0,1\nFEDRAT/MMPM,500"
	for (i = 0; i < 3000; i++) {
		t = i / 400; a = 0.3 * sin(t); b = 0.25 * cos(t * 1.3) + 0.05
		printf "$$-> CONTCT/%.6f,%.6f,%.6f,0,0,1\n", i / 10, 1, -0.5
		printf "GOTO/%.6f,%.6f,%.6f,%.9f,%.9f,%.9f\n", i / 10, t, 5 * sin(t), a, b, sqrt(1 - a * a - b * b)
		if (i % 50 == 0) printf "GOTO/ %d , -1.5 ,2\n", i / 10
	}
	print "FINI"
}' >"$TMP/plain.cl"
sed 's/^GOTO.*/& $$ here/; s/^\$\$-> CONTCT/$$-> contct/' "$TMP/plain.cl" >"$TMP/rich.cl"
sed 's/$/\r/' "$TMP/plain.cl" >"$TMP/crlf.cl"
for way in plain rich crlf; do
	ok "ncpost reads $way points" ncpost -q -c fanuc --contact-feed -o "$TMP/$way.nc" "$TMP/$way.cl"
	grep -v -i "$way" "$TMP/$way.nc" >"$TMP/$way.txt"
done
same "points with comments say the same" "$TMP/plain.txt" "$TMP/rich.txt"
same "points of CRLF files say the same" "$TMP/plain.txt" "$TMP/crlf.txt"
sed '2500s/,/,x/' "$TMP/plain.cl" >"$TMP/bad.cl"
status 1 "a bad number among plain points" ncpost -q -c fanuc "$TMP/bad.cl"
has "is named with its line" 'bad.cl:2500: found `X[0-9.-]*. in' "$TMP/err"

# post PATH CONTROL MACHINE [OPTIONS]: the program is made and, as its control runs it on this
# machine, keeps 0.01 mm at the tip and 0.1 degrees, no axis leaves its travel; then in $TMP/out
post() {
	path=$1 control=$2 machine=$3
	shift 3
	desc="$(basename "$path") for $control, $machine $*"
	case $control in *-vectors | *-rotary) word=--${control#*-} ;; *) word= ;; esac
	# shellcheck disable=SC2086
	if ! ncpost -c "${control%-*}" $word -m "$machine" "$@" -o "$TMP/p.nc" "$path" 2>"$TMP/err"; then
		result 1 "$desc: ncpost"
		return
	fi
	tcp=
	case $machine in linuxcnc*) ;; *) [ "$control" = linuxcnc ] && tcp=--no-tcp ;; esac
	# shellcheck disable=SC2086
	ok "$desc" "$READBACK" -c "${control%-*}" -m "$machine" $tcp "$@" --path "$path" -e 0.01 \
		--axis 0.1 "$TMP/p.nc"
	ball=$(sed -n 's/.* ball \([0-9.]*\) mm$/\1/p' "$TMP/out" | sort -n | tail -n 1)
	[ "$(awk -v b="$ball" 'BEGIN { print b <= 0.01 }')" = 1 ] || result 1 "$desc: ball off by $ball"
}
turns() {
	sed -n 's/^axes: \([0-9]*\) turns back.*/\1/p' "$TMP/out"
}

# A spiral on a cone: turns, tilt, points a turn, start, sense, POINTS or ARCS
spiral() {
	awk -v turns="$1" -v tilt="$2" -v each="$3" -v start="$4" -v sense="$5" -v kind="$6" '
	function go(k, up,  w, s) {
		w = rad * (start + sense * 360 * k / each); s = sin(rad * tilt)
		printf "GOTO/%.6f,%.6f,%.6f,%.9f,%.9f,%.9f\n", 30 * cos(w) + up * s * cos(w),
			30 * sin(w) + up * s * sin(w), -5 * k / each + up * cos(rad * tilt),
			s * cos(w), s * sin(w), cos(rad * tilt)
	}
	BEGIN {
		rad = atan2(0, -1) / 180; n = int(turns * each)
		print "PARTNO/SPIRAL\nUNITS/MM\nMULTAX/ON\nCUTTER/8,4,0,4,0,0,60\nLOADTL/1"
		print "SPINDL/RPM,8000,CLW\n$$-> CLOUDMILL/1\n$$-> PASS/1\nRAPID"
		go(0, 60)
		print "FEDRAT/MMPM,800"
		for (k = 0; k <= n; k++) {
			if (kind == "ARCS" && k)
				printf "CIRCLE/0,0,%.6f,0,0,%d,30\n", -5 * (k - 1) / each, sense
			go(k, 0)
		}
		print "RAPID"
		go(n, 60)
		print "FINI"
	}'
}

# The fewest turns back along it, counted by hand: C from where it may start to the end of its
# travel, then from as far back as that place is again, by 360 degrees, or by 180 where A may change
# its sign: TURNS START SENSE C-MIN C-MAX TILT A-MIN A-MAX
fewest() {
	awk -v turns="$1" -v start="$2" -v sense="$3" -v min="$4" -v max="$5" -v t="$6" -v amin="$7" -v amax="$8" 'BEGIN {
		plus = t <= amax; minus = -t >= amin; best = 99
		step = plus && minus ? 180 : 360
		back = step * int((max - min) / step + 1e-9)
		for (k = -9; k <= 9; k++) {
			c = start + 90 + (plus ? 0 : 180) + k * step
			if (c < min - 1e-9 || c > max + 1e-9) continue
			left = turns * 360 - (sense > 0 ? max - c : c - min)
			n = left > 1e-9 ? int((left - 1e-9) / back) + 1 : 0
			if (n < best) best = n
		}
		print best
	}'
}

back() { # TURNS TILT EACH START SENSE KIND A-MIN A-MAX C-MIN C-MAX CONTROL MACHINE
	spiral "$1" "$2" "$3" "$4" "$5" "$6" >"$TMP/spiral.cl"
	post "$TMP/spiral.cl" "${11}" "${12}" --set a.min="$7" --set a.max="$8" --set c.min="$9" --set c.max="${10}"
	want=$(fewest "$1" "$4" "$5" "$9" "${10}" "$2" "$7" "$8")
	off=$(sed -n 's/.* turns back, \([0-9.]*\) mm off.*/\1/p' "$TMP/out")
	ok "$1 turns at $2 from $4, $5: $want turns back" test "$(turns)" -eq "$want"
	[ "$want" = 0 ] || below "each $off mm off the part, a full retract" 50 "$off"
}

for control in fanuc siemens-rotary heidenhain linuxcnc; do
	back 5 50 72 0 1 POINTS -30 120 -360 360 $control table-ac
done
back 5 50 72 33 -1 POINTS -30 120 -360 360 fanuc table-ac
back 5 50 8 100 1 POINTS -30 120 -360 360 fanuc head-ca
back 5 20 36 77 -1 POINTS -30 120 -360 360 fanuc table-ac-notcp
back 5 50 72 0 1 POINTS -30 120 -200 210 siemens-rotary table-ac
back 3.5 20 72 200 1 POINTS -30 120 -200 290 fanuc table-ac
back 4 70 24 10 1 POINTS -120 30 -720 0 fanuc table-ac
back 2 20 24 -90 1 POINTS -30 120 0 720 fanuc table-ac
back 5 50 3 20 1 ARCS -30 120 -360 360 fanuc table-ac
back 5 50 3 20 -1 ARCS -30 120 -360 360 siemens-rotary table-ac
back 5 50 8 20 -1 ARCS -30 120 -360 360 linuxcnc table-ac
spiral 5 50 72 33 1 POINTS >"$TMP/points.cl"
bsplfit -q -e 0.001 -o "$TMP/splines.cl" "$TMP/points.cl"
post "$TMP/splines.cl" fanuc table-ac --set a.min=-30 --set c.min=-360 --set c.max=360
ok "inside of a spline too: 2 turns back" test "$(turns)" -eq 2
has "and its parts are splines" 'G06.2' "$TMP/p.nc"

# Vectors leave the rotary axes to the control, which cannot turn back: rotary words then
spiral 5 50 72 33 -1 POINTS >"$TMP/spiral.cl"
for control in fanuc-vectors siemens heidenhain-vectors; do
	post "$TMP/spiral.cl" $control table-ac --set a.min=-30 --set c.min=-360 --set c.max=360
	ok "$control: 2 turns back" test "$(turns)" -eq 2
done
status 0 "without such an end vectors stay" ncpost -c siemens -o "$TMP/v.mpf" "$TMP/spiral.cl"
has "and are vectors" ' A3=.* B3=.* C3=' "$TMP/v.mpf"

# The tip all but stands while the tool axis turns: what is beside what is said by both alike
awk 'BEGIN {
	seed = 4 + 7919 * ENVIRON["SEED"]; rad = atan2(0, -1) / 180; x = 20; th = 0.3
	print "UNITS/MM\nMULTAX/ON\nCUTTER/8,4,0,4,0,0,60\nLOADTL/1\nSPINDL/RPM,8000,CLW\n$$-> CLOUDMILL/1"
	print "RAPID\nGOTO/20,0,60,0,0.173648178,0.984807753\nFEDRAT/MMPM,500"
	for (i = 0; i < 120; i++) {
		for (k = 0; k < 5; k++) { seed = (seed * 16807) % 2147483647; r[k] = seed / 2147483647 }
		d = r[0] < 0.4 ? (r[1] < 0.3 ? 0 : r[1] < 0.6 ? 0.0003 : 0.01) : 1
		x += d * (r[2] * 1.3 - 0.3); y += d * (r[1] - 0.5)
		th += 0.1 * r[3] - 0.05; ph += 0.8 * r[4] - 0.4
		if (th < 0.02 || th > 0.8) th = 0.3
		printf "GOTO/%.6f,%.6f,0,%.9f,%.9f,%.9f\n", x, y, sin(th) * cos(ph), sin(th) * sin(ph), cos(th)
	}
	printf "RAPID\nGOTO/%.6f,%.6f,60,%.9f,%.9f,%.9f\nFINI\n", x, y, sin(th) * cos(ph), sin(th) * sin(ph), cos(th)
}' >"$TMP/standing.cl"
for control in fanuc fanuc-vectors siemens siemens-rotary heidenhain linuxcnc; do
	post "$TMP/standing.cl" $control table-ac
done
post "$TMP/standing.cl" fanuc table-ac-notcp
post "$TMP/standing.cl" siemens head-table-bc-notcp

# A dome over its top in a direction: how far beside the pole (mm), direction, step between points
dome() {
	awk -v off="$1" -v dir="$2" -v step="$3" 'BEGIN {
		rad = atan2(0, -1) / 180; c = cos(rad * dir); s = sin(rad * dir)
		print "PARTNO/DOME\nUNITS/MM\nMULTAX/ON\nCUTTER/40,20,0,20,0,0,60\nLOADTL/1"
		print "SPINDL/RPM,8000,CLW\n$$-> CLOUDMILL/1\n$$-> PASS/1"
		for (t = -40; t < 40 + step; t += step) {
			x = t * c - off * s; y = t * s + off * c; z = sqrt(6400 - x * x - y * y)
			if (t == -40)
				printf "RAPID\nGOTO/%.6f,%.6f,%.6f,%.9f,%.9f,%.9f\nFEDRAT/MMPM,800\n", 1.75 * x, 1.75 * y,
					1.75 * z, x / 80, y / 80, z / 80
			printf "GOTO/%.6f,%.6f,%.6f,%.9f,%.9f,%.9f\n", x, y, z, x / 80, y / 80, z / 80
		}
		printf "RAPID\nGOTO/%.6f,%.6f,%.6f,%.9f,%.9f,%.9f\nFINI\n", 1.75 * x, 1.75 * y, 1.75 * z,
			x / 80, y / 80, z / 80
	}'
}
over() { # OFF DIRECTION STEP: on all machines, for all controls between them
	dome "$@" >"$TMP/dome-$1-$2-$3.cl"
	set -- "$TMP/dome-$1-$2-$3.cl"
	post "$1" fanuc table-ac
	post "$1" fanuc-vectors head-ca
	post "$1" siemens table-bc
	post "$1" siemens-rotary nutating-head
	post "$1" heidenhain head-cb
	post "$1" fanuc nutating-table
	post "$1" linuxcnc nutating-head-table
	post "$1" linuxcnc linuxcnc-xyzac
	post "$1" fanuc table-ac-notcp
	post "$1" siemens table-bc-notcp
	post "$1" heidenhain head-table-bc-notcp
	post "$1" fanuc head-table-bc --set b.min=-5
}
over 0 0 1         # a point at the pole
over 0 201 7       # the pole between two points
over 0.0000014 37 1 # 1e-6 degrees beside it
over 0.05 300 1
over 2 90 4

# What no turn helps: exit 3, the place named
spiral 5 50 72 0 1 POINTS >"$TMP/spiral.cl"
status 1 "a tilt beyond the travel" ncpost -c fanuc --set a.min=-30 --set a.max=45 "$TMP/spiral.cl"
has "is told with pass, line and axis" 'spiral.cl:10: pass 1: axis A .* at the point [-0-9.]+ [-0-9.]+ [-0-9.]+, .* -30 to 45' "$TMP/err"
status 1 "C may not turn far enough" ncpost -c fanuc --set a.min=0 --set c.min=-100 --set c.max=100 "$TMP/spiral.cl"
has "is told with pass, axis and point" \
	'spiral.cl:[0-9]+: pass 1: axis C of .* at the point [-0-9.]+ [-0-9.]+ [-0-9.]+, expected' "$TMP/err"
sed 's/^\(GOTO.*,\)\([0-9.]*\)$/\1-\2/' "$TMP/spiral.cl" >"$TMP/under.cl"
status 1 "a nutating head does not reach below" ncpost -c fanuc -m nutating-head "$TMP/under.cl"
has "is told with the direction" 'under.cl:10: pass 1: found tool axis .* at the point .*, which no angles' "$TMP/err"

# ---- a path that ends in a cut with the tool below the horizontal: home is straight up, so the tool
# goes on along its axis until it is beside all that was cut
printf '%s\n' UNITS/MM MULTAX/ON CUTTER/10,5 LOADTL/1 SPINDL/900 RAPID 'GOTO/100,0,0,0.94,0,-0.3412' \
	FEDRAT/MMPM,500 'GOTO/50,0,0,0.94,0,-0.3412' 'GOTO/-80,20,0,0.94,0,-0.3412' FINI >"$TMP/below.cl"
ncpost -q -c fanuc -m head-ca -o "$TMP/below.nc" "$TMP/below.cl"
awk '/ G1 / { cut = 1 } cut { for (i = 1; i <= NF; i++) if ($i ~ /^X/) x = substr($i, 2) }
	cut && / G0 / { exit } END { exit !(x + 0 >= 99.999) }' "$TMP/below.nc"
result $? "a tool below the horizontal leaves beside the part"
ncpost -q -c fanuc -m head-ca --split 45 -o "$TMP/low.nc" "$TMP/below.cl"
awk '/ G1 / { cut = 1 } cut { for (i = 1; i <= NF; i++) if ($i ~ /^X/) x = substr($i, 2) }
	cut && / G0 / { exit } END { exit !(x + 0 >= 99.999) }' "$TMP/low-1.nc"
result $? "so does each part"
sed 's/0.94,0,-0.3412/0,0,-1/' "$TMP/below.cl" >"$TMP/down.cl"
status 1 "upside down there is no way home" ncpost -c fanuc -m head-ca --set a.min=-180 --set a.max=180 "$TMP/down.cl"
has "told with its line" 'down.cl:10: .*upside down' "$TMP/err"
empty "and nothing written" "$TMP/out"
ncpost -q -c fanuc -m table-ac -o "$TMP/table.nc" "$TMP/below.cl"
result $? "a table brings the part below the tool: no matter there"

# ---- a cut that goes into the pole on one side and out on another: where the control does not lead
# the tip, C turns there about the tool, at feed, the tip at rest
printf '%s\n' UNITS/MM MULTAX/ON CUTTER/8,4,0,4,0,0,60 LOADTL/1 SPINDL/900 RAPID \
	'GOTO/0,0,60,-0.1,-0.1,0.989949494' FEDRAT/MMPM,500 'GOTO/10,20,5,-0.1,-0.1,0.989949494' \
	'GOTO/12,20,5,0,0,1' 'GOTO/14,20,5,-0.1,0.1,0.989949494' 'GOTO/18,20,5,0,0,1' \
	'GOTO/20,20,5,0.02,-0.3,0.953729528' RAPID 'GOTO/20,20,60,0.02,-0.3,0.953729528' FINI >"$TMP/kink.cl"
sed -e 's|^GOTO/14,|CIRCLE/13,20,5,0,0,1,1\n&|' -e 's|^GOTO/20,20,5,|CIRCLE/19,20.5,5,0,0,1,1.118034\n&|' \
	"$TMP/kink.cl" >"$TMP/arcs.cl" # the same on arcs
sed 's|^\(GOTO/1[0-9],20,5,\)0,0,1|\10.000004,-0.000003,1|' "$TMP/arcs.cl" >"$TMP/beside.cl" # hardly past it
for c in fanuc siemens heidenhain linuxcnc; do
	for path in kink arcs beside; do
		status 0 "$c, $path: out of the pole in another direction" \
			ncpost -c $c -m table-ac-notcp -o "$TMP/kink.nc" "$TMP/$path.cl"
		status 0 "read back it is the path" "$READBACK" -c $c -m table-ac-notcp -e 0.006 --axis 0.06 \
			--path "$TMP/$path.cl" "$TMP/kink.nc"
	done
done

# ---- a cut that ends in the pole: C, which is free there, turns for the next one off the part, not in
# the rapid that leads out of it (nor in one that is made for it)
printf '%s\n' UNITS/MM MULTAX/ON CUTTER/8,4,0,4,0,0,60 LOADTL/1 SPINDL/900,CLW RAPID \
	'GOTO/40,0,60,0.3,0,0.953939201' FEDRAT/MMPM,500 'GOTO/40,0,10,0.3,0,0.953939201' \
	'GOTO/43,0,10,0,0,1' RAPID 'GOTO/43,0,60,0,0,1' RAPID 'GOTO/43,20,60,U' FEDRAT/MMPM,500 \
	'GOTO/43,20,10,U' RAPID 'GOTO/43,20,60,U' FINI >"$TMP/turned"
for c in fanuc siemens heidenhain linuxcnc; do
	for axis in 0,-0.3,0.953939201 0.28,-0.107703296,0.953939201; do # 90 and 21 degrees on
		sed "s/,U$/,$axis/" "$TMP/turned" >"$TMP/turned.cl"
		status 0 "$c, $axis: a cut that ends in the pole" \
			ncpost -c $c -m table-ac-notcp -o "$TMP/turned.nc" "$TMP/turned.cl"
		# the blocks after Z10 up to the first that rises
		awk 'match($0, / Z[-+0-9.]+/) { z = substr($0, RSTART + 2, RLENGTH - 2) + 0
				if (low && z > 10) { print; exit }
				low = z == 10; next }
			low' "$TMP/turned.nc" >"$TMP/out"
		has "it goes up first" 'Z\+?60' "$TMP/out"
		hasnt "C stands still" ' C[-+0-9]' "$TMP/out"
	done
done

# ---- Y comes to the end of its travel on the way down: a turn of the axes does not help, and the way
# back from it would want one, too
printf '%s\n' UNITS/MM MULTAX/ON CUTTER/4,2,0,2,0,0,60 LOADTL/1 SPINDL/8000,CLW RAPID \
	'GOTO/352.497987,-131.088377,99.99994,0.166600835,-0.150171914,0.974521707' FEDRAT/MMPM,1500 \
	'GOTO/349.729626,-128.593011,83.806579,0.166600835,-0.150171914,0.974521707' RAPID \
	'GOTO/352.554092,-131.091769,99.99994,0.166600835,-0.150171914,0.974521707' RAPID \
	'GOTO/330.64035,-131.806355,99.99994,0,-0.258819045,0.965925826' RAPID \
	'GOTO/330.64035,-128.822559,88.86426,0,-0.258819045,0.965925826' FEDRAT/MMPM,750 \
	'GOTO/330.64035,-127.528464,84.034631,0,-0.258819045,0.965925826' FINI >"$TMP/far.cl"
for c in fanuc siemens heidenhain; do
	status 1 "$c: a turn that needs a turn on its way back" ncpost -q -c $c -m haas-umc750 "$TMP/far.cl"
	has "is the end of Y's travel" 'axis Y of Haas UMC-750: found a position of -?330.64.* expected its travel' "$TMP/err"
done

# ---- from home: with A and C at zero X and Y would be beyond their travel above the first place, with
# the axes turned they are not: they turn above a place nearer to the middle, as high
cl() {
	printf '%s\n' UNITS/MM MULTAX/ON CUTTER/8,4,0,4,0,0,60 LOADTL/1 SPINDL/8000,CLW "$@" FINI
}
awk 'BEGIN { for (i = 300; i <= 370; i += 5) for (j = -150; j <= -80; j += 5) print i, j, 70 }' >"$TMP/far.xyz"
a=0.2,-0.3,0.932737905
cl RAPID GOTO/340,-126,100,$a FEDRAT/MMPM,800 GOTO/334,-117,72,$a GOTO/336,-117,72,$a GOTO/336,-116,72,$a \
	GOTO/334,-116,72,$a GOTO/332,-116,72,$a GOTO/332,-115,72,$a RAPID GOTO/340,-126,100,$a >"$TMP/home.cl"
for c in fanuc siemens heidenhain 'fanuc --vectors' 'siemens --vectors'; do
	# shellcheck disable=SC2086 # options
	status 0 "$c: from home to a place that the axes reach turned" \
		ncpost -q -c $c -m mazak-variaxis-i600 -o "$TMP/home.nc" "$TMP/home.cl"
	# shellcheck disable=SC2086
	status 0 "$c: and in parts" \
		ncpost -q -c $c -m mazak-variaxis-i600 --split 45 -o "$TMP/home.nc" "$TMP/home.cl"
	for nc in home home-1 home-2; do
		ncverify -c "${c%% *}" -m mazak-variaxis-i600 -g "$TMP/far.xyz" --partial --left 1000 \
			--ball-only "$TMP/$nc.nc" >"$TMP/out" 2>&1
		hasnt "$nc: within the travel" 'beyond its travel' "$TMP/out"
		has "and looked at" '^travel X' "$TMP/out"
	done
done
sed 's/GOTO\/340,-126/GOTO\/500,-126/' "$TMP/home.cl" >"$TMP/out.cl"
status 1 "no way from home" ncpost -q -c fanuc -m mazak-variaxis-i600 "$TMP/out.cl"
has "is told with axis, value and travel" \
	'axis X of Mazak .*: found .* position of .*, expected its travel -255 to 255' "$TMP/err"
empty "and nothing written" "$TMP/out"
status 1 "a tilted plane out of the travel" ncpost -q -c siemens -m mazak-variaxis-i600 --plane "$TMP/home.cl"
has "is told" 'home.cl:[0-9]+: axis X of Mazak .*: found above a tilted plane a position of 3' "$TMP/err"
empty "and nothing written" "$TMP/out"

# ---- a rapid between two places within the travel, while C turns a quarter: half-way Y is beyond it
cl RAPID GOTO/152,170,100,-0.17,0,0.985443 FEDRAT/MMPM,800 GOTO/152,170,72,-0.17,0,0.985443 RAPID \
	GOTO/152,170,100,-0.17,0,0.985443 RAPID GOTO/152,170,100,0,-0.17,0.985443 FEDRAT/MMPM,800 \
	GOTO/152,170,72,0,-0.17,0.985443 RAPID GOTO/152,170,100,0,-0.17,0.985443 >"$TMP/way.cl"
for c in fanuc siemens heidenhain; do
	status 1 "$c: Y beyond its travel on the way" \
		ncpost -q -c $c -m table-ac --rotary --set y.min=-225 --set y.max=225 "$TMP/way.cl"
	has "is told" 'axis Y of .*: found on the way a position of 230.* expected its travel' "$TMP/err"
	status 0 "$c: not where it has more" \
		ncpost -q -c $c -m table-ac --rotary --set y.min=-250 --set y.max=250 -o "$TMP/way.nc" "$TMP/way.cl"
done

# ---- off the part so that C can turn back: is the way up clear?  A tool that leans by 20 degrees goes
# twice around on a plate, with a plate 25 mm above it or without
cd "$TMP" || exit 1
plate() { awk -v z="$1" 'BEGIN { for (x = -30; x <= 30; x++) for (y = -30; y <= 30; y++) print x, y, z }'; }
plate 0 >open.xyz
{ plate 0 && plate 25; } >roof.xyz
for scan in open roof; do
	cloud2mesh -q -t 3 $scan.xyz 2>/dev/null | meshnorm -q -r 3 -g $scan.xyz 2>/dev/null | grep 'SCAN/' >said
	{
		printf 'UNITS/MM\nMULTAX/ON\nCUTTER/6,3\nSPINDL/RPM,8000,CLW\nLOADTL/1\n$$-> CLOUDMILL/1\n'
		printf '$$-> TOOL/FLUTE,12\n' && cat said
		awk 'BEGIN { s = sin(20 * 3.14159265 / 180); c = sqrt(1 - s * s)
			for (w = 0; w <= 720; w += 5) { t = w * 3.14159265 / 180
				x = 8 * cos(t); y = 8 * sin(t)
				if (w == 0) printf "RAPID\nGOTO/%f,%f,3,%f,0,%f\nFEDRAT/MMPM,800\n", x, y, s, c
				printf "GOTO/%f,%f,0.2,%f,%f,%f\n", x, y, s * cos(t), s * sin(t), c }
			printf "RAPID\nGOTO/%f,%f,3,%f,0,%f\nFINI\n", x, y, s, c }'
	} >$scan.cl
done
for c in fanuc siemens heidenhain linuxcnc; do
	for accept in "" --accept; do
		status 0 "$c: around without an end needs no turn" \
			ncpost -c $c $accept -o around.nc roof.cl
		turns="ncpost -c $c $accept --set c.min=-200 --set c.max=200"
		status 0 "$c: a turn on an open plate" $turns -o open.nc open.cl
		has "is there" 'retracted, turned and returned [12] times' err
		[ -z "$accept" ] && expected=3 || expected=0
		status $expected "$c: one under a roof" $turns -o roof.nc roof.cl
		has "goes through it" 'the (ball|shaft) goes [1-3]\.[0-9]+ mm deep into the scan after line [0-9]+' err
		has "the head says it" 'UNMET: (ncpost|NCPOST)' roof.nc
	done
	status 3 "$c: the judge says so, too" ncverify -c $c -g roof.xyz -r 3 --partial --left 1000 --accept \
		--set c.min=-200 --set c.max=200 roof.nc
done
mv roof.xyz gone.xyz
status 0 "a scan that is gone" ncpost -c siemens --set c.min=-200 --set c.max=200 -o roof.nc roof.cl
has "is said" 'the scan that the path names does not guard: .*; the moves added for rotary axes are not checked' err
grep -v 'SCAN/' roof.cl >none.cl
status 0 "a path that names none" \
	ncpost -c siemens --set c.min=-200 --set c.max=200 -o none.nc none.cl
has "is said, too" 'the path names neither scan nor mesh: the moves added .* are not checked' err

# the same plates as facets, of which the path names the mesh: from a file, changed, gone, piped in
plates() { # Z ...: a square of two facets at each, in millimetres
	awk 'BEGIN { print "OFF"; print 4 * (ARGC - 1), 2 * (ARGC - 1), 0
		for (i = 1; i < ARGC; i++) printf "-30 -30 %s\n30 -30 %s\n30 30 %s\n-30 30 %s\n",
			ARGV[i], ARGV[i], ARGV[i], ARGV[i]
		for (i = 0; i < ARGC - 1; i++) printf "3 %d %d %d\n3 %d %d %d\n",
			4 * i, 4 * i + 1, 4 * i + 2, 4 * i, 4 * i + 2, 4 * i + 3; exit }' "$@"
}
plates 0 >open.off
plates 0 25 >roof.off
for mesh in open roof; do
	planecut -q -r 3 -s 5 $mesh.off 2>/dev/null | grep 'MESH/' >said
	has "the path names its mesh" "^..-> MESH/[48],[0-9a-f]{16},$mesh.off\$" said
	awk 'NR == FNR { said = $0; next } /SCAN/ { $0 = said } { print }' said $mesh.cl >$mesh.m.cl
done
turns="ncpost -c linuxcnc --set c.min=-200 --set c.max=200"
status 0 "a turn on an open plate of facets" $turns -o open.nc open.m.cl
status 3 "one under a roof of facets" $turns -o roof.nc roof.m.cl
has "goes through it" 'the (ball|shaft) goes [1-3]\.[0-9]+ mm deep into the mesh after line ' err
for fitter in biarcfit bsplfit; do
	status 3 "$fitter carries it on" sh -c "$fitter -q roof.m.cl | $turns -o roof.nc"
	has "and it is looked at" 'mm deep into the mesh after line' err
done
status 0 "no turn, no look" ncpost -c fanuc -o around.nc roof.m.cl
plates 0 26 >roof.off
status 3 "a mesh that has changed is not believed" $turns -o roof.nc roof.m.cl
has "is told" 'the path names is not looked at: roof.off: found other points, as many: it has' err
rm roof.off
status 3 "nor one that is gone" $turns -o roof.nc roof.m.cl
has "is told" 'the mesh that the path names is not looked at: roof.off: cannot open' err
planecut -q -r 3 -s 5 <open.off 2>/dev/null | grep 'MESH/' >said
has "a hyphen is what was piped in" '^\$\$-> MESH/4,[0-9a-f]{16},-$' said
sed 's/roof.off/-/' roof.m.cl >piped.cl
status 3 "nor one that was piped in" $turns -o roof.nc piped.cl
has "is told" 'looked at: it was read from standard input; the moves added .* are not checked' err
status 0 "unless it is accepted" $turns --accept -o roof.nc piped.cl

# Where no angles are within the travel, the angle that has just left it is named, whichever of the
# two solutions it is of: LEAN and two directions of the axis.
turning() {
	awk -v l="$1" -v b="$2" -v c="$3" 'function axis(d) {
		return sprintf("%.12f,%.12f,%.12f", sin(l) * cos(d * r), sin(l) * sin(d * r), cos(l))
	}
	BEGIN {
		r = atan2(0, -1) / 180; l *= r
		print "UNITS/MM\nMULTAX/ON\nLOADTL/1\nSPINDL/900\nRAPID\nGOTO/0,0,50," axis(b)
		print "FEDRAT/100\nGOTO/0,0,0," axis(b) "\nGOTO/100,0,0," axis(c) "\nFINI"
	}' >turning.cl
}
leaves() { # MACHINE TRAVEL LEAN FROM TO ANGLE
	turning "$3" "$4" "$5"
	for c in fanuc siemens; do
		status 1 "$1, C to $2, from $4 to $5, $c" \
			ncpost -c $c -m "$1" --set c.min=-$2 --set c.max=$2 turning.cl
		has "leaves its travel at $6" "axis C of .* found angle $6\.000[0-9]* at the point [3-6]" err
	done
}
leaves table-bc 30 20 10 60 30
leaves table-bc 30 20 190 220 30
leaves table-bc 30 20 170 130 -30
leaves nutating-head 90 20 -60 -100 -90
leaves nutating-head 90 20 -120 -60 90
# ---- a rotary axis that turns back far between two passes does so above the part: the way up to
# the clearance plane is led first, whatever the control.
awk 'function put(t, up, rapid) { a = t * 3.14159265358979 / 180; s = sin(1.2)
		if (rapid) print "RAPID"
		printf "GOTO/%.6f,%.6f,%.6f,%.9f,%.9f,%.9f\n", 20 * sin(a), -20 * cos(a), up, s * sin(a),
			-s * cos(a), cos(1.2) }
	BEGIN { print "PARTNO/WIND\nUNITS/MM\nMULTAX/ON\nCUTTER/10,5,0,5,0,0,60\nLOADTL/1"
		print "SPINDL/RPM,8000,CLW"
		for (p = 0; p < 2; p++) { from = p ? 330 : 0; to = p ? 560 : 330
			put(from, 60, 1); put(from, 20, 1); print "FEDRAT/800"
			for (t = from; t <= to; t += 2) put(t, 0, 0)
			put(to, 20, 1); put(to, 60, 1) }
		print "FINI" }' >wind.cl
for control in fanuc linuxcnc siemens; do
	ncpost -q -c $control -m head-ca -o wind.nc wind.cl
	awk 'NR > 100 && !up && /G0/ { up = NR } up && NR == up + 1 { print }' wind.nc >next
	has "$control: up" ' Z' next
	hasnt "$control: without a turn" ' [AXYC]=?-?[0-9]' next
done

done_testing
