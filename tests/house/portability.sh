#!/bin/sh
# portability.sh - the same jobs on every platform that can be built and run here: a table of platform
# by output, with the hash of its bytes, and exit 1 where one differs from the first.  Usage:
#	portability.sh [PLATFORM...]	of those below; default: all
# A platform whose compiler, C library or emulator is missing is told and skipped.
set -u
SRC=$(cd "$(dirname "$0")/../.." && pwd)
cd "$SRC" || exit 1
BUILD=${BUILD:-build}
TMP=$(mktemp -d "${TMPDIR:-/tmp}/cloudmill.XXXXXX") || exit 1
trap 'rm -rf "$TMP"' EXIT
trap 'exit 130' INT TERM
WINEDEBUG=-all
export WINEDEBUG
unset CLOUDMILL_MACHINES CLOUDMILL_CONTROLS
unset MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES

platforms="gcc-O0 gcc-O1 gcc-O2 gcc-O3 gcc-native clang-O0 clang-O1 clang-O2 clang-O3 musl i386 arm64 windows"

# NAME: sets compiler, flags (CFLAGS), link (LDFLAGS), define (CPPFLAGS), exe, and what runs a tool
platform() {
	flags=-O2 link='' define='' exe='' runner=''
	case $1 in
	gcc-native) compiler=gcc flags='-O3 -march=native' ;;
	gcc-* | clang-*) compiler=${1%%-*} flags=-${1#*-} ;;
	musl) compiler=musl-gcc link=-static ;;
	i386) compiler=i686-linux-gnu-gcc flags='-O2 -msse2 -mfpmath=sse' link=-static ;;
	arm64) compiler=aarch64-linux-gnu-gcc link=-static runner=qemu-aarch64-static ;;
	windows)
		compiler=x86_64-w64-mingw32-gcc link='-static -s' exe=.exe runner=wine
		define='-D__USE_MINGW_ANSI_STDIO=1 -Wno-format'
		;;
	*) echo "portability: no platform $1; there are $platforms" >&2 && exit 2 ;;
	esac
}

# NAME: builds its tools in $bin; 1 and why, if that is not possible here
build() {
	for needed in $compiler $runner; do
		command -v "$needed" >/dev/null || { echo "no $needed" && return 1; }
	done
	echo 'int main(void) { return 0; }' >"$TMP/empty.c"
	# shellcheck disable=SC2086 # words
	$compiler $flags $link -pthread -o "$TMP/empty$exe" "$TMP/empty.c" -lm 2>/dev/null ||
		{ echo "$compiler has no C library" && return 1; }
	"${MAKE:-make}" -j "$(getconf _NPROCESSORS_ONLN)" BUILD="$BUILD/portable/$1" CC="${CCACHE:-}$compiler" \
		CFLAGS="$flags" LDFLAGS="$link" CPPFLAGS="$define" EXE="$exe" all >"$TMP/log" 2>&1 ||
		{ grep -m 1 error "$TMP/log" || echo "make failed"; return 2; }
}

# The jobs, in a folder of their own; statuses are part of what must agree.
job() { # OUTPUT TOOL ARGUMENT...
	to=$1 tool=$2
	shift 2
	$runner "$bin/$tool$exe" -q "$@" -o "$to" 2>>errors
	echo "$to $?" >>statuses
}

scan() { # a bowl in a slope, and points beside a grid, by whole numbers alone
	awk 'BEGIN { for (i = 0; i <= 24; i++) for (k = 0; k <= 24; k++) {
		s = (s * 1103 + 12345 + i * k) % 65536; x = i + s / 262144; y = k + (s % 256) / 1024
		d = (x - 12) * (x - 12) + (y - 11) * (y - 11)
		printf "%.5f %.5f %.5f\n", x, y, 0.1 * x - 6 / (1 + d / 40) } }'
}

jobs() {
	scan >scan.xyz
	job mesh.ply cloud2mesh -t 1 scan.xyz
	job mesh-auto.ply cloud2mesh scan.xyz
	job rows.cl meshnorm -r 2 --rows mesh mesh.ply
	job path.cl meshnorm -r 2 --scallop 0.05 mesh.ply
	job arcs.cl biarcfit -e 0.01 rows.cl
	job splines.cl bsplfit -e 0.01 rows.cl
	job arcs.mpf ncpost -c siemens -m table-ac arcs.cl
	job splines.nc ncpost -c fanuc -m table-bc splines.cl
	job rows.h ncpost -c heidenhain -m head-ca rows.cl
	job rows.ngc ncpost -c linuxcnc -m head-table-bc rows.cl
	job verdict.txt ncverify -g scan.xyz -r 2 -m table-ac arcs.mpf
	job picture.svg ncplot arcs.cl
	job surface.txt cloud2surf scan.xyz
	job surface.ply nurbs2mesh surface.txt
	job planes.cl planecut -r 2 --step 2 surface.ply
}

failed=0
first=
[ $# -gt 0 ] || eval "set -- $platforms"
for name; do
	platform "$name"
	why=$(build "$name")
	case $? in
	1) echo "$name skipped: $why" && continue ;;
	2) echo "$name FAILED: $why" && failed=1 && continue ;;
	esac
	bin=$SRC/$BUILD/portable/$name/bin
	case $BUILD in /*) bin=$BUILD/portable/$name/bin ;; esac
	mkdir "$TMP/$name"
	(cd "$TMP/$name" && jobs && rm -f errors && cksum -- * | awk '{ print $3, $1 }' >"$TMP/$name.sums")
	if [ -z "$first" ]; then
		first=$name
		awk '$1 ~ /\./ { n++ } END { printf "%d outputs; %s is compared with\n", n, "'"$name"'" }' "$TMP/$name.sums"
		sed 's/^/  /' "$TMP/$name/statuses"
	fi
	differ=$(diff "$TMP/$first.sums" "$TMP/$name.sums" | sed -n 's/^> \([^ ]*\) .*/\1/p' | tr '\n' ' ')
	hash=$(cksum <"$TMP/$name.sums" | cut -d ' ' -f 1)
	if [ -z "$differ" ] && [ "$(wc -l <"$TMP/$name.sums")" -eq "$(wc -l <"$TMP/$first.sums")" ]; then
		printf '%-12s %10s  same bytes\n' "$name" "$hash"
	else
		printf '%-12s %10s  DIFFERENT: %s\n' "$name" "$hash" "${differ:-outputs missing}"
		failed=1
	fi
done
exit $failed
