# splines.awk - how far the B-splines of a path are from the points of the path they were made of.
#
#	awk -f splines.awk POINTS.cl SPLINES.cl
#
# A reader of its own: de Boor's algorithm on the printed numbers, 1600 places on each curve, the
# distance both ways to the polyline of the points.  Both files hold the same runs, parted by RAPID.
# Prints the largest distance, mm.

/^\$\$/ { next }
/ \$$/ { held = held substr($0, 1, length($0) - 2); next }
{ line = held $0; held = "" }
FNR == 1 { file++; run = 0; rapid = 0 }
line ~ /^RAPID/ { rapid = 1 }
line ~ /^MOVNRB\/ON/ { split(line, f, ","); order = f[2] + 0; knots = f[3] + 0; poles = f[5] + 0; inside = 1 }
line ~ /^MOVNRB\/1,/ { split(line, knot, ","); for (i = 1; i <= knots; i++) knot[i] = knot[i + 1] + 0 }
line ~ /^MOVNRB\/2,/ { split(line, pole, ","); for (i = 1; i <= 3 * poles; i++) pole[i] = pole[i + 1] + 0 }
line ~ /^MOVNRB\/OFF/ { inside = 0; curve(); compare() }
line ~ /^GOTO/ && !inside {
	if (rapid) { n = rapid = 0; run++; next }
	sub(/^GOTO\//, "", line)
	split(line, f, ",")
	if (file == 1) {
		count[run] = ++n
		for (c = 1; c <= 3; c++) data[run, n, c] = f[c] + 0
	}
}

# The curve at 1600 places: way[k, c].
function curve(  k, u, i, c, r, j, a, span) {
	for (k = 0; k <= 1600; k++) {
		u = knot[1] + (knot[knots] - knot[1]) * k / 1600
		for (span = order; span < poles && knot[span + 1] <= u; span++) ;
		for (c = 1; c <= 3; c++) {
			for (i = 0; i < order; i++) d[i] = pole[3 * (span - order + i) + c]
			for (r = 1; r < order; r++)
				for (i = order - 1; i >= r; i--) {
					j = span - order + 1 + i
					a = (u - knot[j]) / (knot[j + order - r] - knot[j])
					d[i] = (1 - a) * d[i - 1] + a * d[i]
				}
			way[k, c] = d[order - 1]
		}
	}
}

function from_piece(px, py, pz, ax, ay, az, bx, by, bz,  t, l) {
	bx -= ax; by -= ay; bz -= az; px -= ax; py -= ay; pz -= az
	l = bx * bx + by * by + bz * bz
	t = l > 0 ? (px * bx + py * by + pz * bz) / l : 0
	t = t < 0 ? 0 : t > 1 ? 1 : t
	return (px - t * bx) ^ 2 + (py - t * by) ^ 2 + (pz - t * bz) ^ 2
}

function compare(  k, i, best, off) {
	for (k = 0; k <= 1600; k += 32) {
		best = 1e30
		for (i = 1; i < count[run]; i++) {
			off = from_piece(way[k, 1], way[k, 2], way[k, 3], data[run, i, 1], data[run, i, 2],
				data[run, i, 3], data[run, i + 1, 1], data[run, i + 1, 2], data[run, i + 1, 3])
			if (off < best) best = off
		}
		if (best > worst) worst = best
	}
	for (i = 1; i <= count[run]; i += 7) {
		best = 1e30
		for (k = 0; k < 1600; k++) {
			off = from_piece(data[run, i, 1], data[run, i, 2], data[run, i, 3], way[k, 1], way[k, 2],
				way[k, 3], way[k + 1, 1], way[k + 1, 2], way[k + 1, 3])
			if (off < best) best = off
		}
		if (best > worst) worst = best
	}
	curves++
}

END { if (curves) printf "%.6f\n", sqrt(worst) }
