#!/bin/sh
# make.t - what was deleted from a build is made again, and all objects after a change of the
# Makefile, which has the flags.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"

unset MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES
built=$(dirname "$BIN")
mkdir "$TMP/b"
cp -Rp "$built/bin" "$built/src" "$built/controls" "$built/libcloudmill.a" "$built"/version.* \
	"$TMP/b" 2>"$TMP/cp" || skip_rest "the tools are not in a build of make's"

# would [OPTION...]: the files that make would make there, by name
would() {
	"${MAKE:-make}" -s -n -C "$SRC" BUILD="$TMP/b" "$@" all 2>"$TMP/err" |
		sed -n "s/.* -o \([^ ]*\).*/\1/p; s/^.* rcs \([^ ]*\) .*/\1/p" |
		sed "s,^$TMP/b/,," | sort >"$TMP/would"
}

would
[ ! -s "$TMP/would" ] || skip_rest "the build is not of today's sources"
rm "$TMP/b/src/ncplot.o"
would
ok "a tool's object" [ "$(paste -sd ' ' "$TMP/would")" = "bin/ncplot src/ncplot.o" ]
cp -p "$built/src/ncplot.o" "$TMP/b/src"
rm "$TMP/b/src/math/cubic.o"
would
ok "an object of the library, the library and the tools" \
	grep -qx src/math/cubic.o "$TMP/would"
ok "the library" grep -qx libcloudmill.a "$TMP/would"
ok "the tools" [ "$(grep -c '^bin/' "$TMP/would")" -ge 10 ]
cp -p "$built/src/math/cubic.o" "$TMP/b/src/math"
rm "$TMP/b/libcloudmill.a"
would
ok "the library alone" [ "$(grep -c '^src/' "$TMP/would")" -eq 0 ]
ok "and the tools after it" [ "$(grep -c '^bin/' "$TMP/would")" -ge 10 ]
cp -p "$built/libcloudmill.a" "$TMP/b"
would -W Makefile
ok "all objects after a change of the Makefile" [ "$(grep -c '^src/.*[.]o$' "$TMP/would")" -eq \
	"$(find "$SRC/src" -name '*.c' -o -name 'page.*' | wc -l)" ]
done_testing
