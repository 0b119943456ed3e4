#!/bin/sh
# options.sh - every option of every tool, from their own --help all, as the table of cloudmill(7):
# one row for each name, its letter, and the tools that have it.  With --write MAN the table
# in that page is replaced; man.t compares it.
set -eu
BIN=${BIN:-$(dirname "$0")/../../build/bin}
LC_ALL=C
export LC_ALL

table() {
	for tool in "$BIN"/*; do
		head -c 2 "$tool" | grep -q '^#!' && continue # a script has no table of options
		"$tool" --help all | sed -nE "s/^  (-([a-zA-Z]), |    )--([a-z0-9-]+).*/\3 \2 ${tool##*/}/p"
	done | awk '
	{ seen[$NF]++; name = $1; tool = $NF; letter[name] = NF > 2 ? $2 : letter[name]; count[name]++
	  tools[name] = tools[name] (tools[name] ? " , Nm " : "") tool }
	END { for (t in seen) all++
	for (name in tools) {
		head = letter[name] ? "-" name " Ta Fl " letter[name] : "-" name " Ta"
		if (count[name] == all) tools[name] = "all"
		else tools[name] = "Nm " tools[name]
		print ".It Fl " head " Ta " tools[name] } }' | sort -f
}

case ${1:-} in
--write)
	table >"$2.rows"
	awk -v rows="$2.rows" '
	/^\.\\" end of options$/ { on = 0 }
	!on { print }
	/^\.\\" options$/ { on = 1; while ((getline line <rows) > 0) print line }' "$2" >"$2.new"
	mv "$2.new" "$2"
	rm "$2.rows"
	;;
*) table ;;
esac
