#!/bin/sh
# cloud2mesh-sides.t - a surface that folds under itself, seen from above: no facet faces into it,
# and where much of the mesh would, that is no mesh to be cut without a word.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"

# A cap of a ball of radius 9 about 0 0 0, points 0.7 mm apart, turned by LEAN degrees about x.
cap() { # LEAN
	LC_ALL=C awk -v lean="$1" 'BEGIN {
		c = cos(lean * 0.017453292519943295); s = sin(lean * 0.017453292519943295)
		for (x = -8; x <= 8; x += 0.7) for (y = -8; y <= 8; y += 0.7) {
			if (x * x + y * y > 70) continue
			z = sqrt(81 - x * x - y * y)
			printf "%.5f %.5f %.5f\n", x, c * y - s * z, s * y + c * z
		}
	}'
}

# How many facets face the middle of that ball.
inward() { # MESH
	awk 'BEGIN { n = 0 }
		/^element vertex/ { nv = $3 }
		/^end_header/ { body = 1; next }
		body && n < nv { x[n] = $1; y[n] = $2; z[n++] = $3; next }
		body { a = $2; b = $3; c = $4
			ux = x[b] - x[a]; uy = y[b] - y[a]; uz = z[b] - z[a]
			vx = x[c] - x[a]; vy = y[c] - y[a]; vz = z[c] - z[a]
			d = (uy * vz - uz * vy) * (x[a] + x[b] + x[c])
			d += (uz * vx - ux * vz) * (y[a] + y[b] + y[c])
			d += (ux * vy - uy * vx) * (z[a] + z[b] + z[c])
			if (d < 0) k++ }
		END { print k + 0 }' "$1"
}

cap -20 >"$TMP/cap.xyz"
ok "a cap seen from above: a mesh" cloud2mesh -o "$TMP/cap.ply" "$TMP/cap.xyz"
hasnt "none of it faces against its points" 'face against' "$TMP/err"
hasnt "it faces up" 'leans' "$TMP/err"

cap -82 >"$TMP/cap.xyz"
ok "a cap that leans far: a mesh" cloud2mesh -o "$TMP/cap.ply" "$TMP/cap.xyz"
has "that most of it is steep and it folds" \
	'folds under itself, seen from above: [5-9][0-9]\.[0-9] % of its mesh is steeper' "$TMP/err"
has "so that it is by parts" 'divided into [1-9]' "$TMP/err"
below "no facet faces into it" "$(inward "$TMP/cap.ply")" 0
has "which side was taken" 'was taken for the outside' "$TMP/err"
cloud2mesh -q --subdivide -o "$TMP/parts.ply" "$TMP/cap.xyz"
same "the same as by parts at once" "$TMP/parts.ply" "$TMP/cap.ply"
ok "with what is under others kept" cloud2mesh -v --outliers keep -o "$TMP/cap.ply" "$TMP/cap.xyz"
has "no point is there twice" '439 points in, 0 left out' "$TMP/err"
cloud2mesh -q --subdivide --outliers keep -o "$TMP/parts.ply" "$TMP/cap.xyz"
same "and as by parts at once" "$TMP/parts.ply" "$TMP/cap.ply"
status 3 "extended it is not by parts" cloud2mesh --extend 1 -o "$TMP/cap.ply" "$TMP/cap.xyz"
has "which is told" 'steeper than 70 degrees, and it folds under itself' "$TMP/err"

cap -90 >"$TMP/cap.xyz"
status 3 "a cap that stands upright: not kept" cloud2mesh -o "$TMP/cap.ply" "$TMP/cap.xyz"
has "how much faces against its points is told" \
	'and [1-9][0-9]?\.[0-9] % would face against the points about it' "$TMP/err"
status 3 "extended, too" cloud2mesh --extend 1 -o "$TMP/cap.ply" "$TMP/cap.xyz"
has "as a mesh seen from above" \
	'% of the mesh would face against the points about it, expected at most 10 %' "$TMP/err"
status 3 "divided it is a mesh of nobody knows which side" \
	cloud2mesh --subdivide -o "$TMP/cap.ply" "$TMP/cap.xyz"
hasnt "no facet of it faces against the points" 'face against' "$TMP/err"
has "which side was taken is told" \
	'upright: the side that faces -?0\.0[0-9]+ [01]\.[0-9]+ -?0\.[0-9]+ was taken for' "$TMP/err"
has "and what to say" 'expected --subdivide --outside I,J,K' "$TMP/err"
has "its head says so" '^comment unmet .*stands upright' "$TMP/cap.ply"

ok "its outside is said" cloud2mesh --subdivide --outside 0.2,3,0.1 -o "$TMP/cap.ply" "$TMP/cap.xyz"
below "and is the outside of the mesh" "$(inward "$TMP/cap.ply")" 0
hasnt "of which nothing is told" 'outside' "$TMP/err"
ok "the other side is said" cloud2mesh --subdivide --outside 0,-1,0 -o "$TMP/cap.ply" "$TMP/cap.xyz"
faces=$(sed -n 's/^element face //p' "$TMP/cap.ply")
below "and is the outside" "$((faces - $(inward "$TMP/cap.ply")))" 0

lean() { # a plate of 60 degrees
	awk 'BEGIN { for (x = 0; x <= 20; x += 0.5) for (t = 0; t <= 10; t += 0.5)
		printf "%.4f %.4f %.4f\n", x, t * 0.5, t * 0.866 }'
}
lean >"$TMP/lean.xyz"
ok "a plate that leans by 60 degrees, seen from below" cloud2mesh --subdivide --outside 0,1,-1 \
	-o "$TMP/lean.ply" "$TMP/lean.xyz"
status 3 "no path is made of it without a word" \
	meshnorm -r 2 --avoid -o "$TMP/lean.cl" "$TMP/lean.ply"
has "a scan is guarded from above" \
	'the surface faces down, along -?0\.000 0\.866 -0\.500' "$TMP/err"
ok "faces down" awk '$1 == "element" && $2 == "vertex" { n = $3 } body && i++ < n { bad += $6 >= 0 }
	/^end_header/ { body = 1 } END { exit !(n > 100 && bad == 0) }' "$TMP/lean.ply"
status 2 "an outside of a grid seen from above" cloud2mesh --outside 0,0,1 "$TMP/lean.xyz"
has "is none" 'found --outside without --subdivide, expected both' "$TMP/err"
status 2 "an outside of no length" cloud2mesh --subdivide --outside 0,0,0 "$TMP/lean.xyz"
has "is none" 'option --outside: found a direction of no length' "$TMP/err"

done_testing
