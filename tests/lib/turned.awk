# turned.awk - a solid of revolution about z, from its profile, as lines for iges.awk (-v kind=igs) or
# step.awk (-v kind=step), or what is exact of it (-v kind=exact: area, volume).  The profile's lines:
# `at R Z` first, then `line R Z`, `arc R Z CR CZ ccw|cw` to the next corner; material on the left.
function face(sense, bounds, surface) {
	printf "s%d %s\nf%d ADVANCED_FACE(\047\047,(%s),{s%d},.%s.)\n", n, surface, n, bounds, n, sense ? "T" : "F"
	faces = faces (faces == "" ? "" : ",") "{f" n "}"
}
function circle(i, r, z) { # edge i, once
	if (i in made) return
	made[i] = 1
	printf "v%d VERTEX_POINT(\047\047,{p %.17g 0 %.17g})\n", i, r, z
	printf "c%d CIRCLE(\047\047,{a 0,0,%.17g 0,0,1 1,0,0},%.17g)\n", i, z, r
	printf "e%d EDGE_CURVE(\047\047,{v%d},{v%d},{c%d},.T.)\n", i, i, i, i
}
function bound(i, r, z, forwards,   k) {
	if (r == 0) return ""
	circle(i, r, z)
	k = n "x" forwards
	printf "o%s ORIENTED_EDGE(\047\047,*,*,{e%d},.%s.)\nl%s EDGE_LOOP(\047\047,({o%s}))\n", k, i, forwards ? "T" : "F", k, k
	printf "b%s FACE_BOUND(\047\047,{l%s},.T.)\n", k, k
	return "{b" k "}"
}
function end_of(r, z,   k) { # the corner's number; the profile may end where it began
	for (k = 0; k < n; k++) if (cr[k] == r && cz[k] == z) return k
	cr[n] = r; cz[n] = z
	return n
}
function step_face(type, p, z, q, w, a, b,   one, two, both, t) {
	one = bound(from, p, z, 1)
	two = bound(to, q, w, 0)
	both = one (one != "" && two != "" ? "," : "") two
	if (type == "line" && z == w) face(q < p, both, sprintf("PLANE(\047\047,{a 0,0,%.17g 0,0,1 1,0,0})", z))
	else if (type == "line" && p == q)
		face(w > z, both, sprintf("CYLINDRICAL_SURFACE(\047\047,{a 0,0,%.17g 0,0,1 1,0,0},%.17g)", z, p))
	else if (type == "line") {
		t = (q - p) / (w - z)
		face(w > z, both, sprintf("CONICAL_SURFACE(\047\047,{a 0,0,%.17g 0,0,%d 1,0,0},%.17g,%.17g)", z,
			t > 0 ? 1 : -1, p, atan2(t < 0 ? -t : t, 1) * angle))
	} else if (a == 0)
		face(ccw, both, sprintf("SPHERICAL_SURFACE(\047\047,{a 0,0,%.17g 0,0,1 1,0,0},%.17g)", b, radius))
	else face(ccw, both, sprintf("TOROIDAL_SURFACE(\047\047,{a 0,0,%.17g 0,0,1 1,0,0},%.17g,%.17g)", b, a, radius))
}
function igs_face(type, p, z, q, w, a, b) {
	if (type == "line") printf "g%d 110 0 %.17g,0,%.17g,%.17g,0,%.17g\n", n, p, z, q, w
	else if (ccw) printf "g%d 100 0@upright 0,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n", n, a, b, p, z, q, w
	else printf "g%d 100 0@upright 0,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n", n, a, b, q, w, p, z
	printf "f%d 120 0 {axis},{g%d},0.,6.2831853071795865\n", n, n
}
function exact(type, p, z, q, w, a, b,   i, m, s, e, t, f) {
	if (type == "line") {
		area += pi * (p + q) * sqrt((q - p) ^ 2 + (w - z) ^ 2)
		volume += pi / 3 * (w - z) * (p * p + p * q + q * q)
		return
	}
	s = atan2(z - b, p - a); e = atan2(w - b, q - a); m = 2000 # Simpson
	if (ccw && e <= s) e += 2 * pi
	if (!ccw && e >= s) e -= 2 * pi
	for (i = 0; i <= m; i++) {
		t = s + (e - s) * i / m; f = (i == 0 || i == m ? 1 : i % 2 ? 4 : 2) * (e - s) / m / 3
		area += 2 * pi * (a + radius * cos(t)) * radius * (f < 0 ? -f : f)
		volume += pi * (a + radius * cos(t)) ^ 2 * radius * cos(t) * f
	}
}
BEGIN {
	pi = atan2(0, -1)
	if (!angle) angle = 1 # of a radian, in the file
	if (kind == "igs") print "axis 110 0 0,0,-1,0,0,1\nupright 124 0 1,0,0,0,0,0,-1,0,0,1,0,0"
}
$1 == "at" { r = cr[0] = $2; z = cz[0] = $3; n = 0; from = 0; next }
$1 == "line" || $1 == "arc" {
	n++
	ccw = $6 == "ccw"
	radius = sqrt((r - $4) ^ 2 + (z - $5) ^ 2)
	to = end_of($2, $3)
	if (kind == "igs") igs_face($1, r, z, $2, $3, $4, $5)
	else if (kind == "step") step_face($1, r, z, $2, $3, $4, $5)
	else exact($1, r, z, $2, $3, $4, $5)
	r = $2; z = $3; from = to
}
END {
	if (kind == "step") printf "shell CLOSED_SHELL(\047\047,(%s))\nSOLID MANIFOLD_SOLID_BREP(\047\047,{shell})\n", faces
	if (kind == "exact") printf "%.9f %.9f\n", area, volume
}
