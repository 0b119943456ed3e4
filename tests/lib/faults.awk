# faults.awk - a program with one fault in it.
#
#	awk -v kind=KIND -v seed=N -v control=C -v named=FILE -f faults.awk PROGRAM
#
# C: fanuc, siemens, heidenhain, linuxcnc.  The block is drawn by the seed among those that can have
# the fault; its number, and those of the blocks that may be named for it, go to FILE as one regular
# expression.  Exit 4: no block of this program can have it.  Blocks are numbered anew.
#
# KIND: rapid (G0 for G1), plunge (down to the part at rapid), approach (its blocks are missing),
# retract (the last one is missing), no-offset, offset, edge (D0), length (H2), tool (T2), coolant
# (off amid), dry (never on), fast, slow (F ten times, a thousandth), ORIMKS, ORICURVE (its word is
# lost), poly (all coefficients 1 % off;
# the block where it matters most), axis (5 degrees off), sign (of a rotary word), digit (1 mm off)

function draw(n) { # 1 to n
	state = (state * 16807) % 2147483647
	return 1 + int(state / 2147483647 * n)
}

# The value of a word by its letters, "" without; its place is RSTART, RLENGTH.
function word(text, name) {
	if (!match(text, " " name "[-+]?[0-9.]+"))
		return ""
	RSTART += 1 + length(name)
	RLENGTH -= 1 + length(name)
	return substr(text, RSTART, RLENGTH)
}

function number(v, digits,   s) {
	s = sprintf("%." digits "f", v)
	return control == "heidenhain" && s !~ /^-/ ? "+" s : s
}

function set(text, name, v, digits) {
	if (word(text, name) == "")
		return text
	return substr(text, 1, RSTART - 1) number(v, digits) substr(text, RSTART + RLENGTH)
}

# What a line does: kind of motion, so far as the faults need it.
function look(i,   t) {
	t = line[i]
	block[i] = control == "heidenhain" ? t ~ /^[0-9]+ / : t ~ /^N[0-9]+ /
	at[i] = "" # no motion
	if (!block[i] || t ~ / ;|M91|G53|SUPA|G28|CALL|RESET/)
		return
	if (control == "heidenhain") {
		if (t ~ / (L|LN) /)
			at[i] = t ~ /FMAX/ ? "rapid" : "feed"
	} else {
		if (t ~ / G0?0( |$)/) modal = "rapid"
		if (t ~ / G0?1( |$)/) modal = "feed"
		if (t ~ / (G0?[23]|G0?6\.2|G5\.2|CIP|BSPLINE|POLY)( |$)/) modal = "curve"
		if (t ~ / (X[-0-9.]|Y[-0-9.]|Z[-0-9.]|PO\[)/)
			at[i] = modal
	}
	if (at[i] != "") {
		way[i] = way_of(t)
		before[i] = last
		if (last) after[last] = i
		last = i
	}
}

function cuts(i) { return at[i] == "feed" || at[i] == "curve" }

# Amid a pass: those around it cut too.
function amid(i) {
	return cuts(i) && cuts(before[i]) && cuts(after[i]) && cuts(before[before[i]]) &&
		cuts(after[after[i]])
}

function turns(i,   k, v) {
	for (k = 1; k <= axes; k++) {
		v = word(line[i], axis[k])
		if (v != "" && (v < 0 ? -v : +v) > least)
			return axis[k]
	}
	return ""
}

# Beside the pole another angle is hardly another axis.
function leans(t,   a, b) {
	a = word(t, "A") + 0; b = word(t, "B") + 0
	return a > least || a < -least || b > least || b < -least
}

# At the pole C turns as far as it likes within no way at all: how slow F may be there nobody can say.
function is_at_pole(t,   dx, dy, dz) {
	if (t ~ /C3=/)
		return word(t, "C3=") > 0.99999
	if (t ~ / XH=/) {
		dx = word(t, "XH=") - word(t, "X"); dy = word(t, "YH=") - word(t, "Y"); dz = word(t, "ZH=") - word(t, "Z")
		return dz > 0.99999 * sqrt(dx * dx + dy * dy + dz * dz)
	}
	return word(t, "C") != "" && (word(t, "A") != "" || word(t, "B") != "") && !tilts(t)
}

function tilts(t,   a, b) {
	a = word(t, "A") + 0; b = word(t, "B") + 0
	return a > 0.5 || a < -0.5 || b > 0.5 || b < -0.5
}

# How far a block goes: an F that holds for a hundredth of a micron is no fault.
function way_of(t,   k, v, way) {
	way = t ~ /PO\[/
	for (k = 1; k <= 3; k++) {
		v = word(t, substr("XYZ", k, 1))
		if (v == "")
			continue
		way += v > was[k] ? v - was[k] : was[k] - v
		was[k] = v
	}
	return way
}

function fits(i,   t) {
	t = line[i]
	if (kind == "rapid") return at[i] == "feed" && amid(i) && at[after[i]] == "feed" && t ~ / [XYZ]/
	if (kind == "plunge" || kind == "approach")
		return at[i] == "feed" && at[before[i]] == "rapid" && i in after
	if (kind == "retract") return i == lastcut
	if (kind ~ /^(offset|edge|length|tool|coolant)$/) return amid(i) && at[i] == "feed" && t ~ / [XYZ]/
	if (kind == "slow" && (is_at_pole(t) || is_at_pole(line[before[i]]))) return 0
	# beside it a block is slow already, and a thousandth of the path's feed none of its own
	if (kind == "slow" && word(t, "F") < feed / 10) return 0
	if (kind ~ /^(fast|slow)$/) return way[i] > 0.001 && cuts(i) && cuts(before[i]) && word(t, "F") != "" && t ~ / [XYZ]/
	if (kind == "ORIMKS") return t ~ /ORIWKS/
	if (kind == "no-offset") return t ~ / G54( |$)/
	if (kind == "dry") return t ~ / M8( |$)/
	if (kind == "ORICURVE") return t ~ /ORICURVE/
	if (kind == "poly") return bent(t) > 0.0015 && bent(t) == most_bent
	if (kind == "axis") return amid(i) && turns(i) != "" && (control == "siemens" ? t ~ /C3=/ : leans(t))
	if (kind == "sign") return amid(i) && turns(i) != ""
	if (kind == "digit") return amid(i) && t ~ / [XYZ][-+0-9.]/
	return 0
}

function cross_turn(t, degrees,   x, y, z, ux, uy, uz, l, c, s) { # a vector turned about x
	x = word(t, "A3="); y = word(t, "B3="); z = word(t, "C3=")
	c = cos(degrees / 57.29577951308232); s = sin(degrees / 57.29577951308232)
	t = set(t, "B3=", c * y - s * z, 8)
	return set(t, "C3=", s * y + c * z, 8)
}

function as_rapid(i,   t, j) {
	t = line[i]
	j = after[i]
	sub(/ F[0-9.]+/, "", t)
	if (control == "heidenhain")
		line[i] = t " FMAX"
	else {
		sub(/ G0?1( |$)/, " ", t)
		sub(/^N[0-9]+/, "& G0", t)
		line[i] = t
		if (line[j] !~ / (G0?[0-3]|G0?6\.2|CIP|BSPLINE|POLY)( |$)/)
			sub(/^N[0-9]+/, "& G1", line[j])
	}
	if (line[j] !~ / F[0-9M]/) # the feed that it took along
		line[j] = line[j] " F800" (control == "fanuc" || control == "linuxcnc" ? "." : "")
}

function digits_of(i, name,   v) {
	v = word(line[i], name)
	sub(/^[^.]*\.?/, "", v)
	return length(v)
}

function grown(t,   out, v) { # coefficients, 1 % more
	while (match(t, /,-?[0-9.]+[,)]/)) {
		v = substr(t, RSTART + 1, RLENGTH - 2)
		out = out substr(t, 1, RSTART) sprintf("%.6f", v * 1.01)
		t = substr(t, RSTART + RLENGTH - 1)
	}
	return out t
}

# How far coefficients 1 % larger take a polynomial of the tip off rows along x, mm: its end stays.
function bent(t,   k, c, n, l, p, d, most, name) {
	l = match(t, / PL=[0-9.]+/) ? substr(t, RSTART + 4, RLENGTH - 4) : 1
	for (k = 1; k <= 2; k++) {
		name = "PO[" substr("YZ", k, 1) "]=("
		if (!index(t, name))
			continue
		n = split(substr(t, index(t, name) + length(name)), c, /[,)]/)
		for (p = l / 8; p < l; p += l / 8) {
			d = 0.01 * (c[2] * (p ^ 2 - p * l) + c[3] * (p ^ 3 - p * l * l))
			if (d < 0) d = -d
			if (d > most) most = d
		}
	}
	return most
}

# An approach, from the end of the cut or the start of the program on: the blocks of rapid moves
# along and down are gone, too; the clearance plane stays.
function drop_approach(i,   j, t) {
	j = after[i]
	if (line[j] !~ / (G0?[0-3]|G0?6\.2|CIP|BSPLINE|POLY)( |$)/ && control != "heidenhain")
		sub(/^N[0-9]+/, "& G1", line[j])
	if (line[j] !~ / F[0-9M]/)
		line[j] = line[j] " F800" (control == "fanuc" || control == "linuxcnc" ? "." : "")
	gone[i] = 1
	if (at[before[i]] == "rapid" && line[before[i]] ~ / Z/ && before[i] in before)
		gone[before[i]] = 1
}

# From the last cut to where the compensation ends: nothing moves.
function drop_retract(i,   j) {
	for (j = i; j; j = after[j])
		gone[j] = 1
}

function change(i,   name, names, n, t, j) {
	t = line[i]
	if (kind == "rapid" || kind == "plunge") as_rapid(i)
	else if (kind == "approach") drop_approach(i)
	else if (kind == "retract") drop_retract(i)
	else if (kind == "offset") put[i] = control == "heidenhain" ? "CYCL DEF 247 Q339=+2" : "G55"
	else if (kind == "edge") put[i] = "D0"
	else if (kind == "length") put[i] = control == "linuxcnc" ? "G43 H2" : "H2"
	else if (kind == "tool") put[i] = control == "heidenhain" ? "TOOL CALL 2 Z S8000" : "T2"
	else if (kind == "coolant") put[i] = "M9"
	else if (kind == "fast") line[i] = set(t, "F", 10 * feed, 2)
	else if (kind == "slow") line[i] = set(t, "F", feed / 1000, 4)
	else if (kind == "ORIMKS") sub(/ORIWKS/, "ORIMKS", line[i])
	else if (kind == "no-offset") {
		for (j = 1; j <= n_lines; j++)
			if (line[j] ~ /^N[0-9]+ G54 *$/) gone[j] = 1; else sub(/ G54( |$)/, " ", line[j])
	} else if (kind == "dry") sub(/ M8( |$)/, " M9 ", line[i])
	else if (kind == "ORICURVE") sub(/ ORICURVE/, "", line[i])
	else if (kind == "poly") {
		for (j = 1; j <= n_lines; j++)
			if (line[j] ~ /PO\[/) line[j] = grown(line[j])
	}
	else if (kind == "axis") {
		name = turns(i)
		line[i] = control == "siemens" ? cross_turn(t, 5) : set(t, name, word(t, name) + 5, 3)
	} else if (kind == "sign") {
		name = turns(i)
		line[i] = set(t, name, -word(t, name), digits_of(i, name))
	} else if (kind == "digit") {
		for (j = 1; j <= 3; j++) {
			name = substr("XYZ", j, 1)
			if (word(t, name) != "") names[++n] = name
		}
		name = names[draw(n)]
		line[i] = set(t, name, word(t, name) + (draw(2) == 1 ? 1 : -1), digits_of(i, name))
	}
	sub(/ F\+/, " F", line[i])
}

{ line[NR] = $0 }

END {
	n_lines = NR
	state = (seed * 7919 + 12345) % 2147483647
	for (i = 0; i < 20; i++)
		draw(2)
	axes = split(control == "siemens" ? "A3= B3=" : "A B C", axis, " ")
	least = control == "siemens" ? 0.05 : 3
	for (i = 1; i <= NR; i++)
		look(i)
	for (i = 1; i <= NR; i++)
		if (at[i] == "feed" && cuts(before[i]) && !cuts(after[i]))
			lastcut = i
	for (i = 1; i <= NR; i++)
		if (cuts(i) && word(line[i], "F") + 0 > feed)
			feed = word(line[i], "F") + 0
	for (i = 1; i <= NR; i++)
		if (kind == "poly" && bent(line[i]) > most_bent)
			most_bent = bent(line[i])
	for (i = 1; i <= NR; i++)
		if (fits(i))
			may[++count] = i
	if (!count)
		exit 4
	pick = may[kind ~ /^(retract|ORIMKS|no-offset|dry)$/ ? count : draw(count)]
	stands = kind == "axis" || kind == "sign" ? turns(pick) : "" # a word that holds until the next
	change(pick)
	k = 0
	# numbers anew; those of motions from two before the fault to two after it may be named
	if (kind == "no-offset" || kind == "dry") # told where cutting begins
		for (from = pick; from < NR && !cuts(from); from++) ;
	else
		from = pick
	to = from + reach
	for (i = pick + 1; stands != "" && i <= NR && word(line[i], stands) == ""; i++)
		to = i > to ? i : to
	for (i = 1; i <= NR; i++) {
		t = line[i]
		if (gone[i])
			continue
		near = (i >= from - reach && i <= to)
		if (kind == "poly") # all of them have it
			near = near || t ~ /PO\[/
		if (control == "heidenhain") {
			if (i in put) { print k " " put[i]; list = list "|" k++ }
			sub(/^[0-9]+/, k, t)
			if (near) list = list "|" k
			k++
		} else if (block[i]) {
			if (i in put) { k += 10; print "N" k " " put[i]; list = list "|N" k }
			k += 10
			sub(/^N[0-9]+/, "N" k, t)
			if (near) list = list "|N" k
		}
		print t
	}
	print "(" substr(list, 2) ")" >named
}
