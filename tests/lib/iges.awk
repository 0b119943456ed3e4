# iges.awk - an IGES file from lines `NAME TYPE FORM PARAMETERS`, where {NAME} in the parameters of an
# entity is the pointer to another, and a form FORM@NAME names the transformation (124) of the entity; -v unit=1 for inches (default 2, mm), -v global=TEXT for another
# global section.
NF >= 4 && $1 !~ /^#/ {
	n++
	number[$1] = 2 * n - 1
	type[n] = $2
	form[n] = $3 + 0
	matrix[n] = index($3, "@") ? substr($3, index($3, "@") + 1) : ""
	text[n] = $4
}
function record(line, letter, count) { printf "%-72s%s%7d\n", line, letter, count }
END {
	if (unit == "") unit = 2
	if (global == "")
		global = "1H,,1H;,5Hmodel,5Hmodel,4Htest,1H1,32,38,6,308,15,5Hmodel,1.," unit "," \
			(unit == 1 ? "4HINCH" : "2HMM") ",1,0.01,13H261121.101010,1E-6,0.,,,11,0;"
	record("made by iges.awk", "S", 1)
	for (i = 1; global != ""; i++) { record(substr(global, 1, 72), "G", i); global = substr(global, 73) }
	globals = i - 1
	for (i = 1; i <= n; i++) {
		p = type[i] "," text[i] ";"
		while (match(p, /{[^}]*}/)) {
			name = substr(p, RSTART + 1, RLENGTH - 2)
			p = substr(p, 1, RSTART - 1) number[name] substr(p, RSTART + RLENGTH)
		}
		first = lines + 1
		while (p != "") { # lines end at a comma
			cut = length(p)
			if (cut > 64) for (cut = 64; substr(p, cut, 1) != ","; cut--) ;
			out[++lines] = sprintf("%-64s%8d", substr(p, 1, cut), 2 * i - 1)
			p = substr(p, cut + 1)
		}
		record(sprintf("%8d%8d%8d%8d%8d%8d%8d%8d%8s", type[i], first, 0, 0, 0, 0, matrix[i] == "" ? 0 : number[matrix[i]], 0, "00000000"), "D", 2 * i - 1)
		record(sprintf("%8d%8d%8d%8d%8d%16s%8s%8d", type[i], 0, 0, lines - first + 1, form[i], "", "", 0), "D", 2 * i)
	}
	for (i = 1; i <= lines; i++) record(out[i], "P", i)
	record(sprintf("S%7dG%7dD%7dP%7d", 1, globals, 2 * n, lines), "T", 1)
}
