#!/bin/sh
# portability.t - the same bytes everywhere: no object asks the C library for a function that differs
# from one to the next, and ours give the same bits under every compiler that is here, at every level
# of optimisation, for every machine that is here or can be emulated.  make portability: whole jobs.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"

# ---- nobody calls what the libraries round differently

inexact='sin|cos|tan|sincos|asin|acos|atan|atan2|exp|exp2|exp10|expm1|log|log2|log10|log1p|pow|hypot|cbrt'
inexact="($inexact|sinh|cosh|tanh|asinh|acosh|atanh|fma|fmax|fmin|erf|erfc|tgamma|lgamma)[fl]?"
find "$BIN/../src" -name '*.o' >"$TMP/objects"
ok "objects are found" test "$(wc -l <"$TMP/objects")" -ge 300
xargs nm -A <"$TMP/objects" 2>/dev/null | grep -E " U $inexact\$" >"$TMP/found"
empty "no object calls a function that the libraries round differently" "$TMP/found"
echo 'x.o:                 U atan2' | grep -Ec " U $inexact\$" >"$TMP/found"
has "and would be found to" '^1$' "$TMP/found"

# ---- the bits of 320,000 results, added up

want=$(sed -n 's/.*ck_assert_msg(sum == \(0x[0-9a-f]*\).*/\1/p' "$SRC/tests/unit/math/check_elementary.c")
bits() { # NAME RUNNER COMPILER OPTION...: the sum is that of the unit test
	desc=$1 runner=$2
	shift 2
	if ! command -v "$1" >/dev/null || ! command -v "${runner:-sh}" >/dev/null; then
		skip "$desc: the same bits" "no $1 or no ${runner:-sh}"
		return
	fi
	if ! "$@" -std=c11 -D_XOPEN_SOURCE=700 -ffp-contract=off -iquote "$SRC/include" -iquote "$SRC/tests/lib" \
		-o "$TMP/bits.exe" "$SRC"/src/math/elementary*.c "$SRC/tests/house/bits.c" -lm 2>"$TMP/err"; then
		skip "$desc: the same bits" "$1 has no C library here"
		return
	fi
	WINEDEBUG=-all WINEPREFIX="$TMP/wine" $runner "$TMP/bits.exe" 2>/dev/null | tr -d '\r' >"$TMP/found"
	has "$desc: the same bits" "^$want\$" "$TMP/found"
}

for compiler in gcc clang; do
	for level in 0 1 2 3; do bits "$compiler -O$level" "" $compiler -O$level; done
done
bits "gcc for the machine here" "" gcc -O3 -march=native
bits "musl" "" musl-gcc -O2 -static
bits "i386, SSE2" "" i686-linux-gnu-gcc -O2 -static -msse2 -mfpmath=sse
bits "arm64" qemu-aarch64-static aarch64-linux-gnu-gcc -O2 -static
bits "Windows" wine x86_64-w64-mingw32-gcc -O2 -static

done_testing
