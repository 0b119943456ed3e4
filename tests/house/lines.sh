#!/bin/sh
# lines.sh COVERED [TEST]... - which line of src/ which test runs, from a build with --coverage in
# COVERED (`make coverage` builds it): COVERED/lines/TEST has `src/FOLDER/MODULE.c:LINE` for each,
# COVERED/lines/all those that can be run, COVERED/seconds/TEST the processor time.  TEST: as
# tests/unit/base/check_num or tests/tool/all-bad.t; without any, all of both.  What is newer than
# the test and the library stays as it is, so that a second run costs little.
cd "$(dirname "$0")/../.." || exit 1
SRC=$PWD
COVERED=$(cd "$1" && pwd) || exit 1
export SRC COVERED LC_ALL=C

# executed 1|0 LIST: FILE:LINE of all lines of modules, or of those run, by the files of counts that
# LIST names
executed() {
	xargs gcov --stdout <"$2" 2>/dev/null | awk -v all="$1" -F: '
		$3 == "Source" { file = $4; next }
		file !~ /^src\/.*\.c$/ { next }
		{ gsub(/ /, "", $1); gsub(/ /, "", $2) }
		$2 > 0 && $1 != "-" && (all || $1 !~ /^[#=]/) { print file ":" $2 }' | sort -u
}

one() { # TEST
	out=$COVERED/lines/$1
	mkdir -p "$(dirname "$out")" "$(dirname "$COVERED/seconds/$1")"
	case $1 in
	*.t) sources="$1 $COVERED/bin/ncpost" ;;
	*) sources="$COVERED/$1" ;;
	esac
	# shellcheck disable=SC2086 # two files
	[ -f "$out" ] && [ -z "$(find $sources -newer "$out")" ] && return
	counts=$(mktemp -d "${TMPDIR:-/tmp}/cloudmill.XXXXXX") || exit 1
	export GCOV_PREFIX="$counts"
	case $1 in
	*.t) BIN=$COVERED/bin READBACK=$COVERED/tests/readback/readback \
		CLOUD=$COVERED/tests/accuracy/cloud REPLAY=$COVERED/tests/fuzz/replay \
		timeout 1200 sh "$1" ;;
	*) CK_FORK=no timeout 900 "$COVERED/$1" ;;
	esac >"$counts/log" 2>&1 </dev/null
	echo $? >"$COVERED/seconds/$1.exit"
	times >"$counts/times"
	awk -F'[ms ]' 'NR == 2 { printf "%.2f\n", 60 * $1 + $2 + 60 * $4 + $5 }' "$counts/times" \
		>"$COVERED/seconds/$1"
	unset GCOV_PREFIX
	find "$counts" -name '*.gcda' >"$counts/files"
	# what gcov reads beside them
	sed "s,^$counts\(.*\)gcda\$,ln -s \1gcno $counts\1gcno," "$counts/files" | sh
	executed 0 "$counts/files" >"$out.new"
	mv "$out.new" "$out"
	rm -rf "$counts"
}

if [ "$2" = --one ]; then
	one "$3"
	exit 0
fi
shift
mkdir -p "$COVERED/lines"
find "$COVERED/src" -name '*.gcno' >"$COVERED/lines/files"
executed 1 "$COVERED/lines/files" >"$COVERED/lines/all.new"
mv "$COVERED/lines/all.new" "$COVERED/lines/all"
# shellcheck disable=SC2046 # names
[ $# -gt 0 ] || set -- $(find tests/unit -name 'check_*.c' | sed 's/\.c$//' | sort) \
	$(find tests -name '*.t' | sort)
printf '%s\n' "$@" | xargs -P "${JOBS:-$(getconf _NPROCESSORS_ONLN)}" -n 1 sh "$0" "$COVERED" --one
