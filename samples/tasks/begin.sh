# begin.sh - what every task begins with: BIN (the tools; else those of the build folder, else those on
# PATH), the folder to work in (the task's argument; else one that is gone at the end), and
#
#	figure NAME VALUE            a figure of the task, as `figure NAME VALUE`; see expected.txt
#	check NAME PROGRAM OPTION... runs ncverify on it; figures NAME.accepted (1 or 0), NAME.gouge,
#	                             NAME.left (the most and of 95 %, mm), NAME.minutes
#
# shellcheck shell=sh
set -eu
here=$(cd "$(dirname "$0")" && pwd)
samples=$(cd "$here/.." && pwd)
BIN=${BIN:-$samples/../build/bin}
PATH=$BIN:$PATH
[ -d "$samples/../machines" ] && CLOUDMILL_MACHINES=${CLOUDMILL_MACHINES:-$samples/../machines}
export BIN PATH CLOUDMILL_MACHINES
if [ $# -gt 0 ]; then
	mkdir -p "$1"
	work=$(cd "$1" && pwd)
else
	work=$(mktemp -d "${TMPDIR:-/tmp}/task.XXXXXX")
	trap 'rm -rf "$work"' EXIT
	trap 'exit 130' INT TERM
fi
cd "$work"

figure() {
	echo "figure $1 $2"
}

check() {
	name=$1 program=$2 code=0
	shift 2
	ncverify -q "$@" "$program" >"$name.verdict" || code=$?
	[ $code -eq 0 ] || [ $code -eq 3 ] || exit $code
	awk -v name="$name" '
		$1 == "gouge" && $2 == "worst" { print "figure", name ".gouge", $3 }
		$1 == "left" && $2 == "worst" { print "figure", name ".left", $3 }
		$1 == "left" && $2 == "50%" { print "figure", name ".left95", $5 + 0 }
		$1 == "time" { print "figure", name ".minutes", $2 }
		$1 == "verdict" { print "figure", name ".accepted", $2 == "accepted" ? 1 : 0 }' "$name.verdict"
}
