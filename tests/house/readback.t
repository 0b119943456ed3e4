#!/bin/sh
# readback.t - the tests' reader of paths shares nothing with the suite's: a mistake built into the
# suite's reader goes into the program, and reading the program back beside the path finds it.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
LC_ALL=C
export LC_ALL
cd "$TMP" || exit 1

# Its files, and what they include, whoever includes it.
grep -n '#include "' "$SRC"/tests/readback/cl*.[ch] |
	grep -vE '"(cl|cl_text|cl_state|base/array|base/error|simulate/nc_motion)\.h"' >found
empty "it includes nothing but the motion that it fills" found

cat >hand.cl <<'END'
UNITS/INCHES
CUTTER/0.5,0.25
SPINDL/RPM,8000,CLW
RAPID
GOTO/0,0,2,0,0,1
FEDRAT/508
GOTO/0,0,0,0,0,1
CIRCLE/0,1,0,0,0,1,1
GOTO/1,1,0,0,0,1
CIRCLE/1.5,1,0,0,0,1,0.5,0.06,0.5,10,0
GOTO/1.5,1.5,0,0,0,1
GODLTA/0.5,0.25,0
RAPID
GOTO/2,2,2,0,0,1
FINI
END

# What would build a tool as `make` does; not where the objects hold a sanitizer's calls.
lib=$BIN/../libcloudmill.a tool=$BIN/../src/ncpost.o cc=${CC:-cc}
command -v "${cc%% *}" >/dev/null || skip_rest "no compiler"
[ -f "$lib" ] && [ -f "$tool" ] || skip_rest "no objects of the build"
nm "$tool" | grep -q __asan_init && skip_rest "objects with a sanitizer"

ncpost -q -c siemens -o right.mpf hand.cl
ok "as it is, the program follows the path" "$READBACK" -c siemens --path hand.cl right.mpf

# misread DESC CODE SED: the reader of paths with this change; CODE is in the file to be changed
misread() {
	file=$(grep -lF "$2" "$SRC"/src/io/path/*.c)
	sed "$3" "$file" >wrong.c
	if [ -z "$file" ] || cmp -s "$file" wrong.c; then
		result 1 "$1: the change does not fit"
		return
	fi
	# shellcheck disable=SC2086
	$cc -std=c11 -D_XOPEN_SOURCE=700 -iquote "$SRC/include" -iquote "$SRC/src/io/path" -w -pthread \
		-o wrong wrong.c "$tool" "$lib" -lm 2>err || cat err
	rm -f wrong.mpf
	./wrong -q -c siemens -o wrong.mpf hand.cl
	status 3 "$1: found" "$READBACK" -c siemens --path hand.cl wrong.mpf
	has "... and says where" "line [0-9]+.*beyond|not in the path" err
}

misread "CIRCLE the wrong way round" 'if (clockwise) {' 's/if (clockwise) {/if (!clockwise) {/'
misread "inches taken as millimetres" 'set_unit(p, 25.4)' 's/set_unit(p, 25\.4)/set_unit(p, 1)/'
misread "GODLTA taken away" 'v[0], p->axis) : path_vector_of(p, v)' \
	'/path_read_godlta/,/^}/s/vec_add(/vec_sub(/'

done_testing
