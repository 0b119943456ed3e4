# model.sh - models as IGES and STEP from short lines, and what is measured on their meshes.
#
# shellcheck shell=sh

# Area, volume and border edges by place.
measure() { # FILE
	awk '
	BEGIN { n = 0 }
	/^element vertex/ { nv = $3 }
	!body { if ($0 == "end_header") body = 1; next }
	n < nv { x[n] = $1; y[n] = $2; z[n] = $3
		key = $1 " " $2 " " $3; if (!(key in place)) place[key] = n; at[n] = place[key]; n++; next }
	{ i = $2; j = $3; k = $4
		ux = x[j] - x[i]; uy = y[j] - y[i]; uz = z[j] - z[i]
		vx = x[k] - x[i]; vy = y[k] - y[i]; vz = z[k] - z[i]
		nx = uy * vz - uz * vy; ny = uz * vx - ux * vz; nz = ux * vy - uy * vx
		area += sqrt(nx * nx + ny * ny + nz * nz) / 2
		volume += (x[i] * nx + y[i] * ny + z[i] * nz) / 6
		edge[at[i] " " at[j]]++; edge[at[j] " " at[k]]++; edge[at[k] " " at[i]]++ }
	END { for (e in edge) { split(e, q, " "); if (edge[e] != edge[q[2] " " q[1]]) open++ }
		printf "%.6f %.6f %d\n", area, volume, open }' "$1"
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

part() { # DESC VALUE WANT: within 1e-4 of it
	below "$1 ($2, expected $3)" "$(awk -v a="$2" -v b="$3" 'BEGIN { d = (a - b) / b; print d < 0 ? -d : d }')" 0.0001
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
