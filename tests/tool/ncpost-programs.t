#!/bin/sh
# ncpost-programs.t - golden programs, programs read back against their paths, travel, refusals,
# manners.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
# Paths here need not name a speed of the spindle and a tool: ncpost-missing.t has those that lack them.
ncpost() { command ncpost --no-spindle "$@"; }
golden=$SRC/tests/data/golden
cd "$TMP" || exit 1

# ---- golden programs: every shape, small enough to read
post() { # NAME OPTIONS...: the golden program NAME of shapes.cl
	name=$1
	shift
	ncpost -q "$@" "$golden/shapes.cl" >"$TMP/$name" 2>"$TMP/err"
	same "golden $name" "$golden/$name" "$TMP/$name"
}
post shapes.fanuc.nc -c fanuc
post shapes.vectors.nc -c fanuc --vectors
post shapes.notcp.nc -c fanuc -m table-ac-notcp --chord 0.1 --axis-tolerance 1
post shapes.siemens.mpf -c siemens
post shapes.heidenhain.h -c heidenhain --chord 0.05 --axis-tolerance 0.5
post shapes.vectors.h -c heidenhain --vectors --chord 0.05 --axis-tolerance 0.5
post shapes.linuxcnc.ngc -c linuxcnc -m linuxcnc-xyzac --chord 0.05 --axis-tolerance 0.5
post shapes.notcp.ngc -c linuxcnc --chord 0.1 --axis-tolerance 1
post shapes.rotary.mpf -c siemens --rotary --chord 0.05 --axis-tolerance 0.5

# ---- read back by the tests' own reader: options of ncpost, then options of the reader
back() { # PATH NCPOST-OPTIONS READBACK-OPTIONS
	# shellcheck disable=SC2086
	ncpost -q $2 "$1" >"$TMP/back.nc" 2>"$TMP/err" &&
		ok "$(basename "$1"): ncpost $2, read back" \
			"$READBACK" $3 --path "$1" -e "${4:-0.0029}" --axis 0.052 "$TMP/back.nc" && return
	result 1 "$(basename "$1"): ncpost $2"
}

linuxcnc() { # PATH NCPOST-OPTIONS READBACK-OPTIONS
	desc="$(basename "$1"): ncpost -c linuxcnc $2, run by rs274, read back"
	# shellcheck disable=SC2086
	ncpost -q -c linuxcnc $2 "$1" >"$TMP/back.ngc" 2>"$TMP/err" || { result 1 "$desc"; return; }
	if ! command -v rs274 >/dev/null; then
		skip "$desc" "no rs274"
		return
	fi
	canon back.ngc >back.canon || { cat canon.err >"$TMP/err"; result 1 "$desc"; return; }
	# shellcheck disable=SC2086
	ok "$desc" "$READBACK" -c canon $3 --path "$1" -e 0.0029 --axis 0.052 back.canon
}

# A wave with four passes, the tool leaning by 15 degrees: height of the wave, path file
wave() {
	awk -v high="$1" '
	function unit(v,  l) { l = sqrt(v[1]^2 + v[2]^2 + v[3]^2); for (k = 1; k <= 3; k++) v[k] /= l }
	function pose(word, x, y, up,  k, z, s, c) {
		z = high * sin(x / 10) * cos(y / 12)
		n[1] = -high / 10 * cos(x / 10) * cos(y / 12); n[2] = high / 12 * sin(x / 10) * sin(y / 12)
		n[3] = 1; t[1] = 1; t[2] = 0; t[3] = -n[1]; unit(n); unit(t)
		b[1] = n[2]*t[3] - n[3]*t[2]; b[2] = n[3]*t[1] - n[1]*t[3]; b[3] = n[1]*t[2] - n[2]*t[1]
		s = sin(atan2(1, 1) / 3); c = cos(atan2(1, 1) / 3)
		for (k = 1; k <= 3; k++) a[k] = c * n[k] + s * b[k]
		unit(a)
		if (!up)
			printf "$$-> CONTCT/%.6f,%.6f,%.6f,%.9f,%.9f,%.9f\n", x, y, z, n[1], n[2], n[3]
		printf "%s/%.6f,%.6f,%.6f,%.9f,%.9f,%.9f\n", word, x + 8 * (n[1] - a[1]), y + 8 * (n[2] - a[2]),
			up ? up : z + 8 * (n[3] - a[3]), a[1], a[2], a[3]
	}
	BEGIN {
		print "PARTNO/WAVE\nUNITS/MM\nMULTAX/ON\nCUTTER/16,8,0,8,0,0,60\nLOADTL/1"
		print "SPINDL/RPM,8000,CLW\n$$-> CLOUDMILL/1"
		for (j = 0; j < 4; j++) {
			s = j % 2 ? -1 : 1
			print "$$-> PASS/" j + 1 "\nRAPID"
			pose("GOTO", -30 * s, 8 * j - 12, 60)
			print "FEDRAT/MMPM,800"
			for (i = -30; i <= 30; i++) pose("GOTO", s * i, 8 * j - 12, 0)
			print "RAPID"
			pose("GOTO", 30 * s, 8 * j - 12, 60)
		}
		print "FINI"
	}' >"$2"
}
wave 3 wave.cl
wave 25 steep.cl
for path in wave steep; do
	biarcfit -q -e 0.01 $path.cl >$path-arcs.cl && bsplfit -q -e 0.01 $path.cl >$path-splines.cl
	for kind in "" -arcs -splines; do
		file=$TMP/$path$kind.cl
		back "$file" "-c fanuc" "-c fanuc"
		back "$file" "-c fanuc --vectors" "-c fanuc"
		back "$file" "-c fanuc -m table-bc" "-c fanuc --axes bc"
		back "$file" "-c fanuc -m table-ac-notcp" "-c fanuc --no-tcp"
		back "$file" "-c siemens" "-c siemens"
		back "$file" "-c siemens --rotary" "-c siemens"
		back "$file" "-c siemens -m table-ac-notcp" "-c siemens --no-tcp"
		back "$file" "-c heidenhain" "-c heidenhain"
		back "$file" "-c heidenhain --vectors" "-c heidenhain"
		linuxcnc "$file" "" "--no-tcp"
		linuxcnc "$file" "-m table-bc" "--no-tcp --axes bc"
		linuxcnc "$file" "-m linuxcnc-xyzac" "--reversed"
		linuxcnc "$file" "-m linuxcnc-xyzbc" "--reversed --axes bc"
	done
done
for path in wave steep; do # arcs in space, of a Fanuc that has them
	back "$TMP/$path-arcs.cl" "-c fanuc --set arcs.space=yes" "-c fanuc"
	back "$TMP/$path-arcs.cl" "-c fanuc --set arcs.space=yes --vectors" "-c fanuc"
done
ncpost -q -c fanuc --set arcs.space=yes "$TMP/steep-arcs.cl" >space.nc
has "G02.4 with a point on the way" '^N[0-9]+ G02\.4 X.* Y.* Z.* A' space.nc
ncpost -q -c fanuc "$TMP/steep-arcs.cl" >flat.nc
below "and shorter than without" "$(wc -l <space.nc)" "$(wc -l <flat.nc)"
back "$golden/shapes.cl" "-c fanuc" "-c fanuc"
back "$golden/shapes.cl" "-c siemens" "-c siemens"
back "$golden/shapes.cl" "-c heidenhain" "-c heidenhain"
linuxcnc "$golden/shapes.cl" "" "--no-tcp"
linuxcnc "$golden/shapes.cl" "-m linuxcnc-xyzac" "--reversed"

# ---- shapes go over as what they are
ncpost -q -c fanuc "$TMP/wave-splines.cl" >f.nc
ncpost -q -c siemens "$TMP/wave-splines.cl" >s.mpf
has "Fanuc: G06.2 with rotary poles" '^N[0-9]+ G06\.2 P4 K0\. X.* Y.* Z.* A.* C' f.nc
has "Siemens: polynomials with a head curve" 'POLY PO\[X\]=.* PO\[ZH\]=.* PL=' s.mpf
for degree in 2 4 5; do
	bsplfit -q --degree $degree -e 0.01 "$TMP/steep.cl" >"$TMP/steep-$degree.cl"
	# a cubic beside one of the fifth degree is 0.0001 mm over --chord and the rounding: known
	back "$TMP/steep-$degree.cl" "-c fanuc" "-c fanuc" 0.0031
	back "$TMP/steep-$degree.cl" "-c siemens" "-c siemens"
done
ncpost -q -c siemens "$TMP/steep-5.cl" >s.mpf
has "Siemens: to the fifth degree" 'POLY PO\[X\]=\([-0-9.]+(,[-0-9.]+){4}\) .* PO\[ZH\]=\([-0-9.]+(,[-0-9.]+){4}\) PL=' s.mpf
ok "as they are" "$READBACK" -c siemens --path "$TMP/steep-5.cl" -e 0.0001 --axis 0.001 s.mpf
ncpost -q -c fanuc "$TMP/steep-5.cl" >f.nc
has "Fanuc: a cubic beside it" 'G06\.2 P4 ' f.nc
ncpost -q -c siemens "$TMP/wave-arcs.cl" >a.mpf
has "Siemens: the head on the curve's parameter" 'ORIWKS ORIAXES UPATH$' s.mpf
has "the compressor off" '^N[0-9]+ COMPOF$' s.mpf
hasnt "not without curves" 'UPATH|COMPOF' a.mpf
has "Siemens: arcs in space" 'CIP X.*I1=AC\(.*A3=' a.mpf
ncpost -q -c fanuc "$TMP/wave-arcs.cl" >a.nc
has "Fanuc: arcs in a plane" 'G18 G[23] X.* Z.* A.* C.* I.* K' a.nc
ncpost -q -m linuxcnc-xyzac "$TMP/wave-arcs.cl" >l.ngc
has "LinuxCNC: arcs in a plane, A and C riding" 'G18 G[23] X.* Z.* A.* C.* I.* K' l.ngc
ncpost -q -c linuxcnc "$TMP/steep.cl" >n.ngc
ncpost -q -c heidenhain "$golden/shapes.cl" >h.h
has "Heidenhain: an arc in the working plane" '^[0-9]+ C X\+0 Y\+40 DR-' h.h
ncpost -q -c heidenhain --vectors "$TMP/wave.cl" >v.h
has "Heidenhain: LN with the tool axis" '^[0-9]+ LN X[+-].* Y[+-].* Z[+-].* TX[+-].* TY[+-].* TZ[+-]' v.h
hasnt "Heidenhain: places, angles and vectors have signs, feeds none" \
	'^[^;]* (([XYZABC]|T[XYZ])[0-9.]|F[+-])' v.h
ncpost -q -c siemens --set splines=no --set arcs=no "$golden/shapes.cl" >none.mpf
hasnt "a machine without arcs and splines gets none" 'CIP|POLY|BSPLINE' none.mpf

# ---- what every program keeps
ncpost -q -c fanuc -m table-ac-notcp "$TMP/steep.cl" >n.nc
for file in f.nc s.mpf a.mpf a.nc none.mpf n.nc l.ngc n.ngc h.h v.h; do
	hasnt "$file: no -0, no exponent" '[A-Z=,(]-(0+\.?|0*\.0+)( |,|\)|$)|[0-9][eE][-+0-9]' $file
	awk '{ if (length($0) > most) most = length($0) } END { print most }' $file >most
	case $file in *.ngc) limit=255 ;; *) limit=512 ;; esac
	below "$file: short blocks" "$(cat most)" $limit
done
hasnt "LinuxCNC: no G5.2" 'G5(\.| |$)' l.ngc
awk '/^\(/ && (length($0) > 80 || /\(.*\(/ || /[a-z]/) { print }' f.nc >bad
empty "Fanuc comments: capitals, 80 columns, no brackets inside" bad
for file in n.nc n.ngc; do
	awk '/G93/ { on = 1 } /G94$/ { on = 0 } on && / G[01]( |$)/ { feed = / G1( |$)/ }
		on && feed && !/^\(/ { blocks++; with += / F/ }
		END { print blocks - with, (blocks > 100) }' $file >found
	has "$file: inverse time: F in each block at feed" '^0 1$' found
done
hasnt "inverse time: never F0" ' F0?\.?0*$' n.nc
hasnt "inverse time: no arcs" ' G[23] ' n.nc
awk '/G43\.4/ { on = 1 } /G49/ { on = 0 } on && /G28|G53/ { print }' f.nc >bad
empty "no retract by G28 under G43.4" bad
has "M30 comes before the last line" '^N[0-9]+ M30$' f.nc
has "the ledger stands in the head" '^\(TOLERANCE SUM +0\.0[0-9]+ MM' f.nc

# ---- the ledger
status 3 "-e that is not kept: exit 3" ncpost -c fanuc -e 0.001 "$golden/shapes.cl"
has "and it names the sum" 'spent 0\.00[0-9]+ mm, expected at most 0\.001' err
status 0 "-e that is kept" ncpost -c fanuc -e 0.02 "$golden/shapes.cl"

# ---- travel: a pass along y over a ridge; the axis leans from -60 to 60 degrees
head='UNITS/MM\nMULTAX/ON\nCUTTER/8,4,0,4,0,0,60\nSPINDL/RPM,8000,CLW\nFEDRAT/MMPM,500\n'
awk -v head="$head" 'BEGIN {
	print head "$$-> PASS/7\nRAPID"
	print "GOTO/0,-30,60,0,-0.866025404,0.5"
	for (i = -60; i <= 60; i += 3) {
		w = i * atan2(1, 1) / 45
		printf "GOTO/0,%.6f,%.6f,0,%.9f,%.9f\n", 20 * sin(w), 20 * cos(w), sin(w), cos(w)
	}
	print "RAPID\nGOTO/0,30,60,0,0.866025404,0.5\nFINI"
}' >ridge.cl
# and three times round a dome, so that C winds up
awk -v head="$head" 'BEGIN {
	print head "$$-> PASS/8\nRAPID"
	print "GOTO/40,0,60,0.5,0,0.866025404"
	for (i = 0; i <= 1080; i += 5) {
		w = i * atan2(1, 1) / 45
		printf "GOTO/%.6f,%.6f,10,%.9f,%.9f,0.866025404\n", 20 * cos(w), 20 * sin(w),
			cos(w) / 2, sin(w) / 2
	}
	print "RAPID\nGOTO/40,0,60,0.5,0,0.866025404\nFINI"
}' >dome.cl
status 0 "over the pole without a turn" ncpost -c fanuc ridge.cl
hasnt "C stays" ' C[1-9]' out
status 0 "a shorter travel: the other solution over the pole" ncpost -c fanuc --set a.max=40 ridge.cl
cp out turn.nc
awk '/ A/ { sub(/.* A/, ""); if ($1 + 0 > 40) print }' turn.nc >bad
empty "no A beyond its travel" bad
ok "and the cut is still the path" \
	"$READBACK" -c fanuc --path ridge.cl -e 0.0062 --axis 0.052 turn.nc
for options in "-c fanuc" "-c fanuc -m table-ac-notcp" "-c siemens --rotary"; do
	# shellcheck disable=SC2086
	status 0 "$options: C winds up: retract, turn, return" \
		ncpost $options --set c.min=-360 --set c.max=360 dome.cl
	has "and it is said" 'retracted, turned and returned 1 times' err
	cp out turn.nc
	awk '/ C/ { sub(/.* C/, ""); if ($1 + 0 > 360 || $1 + 0 < -360) print }' turn.nc >bad
	empty "no C beyond its travel" bad
	[ "$options" = "-c fanuc" ] && cp turn.nc dome.nc
done
# each point of the path is reached in the program, tip and axis, and in the path's order
awk -F'[/,]' 'function value(letter) {
		if (match(line, " " letter "-?[0-9.]+")) at[letter] = substr(line, RSTART + 2, RLENGTH - 2)
		return at[letter]
	}
	NR == FNR { if (/^GOTO/) { n++; for (k = 2; k <= 7; k++) want[n, k] = $k } next }
	/^N/ { line = $0; w = atan2(1, 1) / 45; x = value("X"); y = value("Y"); z = value("Z")
		a = value("A") * w; c = value("C") * w
		d = (x - want[i + 1, 2])^2 + (y - want[i + 1, 3])^2 + (z - want[i + 1, 4])^2
		d += (sin(c) * sin(a) - want[i + 1, 5])^2 + (-cos(c) * sin(a) - want[i + 1, 6])^2
		if (i < n && d < 1e-6) i++ }
	END { print i, "of", n }' dome.cl dome.nc >found
has "the whole path is there, turned or not" '^219 of 219$' found
# five turns inwards at a tilt of 50 degrees: C from -360 to 360, back twice
awk -v head="$head" 'BEGIN {
	print head "$$-> PASS/1\nRAPID\nGOTO/30,0,60,0.766044443,0,0.642787610"
	for (i = 0; i <= 1800; i += 5) {
		w = i * atan2(1, 1) / 45; r = 30 - i / 180
		printf "GOTO/%.6f,%.6f,%.6f,%.9f,%.9f,0.642787610\n", r * cos(w), r * sin(w), i / 180,
			0.766044443 * cos(w), 0.766044443 * sin(w)
	}
	print "RAPID\nGOTO/20,0,60,0.766044443,0,0.642787610\nFINI"
}' >spiral.cl
for options in "-c fanuc" "-c fanuc -m head-ca" "-c heidenhain" "-c linuxcnc"; do
	# shellcheck disable=SC2086
	status 0 "$options: a spiral of five turns" ncpost $options --set a.min=-30 --set a.max=120 \
		--set c.min=-360 --set c.max=360 spiral.cl
	has "with the fewest turns back" 'retracted, turned and returned 2 times' err
	awk '/ [AC][+-]?[0-9]/ { for (i = 2; i <= NF; i++) { v = substr($i, 2) + 0
		if ($i ~ /^C[-+0-9]/ && (v > 360 || v < -360) || $i ~ /^A[-+0-9]/ && (v > 120 || v < -30))
			print } }' out >bad
	empty "no block outside the travel" bad
done
# a dome straight over its top, beside it by a hair, and all round
pole() { # MM-BESIDE DIRECTION
	awk -v head="$head" -v y="$1" -v way="$2" '
	function pose(t, up,  x, z, c, s) {
		x = 60 * sin(t); z = sqrt(3600 - x * x - y * y); c = cos(way / 57.29577951)
		s = sin(way / 57.29577951)
		printf "GOTO/%.6f,%.6f,%.6f,%.9f,%.9f,%.9f\n", x * c - y * s, x * s + y * c, z + up,
			(x * c - y * s) / 60, (x * s + y * c) / 60, z / 60
	}
	BEGIN {
		print head "$$-> PASS/1\nRAPID"; pose(-0.5, 50)
		for (i = -25; i <= 25; i++) pose(i / 50, 0)
		print "RAPID"; pose(0.5, 50); print "FINI"
	}' >pole.cl
}
for beside in 0 0.001 0.03 1; do
	for way in 0 37 90 225; do
		pole $beside $way
		for options in "-c fanuc" "-c fanuc -m table-ac-notcp" "-c siemens --rotary"; do
			notcp=
			case $options in *notcp) notcp=--no-tcp ;; esac
			# shellcheck disable=SC2086
			ncpost -q $options pole.cl >pole.nc 2>err && "$READBACK" -c "$(echo "$options" |
				cut -d' ' -f2)" $notcp --path pole.cl -e 0.0062 --axis 0.06 pole.nc >>err 2>&1 ||
				echo "$beside beside, way $way: $options"
		done
	done
done >bad
empty "over the pole, near it and beside it in all directions: ball and axis kept" bad
status 0 "the other solution where it serves" ncpost -c fanuc --set a.min=-10 --set a.max=61 \
	--set c.min=-280 --set c.max=280 "$TMP/wave.cl"
hasnt "and no turns" 'retracted' err
status 1 "no solution: exit 1" ncpost -c fanuc --set a.min=-30 --set a.max=30 ridge.cl
has "with pass, line and axis" 'ridge\.cl:[0-9]+: pass 7: axis A' err
empty "and no program" out
status 1 "a place beyond a linear axis" ncpost -c fanuc --set z.max=30 ridge.cl
has "names it" 'axis Z' err

# ---- refusals: nothing that looks like a program
printf 'UNITS/MM\n$$-> TRACK/CONTACT\nGOTO/0,0,1\nGOTO/0,1,1\nFINI\n' >contact.cl
status 1 "contact points are refused" ncpost -c fanuc contact.cl
has "clearly" 'TRACK/CONTACT' err
printf 'UNITS/MM\n$$-> TRACK/CENTER\nRAPID\nGOTO/0,0,9\nFEDRAT/MMPM,100\nGOTO/0,1,1\nFINI\n' >centre.cl
status 0 "a path of ball centres" ncpost -c fanuc centre.cl
has "is told in the head" '^\(.*X Y Z ARE THE CENTRE OF THE BALL' out
printf 'UNITS/MM\nLOADTL/1\nRAPID\nGOTO/0,0,9\nLOADTL/2\nRAPID\nGOTO/0,1,9\nFINI\n' >tools.cl
status 0 "a second tool is changed to" ncpost -c fanuc tools.cl
has "with its number" '^N[0-9]+ T2 M6$' out
printf 'UNITS/MM\nFROBNI/1\nRAPID\nGOTO/0,0,9\nFINI\n' >frob.cl
status 0 "an unknown word: passed over" ncpost -c fanuc frob.cl
has "with a warning" 'FROBNI' err
status 1 "an error with --strict" ncpost -c fanuc --strict frob.cl
status 2 "no control" ncpost "$golden/shapes.cl"
status 2 "an unknown control" ncpost -c nosuch "$golden/shapes.cl"
status 2 "vectors and rotary words" ncpost -c fanuc --vectors --rotary "$golden/shapes.cl"
status 2 "a Fanuc program has a number" ncpost -c fanuc --program NAME "$golden/shapes.cl"
status 2 "a wrong key" ncpost -c fanuc --set frob=1 "$golden/shapes.cl"
status 1 "no such machine" ncpost -c fanuc -m nowhere "$golden/shapes.cl"
head -n 30 "$golden/shapes.cl" >half.cl
status 1 "half a path" ncpost -c fanuc half.cl
hasnt "has no end" 'M30' out
status 1 "and no file" ncpost -c fanuc -o half.nc half.cl
ok "not even part of one" test ! -e half.nc

# ---- manners
printf 'UNITS/MM\nGOTO/0,0,9\nGOTO/5,0,9\nFINI\n' >bare.cl
status 0 "a path without feed, rapid or tool" ncpost -c siemens bare.cl
has "says the feed it took" 'used 500 mm/min' err
has "comes from above" ' Z59$' out
ncpost -q -c fanuc "$golden/shapes.cl" >a.nc
ncpost -q -c fanuc -m table-ac -j 3 "$golden/shapes.cl" >b.nc
same "table-ac is the default machine" a.nc b.nc
if has_locale de_DE.UTF-8; then
	LC_ALL=de_DE.UTF-8 ncpost -q -c fanuc -o c.nc "$golden/shapes.cl"
	same "the same bytes in another locale, in a file" a.nc c.nc
else
	skip "the same bytes in another locale, in a file" "no locale de_DE.UTF-8"
fi
if [ -w /dev/full ]; then
	status 1 "a full disk" sh -c "ncpost -q -c fanuc '$golden/shapes.cl' >/dev/full"
else
	skip "a full disk" "no /dev/full"
fi
ncpost -q -c siemens --program AB_1 "$golden/shapes.cl" >name.mpf
has "a name of its own" '^%_N_AB_1_MPF$' name.mpf
ncpost -q -c fanuc --program 4711 --set number.step=0 "$golden/shapes.cl" >name.nc
has "a number of its own" '^O4711$' name.nc
hasnt "no block numbers" '^N' name.nc

# ---- block numbers, templates
ncpost -q -c fanuc --set number.step=1000 "$TMP/wave.cl" >many.nc
has "block numbers of six digits" '^N100000 ' many.nc
ncpost -q -c fanuc --set number.step=100 --set number.max=9999 "$TMP/wave.cl" >few.nc
hasnt "number.max: none beyond it" '^N[0-9]{5}' few.nc
ncpost -q -c fanuc --set 'home=G53 Z0.|G90' --set 'tool.change=T{tool}|M6 (S{rpm})' \
	--set 'tcp.on=G43.4 H{tool}' --set start=G187 --set end=M99 "$golden/shapes.cl" >own.nc
for line in 'G53 Z0\.' 'T3' 'M6 \(S12000\)' 'G187' 'M99' 'G43\.4 H3'; do
	has "templates: a block $line" "^N[0-9]+ $line\$" own.nc
done
status 2 "a template with a word that nobody knows" \
	ncpost -c fanuc --set 'home=G53 Z{height}' "$golden/shapes.cl"
has "names it" '\{height\}' err
for control in fanuc siemens heidenhain linuxcnc; do
	ncpost -q -c $control --set smooth=yes --chord 0.008 --axis-tolerance 0.2 \
		"$golden/shapes.cl" >$control.smooth
done
has "its tolerance is in the ledger" '^\(TOLERANCE SMOOTHING +0\.0080\)$' fanuc.smooth
status 3 "and counts" ncpost -q -c fanuc --set smooth=yes -e 0.0065 "$golden/shapes.cl"
status 0 "as it does not without" ncpost -q -c fanuc -e 0.0065 "$golden/shapes.cl"
has "smoothing: Fanuc" ' G05\.1 Q1 R6$' fanuc.smooth
has "and off again" ' G05\.1 Q0$' fanuc.smooth
has "smoothing: Siemens, with the axis" 'CYCLE832\(0\.008,11,0\.2\)' siemens.smooth
has "smoothing: Heidenhain" 'CYCL DEF 32\.1 T0\.008$' heidenhain.smooth
has "smoothing: LinuxCNC" 'G64 P0\.008$' linuxcnc.smooth

# ---- 3+2: the points of a tilted plane, brought back by the angles that the program names
plane_path='
	function world(word, u, v, w,  r, x, y, z) {
		r = atan2(1, 1) / 45; ca = cos(20 * r); sa = sin(20 * r); cb = cos(30 * r); sb = sin(30 * r)
		x = cb * u + sb * w; z = -sb * u + cb * w; y = ca * v - sa * z; z = sa * v + ca * z
		printf "%s%.6f,%.6f,%.6f%s", word, x, y, z, word == "GOTO/" ? a : ""
	}
	BEGIN {
		r = atan2(1, 1) / 45
		a = sprintf(",%.9f,%.9f,%.9f\n", sin(30 * r), -sin(20 * r) * cos(30 * r), cos(20 * r) * cos(30 * r))
		printf head "$$-> PASS/1\nRAPID\n"; world("GOTO/", 10, 5, 60); world("GOTO/", 10, 5, 3)
		world("GOTO/", 30, 5, 3)
		world("CIRCLE/", 30, 15, 3); sub("\n", "", a); printf "%s,10\n", a; a = a "\n"
		world("GOTO/", 30, 25, 3); print "RAPID"; world("GOTO/", 30, 25, 60); print "FINI"
	}'
awk -v head="$head" "$plane_path" >plane.cl
# Angles of the frame: Euler about Z X Z, or about X and the turned Y; then each place again
plane_back() { # PROGRAM
	awk -F'[/,]' '
	function turn(v, i, j, by,  c, s, t) {
		c = cos(by / 57.29577951308232); s = sin(by / 57.29577951308232)
		t = c * v[i] - s * v[j]; v[j] = s * v[i] + c * v[j]; v[i] = t
	}
	function value(word,  at) {
		at = match(line, "[ (,]" word "[-+]?[0-9.]+")
		return at ? substr(line, RSTART + 1 + length(word), RLENGTH - 1 - length(word)) + 0 : old[word]
	}
	NR == FNR { if (/^GOTO/) { n++; for (k = 2; k <= 4; k++) want[n, k - 1] = $k } next }
	{ line = $0 }
	/G68\.2/ { e1 = value("I"); e2 = value("J"); e3 = value("K"); euler = 1; on = 1; next }
	/CYCLE800\(0/ { split(line, p, ","); a = p[8]; b = p[9]; on = 1; next }
	/PLANE SPATIAL/ { a = value("SPA"); b = value("SPB"); fixed = 1; on = 1; next }
	on && / [XYZ][-+]?[0-9]/ && !/M91|SUPA|G28/ {
		old["X"] = value("X"); old["Y"] = value("Y"); old["Z"] = value("Z")
		v[1] = old["X"]; v[2] = old["Y"]; v[3] = old["Z"]
		if (euler) { turn(v, 1, 2, e3); turn(v, 2, 3, e2); turn(v, 1, 2, e1) }
		else if (fixed) { turn(v, 2, 3, a); turn(v, 3, 1, b) }
		else { turn(v, 3, 1, b); turn(v, 2, 3, a) }
		d = (v[1] - want[i + 1, 1])^2 + (v[2] - want[i + 1, 2])^2 + (v[3] - want[i + 1, 3])^2
		if (i < n && d < 4e-6) i++
	}
	END { print i, "of", n }' plane.cl "$1" >found
}
for control in fanuc siemens heidenhain; do
	status 0 "$control: 3+2" ncpost -c $control --plane plane.cl
	plane_back out
	has "the places in the plane are those of the path" '^5 of 5$' found
	hasnt "no words of tool-centre-point control" 'G43\.[45]|TRAORI|FUNCTION TCPM' out
done
has "an arc in the plane is an arc" ' C X.* DR\+' out

# A B-spline in the tilted plane, where Fanuc has no tool-centre-point control: chords.
cat >tilted-spline.cl <<'END'
UNITS/MM
CUTTER/10,5
SPINDL/RPM,8000,CLW
RAPID
GOTO/0,0,50,0,.6,.8
FEDRAT/MMPM,500
GOTO/0,0,0,0,.6,.8
MOVNRB/M3AXIS
MOVNRB/ON,4,8,0,4,30
MOVNRB/1,0,0,0,0,30,30,30,30
MOVNRB/2,0,0,0,10,5,0,20,5,0,30,0,0
MOVNRB/NEXT
GOTO/30,0,0
MOVNRB/OFF
RAPID
GOTO/30,0,50
FINI
END
status 0 "a B-spline under --plane" ncpost -c fanuc --plane tilted-spline.cl
has "its chords end on it" ' X30\. Y0\. Z0\.$' out
hasnt "and no G06.2 under G68.2" 'G06' out
status 0 "on the spot with tool-centre-point control" ncpost -c fanuc tilted-spline.cl
has "it is G06.2" 'G06\.2' out

status 0 "by a key of the machine" ncpost -c fanuc --set plane=yes plane.cl
has "where the axis stays" 'G68\.2 X0\. Y0\. Z0\. I' out
has "and is cancelled" ' G69$' out
status 0 "but not where it turns" ncpost -c fanuc --set plane=yes "$golden/shapes.cl"
hasnt "there it is tool-centre-point control" 'G68' out
status 1 "--plane with an axis that turns" ncpost -c fanuc --plane "$golden/shapes.cl"
status 2 "LinuxCNC knows no plane" ncpost -c linuxcnc --plane plane.cl
status 1 "a plane out of reach" ncpost -c fanuc --plane --set a.min=-5 --set a.max=5 plane.cl

# ---- inches
ncpost -q -c fanuc --inch "$TMP/wave.cl" >inch.nc
has "G20" ' G20 ' inch.nc
has "feeds in inches" ' F31\.496$' inch.nc
awk -F'[/,]' 'function value(letter) {
		if (match(line, " " letter "-?[0-9.]+")) at[letter] = substr(line, RSTART + 2, RLENGTH - 2)
		return at[letter] * 25.4
	}
	NR == FNR { if (/^GOTO/) { n++; for (k = 2; k <= 4; k++) want[n, k] = $k } next }
	/^N/ { line = $0; x = value("X"); y = value("Y"); z = value("Z")
		d = (x - want[i + 1, 2])^2 + (y - want[i + 1, 3])^2 + (z - want[i + 1, 4])^2
		if (i < n && d < 1.5e-5) i++ }
	END { print n - i }' "$TMP/wave.cl" inch.nc >found
has "each point of the path is there" '^0$' found
ncpost -q -c linuxcnc --inch "$golden/shapes.cl" >inch.ngc
if command -v rs274 >/dev/null; then
	ok "rs274 takes it" canon inch.ngc
else
	skip "rs274 takes it" "no rs274"
fi

# ---- feed of the contact point: on the inside of a hollow of radius 50 a ball's tip of radius 10
# goes at 4/5 of it
awk -v head="$head" 'BEGIN {
	print "UNITS/MM\nMULTAX/ON\nCUTTER/20,10,0,10,0,0,60\nFEDRAT/MMPM,500\n$$-> PASS/1\nRAPID"
	print "GOTO/0,0,90,0,0,1"
	for (i = 0; i <= 10; i++) {
		w = i / 50; x = -sin(w); z = cos(w)
		printf "$$-> CONTCT/%.6f,0,%.6f,%.9f,0,%.9f\n", -50 * x, 50 - 50 * z, x, z
		printf "GOTO/%.6f,0,%.6f,0,0,1\n", -40 * x, 40 - 40 * z
	}
	print "RAPID\nGOTO/0,0,90,0,0,1\nFINI"
}' >hollow.cl
ncpost -q -c fanuc --contact-feed hollow.cl >contact.nc
has "contact feed: the tip goes slower in a hollow" ' F400\.?[01]?$' contact.nc
ncpost -q -c fanuc hollow.cl >tip.nc
hasnt "and not without it" ' F400' tip.nc

# ---- a slow rotary axis is not asked for more than it can
ncpost -q -c fanuc --set a.rapid=60 ridge.cl >slow.nc
awk '/ F/ { sub(/.* F/, ""); if ($1 > most) most = $1 } END { print most }' slow.nc >most
below "feed by the slowest axis: 20 mm a radian at 60 degrees/min" "$(cat most)" 21.1
ncpost -q -c fanuc --set feed.max=300 "$TMP/wave.cl" >capped.nc
hasnt "feed.max" ' F[3-9][0-9][0-9][^.]|F800' capped.nc

# ---- feeds along all axes together
ncpost -q -c fanuc -m table-ac-notcp --set feeds=combined "$TMP/wave.cl" >combined.nc
hasnt "no inverse time" 'G93' combined.nc
awk 'function value(letter) {
		if (match($0, " " letter "-?[0-9.]+")) return substr($0, RSTART + 2, RLENGTH - 2); return at[letter] }
	/^N/ { way = 0; for (k = 1; k <= 5; k++) { l = substr("XYZAC", k, 1); v = value(l)
			way += (v - at[l])^2; at[l] = v }
		f = value("F"); at["F"] = f
		if (/ G1 /) on = 1; if (/ G0 /) on = 0
		if (on && way > 0) minutes += sqrt(way) / f }
	END { print minutes }' combined.nc >minutes
sed -n 's/^(CUT.* \([0-9.]*\) MIN)$/\1/p' combined.nc >said
awk -v a="$(cat minutes)" -v b="$(cat said)" 'BEGIN { print (a > b - 0.3 && a < b + 0.06) }' >found
has "and the blocks take the time that the head says" '^1$' found

# ---- parts
for options in "-c fanuc" "-c siemens" "-c heidenhain" "-c fanuc -m table-ac-notcp"; do
	rm -f part*
	notcp=
	case $options in *notcp) notcp=--no-tcp ;; esac
	# shellcheck disable=SC2086
	status 0 "$options: in parts of 70 blocks" \
		ncpost $options --split 110 -o part.nc --chord 0.05 --axis-tolerance 0.5 "$TMP/wave.cl"
	find . -name 'part-*.nc' | wc -l >found
	has "more than one" '^ *([2-9]|[1-9][0-9])$' found
	wc -l part-*.nc | awk '$2 != "total" && $1 > 110 { print }' >bad
	empty "none is longer" bad
	for part in part-*.nc; do
		# shellcheck disable=SC2086
		"$READBACK" -c "$(echo "$options" | cut -d' ' -f2)" $notcp $part >part.out 2>&1 ||
			cat part.out
	done >bad
	empty "each is a program, begun and ended as a whole one" bad
done
status 0 "parts by bytes" ncpost -c linuxcnc --split 4k -o byte.ngc "$golden/shapes.cl"
find . -name 'byte-*.ngc' -size +8 >bad
empty "none of more than 4000 bytes" bad
status 2 "parts need a name" ncpost -c fanuc --split 100 "$golden/shapes.cl"
status 2 "and a number" ncpost -c fanuc --split many -o part.nc "$golden/shapes.cl"
status 1 "of blocks that a program can have" ncpost -c fanuc --split 5 -o part.nc "$golden/shapes.cl"
ncpost -q -c fanuc --from 3 "$golden/shapes.cl" >three.nc
hasnt "--from: no pass before it" 'PASS [12]\)' three.nc
has "but that one" '^\(PASS 3\)' three.nc
has "with tool, tool-centre-point control" 'G43\.4 H3' three.nc
has "and the coolant as it was" ' M9$' three.nc
ok "a whole program" "$READBACK" -c fanuc three.nc
status 1 "--from a pass that is not there" ncpost -c fanuc --from 9 "$golden/shapes.cl"

# ---- where a block comes from
status 0 "--explain" ncpost -c fanuc --explain 170 "$golden/shapes.cl"
has "the block" '^N170 G3 X20\.98 ' out
has "its line of the path, pass and rule" 'shapes\.cl:21: pass 2, arc: as the path says it' out
status 0 "--explain with a contact point" ncpost -c fanuc --explain 120 hollow.cl
has "names it" '^contact [0-9.]+ 0\.000000 [0-9.]+, normal' out
status 1 "--explain a block that is not there" ncpost -c fanuc --explain 5000 "$golden/shapes.cl"
has "names the last" 'the last one is 1020' err

# ---- a curve or an arc that bulges beyond the travel between ends within it; poles without bound
for control in fanuc siemens heidenhain linuxcnc; do
	sed 's/26,41,1,30,40,0/26,41,9000,30,40,0/' "$golden/shapes.cl" >bulge.cl
	status 1 "a curve beyond the travel: $control" ncpost -c $control bulge.cl
	has "names the axis" 'axis Z of .*: found a position of 2[0-9]{3}\.' err
	sed 's/26,41,1,30,40,0/26,41,3000,30,40,0/' "$golden/shapes.cl" >bulge.cl
	status 0 "poles beyond it, of a curve within: $control" ncpost -c $control bulge.cl
	sed -e '/^PAINT\|^MOVNRB/d' -e '16,$d' "$golden/shapes.cl" >bulge.cl
	printf 'GOTO/0,1990,0,0,0,1\nCIRCLE/25,1990,0,0,0,-1,25\nGOTO/50,1990,0,0,0,1\nFINI\n' >>bulge.cl
	status 1 "an arc beyond the travel: $control" ncpost -c $control bulge.cl
	has "names the axis" 'axis Y of .*: found a position of 20[01][0-9]\.' err
done
sed 's/26,41,1,30,40,0/26,41,1e300,30,40,0/' "$golden/shapes.cl" >bulge.cl
status 1 "a pole without bound" ncpost -c siemens bulge.cl
has "is told" 'a pole too far for any machine' err

# ---- the self-test of every machine: the tip stays where it is
for machine in "$SRC"/machines/*.txt; do
	control=fanuc
	grep -q 'linuxcnc$' "$machine" && control=linuxcnc
	grep -q '= grbl' "$machine" && continue # too low for it
	ncpost -q -c $control -m "$machine" --self-test >self.nc 2>err || cat err
	grep -q 'THE TOOL LEANS TO' self.nc || [ "$(basename "$machine")" = three-axis.txt ] || grep -q '= three-axis' "$machine" ||
		echo "$machine: no lean"
done >bad
empty "--self-test: a program for every shipped machine" bad
ncpost -q -c fanuc --self-test >self.nc
hasnt "the tip stays" 'G1 [XY]|Z(9|10[1-9])' self.nc
awk '/LEANS TO Y-/ { getline; print }' self.nc >found
has "A 15 leans the tool to Y-" ' A15\.' found

# ---- the axis of a tool that a scan guards

awk 'BEGIN { for (i = -15; i <= 15; i++) for (j = -15; j <= 15; j++)
	printf "%.3f %.3f %.3f\n", i, j, -(i * i + j * j) / 60 }' >hill.xyz
cloud2mesh -q hill.xyz | meshnorm -q -r 3 --avoid --holder 9:60 -g hill.xyz -o hill.cl
status 0 "a holder and a large tolerance of the axis" \
	ncpost -c fanuc --axis-tolerance 0.5 --chord 0.05 -o wide.nc hill.cl
has "say that the axis stays nearer" 'axis stays within 0\.05 degrees, not 0\.5' err
ncpost -q -c fanuc --chord 0.05 -o usual.nc hill.cl
same "as it is usually" wide.nc usual.nc
cloud2mesh -q hill.xyz | meshnorm -q -r 3 --avoid --flute 5 -g hill.xyz | sed '/^..-> SCAN/d' >bare.cl
status 0 "no scan" ncpost -c fanuc --axis-tolerance 0.5 -o bare.nc bare.cl
hasnt "leaves it as it is asked for" 'axis stays' err
cloud2mesh -q hill.xyz | meshnorm -q -r 3 --avoid --flute 5 -g hill.xyz -o short.cl
ncpost -c fanuc --axis-tolerance 0.5 -o short.nc short.cl 2>err
has "and a short tool may lean more" 'axis stays within 0\.229 degrees' err

done_testing
