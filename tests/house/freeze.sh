#!/bin/sh
# freeze.sh - does every tool still write what it wrote, to the byte?  Runs the jobs of jobs.sh: all
# tools, options, controls and machines, over the samples and over the shapes of inputs.sh, each
# tool with 1 and with 8 threads; keeps of each a line in freeze.sums:
#
#	hash of what it wrote   exit status   name
#
#	BIN=build/bin sh tests/house/freeze.sh [--write] [--only REGEX] [--keep DIR]
#
#	--write       make freeze.sums anew (with --only: these lines of it)
#	--only REGEX  jobs whose names match, and what they are made from
#	--keep DIR    leave what they wrote in DIR/out, and what they said in DIR/log
#
# Prints the lines that differ, - as they were and + as they are, and what it took; exit 1 when any
# differ.  Messages on standard error do not count, the exit status does (124: stopped after ten
# minutes).  What it takes of the project besides the tools: samples/, machines/, and the folders that
# jobs.sh calls awkward and foreign.
here=$(cd "$(dirname "$0")" && pwd)
SRC=$(cd "${SRC:-$here/../..}" && pwd)
BIN=$(cd "${BIN:-$SRC/build/bin}" && pwd) || exit 1
PATH=$BIN:$PATH
CLOUDMILL_MACHINES=$SRC/machines
LC_ALL=C
export SRC BIN PATH CLOUDMILL_MACHINES LC_ALL
# shellcheck source=tests/house/inputs.sh
. "$here/inputs.sh"
# shellcheck source=tests/house/jobs.sh
. "$here/jobs.sh"

if [ "${1:-}" = --job ]; then # --job FOLDER NAME: runs it; its exit status is kept, this one's is 0
	cd "$2/out" || exit 1
	command=$(awk -v name="$3" '$1 == name { sub(/^[^ ]+ +/, ""); print; exit }' ../jobs)
	: >"$3"
	echo 124 >"../log/$3.exit" # when it is stopped
	(eval "$command") >"../new/$3" 2>"../log/$3.err" </dev/null
	echo $? >"../log/$3.exit"
	mv "../new/$3" "$3"
	times >"../log/$3.times" # of this shell, and of what it ran
	exit 0
fi

write=no
only=.
keep=
while [ $# -gt 0 ]; do
	case $1 in
	--write) write=yes ;;
	--only) only=$2 && shift ;;
	--keep) keep=$2 && shift ;;
	*) sed -n '2,/^[^#]/s/^# \{0,1\}//p' "$0" >&2 && exit 2 ;;
	esac
	shift
done
if [ -n "$keep" ]; then
	mkdir -p "$keep" && tmp=$(cd "$keep" && pwd) || exit 1
	rm -rf "$tmp/out" "$tmp/new" "$tmp/log"
else
	tmp=$(mktemp -d "${TMPDIR:-/tmp}/cloudmill.XXXXXX") || exit 1
	trap 'rm -rf "$tmp"' EXIT
	trap 'exit 130' INT TERM
fi
mkdir "$tmp/out" "$tmp/new" "$tmp/log" || exit 1

# The jobs, and which need which: a name of one in the command of another.  Make runs them in order.
jobs | sed '/^ *$/d; /^ *#/d' >"$tmp/jobs"
cut -d ' ' -f 1 "$tmp/jobs" | sort | uniq -d | sed 's/^/two jobs called /' >&2
awk -v run="sh '$here/freeze.sh' --job '$tmp'" '
	NR == FNR { name[$1]; next }
	{
		needs = ""
		line = $0
		gsub(/[][<>|;&()"=]/, " ", line)
		n = split(line, word, " ")
		for (i = 2; i <= n; i++) if (word[i] in name) needs = needs " " word[i]
		printf "%s:%s\n\t@timeout 600 %s %s || :\n", $1, needs, run, $1
	}' "$tmp/jobs" "$tmp/jobs" >"$tmp/jobs.mk"
export only
awk '$1 ~ ENVIRON["only"] { print $1 }' "$tmp/jobs" | sort >"$tmp/names"
[ -s "$tmp/names" ] || { echo "freeze.sh: no job matches $only" >&2 && exit 2; }
for tool in "$BIN"/*; do
	head -c 2 "$tool" | grep -q "^#!" && continue # a script of the others
	grep -q -w "$(basename "$tool")" "$tmp/jobs" || echo "freeze.sh: no job runs $(basename "$tool")" >&2
done
unset MAKEFLAGS MFLAGS
(cd "$tmp/out" && xargs make -s -k -f "$tmp/jobs.mk" \
	-j "$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 1)" <"$tmp/names") || exit 1

while read -r name; do
	printf '%s %3d %s\n' "$(sha256sum <"$tmp/out/$name" | cut -c 1-16)" "$(cat "$tmp/log/$name.exit")" "$name"
done <"$tmp/names" | sort -k 3 >"$tmp/sums"
cat "$tmp"/log/*.times | awk '{ for (i = 1; i <= 2; i++) { split($i, t, "m"); seconds += t[1] * 60 + t[2] } }
	END { printf "%d jobs, %.0f seconds of processor\n", NR / 2, seconds }'

[ -e "$here/freeze.sums" ] || : >"$here/freeze.sums"
awk '$3 ~ ENVIRON["only"]' "$here/freeze.sums" >"$tmp/before"
if [ $write = yes ]; then
	awk '$3 !~ ENVIRON["only"]' "$here/freeze.sums" | sort -k 3 - "$tmp/sums" >"$tmp/all"
	cp "$tmp/all" "$here/freeze.sums"
	exit
fi
diff "$tmp/before" "$tmp/sums" | sed -n 's/^</-/p; s/^>/+/p' >"$tmp/differ"
cat "$tmp/differ"
[ ! -s "$tmp/differ" ]
