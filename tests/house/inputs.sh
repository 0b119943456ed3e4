# inputs.sh - what freeze.sh feeds to the tools, made by formulas; sourced, and used by jobs.sh.
# Every file comes from awk alone, by a generator of random numbers that is the same everywhere.
#
# shellcheck shell=sh

# shape KIND WIDTH HEIGHT STEP [SIGMA [PATTERN]]: a scan of z = KIND(x, y), noise along z.  PATTERN is
# grid (the default), lines (four steps apart) or random.
shape() {
	awk -v kind="$1" -v wide="$2" -v high="$3" -v step="$4" -v sigma="${5:-0}" -v pattern="${6:-grid}" '
	function uniform() { seed = (seed * 16807) % 2147483647; return seed / 2147483647 }
	function least(a, b) { return a < b ? a : b }
	function size(a) { return a < 0 ? -a : a }
	function z(x, y,   d, e) {
		d = x * c + y * s
		e = y * c - x * s
		if (kind == "flat") return 3 + x / 10
		if (kind == "wave") return 4 * sin(x / 3.2) * cos(y / 4.8) + 4
		if (kind == "dome") return 20 - (x * x + y * y) / 80
		if (kind == "bowl") return (x * x + y * y) / 20
		if (kind == "saddle") return (x * x - y * y) / 40
		if (kind == "roof") return 12 - size(d) / 2
		if (kind == "valley") return 2 + size(d) / 2
		if (kind == "pyramid") return 10 - 0.6 * (size(d) > size(e) ? size(d) : size(e))
		if (kind == "corner") return 9 - least(-d, least(d / 2 + 0.9 * e, d / 2 - 0.9 * e)) * -0.7
		if (kind == "rib") return 5 - 0.005 * (x * x + y * y) + 0.8 * exp(-(d - 1) * (d - 1) / 0.36)
		if (kind == "groove") return 5 - 0.6 * exp(-(d - 1) * (d - 1) / 0.5)
		if (kind == "step" || kind == "wall") return d > 0 ? 6 : 0
		if (kind == "plateau" || kind == "block") return size(d) < wide / 5 && size(e) < high / 5 ? 4 : 0
		if (kind == "terraces") return 2 * int((x + wide / 2) / (wide / 4)) + x / 50
		if (kind == "folds") return 3 * size(sin(x / 5)) + y / 8
		return 0
	}
	function point(x, y,   k, g) {
		if (kind == "hole" && x * x + y * y < 36) return
		if (kind == "hole") { printf "%.4f %.4f %.4f\n", x, y, sqrt(3600 - x * x - y * y) - 40; return }
		if (kind == "islands" && size(x) < wide / 10) return
		for (k = 0; k < 12 && sigma > 0; k++) g += uniform()
		printf "%.4f %.4f %.4f\n", x, y, z(x, y) + (sigma > 0 ? sigma * (g - 6) : 0)
	}
	BEGIN {
		seed = 4711
		c = cos(0.21)
		s = sin(0.21)
		across = pattern == "lines" ? 4 * step : step
		if (pattern == "random") {
			n = wide * high / step / step
			for (i = 0; i < n; i++) point(wide * (uniform() - 0.5), high * (uniform() - 0.5))
		} else
			for (y = -high / 2; y <= high / 2 + 1e-9; y += across)
				for (x = -wide / 2; x <= wide / 2 + 1e-9; x += step)
					point(x, y)
		for (i = 0; kind == "wall" && i <= high / c / step; i++) # on the wall d = 0
			for (k = 1; k < 6 / step; k++) {
				y = (i * step - high / c / 2) * c
				printf "%.4f %.4f %.4f\n", -y * s / c, y, k * step
			}
		for (i = 0; kind == "block" && i <= 1.6 * (wide + high) / step; i++) # around the block
			for (k = 1; k < 4 / step; k++) {
				a = wide / 5
				b = high / 5
				t = (i * step) % (4 * (a + b))
				if (t < 2 * a) { d = t - a; e = -b }
				else if (t < 2 * a + 2 * b) { d = a; e = t - 2 * a - b }
				else if (t < 4 * a + 2 * b) { d = 3 * a + 2 * b - t; e = b }
				else { d = -a; e = 4 * a + 3 * b - t }
				printf "%.4f %.4f %.4f\n", d * c - e * s, d * s + e * c, k * step
			}
	}' </dev/null
}

# ball RADIUS LOW N [NOISE]: a ball from LOW up, for --subdivide
ball() {
	awk -v R="$1" -v low="$2" -v n="$3" -v noise="${4:-0}" 'BEGIN {
		for (i = 0; i < n; i++) {
			z = low + (R - low) * (i + i * 0.7548776662466927 % 1) / n
			a = i * 2.399963 + i * 0.5698402909980532 % 1 * 0.05
			r = sqrt(R * R - z * z)
			k = 1 + noise * (i * 0.3247 % 1 + i * 0.7143 % 1 + i * 0.1379 % 1 - 1.5) * 2 / R
			printf "%.4f %.4f %.4f\n", k * r * cos(a), k * r * sin(a), k * z
		}
	}' </dev/null
}

# box: four flanks that lean a little and a top, for --subdivide
box() {
	awk 'function u() { s = (s * 16807) % 2147483647; return s / 2147483647 }
	function point(x, y, z) { printf "%.4f %.4f %.4f\n", x, y, z }
	BEGIN {
		s = 4711
		k = 0.0874887
		for (i = 0; i < 6000; i++) {
			a = u() * 2 - 1; b = u() * 2 - 1; z = 10 * u(); f = u() * 1040
			x = 10 + (10 - z) * k; y = 8 + (10 - z) * k
			if (f < 320) point(a * 10, b * 8, 10)
			else if (f < 520) point(a * x, y, z)
			else if (f < 720) point(a * x, -y, z)
			else if (f < 880) point(x, b * y, z)
			else point(-x, b * y, z)
		}
	}' </dev/null
}

# as FORMAT CLOUD: the same points in another format
as() {
	awk -v format="$1" '{ p[++n] = $1 " " $2 " " $3 } END {
		if (format == "pts") print n
		if (format == "ptx") printf "%d\n1\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n5 6 7 1\n", n
		if (format == "pcd")
			printf "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n" \
				"WIDTH %d\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS %d\nDATA ascii\n", n, n
		if (format == "ply")
			printf "ply\nformat ascii 1.0\nelement vertex %d\nproperty float x\nproperty float y\n" \
				"property float z\nend_header\n", n
		if (format == "csv") print "x;y;z"
		for (i = 1; i <= n; i++) {
			line = p[i]
			if (format == "pts") line = line " 100 10 20 30"
			if (format == "ptx") line = line " 0.5"
			if (format == "obj") line = "v " line
			if (format == "csv") { gsub(/ /, ";", line); gsub(/\./, ",", line) }
			if (format == "inch") { split(line, q, " "); line = sprintf("%.7f %.7f %.7f", q[1] / 25.4, q[2] / 25.4, q[3] / 25.4) }
			print line
		}
	}' "$2"
}

# surface KIND: NURBS text: torus, sphere, cube, frame (trimmed), disc (trimmed), meet (two with a
# gap), part (a range of the parameters)
surface() {
	awk -v kind="$1" 'function flat(a, b, c, d, e, f, g, h, i, j, k, l) {
		print "surface degree 1 1 poles 2 2 knots_u 0 0 1 1 knots_v 0 0 1 1 points", \
			a, b, c, d, e, f, g, h, i, j, k, l }
	function hill(y) { return 12 * sin(y / 20) }
	BEGIN {
		print "nurbs 1"
		r = sqrt(0.5)
		split("1 1 0 -1 -1 -1 0 1 1", x, " "); split("0 1 1 1 0 -1 -1 -1 0", y, " ")
		split("0 1 1 1 0", q, " "); split("-1 -1 0 1 1", z, " ")
		if (kind == "torus") {
			print "surface degree 2 2 poles 9 9 knots_u 0 0 0 1 1 2 2 3 3 4 4 4 knots_v 0 0 0 1 1 2 2 3 3 4 4 4 points"
			for (j = 1; j <= 9; j++) for (i = 1; i <= 9; i++) { d = 20 + 5 * x[j]; print d * x[i], d * y[i], 5 * y[j] }
			print "weights"
			for (j = 1; j <= 9; j++) for (i = 1; i <= 9; i++) print (i % 2 ? 1 : r) * (j % 2 ? 1 : r)
		}
		if (kind == "sphere") {
			print "unit cm surface degree 2 2 poles 9 5 knots_u 0 0 0 1 1 2 2 3 3 4 4 4 knots_v 0 0 0 1 1 2 2 2 points"
			for (j = 1; j <= 5; j++) for (i = 1; i <= 9; i++) print x[i] * q[j], y[i] * q[j], z[j]
			print "weights"
			for (j = 1; j <= 5; j++) for (i = 1; i <= 9; i++) print (i % 2 ? 1 : r) * (j % 2 ? 1 : r)
		}
		if (kind == "cube") {
			flat(0, 0, 0, 10, 0, 0, 0, 10, 0, 10, 10, 0)
			flat(0, 0, 10, 10, 0, 10, 0, 10, 10, 10, 10, 10)
			flat(0, 0, 0, 10, 0, 0, 0, 0, 10, 10, 0, 10)
			flat(0, 10, 0, 0, 10, 10, 10, 10, 0, 10, 10, 10)
			flat(0, 0, 0, 0, 10, 0, 0, 0, 10, 0, 10, 10)
			flat(10, 0, 0, 10, 10, 0, 10, 0, 10, 10, 10, 10)
		}
		if (kind == "frame") {
			flat(0, 0, 0, 10, 0, 0, 0, 10, 0, 10, 10, 0)
			print "loop 0.2 0.2 0.8 0.2 0.8 0.8 0.2 0.8 loop 0.45 0.45 0.55 0.45 0.55 0.55 0.45 0.55"
		}
		if (kind == "disc") {
			flat(-5, -5, 0, 5, -5, 0, -5, 5, 0, 5, 5, 0)
			print "loop"
			for (i = 0; i < 180; i++) print 0.5 + 0.4 * cos(i * atan2(0, -1) / 90), 0.5 + 0.4 * sin(i * atan2(0, -1) / 90)
		}
		if (kind == "part") {
			print "unit cm surface degree 1 1 poles 3 3 knots_u 0 1 2 3 4 knots_v 0 0 1 2 2"
			print "range 1.2 2.7 0.1 5 points 0 0 0 1 0 1 2 0 0 0 1 1 1 1 2 2 1 1 0 2 0 1 2 1 2 2 0"
		}
		if (kind == "meet") {
			print "surface degree 1 3 poles 2 9 knots_u 0 0 1 1 knots_v 0 0 0 0 1 2 3 4 5 6 6 6 6 points"
			for (j = 0; j < 9; j++) { v = -50 + 12.5 * j; print -50, v, 0, 0, v, hill(v) }
			print "surface degree 1 3 poles 2 9 knots_u 0 0 1 1 knots_v 0 0 0 0 1 2 3 4 5 6 6 6 6 points"
			for (j = 8; j >= 0; j--) { v = -50 + 12.5 * j; print 0, v, hill(v) + (j == 4 ? 0.02 : 0), 50, v, 30 * (j % 2) }
		}
		print "end"
	}' </dev/null
}

# iges KIND: trimmed (by curves of all types, with a hole in space), bounded (143, 141), cylinder (by
# curves in space round it and over its seam), placed (124, in inches)
iges() {
	awk -v kind="$1" '
	# an entity; the n th is called 2 n - 1
	function add(type, form, matrix, text,   first, number) {
		first = lines + 1
		number = 2 * entities++ + 1
		text = type "," text ";"
		for (; text != ""; text = substr(text, 65))
			parameter = parameter sprintf("%-64s%8dP%7d\n", substr(text, 1, 64), number, ++lines)
		directory = directory sprintf("%8d%8d%8d%8d%8d%8d%8d%8d%8sD%7d\n", type, first, 0, 0, 0, 0, matrix, 0,
			"00000000", number) sprintf("%8d%8d%8d%8d%8d%16s%8s%8dD%7d\n", type, 0, 0, lines - first + 1, form,
			"", "", 0, number + 1)
	}
	function patch() { # 40 x 30 mm, z = xy / 150
		add(128, 0, 0, "1,1,1,1,0,0,1,0,0,0.,0.,1.,1.,0.,0.,1.,1.,1.,1.,1.,1.,0.,0.,0.,40.,0.,0.,0.,30.,0.,40.,30.,8.,0.,1.,0.,1.")
	}
	BEGIN {
		unit = kind == "placed" ? "1,4HINCH" : "2,2HMM"
		if (kind == "trimmed") {
			add(144, 0, 27, "3,1,3,5,17,21,25")
			patch()
			add(142, 0, 0, "0,3,7,0,1")
			add(102, 0, 0, "4,9,11,13,15")
			add(110, 0, 0, "0.1,0.1,0.,0.9,0.1,0.")
			add(100, 0, 0, "0.,0.9,0.5,0.9,0.1,0.9,0.9")
			add(106, 11, 0, "1,3,0.,0.9,0.9,0.5,0.8,0.1,0.9")
			add(126, 0, 0, "1,1,1,0,1,0,0.,0.,1.,1.,1.,1.,0.1,0.9,0.,0.1,0.1,0.,0.,1.,0.,0.,1.")
			add(142, 0, 0, "0,3,0,19,2")
			add(106, 12, 0, "2,5,10.,10.,0.667,15.,10.,1.,15.,15.,1.5,10.,15.,1.,10.,10.,0.667")
			add(142, 0, 0, "0,3,0,23,2")
			add(100, 0, 31, "0.,0.,0.,1.,0.,1.,0.") # in the plane that touches the surface
			add(142, 0, 0, "0,3,0,29,2") # of a type that is not read
			add(124, 0, 0, "0.8,-0.6,0.,100.,0.6,0.8,0.,0.,0.,0.,1.,0.")
			add(116, 0, 0, "1.,2.,3.")
			add(124, 0, 0, "0.991228,-0.021542,-0.130396,25.,0.,0.986627,-0.162997,20.,0.132164,0.161567,0.977972,3.333333")
		}
		if (kind == "bounded") {
			add(143, 0, 0, "1,3,1,5")
			patch()
			add(141, 0, 0, "1,1,3,2,7,1,1,9,7,1,1,11")
			add(110, 0, 0, "0.,0.,0.,40.,0.,0.")
			add(106, 63, 0, "1,3,0.,0.1,0.1,0.9,0.1,0.9,0.8")
			add(106, 63, 0, "1,3,0.,0.9,0.8,0.2,0.9,0.1,0.1")
			add(143, 0, 0, "0,15,1,17")
			patch()
			add(141, 0, 0, "0,0,15,2,19,1,0,21,1,0")
			add(106, 12, 0, "2,3,5.,5.,0.167,35.,5.,1.167,35.,25.,5.833")
			add(106, 12, 0, "2,3,35.,25.,5.833,5.,25.,0.833,5.,5.,0.167")
		}
		if (kind == "placed") {
			add(128, 0, 3, "1,1,1,1,0,0,1,0,0,0.,0.,1.,1.,0.,0.,1.,1.,1.,1.,1.,1.,0.,0.,0.,4.,0.,0.,0.,3.,0.,4.,3.,1.,0.,1.,0.,1.")
			add(124, 0, 5, "1.,0.,0.,1.,0.,1.,0.,2.,0.,0.,1.,3.")
			add(124, 0, 0, "0.,-1.,0.,0.,1.,0.,0.,0.,0.,0.,1.,0.")
		}
		if (kind == "cylinder") {
			split("1 1 0 -1 -1 -1 0 1 1", x, " ")
			split("0 1 1 1 0 -1 -1 -1 0", y, " ")
			for (j = 0; j < 2; j++) for (i = 1; i <= 9; i++) {
				weights = weights (i % 2 ? "1.," : sprintf("%.15f,", sqrt(0.5)))
				poles = poles sprintf("%d.,%d.,%d.,", 10 * x[i], 10 * y[i], 20 * j)
			}
			add(144, 0, 0, "3,1,2,5,9,13")
			add(128, 0, 0, "8,1,2,1,0,0,0,0,0,0.,0.,0.,1.,1.,2.,2.,3.,3.,4.,4.,4.,0.,0.,1.,1.," weights poles "0.,4.,0.,1.")
			add(142, 0, 0, "0,3,0,7,2")
			add(100, 0, 0, "3.,0.,0.,10.,0.,10.,0.")
			add(142, 0, 0, "0,3,0,11,2")
			add(100, 0, 0, "17.,0.,0.,0.,10.,0.,10.")
			add(142, 0, 0, "0,3,0,15,2")
			for (i = 0; i <= 50; i++) { # there and back, with chords that are near the cylinder
				a = i < 25 ? 0.4 * (1 - i / 12) : i < 50 ? 0.4 * ((i - 25) / 12 - 1) : 0.4
				h = i < 25 || i == 50 ? 8 - (1 - (a < 0 ? -a : a) / 0.4) : 12 + (1 - (a < 0 ? -a : a) / 0.4)
				hole = hole sprintf(",%.9f,%.9f,%.9f", 10 * cos(a), 10 * sin(a), h)
			}
			add(106, 12, 0, "2,51" hole)
		}
		printf "%-72sS%7d\n", "made by formulas", 1
		text = "1H,,1H;,4Hpart,4Hfile,4Hmake,1H1,32,38,6,308,15,4Hpart,1.," unit ",1,0.01,13H261121.101010,1E-6,200.,,,11,0;"
		for (; text != ""; text = substr(text, 73)) printf "%-72sG%7d\n", substr(text, 1, 72), ++globals
		printf "%s%sS%7dG%7dD%7dP%7d%40sT%7d\n", directory, parameter, 1, globals, 2 * entities, lines, "", 1
	}' </dev/null
}

# path KIND: CL text: shapes (lines, arcs in all planes, a helix, B-splines), tilted, winding (the axis
# turns here and there), spiral (it goes round three times), steep (under the equator), holes (all
# cycles), leaning (holes in two planes), tools, words (all others), creo, nx, catia
path() {
	case $1 in
	shapes)
		cat <<-'STREAM'
			PARTNO/SHAPES (ALL OF THEM)
			UNITS/MM
			MULTAX/ON
			CUTTER/8,4,0,4,0,0,60
			LOADTL/3
			SPINDL/RPM,12000,CLW
			COOLNT/ON
			$$-> CLOUDMILL/1
			$$-> LEDGER/meshnorm,0.0030
			$$-> PASS/1
			RAPID
			GOTO/0,0,50,0,0,1
			RAPID
			GOTO/0,0,5,0,0,1
			FEDRAT/MMPM,800
			GOTO/0,0,0,0,0,1
			GOTO/10,0,0,0,0,1
			GOTO/20,0,0,0.258819045,0,0.965925826
			$$-> PASS/2
			CIRCLE/20,10,0,0,0,1,10
			GOTO/30,10,0,0,-0.258819045,0.965925826
			CIRCLE/30,20,0,-0.6,0,0.8,10
			GOTO/38,20,6,0,-0.258819045,0.965925826
			MOVNRB/5AXIS,LENGTH,100
			MOVNRB/ON,4,10,0,6,24
			MOVNRB/1,0,0,0,0,6,15,24,24,24,24
			MOVNRB/2,38,20,6,38,22,6.5,40,26,7,44,30,6,50,30,4,54,30,4
			MOVNRB/3,38,-5.881905,102.592583,39,-4,103,42,2,104,47,10,103,52,16,102, $
			54,18,103.277389
			MOVNRB/NEXT
			GOTO/54,30,4,0,-0.12,0.992773892
			MOVNRB/OFF
			COOLNT/OFF
			RAPID
			GOTO/54,30,50,0,-0.12,0.992773892
			$$-> PASS/3
			RAPID
			GOTO/0,40,50,0,0,1
			GOTO/0,40,0,0,0,1
			CIRCLE/5,40,0,0,0,-1,5
			GOTO/0,40,0,0,0,1
			PPRINT A HELIX, ARCS IN XZ AND YZ
			CIRCLE/5,40,0,0,0,1,5
			GOTO/10,40,2,0,0,1
			CIRCLE/10,40,7,0,1,0,5
			GOTO/5,40,7,0,0,1
			CIRCLE/5,40,2,-1,0,0,5
			GOTO/5,45,2,0,0,1
			STOP
			DELAY/1.5
			GOTO/0,40,0,0,0,1
			MOVNRB/M3AXIS
			MOVNRB/ON,4,10,0,6,30
			MOVNRB/1,0,0,0,0,10,20,30,30,30,30
			MOVNRB/2,0,40,0,3,41,1,9,44,2,18,44,2,26,41,1,30,40,0
			MOVNRB/NEXT
			GOTO/30,40,0,0,0,1
			MOVNRB/OFF
			RAPID
			GOTO/30,40,50,0,0,1
			FINI
		STREAM
		;;
	tilted)
		path shapes | awk '/^CIRCLE|^MOVNRB|^54/ { next } { print }' |
			sed 's/^\(GOTO\/[^,]*,[^,]*,[^,]*\),.*/\1,0,0.6,0.8/'
		;;
	tools)
		cat <<-'STREAM'
			PARTNO/TOOLS
			UNITS/INCHES
			CUTTER/0.4,0.2
			LOADTL/3,OSETNO,12
			SPINDL/8000,CLW
			COOLNT/ON
			PPRINT (a nested (remark)) with a long tail that goes on and on beyond what any block may hold
			RAPID
			GOTO/0,0,2
			FEDRAT/20,IPM
			GOTO/0,0,0
			CUTCOM/LEFT
			GOTO/0,1,0
			GOTO/1,1,0
			CIRCLE/1,2,0,0,0,1,1
			GOTO/2,2,0
			CUTCOM/OFF
			GOTO/3,2,0
			STOP
			OPSTOP
			DELAY/0.5
			AUXFUN/88
			FEDRAT/INVERS,4
			GOTO/3,3,0
			SPINDL/500,CCLW
			COOLNT/MIST
			RAPID
			GOTO/0,0,2
			LOADTL/4
			CUTTER/0.25
			SPINDL/RPM,3000,CLW
			FEDRAT/MMPR,.1
			GOTO/0,0,0
			CLEARP/XYPLAN,1
			GODLTA/1,1,0
			FROB/1,2
			RETRCT
			COOLNT/OFF
			FINI
		STREAM
		;;
	words)
		cat <<-'STREAM'
			PARTNO/WORDS
			UNITS/CM
			MULTAX/ON
			CUTTER/.8,.4
			TOOLNO/2
			LOADTL/2
			SPINDL/100,SMM,CLW
			COOLNT/
			FEDRAT/.01,MMPR
			ORIGIN/1,2,3
			TRANS/1,2,3
			FROM/0,0,9
			GODLTA/1,0,-1
			GODLTA/2,0,-1,0,-.6,.8
			GODLTA/-1
			TLAXIS/0,.1,1
			30) GOTO/1,1,1
			1,2,1,0,0,1
			CLEARP/XYPLAN,19
			RETRCT
			GOTO/2,2,1
			CLRSRF/0,1,0,2.9
			GOTO/2,2,1,0,1,0
			RETRCT
			GOTO/2,2,1,0,0,1
			SPINDL/OFF
			GOHOME
			GOHOME/3,4,8
			SPINDL/ON
			SPINDL/ORIENT,30
			SPINDL/RANGE,2,RPM,1000,CLW
			DELAY/REV,10
			FEDRAT/300,MMPM
			FEDRAT/INVERS,AUTO
			GOTO/3,3,3
			FEDRAT/INVERS,OFF
			FEDRAT/PERMIN,14
			ROTABL/ATANGL,0
			MULTAX/OFF
			GOTO/0.5,0,1
			CIRCLE/0,0,0,0,0,1,.5,.06,.5,1,0,TIMES,2
			GOTO/0,.5,0
			CIRCLE/0,0,0,0,0,1
			GOTO/0,.5,.2
			CYCLE/DRILL,DEPTH,.3,DWELL,REV,5,MMPM,9
			GOTO/0,0,0
			CYCLE/PECK,2,200,MMPM,.2,.5
			GOTO/1,0,0
			CYCLE/OFF
			CYCLE/ON
			GOTO/1.5,0,0
			CYCLE/TAP,DEPTH,.3,TPI,20,RTRCTO,AUTO
			GOTO/2,0,0
			CYCLE/DEEP,DEPTH,2,STEP,.6,.4,.2,MMPM,90,DIAMET,1
			GOTO/3,0,0
			CYCLE/CSINK,DEPTH,.2,CSKDIA,1,RETURN,2
			GOTO/4,0,0
			CYCLE/BORE,MANUAL,DEPTH,1,MMPM,90
			GOTO/4,1,0
			CYCLE/OFF
			REMARK the end
			END
			FINI
		STREAM
		;;
	creo)
		cat <<-'STREAM'
			$$* Pro/CLfile 10.0
			$$-> CUTTER / 8.000000
			$$-> CSYS / 1, 0, 0, 0, $
			 0, 1, 0, 0, 0, 0, 1, 0
			LOADTL / 3, OSETNO, 4
			SPINDL / RPM, 1000, CLW
			RAPID
			GOTO / 5, 0, 9
			FEDRAT / 200, MMPM
			GOTO / 5, 0, 0
			CIRCLE / 0, 0, 0, 0, 0, 1, 5
			GOTO / 3, 4, 0
			0, 5, 0
			-5, 0, 0
			-9, 9, 0
			RAPID
			GOTO / 0, 0, 50
			CYCLE / DRILL, DEPTH, 10, MMPM, 90, CLEAR, 5, RAPTO, 3
			GOTO / 1, 2, 0
			CYCLE / DRILL, DEPTH, 10, MMPM, 90, CLEAR, 5, RETURN, 0
			GOTO / 1, 2, 0
			GOTO / 3, 2, -4
			CYCLE / OFF
			FINI
		STREAM
		;;
	nx)
		cat <<-'STREAM'
			TOOL PATH/A,TOOL,BALL_8
			TLDATA/MILL,8.0000,4.0000,75.0000,0.0000,0.0000
			MSYS/0.0000,0.0000,0.0000,1.0000000,0.0000000,0.0000000,0.0000000,1.0000000,0.0000000
			PAINT/PATH
			LOAD/TOOL,3,ADJUST,12
			SPINDL/RPM,1800,CLW
			RAPID
			GOTO/5,0,25,0,0,1
			FEDRAT/MMPM,300
			GOTO/5,0,4
			CIRCLE/0,0,0,0,0,1,5,.06,.5,10,0,TIMES,1
			GOTO/0,5,0
			NURBS/
			KNOT/0.3,0.6,1
			CNTRL/0,5,0
			CNTRL/2,7,1
			CNTRL/6,9,1
			CNTRL/8,5,1
			CNTRL/9,5,0
			RAPID
			GOTO/9,5,25
			END-OF-PATH
			TOOL PATH/B,TOOL,DR_8
			TLDATA/DRILL,8.5,118,80,45
			MSYS/10,0,5,0,1,0,-1,0,0
			RAPID
			GOTO/10,5,25,0,0,1
			CYCLE/DRILL,DEEP,RAPTO,3,STEP,4,FEDTO,-20.5,RTRCTO,AUTO,MMPM,220
			GOTO/10,5,0
			CYCLE/OFF
			END-OF-PATH
		STREAM
		;;
	catia)
		cat <<-'STREAM'
			$$     CATIA APT VERSION 1.0
			UNITS/MM
			MULTAX/ON
			CUTTER/8,4
			SPINDL/9000,RPM,CLW
			RAPID
			GOTO/0,0,50,0,0,1
			FEDRAT/500
			GOTO/20,0,0,0,0,1
			BEGIN NURBS_SIEMENS(D=3,F=4000,AXIS=0.00,0.00,1.00);
			N0,XT= 20.000,YT=0.000,ZT=0.000,DK= 0.00,W=1.0;
			N1,XT=20.000,YT=11.046,ZT=0.000,DK= 0.00,W=1.0;
			N2,XT=11.046,YT=20.000,ZT=0.000,DK=30.00,W=1.0;
			N3,XT=0.000,YT=20.000,ZT=0.000,DK= 0.00,W=1.0;
			END NURBS;
			RAPID
			GOTO/0,20,50,0,0,1
			RAPID
			GOTO/0,0,50,0,0,1
			GOTO/0,0,0,0,0,1
			BEGIN NURBS_SIEMENS(D=3,F=3000,AXIS=VAR,LENGTH=100.00);
			N0,XT= 0.000,YT=0.000,ZT=0.000,XH= 0.000, $
			YH=0.000,ZH=100.00,DK= 0.00,W=1.0;
			N1,XT=10.000,YT=0.000,ZT=0.000,XH=10.000, $
			YH=0.000,ZH=100.00,DK= 0.00,W=1.0;
			N2,XT=20.000,YT=5.000,ZT=0.000,XH=24.000, $
			YH=5.000,ZH=99.92,DK=12.00,W=1.0;
			N3,XT=30.000,YT=0.000,ZT=0.000,XH=40.000, $
			YH=0.000,ZH=99.499,DK= 14.00,W=1.0;
			N4,XT=40.000,YT=0.000,ZT=0.000,XH=60.000, $
			YH=0.000,ZH=97.980,DK= 0.00,W=1.0;
			END NURBS;
			GOTO/45,0,0,0,0,1
			INDIRV/0,1,0
			PSIS/(PLANE/0,0,1,0)
			TLON,GOFWD/(CIRCLE/40,0,0,5),ON,(LINE/40,0,0,40,5,0)
			RAPID
			GOTO/40,0,60,0.2,0,0.9798
			FINI
		STREAM
		;;
	*)
		awk -v kind="$1" '
		function turned(x, y, z, i, j, k) { printf "GOTO/%.6f,%.6f,%.6f,%.9f,%.9f,%.9f\n", x, y, z, i, j, k }
		function place(x, y, z) { if (kind == "leaning" && x == 60) turned(x, y, z, 0, 0.6, 0.8); else turned(x, y, z, 0, 0, 1) }
		function go(k, up,   w) {
			w = k * 5 * rad
			turned(30 * cos(w) + up * st * cos(w), 30 * sin(w) + up * st * sin(w), up * ct - k / 9, st * cos(w),
				st * sin(w), ct)
		}
		BEGIN {
			rad = atan2(0, -1) / 180
			if (kind == "winding") {
				print "UNITS/MM\nMULTAX/ON\nCUTTER/8,4,0,4\nSPINDL/9000,CLW\nRAPID\nGOTO/0,0,90,0,0,1\nFEDRAT/MMPM,700"
				for (i = 0; i < 160; i++) {
					a = i / 8
					t = 0.8 * sin(i / 25)
					if (i % 50 == 0) print "$$-> PASS/" ++pass
					printf "$$-> CONTCT/%.6f,%.6f,%.6f,0,0,1\n", 30 * cos(a / 3), i / 9, 5 * sin(a)
					turned(30 * cos(a / 3), i / 9, 5 * sin(a), sin(t) * cos(a), sin(t) * sin(a), cos(t))
				}
				print "RAPID\nGOTO/0,0,90,0,0,1\nFINI"
			}
			if (kind == "spiral" || kind == "steep") {
				t = (kind == "steep" ? 95 : 50) * rad
				st = sin(t)
				ct = cos(t)
				print "PARTNO/SPIRAL\nUNITS/MM\nMULTAX/ON\nCUTTER/8,4,0,4,0,0,60\nLOADTL/1\nSPINDL/RPM,8000,CLW"
				print "$$-> CLOUDMILL/1"
				for (pass = 1; pass <= 3; pass++) {
					print "$$-> PASS/" pass "\nRAPID"
					go(0, 60)
					print "FEDRAT/MMPM,700"
					for (k = 0; k <= 120; k++) {
						if (pass == 2 && k && kind == "spiral") printf "CIRCLE/0,0,%.6f,0,0,1,30\n", -(k - 1) / 9
						go(k, 0)
					}
					print "RAPID"
					go(120, 60)
				}
				print "FINI"
			}
			if (kind == "holes" || kind == "leaning") {
				print "PARTNO/HOLES\nUNITS/MM\nMULTAX/ON\nCUTTER/8\nLOADTL/5\nSPINDL/RPM,1000,CLW\nRAPID"
				place(-7, -3, 100)
				print "CYCLE/DRILL,DEPTH,10,CLEAR,2,RTRCTO,20,MMPM,150"
				place(0, 1, 0); place(10, 2, 0); place(20, 3, 5); print "CYCLE/OFF"
				print "CYCLE/FACE,FEDTO,3,RAPTO,1.5,MMPM,90,DWELL,0.25"
				place(21, 8, 5); place(22, 9, 5)
				print "CYCLE/DEEP,DEPTH,31,STEP,5,SUBPECK,2,CLEAR,2,MMPM,120"
				place(20, 10, 0); place(30, 11, 0)
				print "CYCLE/BRKCHP,DEPTH,13,STEP,6,CLEAR,2,MMPM,120"
				place(40, 12, -4); print "CYCLE/OFF"
				print "CYCLE/TAP,DEPTH,12,PITCH,1.25,CLEAR,4"
				place(40, 20, 0); place(41, 27, 0)
				print "CYCLE/BORE,DEPTH,14,CLEAR,3,MMPM,80,DWELL,1,RTRCTO,9"
				place(50, 20, 0); print "CYCLE/BORE,DRAG,DEPTH,15,CLEAR,4,MMPM,80"; place(60, 22, 0)
				print "CYCLE/OFF\nRAPID"; place(60, 22, 100); print "FINI"
			}
		}' </dev/null
		;;
	esac
}

# program KIND: a program as a hand or another system writes it
program() {
	case $1 in
	fanuc)
		cat <<-'STREAM'
			%
			O7(BY HAND)
			N10 G90 G17 G20 G40 G49 G80 G94 G54
			N20 G53 G0 Z0.
			N30 T1 M6
			N40 S8000 M3
			N50 G0 A0. C0.
			N60 G43.4 H1
			N70 G0 X0. Y0. Z2.
			N80 G1 Z0.4 F20.
			N90 G2 X0.4 Y0.4 R0.4
			N100 G3 X0.6 Y0.2 R-0.2
			N110 G18 G2 X0.4 Z0.6 I0. K0.2
			N120 G19 G3 Y0.4 Z0.4 J0. K-0.2
			N130 G17 G1 A10. C20.
			N140 G0 Z2.
			N150 G49
			N160 G43.5 H1
			N165 G0 X0. Y0. Z1. I0. J0. K1.
			N170 G1 Z0.5 F30.
			N180 X0.2 I0.6 J0. K0.8
			N190 G4 P500
			N200 G49
			N210 G28 G91 Z0.
			N220 G90
			N230 M5
			N240 M30
			%
		STREAM
		;;
	siemens)
		cat <<-'STREAM'
			%_N_HAND_MPF
			N10 G90 G17 G71 G40 G94 G54
			N20 SUPA G0 Z0 D0
			N30 T="BALL" D1 M6
			N40 S8000 M3
			N50 G0 A0 C0
			N60 TRAORI
			N70 ORIWKS ORIVECT
			N80 CYCLE832(0.01,11,0.1)
			N90 G0 X0 Y0 Z40 A3=0 B3=0 C3=1
			N100 G1 Z10 F500
			N110 G2 X10 Y10 CR=10
			N120 G3 X15 Y5 CR=-5
			N130 G3 X10 Y10 I-5 J0
			N150 MSG("there")
			N160 G1 X20 A3=0 B3=0.6 C3=0.8
			N170 BSPLINE X25 Y10 Z10 PW=1
			N180 X30 Y15 Z9
			N190 X35 Y10 Z10
			N200 X40 Y10 Z10
			N210 G0 Z40
			N220 TRAFOOF
			N230 SUPA G0 Z0 D0
			N240 M5
			N250 M30
		STREAM
		;;
	heidenhain)
		cat <<-'STREAM'
			0 BEGIN PGM HAND MM
			1 L Z+0 R0 FMAX M91
			2 TOOL CALL 1 Z S8000
			3 M3
			4 L A+0 C+0 R0 FMAX
			5 FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS
			6 L X+0 Y+0 Z+40 FMAX
			7 L Z+10 F500
			8 CC X+10 Y+0
			9 C X+10 Y+10 DR-
			10 L A+10 C+20
			11 LN X+20 Y+10 Z+10 TX+0 TY+0.6 TZ+0.8
			12 L Z+40 FMAX
			13 FUNCTION RESET TCPM
			14 L Z+0 R0 FMAX M91
			15 M5
			16 M30
			17 END PGM HAND MM
		STREAM
		;;
	linuxcnc)
		cat <<-'STREAM'
			%
			N10 G90 G91.1 G17 G21 G40 G49 G80 G94 G54
			N20 G61
			N30 G53 G0 Z0.
			N40 T1 M6
			N50 S8000 M3
			N60 G0 A0. C0.
			N70 G0 X0. Y0.
			N80 G43 H1 Z40.
			N90 G1 Z10. F500.
			N100 G2 X10. Y10. I10. J0.
			N110 G64 P0.01 Q0.01
			N120 G4 P0.5
			N130 G1 A10. C20.
			N140 G0 Z40.
			N150 G49
			N160 G53 G0 Z0.
			N170 M5
			N180 M2
			%
		STREAM
		;;
	esac
}

# also FILES -- CMD...: CMD, and behind what it prints the files of these patterns; CMD's status
also() {
	patterns=$1
	shift 2
	"$@"
	status=$?
	# shellcheck disable=SC2086 # patterns
	for file in $patterns; do
		[ -e "$file" ] && echo "==" && cat "$file" && rm -f "$file"
	done
	return $status
}

# figures CMD...: what it prints, and behind that the numbers that it says on standard error
figures() {
	"$@" 2>figures.$$
	status=$?
	tr -c '0-9.\n-' ' ' <figures.$$ | tr -s ' '
	rm -f figures.$$
	return $status
}
