#!/bin/sh
# meshnorm-axes.t - axes that turn little: their rate, their play, lead and tilt chosen; axes that
# lean for shank and holder.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"

panel=$SRC/samples/panel_17036.xyz

# The cutting points of a path, one a line: tip, axis, contact, normal; the pass in front.
cuts() {
	awk -F'[/,]' '/PASS\// { pass = $2 }
		/CONTCT\// { c = $2; for (i = 3; i <= 7; i++) c = c " " $i }
		/^GOTO\// && c != "" { print pass, $2, $3, $4, $5, $6, $7, c; c = "" }' "$1"
}

# deepest WHAT PATH OPTION...: how deep the ball goes at the contact points (`nodes`) or anywhere on
# the path (`way`), as the tests' own reader finds it, mm
deepest() {
	case $1 in nodes) what='contact points' ;; *) what='^ball' ;; esac
	shift
	"$READBACK" -c none "$@" | sed -n "/$what: deepest/s/.*deepest \([-0-9.]*\) mm.*/\1/p"
}

cloud2mesh -q -t 4 -o "$TMP/panel.ply" "$panel"
meshnorm -q -r 8 --rows mesh --no-guard --axis-play 0 -o "$TMP/panel.cl" "$TMP/panel.ply"

# ---- calm axes

# fastest PATH: the fastest turn of the axis between points of a pass, degrees for a mm of the tip
fastest() {
	cuts "$1" | awk '{ c = $5 * a + $6 * b + $7 * e; if ($1 == last && n++) {
			s = sqrt(($6 * e - $7 * b) ^ 2 + ($7 * a - $5 * e) ^ 2 + ($5 * b - $6 * a) ^ 2)
			d = sqrt(($2 - x) ^ 2 + ($3 - y) ^ 2 + ($4 - z) ^ 2)
			v = atan2(s, c) * 45 / atan2(1, 1); if (v / d > w) w = v / d; sum += v }
		last = $1; x = $2; y = $3; z = $4; a = $5; b = $6; e = $7 }
		END { printf "%.4f %.1f\n", w, sum }'
}
fastest "$TMP/panel.cl" >"$TMP/figures"
read -r fast _ <"$TMP/figures"
below "by the normals, axes turn faster than 1.5 degrees a mm" 1.5 "$fast"
# rotary PATH: how far a machine with A and C turns them, its angles from the axes alone
rotary() {
	awk -F '[/,]' '/^GOTO/ { r = sqrt($5 * $5 + $6 * $6); a = atan2(r, $7); c = r > 1e-6 ? atan2($6, $5) : last
		if (n++) { d = c - last; while (d > 3.14159265) d -= 6.2831853; while (d < -3.14159265) d += 6.2831853
			if (d < 0) d = -d; e = a > lean ? a - lean : lean - a; f = a + lean + 3.14159265 - d
			sum += d + e < f ? d + e : f }
		last = c; lean = a } END { printf "%.1f\n", sum * 180 / 3.14159265 }' "$1"
}
status 0 "no faster than 0.8" meshnorm -q -r 8 --rows mesh --no-guard --axis-play 0 --axis-rate 0.8 -o "$TMP/rate.cl" "$TMP/panel.ply"
below "and they don't, on the digits that are printed" "$(fastest "$TMP/rate.cl" | cut -d' ' -f1)" 0.8
below "the ball is where it was" "$(deepest nodes "$TMP/rate.cl" --panel)" 0.005
status 0 "with a play of 10 degrees" meshnorm -q -r 8 --rows mesh --no-guard --axis-play 10 -o "$TMP/play.cl" "$TMP/panel.ply"
below "rotary axes turn less than half as much" "$(rotary "$TMP/play.cl")" \
	"$(rotary "$TMP/panel.cl" | awk '{ print 0.5 * $1 }')"
# the rule with a play: the axes of panel.cl, averaged along the pass over 5 radii to both
# sides, and that twice; up to 10 degrees off the mean that goes no further than to the nearer end, but
# 1.4 radii
cuts "$TMP/panel.cl" >"$TMP/rule"
cuts "$TMP/play.cl" | paste -d' ' - "$TMP/rule" | awk '
	function mean(least, i, h, k, a, b, m, u, v, w, l) { # the integral by the middle of what is in reach
		for (i = 1; i <= n; i++) {
			h = s[i] < s[n] - s[i] ? s[i] : s[n] - s[i]; if (h > 40) h = 40; if (h < least) h = least
			u = v = w = 0
			for (k = 1; k < n; k++) {
				a = s[k] > s[i] - h ? s[k] : s[i] - h; b = s[k + 1] < s[i] + h ? s[k + 1] : s[i] + h
				if (b <= a) continue
				m = ((a + b) / 2 - s[k]) / (s[k + 1] - s[k])
				u += (b - a) * (ru[k] + m * (ru[k + 1] - ru[k]))
				v += (b - a) * (rv[k] + m * (rv[k + 1] - rv[k]))
				w += (b - a) * (rw[k] + m * (rw[k + 1] - rw[k])) }
			l = sqrt(u * u + v * v + w * w); nu[i] = u / l; nv[i] = v / l; nw[i] = w / l }
		for (i = 1; i <= n; i++) { ru[i] = nu[i]; rv[i] = nv[i]; rw[i] = nw[i] }
	}
	function worst(i, c, a, f) { # of the pass that is held
		if (n < 2) return
		for (i = 1; i <= n; i++) { su[i] = ru[i]; sv[i] = rv[i]; sw[i] = rw[i] }
		mean(11.2); mean(11.2)
		for (i = 1; i <= n; i++) {
			eu[i] = ru[i]; ev[i] = rv[i]; ew[i] = rw[i]; ru[i] = su[i]; rv[i] = sv[i]; rw[i] = sw[i] }
		mean(40); mean(40)
		for (i = 1; i <= n; i++) { # straight between the two, within 0.03 degrees of round
			c = ru[i] * eu[i] + rv[i] * ev[i] + rw[i] * ew[i]
			a = c < 1 ? atan2(sqrt(1 - c * c), c) * 45 / atan2(1, 1) : 0; f = a > 10 ? 10 / a : 1
			ru[i] = eu[i] + f * (ru[i] - eu[i]); rv[i] = ev[i] + f * (rv[i] - ev[i])
			rw[i] = ew[i] + f * (rw[i] - ew[i]); c = sqrt(ru[i] ^ 2 + rv[i] ^ 2 + rw[i] ^ 2)
			ru[i] /= c; rv[i] /= c; rw[i] /= c }
		for (i = 1; i <= n; i++) {
			c = ru[i] * pu[i] + rv[i] * pv[i] + rw[i] * pw[i]
			a = c < 1 ? atan2(sqrt(1 - c * c), c) * 45 / atan2(1, 1) : 0; if (a > most) most = a }
	}
	$1 != pass { worst(); n = 0; pass = $1 }
	{ x = $2 + 8 * $5; y = $3 + 8 * $6; z = $4 + 8 * $7; n++
	s[n] = n > 1 ? s[n - 1] + sqrt((x - a) ^ 2 + (y - b) ^ 2 + (z - c) ^ 2) : 0; a = x; b = y; c = z
	pu[n] = $5; pv[n] = $6; pw[n] = $7; ru[n] = $18; rv[n] = $19; rw[n] = $20
	if ($8 != $21 || $9 != $22) apart = 90 }
	END { worst(); print (apart > most ? apart : most) }' >"$TMP/figures"
below "and are no more than 10 degrees off the rule averaged, half a degree more at the pole" "$(cat "$TMP/figures")" 10.6
below "but make use of them" 5 "$(cat "$TMP/figures")"

# ---- lead and tilt chosen

status 0 "lead and tilt that turn least" meshnorm -r 8 --rows mesh --no-guard --axis-play 0 --least-turn 25 -o "$TMP/turn.cl" "$TMP/panel.ply"
has "are told" 'lead .* tilt .*rotary axes turn' "$TMP/err"
below "rotary axes turn a quarter less" "$(rotary "$TMP/turn.cl")" \
	"$(rotary "$TMP/panel.cl" | awk '{ print 0.75 * $1 }')"
below "the ball is where it was, whatever the lean" "$(deepest nodes "$TMP/turn.cl" --panel)" 0.005
status 2 "with an axis that is given" meshnorm -r 8 --least-turn 25 --fixed 0,0,1 "$TMP/panel.ply"

# ---- shank and holder: a post beside a floor, and a holder wider than the ball

awk 'BEGIN { for (i = 0; i <= 80; i++) for (j = 0; j <= 40; j++) print i / 2, j / 2, 0
	for (k = 0; k <= 100; k++) for (a = 0; a < 12; a++) print 20 + cos(a * 0.5236), 25 + sin(a * 0.5236), k / 2 }' \
	>"$TMP/post.xyz"
head -n 3321 "$TMP/post.xyz" | cloud2mesh -q -t 2 -o "$TMP/floor.ply" -
status 0 "a path beside the post" meshnorm -q -r 4 --rows mesh --tilt 0 -g "$TMP/post.xyz" -o "$TMP/none.cl" "$TMP/floor.ply"
status 0 "its holder leans away" meshnorm -v -r 4 --rows mesh --tilt 0 --holder 4:25+15:30 --lean-limit 45 \
	-g "$TMP/post.xyz" -o "$TMP/lean.cl" "$TMP/floor.ply"
has "by so much" 'axes at most [1-9][0-9.]* degrees off' "$TMP/err"
# pierced PATH: how deep points of the post are in a cylinder of radius 15 from 25 to 55 mm above
# the ball's centre
pierced() {
	cuts "$1" >"$TMP/cuts"
	awk 'NR == FNR { if (FNR > 3321) { px[n] = $1; py[n] = $2; pz[n++] = $3 } next }
		{ x = $2 + 4 * $5; y = $3 + 4 * $6; z = $4 + 4 * $7
		for (k = 0; k < n; k += 3) { u = px[k] - x; v = py[k] - y; w = pz[k] - z
			h = u * $5 + v * $6 + w * $7; if (h < 25 || h > 55) continue
			d = 15 - sqrt(u * u + v * v + w * w - h * h); if (d > h - 25) d = h - 25
			if (d > deep) deep = d } } END { printf "%.4f\n", deep }' "$TMP/post.xyz" "$TMP/cuts"
}
below "upright it would go through the post" 5 "$(pierced "$TMP/none.cl")"
below "leaned it does not" "$(pierced "$TMP/lean.cl")" 0.0101
status 3 "where it may not lean it is told" meshnorm -r 4 --rows mesh --tilt 0 --holder 4:25+15:30 --lean-limit 0 \
	-g "$TMP/post.xyz" -o "$TMP/held.cl" "$TMP/floor.ply"
has "with its pass and place" 'keeps flute, shank and holder clear at [0-9]+ points, about [0-9.]+ mm2: .*in pass [0-9]+ at' "$TMP/err"
below "and these points are left out" "$(pierced "$TMP/held.cl")" 0.0101
status 0 "or accepted" meshnorm -q -r 4 --rows mesh --tilt 0 --holder 4:25+15:30 --lean-limit 0 --avoid \
	-g "$TMP/post.xyz" -o "$TMP/avoid.cl" "$TMP/floor.ply"
status 0 "the same in planecut" planecut -q -r 4 --tilt 0 -s 2 --holder 4:25+15:30 --lean-limit 45 \
	-g "$TMP/post.xyz" -o "$TMP/plane.cl" "$TMP/floor.ply"
below "which leans too" "$(pierced "$TMP/plane.cl")" 0.0101
status 2 "a holder that is none" meshnorm -r 4 --holder big "$TMP/floor.ply"
has "is told" 'option --holder: found .big' "$TMP/err"

# ---- machines with fewer than two rotary axes: a fixed axis, and one that they have

few() { # STATUS MACHINE OPTION...: of both tools
	want=$1 machine=$2
	shift 2
	status "$want" "$machine $*" meshnorm -r 8 --rows mesh --no-guard -m "$machine" "$@" \
		-o "$TMP/few.cl" "$TMP/panel.ply"
	status "$want" "planecut: $machine $*" planecut -r 8 -s 6 --no-guard -m "$machine" "$@" \
		-o "$TMP/few.cl" "$TMP/panel.ply"
}
few 2 three-axis
has "of none it is told" 'three-axis: found 0 of two rotary axes, expected --fixed' "$TMP/err"
few 0 three-axis --fixed 0,0,1
few 2 three-axis --fixed 0,0.2,1
few 2 three-axis --fixed 0,0,1 --lean-limit 10
printf 'include = table-a\nname = C\naxes = C\n' >"$TMP/c.txt"
few 2 "$TMP/c.txt" --tilt 20
has "of one along the tool" 'c.txt: found 1 of two rotary axes' "$TMP/err"
few 0 table-a --fixed 0,0.2,1
status 0 "which the program takes" ncpost -q -c linuxcnc -m table-a -o "$TMP/few.ngc" "$TMP/few.cl"
few 2 table-a --fixed 0.1,0.2,1

# ---- one rotary axis across the tool: of the circle of axes that it has the nearest to the rule

# Half of a cylinder about X, R 15, on posts, so that walls are to both sides.
awk 'BEGIN { for (x = -6; x <= 6.001; x += 0.4) for (a = -72; a <= 72.001; a += 2)
	printf "%.5f %.5f %.5f\n", x, 15 * sin(a / 57.29578), 15 * cos(a / 57.29578) }' >"$TMP/half.xyz"
cloud2mesh -q "$TMP/half.xyz" -o "$TMP/half.ply"
turns() { # LOW HIGH: the path in $TMP/one.cl has axes of the circle about X, and as far as that
	awk -F, -v low="$1" -v high="$2" '/^GOTO/ { n++; a = -atan2($5, $6) * 57.29578
		if ($4 != 0 || a < low || a > high) bad++; if (a < least) least = a; if (a > most) most = a }
		END { print least, most; exit !(n > 50 && bad == 0 && least < 0.6 * low && most > 0.6 * high) }' "$TMP/one.cl"
}
one() { # STATUS MACHINE OPTION...: a path, which is as long for ncpost on every control
	want=$1 machine=$2
	shift 2
	status "$want" "$machine $*" meshnorm -r 3 --avoid -m "$machine" "$@" -o "$TMP/one.cl" "$TMP/half.ply"
	[ "$want" -eq 0 ] || return
	for fit in 'biarcfit -e 0.01' 'bsplfit -e 0.01' cat; do
		$fit "$TMP/one.cl" >"$TMP/one.fit" 2>/dev/null
		for control in fanuc siemens heidenhain linuxcnc; do
			ncpost -q -c $control -m "$machine" "$TMP/one.fit" -o "$TMP/one.nc"
			result $? "$machine $*: ${fit%% *}, $control: the machine has these axes"
			status 0 "... and the program is accepted" ncverify -q -g "$TMP/half.xyz" -m "$machine" \
				-p "$TMP/one.fit" "$TMP/one.nc"
		done
	done
}
one 0 table-a
ok "table-a: the axis turns with the surface" turns -88 88
printf 'include = table-a\nname = part of A\na.min = -30\na.max = 50\n' >"$TMP/part.txt"
one 0 "$TMP/part.txt" --tilt 0
ok "as far as its travel" turns -30 50
cd "$TMP" || exit 1
status 0 "planecut has them, too" planecut -q -r 3 --scallop 0.02 --avoid -m table-a half.ply -o one.cl
ok "of the circle" turns -88 88
for rule in '--to-point 0,0,90' '--from-point 0,4,-30' '--lead 10' '--least-turn 25' '--axis-rate 4' '--circle 0,0,60,0,1,0,20'; do
	# shellcheck disable=SC2086
	status 0 "$rule" meshnorm -q -r 3 --avoid -m table-a $rule -o one.cl half.ply
	ok "... of the circle" awk -F, '/^GOTO/ { n++; if ($4 != 0) exit 1 } END { exit !n }' one.cl
done

# A wall across the slope, at its foot: with the travel there is the tool does not come there, which is told.
awk '{ print } END { for (x = -6; x <= 6.001; x += 0.4) for (z = -2; z <= 24; z += 0.4)
	printf "%.5f %.5f %.5f\n", x, 17.5, z }' half.xyz >walled.xyz
cloud2mesh -q half.xyz -o walled.ply
meshnorm -r 3 --avoid -m part.txt -g walled.xyz -o walled.cl walled.ply 2>err
has "what no axis of the circle reaches is told with its area" \
	'(keeps flute, shank and holder clear at|out of reach of ball and tool:) .* mm2' err

done_testing
