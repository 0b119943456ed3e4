# splines.awk - how far the B-splines of a path are from the points of the path they were made of.
#
#	awk -f splines.awk POINTS.cl SPLINES.cl
#
# A reader of its own: de Boor's algorithm on the printed numbers at 8 places of each span, the
# distance both ways to the polyline of the points; some 60 points a run, at their nearest places of the
# curves, found by golden sections.  Both files hold the same runs, separated by RAPID.  Prints the
# largest distance, mm.

/^\$\$/ { next }
/ \$$/ { held = held substr($0, 1, length($0) - 2); next }
{ line = held $0; held = "" }
FNR == 1 { file++; run = 0; rapid = 0 }
line ~ /^RAPID/ { rapid = 1 }
line ~ /^MOVNRB\/ON/ { split(line, f, ","); c++; order[c] = f[2] + 0; knots[c] = f[3] + 0; poles[c] = f[5] + 0; inside = 1 }
line ~ /^MOVNRB\/1,/ { split(line, f, ","); for (i = 1; i <= knots[c]; i++) knot[c, i] = f[i + 1] + 0 }
line ~ /^MOVNRB\/2,/ { split(line, f, ","); for (i = 1; i <= 3 * poles[c]; i++) pole[c, i] = f[i + 1] + 0 }
line ~ /^MOVNRB\/OFF/ { inside = 0; curve(); curves++ }
line ~ /^GOTO/ && !inside {
	if (rapid) {
		if (places) compare()
		n = rapid = c = places = 0; run++
		next
	}
	sub(/^GOTO\//, "", line)
	split(line, f, ",")
	if (file == 1) {
		count[run] = ++n
		for (i = 1; i <= 3; i++) data[run, n, i] = f[i] + 0
	}
}

# The point x[] of curve c at u.
function at(c, u,  i, k, r, j, a, span) {
	for (span = order[c]; span < poles[c] && knot[c, span + 1] <= u; span++) ;
	for (k = 1; k <= 3; k++) {
		for (i = 0; i < order[c]; i++) d[i] = pole[c, 3 * (span - order[c] + i) + k]
		for (r = 1; r < order[c]; r++)
			for (i = order[c] - 1; i >= r; i--) {
				j = span - order[c] + 1 + i
				a = (u - knot[c, j]) / (knot[c, j + order[c] - r] - knot[c, j])
				d[i] = (1 - a) * d[i - 1] + a * d[i]
			}
		x[k] = d[order[c] - 1]
	}
}

function put(u,  k) {
	at(c, u)
	places++
	for (k = 1; k <= 3; k++) way[places, k] = x[k]
	way_u[places] = u
	way_c[places] = c
}

# The places of the last curve.
function curve(  s, k) {
	for (s = order[c]; s <= poles[c]; s++)
		for (k = 0; k < 8; k++) put(knot[c, s] + (knot[c, s + 1] - knot[c, s]) * k / 8)
	put(knot[c, knots[c]])
}

function from_piece(px, py, pz, ax, ay, az, bx, by, bz,  t, l) {
	bx -= ax; by -= ay; bz -= az; px -= ax; py -= ay; pz -= az
	l = bx * bx + by * by + bz * bz
	t = l > 0 ? (px * bx + py * by + pz * bz) / l : 0
	t = t < 0 ? 0 : t > 1 ? 1 : t
	return (px - t * bx) ^ 2 + (py - t * by) ^ 2 + (pz - t * bz) ^ 2
}

function square_to(i, a, b, e) { return (data[run, i, 1] - a) ^ 2 + (data[run, i, 2] - b) ^ 2 + (data[run, i, 3] - e) ^ 2 }
function square_at(i, c, u) { at(c, u); return square_to(i, x[1], x[2], x[3]) }

# The least distance of point i from the curve about the places k and k + 1.
function refine(i, k,  a, b, p, q, fp, fq, n) {
	a = way_u[k > 1 && way_c[k - 1] == way_c[k] ? k - 1 : k]
	b = way_u[k + 1 < places && way_c[k + 2] == way_c[k] ? k + 2 : k + 1]
	p = b - 0.618 * (b - a); q = a + 0.618 * (b - a)
	fp = square_at(i, way_c[k], p); fq = square_at(i, way_c[k], q)
	for (n = 0; n < 18; n++)
		if (fp < fq) { b = q; q = p; fq = fp; p = b - 0.618 * (b - a); fp = square_at(i, way_c[k], p) }
		else { a = p; p = q; fp = fq; q = a + 0.618 * (b - a); fq = square_at(i, way_c[k], q) }
	return fp < fq ? fp : fq
}

# The longest of n pieces, along x; arrays by one number are far quicker to look up than by two.
function longest(x, n,  i, d, most) {
	for (i = 1; i < n; i++) { d = x[i + 1] - x[i]; if (d < 0) d = -d; if (d > most) most = d }
	return most + 1e-9
}

# A piece is not asked for its distance where it is farther off along x than the nearest so far.
function compare(  k, i, n, best, within, near, off) {
	n = count[run]
	stride = 1 + int(n / 60)
	for (i = 1; i <= n; i++) {
		px[i] = data[run, i, 1]; py[i] = data[run, i, 2]; pz[i] = data[run, i, 3] }
	for (k = 1; k <= places; k++) { wx[k] = way[k, 1]; wy[k] = way[k, 2]; wz[k] = way[k, 3] }
	point_step = longest(px, n); way_step = longest(wx, places)
	for (k = 1; k <= places; k += 1 + int(places / 200)) {
		best = within = 1e30
		for (i = 1; i < n; i++) {
			off = px[i] - wx[k]
			if (off > within || -off > within) continue
			off = from_piece(wx[k], wy[k], wz[k], px[i], py[i], pz[i], px[i + 1], py[i + 1], pz[i + 1])
			if (off < best) { best = off; within = sqrt(best) + point_step }
		}
		if (best > worst) worst = best
	}
	for (i = 1; i <= n; i += stride) {
		best = within = 1e30
		for (k = 1; k < places; k++) {
			if (way_c[k] != way_c[k + 1]) continue
			off = wx[k] - px[i]
			if (off > within || -off > within) continue
			off = from_piece(px[i], py[i], pz[i], wx[k], wy[k], wz[k], wx[k + 1], wy[k + 1], wz[k + 1])
			if (off < best) { best = off; near = k; within = sqrt(best) + way_step }
		}
		best = refine(i, near)
		if (best > worst) worst = best
	}
}

END { if (places) compare(); if (curves) printf "%.6f\n", sqrt(worst) }
