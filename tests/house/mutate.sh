#!/bin/sh
# mutate.sh - changes a line of src/ at random, N lines (200, or N=...), one change each, and sees
# whether a test that runs the line notices: the unit tests, the quickest first; then the jobs of
# bytes.sh that run a tool whose code is another, which say that something changed, not that it is
# wrong; then the tool tests, quickest first, as many as TOOL_SECONDS (60) hold; last, for they take
# longest, the unit tests and the quick jobs under the sanitizers.
# FOLDERS: those to take lines from (all).  SEED (1) chooses them.  JOBS: how many at a time.
# Which test runs which line is known from lines.sh; `make mutate` has it made for the unit tests and
# TOOL_TESTS, and builds all of them.  A test that fails without a change is left out.
#
#	BUILD=build sh tests/house/mutate.sh [FILE:LINE:CHANGE]...
#
# A change is one of: + for -, - for +, < for <=, <= for <, > for >=, >= for >, && for ||, || for
# &&, a term of a sum dropped, 2 for 1.  Real numbers, which < and <= tell apart only where both are
# the same to the last bit, are compared the other way round instead: > for <.
#
# Prints a line for each: caught, survived, redundant (in mutate.same, with the reason) or no
# program, the line as changed, and who caught it; at the end how many of which.  Nothing is changed
# in src/: the changed module is compiled beside it and linked before the library.
SRC=$(cd "$(dirname "$0")/../.." && pwd)
BUILD=${BUILD:-$SRC/build}
BUILD=$(cd "$BUILD" && pwd) || exit 1
MAP=$BUILD/coverage/lines
SECONDS_OF=$BUILD/coverage/seconds
CC=${CC:-cc}
FLAGS='-std=c11 -D_XOPEN_SOURCE=700 -iquote include -ffp-contract=off -pthread -O1 -w'
# a place beyond an array is seen, as make sanitize sees it
SANITIZE='-fsanitize=address,undefined -fno-sanitize-recover=all'
fenced=$BUILD/fenced.o
LC_ALL=C
export ASAN_OPTIONS=detect_leaks=0 SRC BUILD LC_ALL
cd "$SRC" || exit 1
libs="$(pkg-config --libs check) -lm -pthread"

# FILE:LINE:CHANGE, one to a line of src/ that can be changed, in an order by chance
# shellcheck disable=SC2046 # names
candidates() {
	awk -v seed="${SEED:-1}" '
	function chance() { seed = (seed * 16807) % 2147483647; return seed }
	function put(change) { made[++n] = change }
	BEGIN { for (i = 0; i < 20; i++) chance() }
	FNR == 1 { inside = 0 }
	/^[a-z].*[^;]$/ { inside = 1 }
	/^}/ { inside = 0 }
	!inside || /^[a-z#}{ ]*$/ || /^ *(\/\*|\*)/ || /"/ || /\*\// { next }
	{ n = 0 }
	/ \+ / { put("s/ + / - /"); put("s/ + [a-z0-9_.]*\\(\\[[^]]*\\]\\)*//") }
	/ - / { put("s/ - / + /") }
	/ < / { put("s/ < / <= /") }
	/ <= / { put("s/ <= / < /") }
	/ > / { put("s/ > / >= /") }
	/ >= / { put("s/ >= / > /") }
	/ && / { put("s/ && / || /") }
	/ \|\| / { put("s/ || / \\&\\& /") }
	/ 1[;) ]/ { put("s/ 1\\([;) ]\\)/ 2\\1/") }
	n { place = chance(); printf "%010d %s:%d:%s\n", place, FILENAME, FNR, made[1 + chance() % n] }
	' $(for folder in ${FOLDERS:-$(cd src && find . -type d | sed 's,^\./,,')}; do
		find "src/$folder" -maxdepth 1 -name '*.c' | sed 's,/\./,/,'
	done | sort -u) | sort | cut -d ' ' -f 2- | head -n "${N:-200}"
}

# tests of KIND (tests/unit, tests/tool) that run FILE:LINE and pass as they are, quickest
# first: SECONDS TEST
tests_of() {
	[ -d "$MAP/$1" ] || return
	grep -rlxF "$2" "$MAP/$1" | sed "s,^$MAP/,," | while read -r test; do
		[ "$(cat "$SECONDS_OF/$test.exit")" -eq 0 ] && echo "$(cat "$SECONDS_OF/$test") $test"
	done | sort -n
}

# limited SECONDS TEST: of processor time, so that what else runs here changes no verdict; in one
# process, for a loop without end in each of many would have its time in each
limited() {
	# shellcheck disable=SC3045 # every shell here has it
	(ulimit -t "$1" && CK_FORK=no exec timeout $((40 * $1)) "$2") >"$TMP/out" 2>&1 </dev/null
}

# shellcheck disable=SC2086 # compilers and flags with blanks
compiled() { # SOURCE [OPTION...]: to changed.o
	source=$1
	shift
	$CC $FLAGS "$@" -iquote "$(dirname "$file")" -c -o "$TMP/changed.o" "$source" 2>"$TMP/link"
}

# shellcheck disable=SC2086
passes() { # SECONDS TEST OBJECT [OPTION...]: with that module in place of the library's
	seconds=$1 unit=$2 object=$3
	shift 3
	[ $# -eq 0 ] || [ "$file" = src/base/array.c ] || object="$object $fenced"
	$CC "$@" -o "$TMP/unit" "$BUILD/$unit.o" $object "$BUILD"/tests/lib/*.o "$BUILD/libcloudmill.a" \
		$libs 2>"$TMP/link" && limited $((5 + 4 * ${seconds%.*})) "$TMP/unit"
}

units_notice() { # one of $TMP/units fails with the changed module
	compiled "$changed" || return 1
	while read -r seconds test <&3; do
		passes "$seconds" "$test" "$TMP/changed.o" || return 0
	done 3<"$TMP/units"
	return 1
}

# shellcheck disable=SC2086
memory_notices() { # the same under the sanitizers, and not as the module was
	compiled "$changed" $SANITIZE || return 1
	while read -r seconds test <&3; do
		passes "$seconds" "$test" "$TMP/changed.o" $SANITIZE && continue
		mv "$TMP/changed.o" "$TMP/kept.o"
		compiled "$file" $SANITIZE
		passes "$seconds" "$test" "$TMP/changed.o" $SANITIZE && { test="memory, $test" && return 0; }
		mv "$TMP/kept.o" "$TMP/changed.o"
	done 3<"$TMP/units"
	return 1
}

# shellcheck disable=SC2086
link_tools() { # FOLDER [OPTION...]: the tools with $TMP/changed.o in place of the module; 1: not all
	to=$1
	shift
	mkdir -p "$to"
	for tool in src/*.c; do
		own="$BUILD/${tool%.c}.o"
		[ "$file" != "$tool" ] || own=
		case $file in
		src/*/*) ;;
		*) [ -z "$own" ] || continue ;;
		esac
		$CC "$@" -o "$to/$(basename "$tool" .c)" $own "$TMP/changed.o" "$BUILD/libcloudmill.a" \
			-Wl,--gc-sections -lm -pthread 2>"$TMP/link" || return 1
	done
}

# Tools that the change makes no other are those of the build, beside the others, so that all look
# for their files in the same places; names of the others go to $TMP/affected.
# shellcheck disable=SC2086
make_tools() {
	compiled "$file" -ffunction-sections && link_tools "$TMP/same" || return 1
	compiled "$changed" -ffunction-sections && link_tools "$TMP/bin" || return 1
	: >"$TMP/affected"
	for tool in src/*.c; do
		tool=$(basename "$tool" .c)
		if [ -f "$TMP/bin/$tool" ] && ! cmp -s "$TMP/bin/$tool" "$TMP/same/$tool"; then
			echo "$tool" >>"$TMP/affected"
		else
			ln -f "$BUILD/bin/$tool" "$TMP/bin" 2>/dev/null || cp "$BUILD/bin/$tool" "$TMP/bin"
		fi
	done
	ln -s "$BUILD/bin/cloudmill" "$TMP/bin"
	# and those that see a place beyond an array
	cp -R "$TMP/bin" "$TMP/fenced"
	while read -r tool; do rm "$TMP/fenced/$tool"; done <"$TMP/affected"
	compiled "$changed" $SANITIZE && link_tools "$TMP/sane" $SANITIZE "$fenced" &&
		while read -r tool; do mv "$TMP/sane/$tool" "$TMP/fenced"; done <"$TMP/affected"
}

# a job of bytes.sh that runs an affected tool has other bytes, or one of $TMP/tests fails
tools_notice() {
	sort -n "$BUILD/bytes/list" | awk 'FNR == NR { affected[$1] = 1; next }
		{ for (i = 3; i <= NF; i++) if ($i in affected) { print $1, $2; next } }' "$TMP/affected" - \
		>"$TMP/jobs"
	jobs_notice "$TMP/bin" && return 0
	spent=0
	while read -r seconds test <&3; do
		spent=$((spent + ${seconds%.*}))
		[ $spent -le "${TOOL_SECONDS:-60}" ] || break
		BIN=$TMP/bin READBACK=$BUILD/tests/readback/readback CLOUD=$BUILD/tests/accuracy/cloud \
			timeout $((60 + 60 * ${seconds%.*})) sh "$test" >"$TMP/out" 2>&1 </dev/null || return 0
	done 3<"$TMP/tests"
	return 1
}

# Where places beyond an array are looked for, a job takes thirty times as long: the quickest ones,
# and not those that fail there with the module as it was.
# shellcheck disable=SC2086
fenced_notice() {
	awk '(sum += $1) < 1' "$TMP/jobs" >"$TMP/quick"
	while read -r seconds test <&3; do
		job_passes "$TMP/fenced" && continue
		if [ ! -d "$TMP/clean" ]; then
			cp -R "$TMP/fenced" "$TMP/clean"
			compiled "$file" $SANITIZE && link_tools "$TMP/sane" $SANITIZE "$fenced" || return 1
			while read -r tool; do mv "$TMP/sane/$tool" "$TMP/clean"; done <"$TMP/affected"
		fi
		job_passes "$TMP/clean" && { test="bytes, fenced/$test" && return 0; }
	done 3<"$TMP/quick"
	return 1
}

# of processor time, for others run here too
job_passes() { # FOLDER of the tools
	# shellcheck disable=SC3045 # every shell here has it
	(ulimit -t $((60 + 60 * ${seconds%.*})) &&
		BIN=$1 exec sh tests/house/bytes.sh "$BUILD/bytes" "$test")
}

jobs_notice() { # FOLDER of the tools
	while read -r seconds test <&3; do
		job_passes "$1" || { test=bytes/$test && return 0; }
	done 3<"$TMP/jobs"
	return 1
}

# is_real CHANGE: is the comparison on $line, that the change is of, one of real numbers?
# shellcheck disable=SC2086
is_real() {
	case $1 in
	's/ < '* | 's/ <= '* | 's/ > '* | 's/ >= '*) ;;
	*) return 1 ;;
	esac
	sed "${line}s/ [<>]=* / == /" "$file" >"$TMP/probe.c"
	$CC ${FLAGS% -w} -Wfloat-equal -iquote "$(dirname "$file")" -fsyntax-only "$TMP/probe.c" 2>&1 |
		grep -q "^$TMP/probe.c:$line:.*float-equal"
}

one() { # FILE LINE CHANGE: the verdict
	file=$1 line=$2 change=$3 by=
	changed=$TMP/$(basename "$file")
	if is_real "$change"; then
		case $change in
		's/ <'*) change='s/ <=* / > /' ;;
		*) change='s/ >=* / < /' ;;
		esac
	fi
	sed "${line}$change" "$file" >"$changed"
	text=$(sed -n "${line}s/^[ 	]*//p" "$changed")
	# a statement may stand on several lines, of which one is counted
	counted=$(awk -F: -v f="$file" -v l="$line" '$1 == f && $2 <= l && $2 > b { b = $2 }
		END { print b }' "$MAP/all")
	tests_of tests/unit "$file:$counted" >"$TMP/units"
	tests_of tests/tool "$file:$counted" >"$TMP/tests"
	# shellcheck disable=SC2086
	if cmp -s "$file" "$changed"; then
		verdict='no change'
	elif awk -F'\t' -v f="$file" -v t="$text" '$1 == f && $2 == t { found = 1 } END { exit !found }' \
		tests/house/mutate.same; then
		verdict=redundant
	elif ! compiled "$changed"; then
		verdict='no program'
	elif units_notice || { test='no link' && ! make_tools; } || tools_notice || memory_notices ||
		fenced_notice; then
		verdict=caught by=" ($test)"
	else
		verdict=survived
	fi
	echo "$verdict: $file:$line: $text$by"
}

TMP=$(mktemp -d "${TMPDIR:-/tmp}/cloudmill.XXXXXX") || exit 1
export TMP
trap 'rm -rf "$TMP"' EXIT
trap 'exit 130' INT TERM
if [ "${1:-}" = --one ]; then
	IFS=: read -r file line change <<-END
		$2
	END
	one "$file" "$line" "$change"
	exit 0
fi
# shellcheck disable=SC2086
$CC $FLAGS $SANITIZE -DARRAY_FENCE -c -o "$fenced" src/base/array.c || exit 1
[ -n "$(find "$BUILD/bytes/made" -newer "$BUILD/bin/ncpost" 2>/dev/null)" ] ||
	BIN=$BUILD/bin sh tests/house/bytes.sh --make "$BUILD/bytes"
if [ $# -gt 0 ]; then printf '%s\n' "$@"; else candidates; fi >"$TMP/candidates"
tr '\n' '\0' <"$TMP/candidates" |
	xargs -0 -P "${JOBS:-$(getconf _NPROCESSORS_ONLN)}" -n 1 sh "$0" --one 2>"$TMP/err" |
	tee "$TMP/results"
awk -F: '{ n[$1]++ }
	$1 == "caught" {
		by[/\(memory/ ? "unit tests under the sanitizers" : /\(tests\/unit/ ? "unit tests" : /\(bytes/ ? "other bytes" : "tool tests"]++
	}
	END { for (v in n) printf "%d %s\n", n[v], v
	for (b in by) printf "%d caught by %s\n", by[b], b
	all = n["caught"] + n["survived"]
	if (all) printf "%.0f %% caught\n", 100 * n["caught"] / all }' "$TMP/results"
