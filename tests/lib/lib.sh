# tests/lib/lib.sh - what the shell tests share.  A test sources it first:
#
#	. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
#
# It sets BIN (the tools), SRC (the project) and TMP (a folder of the test's own, gone at its end),
# puts BIN first on PATH, and gives:
#
#	ok DESC CMD...            the command succeeds
#	fails DESC CMD...         the command exits with 1 to 125
#	status N DESC CMD...      the command exits with N; its output lies in $TMP/out and $TMP/err
#	within SECONDS CMD...     the command, ended after so long (SLOWER times, where tools are slow)
#	same DESC FILE FILE       two files hold the same bytes
#	has DESC REGEX FILE       a line of the file matches the extended regular expression
#	hasnt DESC REGEX FILE     no line does
#	empty DESC FILE           the file is empty; else its first lines are shown
#	below DESC A B            number A <= number B
#	skip DESC WHY             a test that cannot be made here, for what WHY says is missing; it
#	                          counts neither as passed nor as failed
#	skip_rest WHY             so for every test from here to the end of the file
#	has_locale NAME           the C library has this locale, or it could be made here
#	canon PROGRAM             what LinuxCNC's own interpreter makes of it, its canonical calls; each
#	                          of its tools is there, 100 long, $diameter wide (inches)
#	done_testing              at the end: exit 1 when anything failed
#
# shellcheck shell=sh

SRC=$(cd "${SRC:-$(dirname "$0")/../..}" && pwd)
BIN=$(cd "${BIN:-$SRC/build/bin}" && pwd) || exit 1
READBACK=${READBACK:-$SRC/build/tests/readback/readback}
TMP=$(mktemp -d "${TMPDIR:-/tmp}/cloudmill.XXXXXX") || exit 1
trap 'rm -rf "$TMP"' EXIT
trap 'exit 130' INT TERM
PATH=$BIN:$PATH
CLOUDMILL_MACHINES=$SRC/machines
CLOUDMILL_TOOLS=$SRC/tools
CLOUDMILL_CONTROLS=$SRC/controls
export CLOUDMILL_TOOLS CLOUDMILL_CONTROLS SRC BIN READBACK TMP PATH CLOUDMILL_MACHINES
test_count=0
test_failed=0

rest=
result() { # STATUS DESC
	if [ -n "$rest" ]; then
		skip "${2%% (*}" "$rest" # without what was found
		return 0
	fi
	test_count=$((test_count + 1))
	if [ "$1" -eq 0 ]; then
		echo "ok - $2"
	else
		test_failed=$((test_failed + 1))
		echo "not ok - $2"
		[ -s "$TMP/err" ] && head -n 5 "$TMP/err" | sed 's/^/#   /'
		return 0
	fi
}

skip() {
	test_count=$((test_count + 1))
	echo "skip - $1 # $2"
}

skip_rest() {
	rest=$1
}

run() { # CMD...: exit status in $got, output in $TMP/out and $TMP/err
	"$@" >"$TMP/out" 2>"$TMP/err" </dev/null
	got=$?
}

ok() {
	desc=$1
	shift
	run "$@"
	result "$got" "$desc"
}

fails() {
	desc=$1
	shift
	run "$@"
	if [ "$got" -ge 1 ] && [ "$got" -le 125 ]; then
		result 0 "$desc"
	else
		result 1 "$desc (exit $got)"
	fi
}

status() {
	want=$1 desc=$2
	shift 2
	run "$@"
	if [ "$got" -eq "$want" ]; then result 0 "$desc"; else result 1 "$desc (exit $got, not $want)"; fi
}

within() { # SECONDS CMD...
	seconds=$1
	shift
	timeout $((seconds * ${SLOWER:-1})) "$@"
}

same() {
	: >"$TMP/err"
	cmp "$2" "$3" >"$TMP/err" 2>&1
	result $? "$1"
}

has() {
	if grep -Eq -e "$2" "$3"; then result 0 "$1"; else result 1 "$1 (no line like $2)"; fi
}

hasnt() {
	grep -Eq -e "$2" "$3"
	case $? in
	0) result 1 "$1 (a line like $2)" ;;
	1) result 0 "$1" ;;
	*) result 1 "$1 (cannot look in $3)" ;;
	esac
}

empty() {
	if head -n 5 "$2" >"$TMP/err" && [ ! -s "$2" ]; then result 0 "$1"; else result 1 "$1"; fi
}

below() {
	if awk -v a="$2" -v b="$3" 'BEGIN { exit !(a != "" && a + 0 <= b + 0) }'; then
		result 0 "$1 ($2 <= $3)"
	else
		result 1 "$1 ($2 > $3)"
	fi
}

# Those that are not there are made once for this test, where their sources are installed.
has_locale() {
	[ "$(LC_ALL=$1 locale charmap 2>/dev/null)" = "${1#*.}" ] && return
	mkdir -p "$TMP/locales"
	localedef -i "${1%.*}" -f "${1#*.}" "$TMP/locales/$1" >/dev/null 2>&1
	LOCPATH=$TMP/locales:/usr/lib/locale
	export LOCPATH
	[ "$(LC_ALL=$1 locale charmap 2>/dev/null)" = "${1#*.}" ]
}

# Where a program names no tool it is given tool 1.  The interpreter keeps its tools in a file in
# $HOME, which others must not use at the same time.
canon() {
	printf '[EMC]\nMACHINE = test\n[RS274NGC]\nPARAMETER_FILE = sim.var\n' >sim.ini
	printf '[TRAJ]\nCOORDINATES = X Y Z A B C\nLINEAR_UNITS = mm\n' >>sim.ini
	sed -n 's/^.* T\([0-9]*\) M6$/\1/p' "$1" | sort -un >tools
	[ -s tools ] || { echo 1 >tools; sed '2,/G53/s/.*G53.*/&\nT1 M6/' "$1" >one && mv one "$1"; }
	awk -v d="${diameter:-8}" '{ printf "T%d P%d Z100 D%s\n", $1, $1, d }' tools >sim.tbl
	: >sim.var
	HOME=$TMP rs274 -g -i sim.ini -t sim.tbl -v sim.var "$1" 2>canon.err </dev/null
}

done_testing() {
	echo "1..$test_count"
	[ "$test_failed" -eq 0 ]
	exit $?
}
