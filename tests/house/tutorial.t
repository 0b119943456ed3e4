#!/bin/sh
# tutorial.t - the tutorial of cloudmill(7) as a reader types it: each command, taken from the page, one
# after the other in one folder, ends as the page says, and prints the lines that the page shows;
# numbers may be others.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"

# The page's commands and what they are to print: `STATUS<tab>command`, or `-<tab>line`
awk '/^\.Sh / { on = $2 == "TUTORIAL" }
	!on { next }
	/^\.\\" exit / { status = $3 }
	/^\.Bd -literal/ { inside = 1; next }
	/^\.Ed/ { inside = status = 0; next }
	!inside { next }
	{ gsub(/\\e/, "\\"); gsub(/\\&/, ""); gsub(/\\-/, "-") }
	/^\$ / { command = substr($0, 3) }
	!/^\$ / && command == "" { print "-\t" $0; next }
	!/^\$ / { command = command " " $0 }
	command ~ /\\$/ { sub(/ *\\$/, "", command); next }
	{ gsub(/  +/, " ", command); print status + 0 "\t" command; command = "" }' "$SRC/man/cloudmill.7" >"$TMP/steps"
below "commands in the tutorial" 10 "$(grep -c '^[0-9]' "$TMP/steps")"
below "and lines of their messages" 12 "$(grep -vc '^[0-9]' "$TMP/steps")"

plain() { # without numbers and breaks: FILE
	sed -E -e 's/-?[0-9]+(\.[0-9]+)?/N/g' -e 's/[ \t]+/ /g' "$1"
}

mkdir "$TMP/root"
ln -s "$SRC/samples" "$SRC/machines" "$TMP/root"
cd "$TMP/root" || exit 1
while IFS='	' read -r status text; do
	if [ "$status" != - ]; then
		run sh -c "$text"
		[ "$got" -eq "$status" ]
		result $? "exit $status: $text"
		cat "$TMP/out" "$TMP/err" >"$TMP/printed"
		plain "$TMP/printed" >"$TMP/found"
	else
		printf '%s\n' "$text" >"$TMP/line"
		grep -qF -e "$(plain "$TMP/line")" "$TMP/found"
		result $? "prints: $text"
	fi
done <"$TMP/steps"
done_testing
