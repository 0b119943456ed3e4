#!/bin/sh
# mutate.sh - changes a line of src/ at random, N times (200, or N=...), and sees whether a test
# notices: the unit tests of the module, those that include its header, those of its folder; then the
# tool tests of TOOL_TESTS (none), as `tool/ncpost-forms.t`.  FOLDERS: those to take lines from (all).
# SEED (1) chooses them.  Run by `make mutate`, which builds all of them.  A test that fails without
# a change, or takes more than 20 s of processor time, is left out.
#
# A change is one of: + for -, - for +, < for <=, <= for <, > for >=, >= for >, && for ||, || for &&,
# a term of a sum dropped, 2 for 1.  Prints a line for each: caught, survived or no program, then
# the line as changed; at the end how many of which.  Nothing is changed in src/: the changed module
# is compiled beside it and linked before the library.
SRC=$(cd "$(dirname "$0")/../.." && pwd)
BUILD=${BUILD:-$SRC/build}
CC=${CC:-cc}
FLAGS='-std=c11 -D_XOPEN_SOURCE=700 -iquote include -ffp-contract=off -pthread -O1 -w'
# a place beyond an array is seen, as make sanitize sees it
SANITIZE=${SANITIZE--fsanitize=address,undefined -fno-sanitize-recover=all}
export ASAN_OPTIONS=detect_leaks=0
TMP=$(mktemp -d "${TMPDIR:-/tmp}/cloudmill.XXXXXX") || exit 1
trap 'rm -rf "$TMP"' EXIT
trap 'exit 130' INT TERM
cd "$SRC" || exit 1
libs="$(pkg-config --libs check) -lm -pthread"

# FILE:LINE:CHANGE of all changes that can be made, one to a line, in an order by chance
# shellcheck disable=SC2046 # names
candidates() {
	awk -v seed="${SEED:-1}" '
	function chance() { seed = (seed * 16807) % 2147483647; return seed }
	function put(change) { printf "%010d %s:%d:%s\n", chance(), FILENAME, FNR, change }
	BEGIN { for (i = 0; i < 20; i++) chance() }
	FNR == 1 { inside = 0 }
	/^[a-z].*[^;]$/ { inside = 1 }
	/^}/ { inside = 0 }
	!inside || /^[a-z#}{ ]*$/ || /^ *(\/\*|\*)/ || /"/ || /\*\// { next }
	/ \+ / { put("s/ + / - /"); put("s/ + [a-z0-9_.]*\\(\\[[^]]*\\]\\)*//") }
	/ - / { put("s/ - / + /") }
	/ < / { put("s/ < / <= /") }
	/ <= / { put("s/ <= / < /") }
	/ > / { put("s/ > / >= /") }
	/ >= / { put("s/ >= / > /") }
	/ && / { put("s/ && / || /") }
	/ \|\| / { put("s/ || / \\&\\& /") }
	/ 1[;) ]/ { put("s/ 1\\([;) ]\\)/ 2\\1/") }
	' $(for folder in ${FOLDERS:-$(cd src && find . -mindepth 1 -type d | sed 's,^\./,,')}; do
		find "src/$folder" -maxdepth 1 -name '*.c'
	done | sort -u) | sort | cut -d ' ' -f 2- | head -n "${N:-200}"
}

# tests that touch FILE: check_MODULE, those that include its header, those of its folder
tests_of() {
	module=$(basename "$1" .c)
	folder=$(dirname "${1#src/}")
	find tests/unit -name "check_$module.c"
	grep -rlE "\"([a-z/]*/)?$module\.h\"" tests/unit --include='*.c'
	find "tests/unit/$folder" -maxdepth 1 -name 'check_*.c' 2>/dev/null
}

# limited SECONDS TEST: of processor time, so that what else runs here changes no verdict; in one
# process, for a loop without end in each of many would have its time in each
limited() {
	# shellcheck disable=SC3045 # every shell here has it
	(ulimit -t "$1" && CK_FORK=no exec timeout $((20 * $1)) "$2") >"$TMP/out" 2>&1 </dev/null
}

# TEST passes as it is, in a third of the time that it gets with a change
sound() {
	mark=$TMP/sound/$(echo "$1" | tr / -)
	if [ ! -f "$mark" ]; then
		mkdir -p "$TMP/sound"
		limited 20 "$BUILD/${1%.c}"
		echo $? >"$mark"
	fi
	[ "$(cat "$mark")" -eq 0 ]
}

# shellcheck disable=SC2086 # compilers and flags with blanks
caught() { # FILE, whose changed object is changed.o: a test fails
	for test in $(tests_of "$1" | awk '!seen[$0]++'); do
		[ -f "$BUILD/${test%.c}.o" ] && sound "$test" || continue
		$CC $SANITIZE -o "$TMP/unit" "$BUILD/${test%.c}.o" "$TMP/changed.o" "$BUILD"/tests/lib/*.o \
			"$BUILD/libcloudmill.a" $libs 2>"$TMP/link" || return 0
		limited 60 "$TMP/unit" || return 0
	done
	[ -n "$TOOL_TESTS" ] || return 1
	mkdir -p "$TMP/bin"
	for tool in src/*.c; do
		tool=$(basename "$tool" .c)
		$CC $SANITIZE -o "$TMP/bin/$tool" "$BUILD/src/$tool.o" "$TMP/changed.o" "$BUILD/libcloudmill.a" $libs \
			2>"$TMP/link" || return 0
	done
	for test in $TOOL_TESTS; do
		SRC=$SRC BIN=$TMP/bin timeout 300 sh "tests/$test" >"$TMP/out" 2>&1 || return 0
	done
	return 1
}

candidates >"$TMP/candidates"
while IFS=: read -r file line change <&3; do
	changed=$TMP/$(basename "$file")
	sed "${line}$change" "$file" >"$changed"
	# shellcheck disable=SC2086
	if cmp -s "$file" "$changed"; then
		verdict='no change'
	elif ! $CC $FLAGS $SANITIZE -iquote "$(dirname "$file")" -c -o "$TMP/changed.o" "$changed" 2>"$TMP/link"; then
		verdict='no program'
	elif caught "$file"; then
		verdict=caught
	else
		verdict=survived
	fi
	echo "$verdict: $file:$line: $(sed -n "${line}s/^[ 	]*//p" "$changed")"
	rm "$changed"
done 3<"$TMP/candidates" | tee "$TMP/results"
awk -F: '{ n[$1]++ } END { for (v in n) printf "%d %s\n", n[v], v
	if (n["caught"] + n["survived"]) printf "%.0f %% caught\n",
		100 * n["caught"] / (n["caught"] + n["survived"]) }' "$TMP/results"
