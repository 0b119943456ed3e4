#!/bin/sh
# mutate.sh - changes a line of src/ at random, N times (200, or N=...), and sees whether a test
# notices: the unit tests that include the module's header, or lie in its folder, then the tool tests
# of TOOL_TESTS (none).  FOLDERS: those to take lines from (all).  SEED (1) chooses them.
#
# A change is one of: + for -, - for +, < for <=, <= for <, > for >=, >= for >, && for ||, || for &&,
# a term of a sum dropped, 1 added to a small whole number.  Prints a line for each: caught, survived
# or no program, then the change as line of a diff; at the end how many of which.  Works in a copy.
SRC=$(cd "$(dirname "$0")/../.." && pwd)
TMP=$(mktemp -d "${TMPDIR:-/tmp}/cloudmill.XXXXXX") || exit 1
trap 'rm -rf "$TMP"' EXIT
trap 'exit 130' INT TERM
(cd "$SRC" && tar -cf - --exclude=./build --exclude=./.git .) | (cd "$TMP" && tar -xf -)
mkdir "$TMP/build"
[ -d "$SRC/build/src" ] && cp -Rp "$SRC/build/." "$TMP/build/"
cd "$TMP" || exit 1
make ${CC:+CC="$CC"} -s >/dev/null 2>&1 || { echo "mutate: does not build"; exit 1; }

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
	/ \+ / { put("s/ + / - /"); put("s/ + [a-z0-9_.]*//") }
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

caught() { # FILE: a test fails
	for test in $(tests_of "$1" | awk '!seen[$0]++'); do
		unit=build/${test%.c}
		make ${CC:+CC="$CC"} -s "$unit" >make.out 2>&1 || return 0
		CK_DEFAULT_TIMEOUT=60 timeout 120 "$unit" >unit.out 2>&1 || return 0
	done
	[ -n "$TOOL_TESTS" ] || return 1
	make ${CC:+CC="$CC"} -s all >make.out 2>&1 || return 0
	for test in $TOOL_TESTS; do
		SRC=$TMP BIN=$TMP/build/bin timeout 300 sh "tests/$test" >tool.out 2>&1 || return 0
	done
	return 1
}

candidates >candidates
while IFS=: read -r file line change <&3; do
	cp "$file" before.c
	sed "${line}$change" before.c >"$file"
	if cmp -s before.c "$file"; then
		verdict='no change'
	elif ! make ${CC:+CC="$CC"} -s "build/${file%.c}.o" >make.out 2>&1; then
		verdict='no program'
	elif caught "$file"; then
		verdict=caught
	else
		verdict=survived
	fi
	echo "$verdict: $file:$line: $(sed -n "${line}s/^ *//p" "$file")"
	cp before.c "$file"
done 3<candidates | tee results
awk -F: '{ n[$1]++ } END { for (v in n) printf "%d %s\n", n[v], v
	if (n["caught"] + n["survived"]) printf "%.0f %% caught\n",
		100 * n["caught"] / (n["caught"] + n["survived"]) }' results
