#!/bin/sh
# layers.t - the arrows go one way: tools -> formats -> geometry -> base; the mathematics is pure.
. "${SRC:-$(dirname "$0")/..}/tests/lib.sh"

# The layer that owns a header is the one with the source file of the same name.
owner() {
	for layer in base geometry formats; do
		[ -e "$SRC/src/$layer/$1.c" ] && echo $layer && return
	done
	case $1 in
	cli) echo base ;; # cli.h declares what cli.c and message.c define
	*) echo unknown ;;
	esac
}

rank() {
	case $1 in base) echo 0 ;; geometry) echo 1 ;; formats) echo 2 ;; *) echo 9 ;; esac
}

# wrong LAYER FILE...: the includes that point the wrong way
wrong() {
	own=$(rank "$1")
	shift
	for file; do
		sed -n 's/^#include "\([a-z0-9_]*\)\.h"/\1/p' "$file" | while read -r header; do
			[ "$(rank "$(owner "$header")")" -le "$own" ] || echo "$file includes $header.h"
		done
	done
}

for layer in base geometry formats; do
	wrong $layer "$SRC/src/$layer"/*.c >"$TMP/found"
	empty "src/$layer includes nothing from above" "$TMP/found"
	# a header is no way around: it belongs to the layer of its module
	for file in "$SRC/src/$layer"/*.c; do
		header=$SRC/include/$(basename "$file" .c).h
		[ -e "$header" ] && wrong $layer "$header"
	done >"$TMP/found"
	empty "the headers of $layer include nothing from above" "$TMP/found"
done

for file in "$SRC"/include/*.h; do
	[ "$(owner "$(basename "$file" .h)")" = unknown ] && echo "$file"
done >"$TMP/found"
empty "every header belongs to a module" "$TMP/found"

grep -nE '#include <(stdio|unistd|fcntl|signal|time|pthread|getopt)\.h>' "$SRC"/src/geometry/*.c >"$TMP/found"
empty "geometry does no input or output" "$TMP/found"
grep -nE '\b(exit|abort|printf|fprintf|puts|die|die_error|die_usage|say|note|rand|time|clock)\(' \
	"$SRC"/src/geometry/*.c >"$TMP/found"
empty "geometry ends nothing and prints nothing" "$TMP/found"
grep -nE '\b(exit|abort|die|die_error|die_usage)\(' "$SRC"/src/formats/*.c >"$TMP/found"
empty "formats end nothing" "$TMP/found"
grep -rn 'setlocale' "$SRC"/src >"$TMP/found"
empty "nobody calls setlocale" "$TMP/found"

# What reads programs shares nothing with what writes them but files, numbers, vectors and boxes, so
# that no mistake is made twice.
for file in "$SRC"/src/formats/ncread*.c "$SRC"/include/ncread*.h "$SRC"/src/geometry/rig.c \
	"$SRC"/src/geometry/course.c "$SRC"/src/geometry/ball*.c "$SRC"/include/rig.h \
	"$SRC"/include/course.h "$SRC"/include/ball*.h "$SRC"/src/geometry/stock*.c \
	"$SRC"/src/geometry/holder*.c "$SRC"/src/geometry/obstacle.c "$SRC"/src/geometry/tiles.c \
	"$SRC"/src/geometry/axisload.c "$SRC"/include/axisload.h; do
	[ -e "$file" ] || { echo "$file is not there" && continue; }
	grep -Hn '^#include "' "$file" | grep -vE '"(ncread[a-z_]*|rig|course|ball[a-z]*|axisload|stock[a-z]*|holder[a-z]*|obstacle|tiles|quadric|array|box|error|num|reader|vec|kdtree|parallel|machine)\.h"'
done >"$TMP/found"
empty "the reader of programs shares nothing with the writers" "$TMP/found"

# What a sanitizer puts into objects and tools is not ours.
if ! nm "$BIN/cloud2mesh" | grep -q '__asan_init'; then
	ok "the objects of geometry are there" nm -A "$BIN"/../src/geometry/*.o
	grep -E ' [BbDdC] ' "$TMP/out" | grep -vE '\.part|\.cold' >"$TMP/found"
	empty "geometry has no variables that outlive a call" "$TMP/found"
else
	skip "geometry has no variables that outlive a call" "a sanitizer is built in"
fi

done_testing
