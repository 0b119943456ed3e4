# model.sh - models as IGES and STEP from short lines, and what is measured on their meshes.
#
# shellcheck shell=sh

# Area, volume and, by place, the edges that have not one facet on each side.
measure() { # FILE
	"$READBACK" --mesh "$1" | cut -d' ' -f3-5
}

# model DESC AREA VOLUME ARGS...: exact area and volume (- for an open surface) within 1e-4 of them
model() {
	what=$1 want_area=$2 want_volume=$3
	shift 3
	nurbs2mesh "$@" >"$TMP/model.ply" 2>"$TMP/model.err"
	ok "$what: is read" test $? -eq 0
	measure "$TMP/model.ply" >"$TMP/measure"
	read -r area volume open <"$TMP/measure"
	part "$what: area" "$area" "$want_area"
	[ "$want_volume" = - ] && return
	part "$what: volume" "$volume" "$want_volume"
	ok "$what: is closed" test "$open" -eq 0
}

part() { # DESC VALUE WANT: within 1e-4 of it, or $within
	below "$1 ($2, expected $3)" "$(awk -v a="$2" -v b="$3" 'BEGIN { d = (a - b) / b; print d < 0 ? -d : d }')" "${within:-0.0001}"
}

calc() { # EXPRESSION of p (pi)
	awk "BEGIN { p = atan2(0, -1); printf \"%.9f\\n\", $1 }"
}

iges() { # NAME [-v ...]: from standard input
	name=$1
	shift
	awk -f "$SRC/tests/lib/iges.awk" "$@" >"$TMP/$name.igs"
}

step() { # NAME [-v ...]: from standard input, in which SOLID is the solid
	name=$1
	shift
	{ cat; echo "REP ADVANCED_BREP_SHAPE_REPRESENTATION('',({SOLID}),{CONTEXT})"; } |
		awk -f "$SRC/tests/lib/step.awk" "$@" >"$TMP/$name.step"
}

# Two cubes of 10 as twelve squares with outlines, f1 to f12, for iges: the second is beside the first in
# x, and DY further in y.
two_cubes() { # DY
	awk -v dy="$1" 'function face(n, x, y, z, i,   k, c, text, p, q) { # at x y z across direction i
			p[0] = x; p[1] = y; p[2] = z; text = ""
			for (c = 0; c < 5; c++) {
				for (k = 0; k < 3; k++) q[k] = p[k]
				q[(i + 1) % 3] += 10 * (c == 1 || c == 2); q[(i + 2) % 3] += 10 * (c == 2 || c == 3)
				text = text "," q[0] "," q[1] "," q[2] }
			print "p" n " 108 0 " (i == 0) "," (i == 1) "," (i == 2) "," p[i] ",0,0,0,0,1"
			print "r" n " 106 12 2,5" text
			print "o" n " 142 0 0,{p" n "},0,{r" n "},2"
			print "f" n " 144 0 {p" n "},1,0,{o" n "}" }
		BEGIN { for (c = 0; c < 2; c++) for (i = 0; i < 3; i++) for (far = 0; far < 20; far += 10)
			face(++n, 10 * c + (i == 0) * far, dy * c + (i == 1) * far, (i == 2) * far, i) }'
}

# The entities of a closed cylinder, radius 10 and 30 high, up to its shell, for iges.
cylinder_shell() {
	cat <<'END'
origin 116 0 0,0,0,0
top 116 0 0,0,30,0
z 123 0 0,0,1
c0 100 0 0,0,0,10,0,10,0
c1 100 0 30,0,0,10,0,10,0
seam 110 0 10,0,0,10,0,30
vertices 502 1 2,10,0,0,10,0,30
edges 504 1 3,{c0},{vertices},1,{vertices},1,{c1},{vertices},2,{vertices},2,{seam},{vertices},1,{vertices},2
side 192 0 {origin},{z},10
floor 190 0 {origin},{z}
lid 190 0 {top},{z}
l1 508 1 4,0,{edges},1,1,0,0,{edges},3,1,0,0,{edges},2,0,0,0,{edges},3,0,0
l2 508 1 1,0,{edges},1,0,0
l3 508 1 1,0,{edges},2,1,0
f1 510 1 {side},1,1,{l1}
f2 510 1 {floor},1,1,{l2}
f3 510 1 {lid},1,1,{l3}
shell 514 1 3,{f1},1,{f2},0,{f3},1
END
}

# dprism R X H: a cylinder of radius R about z, of which what is at less than x = X is cut off
dprism() {
	awk -v r="$1" -v x="$2" -v h="$3" 'BEGIN { y = sqrt(r * r - x * x)
		printf "va VERTEX_POINT(\047\047,{p %.17g %.17g 0})\nvb VERTEX_POINT(\047\047,{p %.17g %.17g 0})\n", x, -y, x, y
		printf "vc VERTEX_POINT(\047\047,{p %.17g %.17g %d})\nvd VERTEX_POINT(\047\047,{p %.17g %.17g %d})\n", x, -y, h, x, y, h
		printf "ga LINE(\047\047,{p %.17g %.17g 0},{wy})\ngb LINE(\047\047,{p %.17g %.17g %d},{wy})\n", x, -y, x, -y, h
		printf "gc LINE(\047\047,{p %.17g %.17g 0},{wz})\ngd LINE(\047\047,{p %.17g %.17g 0},{wz})\n", x, -y, x, y
		printf "ka CIRCLE(\047\047,{a 0,0,0 0,0,1 1,0,0},%d.)\nkb CIRCLE(\047\047,{a 0,0,%d 0,0,1 1,0,0},%d.)\n", r, h, r
		printf "s1 CYLINDRICAL_SURFACE(\047\047,{a 0,0,0 0,0,1 1,0,0},%d.)\ns2 PLANE(\047\047,{a 0,0,0 0,0,-1 1,0,0})\n", r
		printf "s3 PLANE(\047\047,{a 0,0,%d 0,0,1 1,0,0})\ns4 PLANE(\047\047,{a %.17g,0,0 -1,0,0 0,1,0})\n", h, x }'
	cat <<'END'
wy VECTOR('',{d 0 1 0},1.)
wz VECTOR('',{d 0 0 1},1.)
ea EDGE_CURVE('',{va},{vb},{ka},.T.)
eb EDGE_CURVE('',{vc},{vd},{kb},.T.)
ec EDGE_CURVE('',{va},{vc},{gc},.T.)
ed EDGE_CURVE('',{vb},{vd},{gd},.T.)
ee EDGE_CURVE('',{va},{vb},{ga},.T.)
ef EDGE_CURVE('',{vc},{vd},{gb},.T.)
o1 ORIENTED_EDGE('',*,*,{ea},.T.)
o2 ORIENTED_EDGE('',*,*,{ed},.T.)
o3 ORIENTED_EDGE('',*,*,{eb},.F.)
o4 ORIENTED_EDGE('',*,*,{ec},.F.)
o5 ORIENTED_EDGE('',*,*,{ea},.F.)
o6 ORIENTED_EDGE('',*,*,{ee},.T.)
o7 ORIENTED_EDGE('',*,*,{eb},.T.)
o8 ORIENTED_EDGE('',*,*,{ef},.F.)
o9 ORIENTED_EDGE('',*,*,{ec},.T.)
oa ORIENTED_EDGE('',*,*,{ef},.T.)
ob ORIENTED_EDGE('',*,*,{ed},.F.)
oc ORIENTED_EDGE('',*,*,{ee},.F.)
l1 EDGE_LOOP('',({o1},{o2},{o3},{o4}))
l2 EDGE_LOOP('',({o5},{o6}))
l3 EDGE_LOOP('',({o7},{o8}))
l4 EDGE_LOOP('',({o9},{oa},{ob},{oc}))
b1 FACE_OUTER_BOUND('',{l1},.T.)
b2 FACE_OUTER_BOUND('',{l2},.T.)
b3 FACE_OUTER_BOUND('',{l3},.T.)
b4 FACE_OUTER_BOUND('',{l4},.T.)
f1 ADVANCED_FACE('',({b1}),{s1},.T.)
f2 ADVANCED_FACE('',({b2}),{s2},.T.)
f3 ADVANCED_FACE('',({b3}),{s3},.T.)
f4 ADVANCED_FACE('',({b4}),{s4},.T.)
shell CLOSED_SHELL('',({f1},{f2},{f3},{f4}))
SOLID MANIFOLD_SOLID_BREP('',{shell})
END
}

vertex_box() { # FILE: the least and the largest coordinates
	awk '/end_header/ { on = 1; next }
		on && NF == 7 { for (i = 1; i <= 3; i++) { if (!(i in low) || $i < low[i]) low[i] = $i
			if (!(i in high) || $i > high[i]) high[i] = $i } }
		END { for (i = 1; i <= 6; i++)
			printf "%s%.3f", (i > 1 ? " " : ""), (i < 4 ? low[i] : high[i - 3]) + 0 }' "$1"
}
