#!/bin/sh
# bare.t - a C compiler, libc and make are enough for the tools and the demo: neither Check nor
# pkg-config, nothing under tests/, no header and no library beyond libc, libm and threads.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
bare=$SRC/tests/house/bare
cd "$TMP" || exit 1

# ---- what make would do, in a folder where nothing is built yet

unset MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES
(cd "$SRC" && "${MAKE:-make}" -n BUILD=nothing CC=cc all demo) >plan 2>err
result $? "make -n all demo"
for source in "$SRC"/src/*.c; do
	grep -Eq -e "-c -o .* src/$(basename "$source")\$" plan || echo "$source"
done >found
empty "compiles every tool" found
has "and runs the demo" 'demo\.sh' plan
grep -E '(^|[^a-z])tests/|READBACK|pkg-config|-lcheck' plan >found
empty "nothing under tests/ is compiled, linked or run" found
tr ' ' '\n' <plan | grep '^-l' | grep -vxE -e '-l(m|pthread)' >found
empty "nothing is linked but libm and threads" found
grep -nE 'tests/|READBACK|check_' "$SRC/samples/demo.sh" >found
empty "the demo itself needs nothing of it either" found

if command -v bmake >/dev/null; then
	(cd "$SRC" && bmake demo) >out 2>&1 && echo "it went on" >>out
	head -n 1 out >first
	has "the make of a BSD is told at once which one is needed" 'GNU make is needed, type gmake' first
	hasnt "and goes no further" 'it went on|Bad modifier' out
else
	skip "the make of a BSD is told at once which one is needed" "no bmake"
fi

# ---- what was built

# shellcheck disable=SC2046 # file names of our own
ok "the compiler says what headers it read (else: make clean)" \
	sh "$bare/headers" $(find "$BIN/../src" -name '*.d')
empty "none but ours and libc's" out
for tool in "$BIN"/*; do
	head -c 2 "$tool" | grep -q '^#!' && continue # cloudmill, a script
	desc="$(basename "$tool") needs libc, libm and threads alone"
	if nm "$tool" | grep -q __asan_init; then
		skip "$desc" "a sanitizer is built in" # and brings along what is not ours
		continue
	fi
	readelf -d "$tool" | sed -n 's/.*(NEEDED).*\[\(.*\)\].*/\1/p' >needed
	grep -vE '^(lib(c|m|pthread)\.so\.[0-9]|libc\.musl|ld-(linux|musl))' needed >found
	grep -q '^libc\.' needed || echo "what it needs is not told" >>found
	empty "$desc" found
done

# ---- the compiler that .ci/run puts in front of the real one, on things a bare machine has not

mkdir -p src tests lib
echo '#define there 1' >lib/there.h
printf '#include <stdio.h>\nint main(void) { return puts("") < 0; }\n' >src/plain.c
printf '#include <there.h>\nint main(void) { return !there; }\n' >src/header.c
cp src/plain.c tests/plain.c
try() { # ARGUMENT...: as the Makefile calls it
	PATH=$bare:$PATH cc -isystem "$TMP/lib" -MD -MP "$@"
}
ok "the bare compiler compiles" try -c -o plain.o src/plain.c
ok "and links" try -o plain plain.o -lm -pthread
fails "not what is under tests/" try -c -o plain.o tests/plain.c
has "which it says" 'not on a bare machine: tests/plain\.c' err
fails "nor with it" try -o plain plain.o build/tests/plain.o
fails "nor with another library" try -o plain plain.o -lz
fails "nor with another header" try -c -o header.o src/header.c
has "which it says too" 'not on a bare machine: .*/lib/there\.h' err
ok "and leaves no object" test ! -e header.o
fails "nor is there a pkg-config" "$bare/pkg-config" --libs check

done_testing
