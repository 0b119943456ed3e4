#!/bin/sh
# ncpost-starts.t - every start of a program, a part and a restart leads over the work: a small
# reader of the test's own moves a ball of 5 mm with its shank from 1,000 random places of each
# control's machine through the first blocks, past a dome of 20 mm on a block: with tool-centre-point
# control and without, with tables and heads, in tilted planes, with rotary axes that stand anywhere.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

# Passes over the dome (its centre at zero, the block below z = 0), the tool along the normal, from
# side to side; the clearance plane is 12 mm above its top.
awk 'function go(w, u,  x, y, z, i, j, k) {
		i = sin(w) * cos(u); j = sin(u); k = cos(w) * cos(u)
		printf "GOTO/%.6f,%.6f,%.6f,%.9f,%.9f,%.9f\n", 20 * i, 20 * j, 20 * k, i, j, k
	}
	function high(w, u, z) { printf "RAPID\nGOTO/%.6f,%.6f,%.6f,%.9f,%.9f,%.9f\n", z * tan(w), z * tan(u) / cos(w), z,
		sin(w) * cos(u), sin(u), cos(w) * cos(u) }
	function tan(a) { return sin(a) / cos(a) }
	BEGIN { print "UNITS/MM\nMULTAX/ON\nCUTTER/10,5\nLOADTL/1\nSPINDL/900\n$$-> CLOUDMILL/1\n$$-> CLEAR/32"
	for (u = -0.9; u <= 0.91; u += 0.3) {
		s = -s; if (!s) s = 1
		print "$$-> PASS/" ++n; high(-s * 0.9, u, 32)
		print "FEDRAT/MMPM,500"
		for (k = -30; k <= 30; k++) go(s * k * 0.03, u)
		high(s * 0.9, u, 32)
	}
	print "FINI" }' >dome.cl
printf '%s\n' 'UNITS/MM' 'CUTTER/10,5' 'LOADTL/1' 'SPINDL/900' RAPID 'GOTO/-45,0,30' 'FEDRAT/100' 'GOTO/-45,0,-3' \
	'GOTO/-45,20,-3' RAPID 'GOTO/-45,20,8' 'RAPID' 'GOTO/45,20,8' 'GOTO/45,20,-3' 'GOTO/45,0,-3' FINI >flat.cl

# The same dome, 3+2: three directions, each with its own passes of tips.
awk 'BEGIN { print "UNITS/MM\nMULTAX/ON\nCUTTER/10,5\nLOADTL/1\nSPINDL/900\n$$-> CLOUDMILL/1"
	split("0.48 -0.6 0", x); split("0.36 0 0.8", y); split("0.8 0.8 0.6", z)
	for (n = 1; n <= 3; n++)
		for (s = -1; s <= 1; s++) {
			printf "$$-> PASS/%d\n", ++pass
			for (k = -6; k <= 6; k++) {
				# n turned by k from the axis, in the plane of the axis and a side of it
				ux = y[n] * 1 - z[n] * s; uy = z[n] * 0.3 - x[n] * 1; uz = x[n] * s - y[n] * 0.3
				l = sqrt(ux * ux + uy * uy + uz * uz); w = k * 0.03
				nx = cos(w) * x[n] + sin(w) * ux / l; ny = cos(w) * y[n] + sin(w) * uy / l; nz = cos(w) * z[n] + sin(w) * uz / l
				px = 25 * nx - 5 * x[n]; py = 25 * ny - 5 * y[n]; pz = 25 * nz - 5 * z[n]
				if (k == -6) printf "RAPID\nGOTO/%.6f,%.6f,%.6f,%g,%g,%g\nFEDRAT/MMPM,500\n", px + 30 * x[n], py + 30 * y[n], pz + 30 * z[n], x[n], y[n], z[n]
				printf "GOTO/%.6f,%.6f,%.6f,%g,%g,%g\n", px, py, pz, x[n], y[n], z[n]
			}
			printf "RAPID\nGOTO/%.6f,%.6f,%.6f,%g,%g,%g\n", px + 30 * x[n], py + 30 * y[n], pz + 30 * z[n], x[n], y[n], z[n]
		}
	print "FINI" }' >tilted.cl

cat >start.awk <<'PROGRAM'
# Blocks as the control runs them, to the first cut: X Y Z of the tip (with tcp or upright), or of
# the linear axes of a trunnion table whose centres are at zero; angles A C.
function turn(u, w, i, j,  c, s, y) { # u turned by w degrees in the plane of its i-th and j-th
	c = cos(w * rad); s = sin(w * rad); y = u[i]
	u[i] = c * y - s * u[j]; u[j] = s * y + c * u[j]
}
function tilt(u) { # out of the plane that is on
	if (kind == "euler") { turn(u, pk, 1, 2); turn(u, pj, 2, 3); turn(u, pi, 1, 2) }
	if (kind == "axes") { turn(u, pj, 3, 1); turn(u, pi, 2, 3) }
	if (kind == "spatial") { turn(u, pi, 2, 3); turn(u, pj, 3, 1) }
}
function work(m,  a, c, y, z) { # m: X Y Z A C; the tip in t, the axis in v
	if (kind != "") {
		v[1] = v[2] = 0; v[3] = 1; tilt(v)
		t[1] = m[1]; t[2] = m[2]; t[3] = m[3]; tilt(t)
		return
	}
	a = sign * m[4] * rad; c = sign * m[5] * rad
	v[1] = sin(c) * sin(a); v[2] = -cos(c) * sin(a); v[3] = cos(a)
	if (tcp) { t[1] = m[1]; t[2] = m[2]; t[3] = m[3]; return }
	y = m[2] * cos(a) - m[3] * sin(a); z = m[2] * sin(a) + m[3] * cos(a)
	t[1] = m[1] * cos(c) - y * sin(c); t[2] = m[1] * sin(c) + y * cos(c); t[3] = z
}
function deep(x, y, z,  dx, dy, dz, d) { # how deep a ball of 5 there is in dome or block
	d = 25 - sqrt(x * x + y * y + (z > 0 ? z * z : 0))
	if (z < 0) d = -1
	dx = x < -40 ? -40 - x : x > 40 ? x - 40 : 0; dy = y < -30 ? -30 - y : y > 30 ? y - 30 : 0
	dz = z > 0 ? z : z < -40 ? -40 - z : 0
	dx = 5 - sqrt(dx * dx + dy * dy + dz * dz)
	return d > dx ? d : dx
}
function tool(m,  h, d, worst) { # ball and shank, 100 long
	work(m); worst = -9
	for (h = 5; h <= 505; h += h > 100 ? 50 : 10) {
		d = deep(t[1] + h * v[1], t[2] + h * v[2], t[3] + h * v[3])
		if (d > worst) worst = d
	}
	return worst
}
function move(from, to,  n, i, k, m, d, far) {
	far = 0
	for (i = 1; i <= 5; i++) { d = to[i] - from[i]; if (d < 0) d = -d; if (d > far) far = d }
	n = int(far / (run > 1 ? 10 : 2)) + 1
	for (k = 0; k <= n; k++) {
		for (i = 1; i <= 5; i++) m[i] = from[i] + (to[i] - from[i]) * k / n
		d = tool(m)
		if (d > worst) { worst = d; where = line }
	}
	if ((to[4] != from[4] || to[5] != from[5]) && low(to) && from[3] < home) { turned_low = line }
}
function low(m) { work(m); return t[3] < clear - 0.01 }
function value_of(name,  i) {
	for (i = 1; i <= NF; i++) if (match($i, "^" name "[-+0-9.]")) return substr($i, length(name) + 1) + 0
	return 0
}
function value(text) { gsub(/[^-+0-9.]/, "", text); return text + 0 }
BEGIN { tcp = always; rad = atan2(0, -1) / 180; home = 500; worst = -9 }
{ line = $0; sub(/^\/?N?[0-9]+ /, ""); text = $0 }
/^[;(%]/ || /BEGIN PGM|END PGM/ { next }
/G43\.4|G43\.5|TRAORI/ || /FUNCTION TCPM/ { tcp = 1; next }
/G68\.2|CYCLE800\(0|PLANE SPATIAL/ {
	planes++; plane_step = steps
	if (/G68/) { kind_at = "euler"; pi_at = value_of("I"); pj_at = value_of("J"); pk_at = value_of("K") }
	if (/CYCLE800/) { kind_at = "axes"; split($0, number, ","); pi_at = number[8]; pj_at = number[9] }
	if (/SPATIAL/) { kind_at = "spatial"; pi_at = value_of("SPA"); pj_at = value_of("SPB") }
	next
}
/ RESET|CYCL|TRAFOOF|PLANE|^O|G69|G53\.1/ { next }
/G28|SUPA|M91|G53/ { if (!homed++) { steps = 0 } z[0] = 1; next } # up to home
/TOOL CALL|M6|^S[0-9]|^G9|^G64|^M/ { next }
{
	for (i = 1; i <= NF; i++) {
		if ($i == "G1" || $i ~ /^F[0-9]/) exit
		for (k = 1; k <= 5; k++) if (index($i, substr("XYZAC", k, 1)) == 1 && $i ~ /^.[-+=]?[D0-9.]/ && $i !~ /^.3=/) {
			word = $i; sub(/^.=?(DC\()?/, "", word); now[k] = value(word); set[k] = 1; any = 1
		}
	}
	if (!any) next
	any = 0
	steps++
	for (k = 1; k <= 5; k++) { to[steps, k] = now[k]; said[steps, k] = set[k]; set[k] = 0 }
	tcp_at[steps] = tcp; of[steps] = line; in_plane[steps] = kind_at
}
END {
	srand(seed + 7919 * ENVIRON["SEED"])
	for (run = 1; run <= runs; run++) {
		kept = worst; kept_at = where; kept_turn = turned_low; kind = ""
		do { # up from there is clear; a head, and axes that keep the tip, go up in the frame of the work
			p[1] = 600 * rand() - 300; p[2] = 600 * rand() - 300; p[3] = 400 * rand() - 30
			p[4] = run % 2 ? 0 : 200 * rand() - 100; p[5] = run % 2 ? 0 : 360 * rand() - 180
			for (k = 1; k <= 5; k++) q[k] = p[k]
			q[3] = home; worst = -9; tcp = head || always; line = "home"; move(p, q)
		} while (worst > -0.5)
		worst = kept; where = kept_at; turned_low = kept_turn
		if (p[4] != 0) turned_start++
		for (k = 1; k <= 5; k++) p[k] = q[k]
		far = 0
		for (s = 1; s <= steps; s++) {
			for (k = 1; k <= 5; k++) q[k] = said[s, k] ? to[s, k] : p[k]
			tcp = tcp_at[s]; line = of[s]
			if (in_plane[s] != kind) { # from home on in the plane
				kind = in_plane[s]; pi = pi_at; pj = pj_at; pk = pk_at; p[3] = home
				if (run == 1) { v[1] = v[2] = 0; v[3] = 1; tilt(v)
					printf "# plane %.3f %.3f %.3f\n", v[1], v[2], v[3] >"plane" }
			}
			if (!(tcp && kind == "") && p[3] == home && !said[s, 3]) { # at home, nothing is near
				if (said[s, 1] || said[s, 2]) across = s
			} else if (run == 1 || !settled) {
				move(p, q)
			}
			if (run == 1 && said[s, 3] && !first_down) { first_down = s; if (said[s, 1] || said[s, 2]) slant = line }
			for (k = 1; k <= 5; k++) p[k] = q[k]
			settled = first_down && s >= first_down # the same from here, whatever the start
		}
		settled = 0
		if (run > 1 && worst > 0.02) break
	}
	if (!homed) print "does not go home"
	if (!turned_start) print "no start with axes that are turned"
	if (slant != "") print "X Y and Z in one block: " slant
	if (turned_low != "") print "turns below the clearance plane: " turned_low
	if (worst > 0.02) printf "%.2f mm deep: %s\n", worst, where
	if (!first_down || steps < 2) print "no way down"
}
PROGRAM
runs=0
start() { # CONTROL PROGRAM SIGN CLEAR ALWAYS HEAD: what is wrong with its start, nothing when it is right
	runs=$((runs + 1))
	awk -v seed=$runs -v runs=100 -v sign="$3" -v clear="$4" -v always="${5:-0}" -v head="${6:-0}" -f start.awk "$2"
}
for c in fanuc siemens heidenhain linuxcnc; do
	machine="-m table-ac" sign=1 always=0
	[ $c = linuxcnc ] && machine="-m linuxcnc-xyzac" sign=-1 always=1
	plane=--plane
	[ $c = linuxcnc ] && plane=
	: >bad
	# shellcheck disable=SC2086
	for path in dome tilted; do
		clear=$(awk -F'[/,]' '/RAPID/ { high = 1 } /GOTO/ && high { if ($4 > z) z = $4; high = 0 } END { print z }' $path.cl)
		[ $path = tilted ] && machine="$machine $plane"
		ncpost -q -c $c $machine -o whole.nc $path.cl
		ncpost -q -c $c $machine --from 4 -o from.nc $path.cl
		ncpost -q -c $c $machine --split 110 -o part.nc $path.cl
		[ $c = linuxcnc ] || ncpost -q -c $c -m head-ca -o head.nc $path.cl
		[ $c = linuxcnc ] || ncpost -q -c $c -m head-ca --from 5 -o head-from.nc $path.cl
		for program in whole from part-2 part-3 head head-from; do
			case $program in head*) head=1 ;; *) head=0 ;; esac
			[ $c$head = linuxcnc1 ] && continue
			start $c $program.nc $sign $clear $always $head | sed "s/^/$path, $program: /" >>bad
			[ $path$program$c = tiltedwhole$c ] && [ $c != linuxcnc ] && cp plane plane.$c
		done
	done
	[ $c = linuxcnc ] || has "$c: the planes are turned to the path's axes" ' 0\.480 0\.360 0\.800' plane.$c
	empty "$c: from 1,000 starts to whole, restart and parts, tables, heads and tilted planes" bad
	# without tool-centre-point control, tables
	: >bad
	for path in dome tilted; do
		ncpost -q -c $c -m table-ac-notcp -o joint.nc $path.cl
		ncpost -q -c $c -m table-ac-notcp --from 4 -o jfrom.nc $path.cl
		ncpost -q -c $c -m table-ac-notcp --split 400 -o jpart.nc $path.cl
		[ -e jpart-2.nc ] || cp joint.nc jpart-2.nc
		for program in joint jfrom jpart-2; do
			start $c $program.nc 1 32 | sed "s/^/$path, $program: /" >>bad
		done
		rm -f jpart*
	done
	empty "$c: without tool-centre-point control" bad
done
for c in fanuc siemens heidenhain linuxcnc; do
	ncpost -q -c $c -m three-axis -o flat.nc flat.cl
	start $c flat.nc 1 30 >bad
	empty "$c: three axes, a low second rapid" bad
done

# The test finds a start that is wrong: the way over the clearance plane taken out; all in one block
ncpost -q -c fanuc --split 110 -o part.nc dome.cl
awk '/Z32\.$/ && !done { done = 1; next } 1' part-2.nc >low.nc
start fanuc low.nc 1 32 >bad
has "a start below the clearance plane is found" 'turns below|deep|no way' bad
ncpost -q -c heidenhain --plane -o plane.h tilted.cl
awk '/PLANE SPATIAL/ { plane = 1 } plane && / L Z/ && !done { sub(/Z[^ ]*/, "Z-20"); done = 1 } 1' plane.h >low.h
start heidenhain low.h 1 30 >bad
has "a way down in a tilted plane that goes too deep is found" 'deep' bad
awk '/G0 X-?[0-9.]+ Y-?[0-9.]+$/ { held = $0; next } held && / Z/ { sub(/N[0-9]+ /, ""); print held " " $0; held = ""; next } 1' \
	part-2.nc >slant.nc
start fanuc slant.nc 1 32 >bad
has "X Y and Z in one block is found" 'in one block' bad

done_testing
