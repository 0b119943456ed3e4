#!/bin/sh
# figures.sh OUTDIR - pictures like the papers': the scan, the triangular grid over it, the points
# kept, the mesh, normals, the path of arcs, the program read back (Chui, Chiu and Yu 2007, figures
# 33 to 43), and the B-splines on two surfaces (Bey, Boudjouad and Tafat-Bouzid 2007, figures 5, 6).
# `make figures` calls it with BIN (the tools) set.
set -eu
src=$(cd "$(dirname "$0")/.." && pwd)
cd "$src"
PATH=${BIN:-$src/build/bin}:$PATH
CLOUDMILL_MACHINES=$src/machines
export PATH CLOUDMILL_MACHINES
out=${1:-figures}
mkdir -p "$out"
work=$(mktemp -d "${TMPDIR:-/tmp}/figures.XXXXXX")
trap 'rm -rf "$work"' EXIT
trap 'exit 130' INT TERM

# figure NAME TITLE OPTIONS...: one picture
figure() {
	name=$1 title=$2
	shift 2
	ncplot -q --title "$title" -o "$out/$name.svg" "$@"
	printf '%-28s %s\n' "$out/$name.svg" "$title"
}

# points MESH: its vertices as a cloud
points() {
	awk '/^element vertex/ { n = $3 }
		/^end_header/ { on = 1; next }
		on && n-- > 0 { print $1, $2, $3 }' "$1"
}

# grid MESH: the least parallelogram with sides along the rows and at 60 degrees to them that holds
# the mesh, and the triangular grid in it, as a path of straight lines
grid() {
	awk 'function corner(u, v) { printf "GOTO/%.6f,%.6f,%.6f\n", u * ux + v * vx, u * uy + v * vy, top }
		function line(u, v, s, t) { print "RAPID"; corner(u, v); corner(s, t) }
		/^comment spacing/ { t = $3 }
		/^comment direction/ { d = $3 * 3.14159265358979 / 180 }
		/^element vertex/ { n = $3 }
		/^end_header/ { on = 1; ux = cos(d); uy = sin(d)
			vx = cos(d + 1.0471975511966); vy = sin(d + 1.0471975511966)
			area = ux * vy - uy * vx; next }
		on && n-- > 0 {
			u = ($1 * vy - $2 * vx) / area; v = (ux * $2 - uy * $1) / area
			if (!seen++) { u0 = u1 = u; v0 = v1 = v; top = $3 }
			if (u < u0) u0 = u; if (u > u1) u1 = u; if (v < v0) v0 = v; if (v > v1) v1 = v
			if ($3 > top) top = $3 }
		END { print "PARTNO/GRID\nUNITS/MM"
			columns = int((u1 - u0) / t + 0.9); rows = int((v1 - v0) / t + 0.9)
			for (i = 0; i <= rows; i++) line(u0, v0 + i * t, u0 + columns * t, v0 + i * t)
			for (i = 0; i <= columns; i++) line(u0 + i * t, v0, u0 + i * t, v0 + rows * t)
			for (i = 1; i < rows + columns; i++) {
				a = i < columns ? i : columns; b = i < rows ? i : rows
				line(u0 + a * t, v0 + (i - a) * t, u0 + (i - b) * t, v0 + b * t) }
			print "FINI" }' "$1"
}

panel=samples/panel_17036.xyz
cloud2mesh -q --paper -t 4 -o "$work/panel.ply" $panel
points "$work/panel.ply" >"$work/points.xyz"
grid "$work/panel.ply" >"$work/grid.cl"
meshnorm -q -r 8 --rows mesh -o "$work/panel.cl" "$work/panel.ply"
biarcfit -q -e 0.01 --tilt 15 -o "$work/arcs.cl" "$work/panel.cl"
ncpost -q -c siemens -o "$work/panel.mpf" "$work/arcs.cl"

figure paper1-33-cloud "The scan of a panel" $panel
figure paper1-34-grid "The triangular grid over the scan" --view plan --cut --colour kind \
	$panel "$work/grid.cl"
figure paper1-35-points "The points kept, one for each node" --view plan "$work/points.xyz"
figure paper1-36-mesh-plan "The mesh from above" --view plan "$work/panel.ply"
figure paper1-37-mesh "The mesh" --view iso "$work/panel.ply"
figure paper1-38-normals "Normals at the vertices" --view iso --show-normals "$work/panel.ply"
figure paper1-39-arcs "Arcs in space, the tool axis tilted by 15 degrees" --view iso --axes \
	"$work/arcs.cl"
figure paper1-40-program "The Siemens program, read back, over the mesh" "$work/panel.ply" \
	"$work/panel.mpf"

face=samples/face_nefertiti_26493.xyz
cloud2mesh -q -t 3 -o "$work/face.ply" $face
meshnorm -q -r 5 --rows mesh -o "$work/face.cl" "$work/face.ply"
biarcfit -q -e 0.02 -o "$work/face-arcs.cl" "$work/face.cl"
ncpost -q -c siemens -o "$work/face.mpf" "$work/face-arcs.cl"

figure paper1-41-face-cloud "The scan of a face" --view plan $face
figure paper1-42a-face-plan "The mesh of the face from above" --view plan "$work/face.ply"
figure paper1-42b-face "The mesh of the face" --view iso "$work/face.ply"
figure paper1-43-face-program "The program for the face, read back, over the mesh" --view plan \
	"$work/face.ply" "$work/face.mpf"

for n in 1 2; do
	surface=samples/paper2_s${n}_a.igs
	nurbs2mesh -q -n 40 -o "$work/surface.ply" $surface
	planecut -q -r 4 -s 4 -a 90 -o "$work/planes.cl" "$work/surface.ply"
	bsplfit -q -e 0.01 -o "$work/splines.cl" "$work/planes.cl"
	figure paper2-$((n + 4))-splines "B-splines on surface $n, with their control points" --view iso \
		--poles --cut "$work/surface.ply" "$work/splines.cl"
done
