#!/bin/sh
# bad.t - bad machine files and bad CL files, the pages in bad/: each is refused with one line that
# says where, what was found and what was expected, and nothing is written.
. "${SRC:-$(dirname "$0")/..}/tests/lib.sh"
cd "$TMP" || exit 1

# The cases of a page into files, their names into a list
pages() { # KIND
	awk -v kind="$1" '
		/^== / { file = sprintf("%s-%03d", kind, ++n); print file "\t" substr($0, 4) >(kind ".list")
			printf "" >file; next }
		{ print >file }' "$SRC/tests/bad/$1.txt"
}
pages machines
pages paths
printf 'GOTO/0,0,9\nFINI\n' >good.cl
printf 'GOTO/0,0,9\nGOTO/\000\001\002\nFINI\n' >paths-900
printf 'paths-900\tbytes of no text\n' >>paths.list
head -c 3000 "$BIN/ncpost" >paths-901
printf 'paths-901\ta program of the machine\n' >>paths.list
printf 'name = A\n\000\001\n' >machines-900
printf 'machines-900\tbytes of no text\n' >>machines.list
{ printf 'GOTO/'; head -c 300000 /dev/zero | tr '\000' 9; printf ',0,0\nFINI\n'; } >paths-902
printf 'paths-902\ta number of 300000 digits\n' >>paths.list

refused() { # NAME PLACE COMMAND...
	name=$1
	place=$2
	shift 2
	run "$@"
	[ "$got" -eq 1 ] || echo "$name: exit $got"
	[ ! -s out ] || echo "$name: something was written"
	[ "$(wc -l <err)" -eq 1 ] || echo "$name: more or less than one line: $(head -c 300 err)"
	grep -Eq "^ncpost: $place.*(found|cannot open|ends ).*" err || echo "$name: $(head -c 200 err)"
	[ "$(wc -c <err)" -le 420 ] || echo "$name: a very long line"
}
while IFS='	' read -r file name; do
	cp "$file" bad.txt
	refused "$name" '[./]*bad\.txt:[1-9][0-9]*: ' ncpost -q -c fanuc -m ./bad.txt good.cl
done <machines.list >complaints
empty "machine files: $(wc -l <machines.list), each refused in its line" complaints
while IFS='	' read -r file name; do
	cp "$file" bad.cl
	refused "$name" 'bad\.cl:([1-9][0-9]*:)? ' ncpost -q -c fanuc bad.cl
done <paths.list >complaints
empty "CL files: $(wc -l <paths.list), each refused in its line" complaints
while IFS='	' read -r file name; do
	cp "$file" bad.cl
	refused "$name" 'bad\.cl:([1-9][0-9]*:)? ' ncpost -q -c siemens -o part.mpf bad.cl
	[ ! -e part.mpf ] || echo "$name: left a file"
done <paths.list >complaints
empty "nor is a file left" complaints
below "cases on both pages" 100 "$(cat machines.list paths.list | wc -l)"

done_testing
