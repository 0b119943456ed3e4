#!/bin/sh
# install.t - make install puts tools, pages and machines where PREFIX and DESTDIR say, what is
# installed runs from there, and make uninstall takes away all of it and nothing else.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"

# A make of its own: nothing of the one that runs the tests gets in.
unset MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES
build() { # TARGET VARIABLE=VALUE...
	"${MAKE:-make}" -C "$SRC" -j2 BUILD="$TMP/build" CC="${CC:-cc}" CFLAGS=-O0 "$@"
}

tools=$(for source in "$SRC"/src/*.c; do basename "$source" .c; done)
files() { # FOLDER: what it holds, without folders
	(cd "$1" && find . ! -type d | sort)
}

# ---- without DESTDIR

prefix=$TMP/usr
mkdir -p "$prefix/bin" "$prefix/share/man/man1"
echo other >"$prefix/bin/another-tool"
echo other >"$prefix/share/man/man1/another-tool.1"
files "$prefix" >"$TMP/before"

ok "make install PREFIX=" build install PREFIX="$prefix" DESTDIR=
for tool in $tools; do
	ok "$tool runs from where it is installed" "$prefix/bin/$tool" --version
	ok "$tool.1 is installed" test -s "$prefix/share/man/man1/$tool.1"
done
for page in "$SRC"/man/*.[57]; do
	name=$(basename "$page")
	ok "$name is installed" test -s "$prefix/share/man/man${name##*.}/$name"
done
for control in "$SRC"/controls/*.txt; do
	ok "$(basename "$control") is installed" \
		test -s "$prefix/share/cloudmill/controls/$(basename "$control")"
done
for machine in "$SRC"/machines/*.txt; do
	ok "machine $(basename "$machine") is installed" \
		test -s "$prefix/share/cloudmill/machines/$(basename "$machine")"
done

cat >"$TMP/path.cl" <<'END'
UNITS/MM
MULTAX/ON
CUTTER/10,5
LOADTL/1
SPINDL/RPM,8000,CLW
RAPID
GOTO/0,0,50,0,0,1
FEDRAT/MMPM,500
GOTO/0,0,0,0,0.173648178,0.984807753
GOTO/10,0,0,0.173648178,0,0.984807753
RAPID
GOTO/10,0,50,0.173648178,0,0.984807753
FINI
END
mkdir "$TMP/elsewhere"
elsewhere() { # CMD...: in another folder, with the installed tools and no hint to the machines
	(cd "$TMP/elsewhere" && unset CLOUDMILL_MACHINES && PATH=$prefix/bin:$PATH && "$@")
}
ok "-m table-bc finds the installed machine" \
	elsewhere ncpost -c fanuc -m table-bc "$TMP/path.cl"
has "and turns its axes" '^[^(]*B[-0-9.]+' "$TMP/out"
status 1 "-m of a machine that is not there" elsewhere ncpost -c fanuc -m no-such "$TMP/path.cl"

echo 'include = table-bc' >"$prefix/share/cloudmill/machines/shop.txt"
ok "make uninstall" build uninstall PREFIX="$prefix" DESTDIR=
ok "a machine file of the user's is kept" test -s "$prefix/share/cloudmill/machines/shop.txt"
rm -r "$prefix/share/cloudmill"
ok "make install again" build install PREFIX="$prefix" DESTDIR=
ok "and make uninstall" build uninstall PREFIX="$prefix" DESTDIR=
files "$prefix" >"$TMP/after"
same "uninstall leaves what was there before, and no more" "$TMP/before" "$TMP/after"
ok "nor a folder of ours" test ! -e "$prefix/share/cloudmill"

# ---- with DESTDIR, for packagers: the same under another root

stage=$TMP/stage
mkdir "$stage"
ok "make install DESTDIR=" build install PREFIX=/opt/mill DESTDIR="$stage"
for tool in $tools; do
	ok "$tool is under DESTDIR" test -x "$stage/opt/mill/bin/$tool"
done
files "$stage" | grep -v '^\./opt/mill/' >"$TMP/found"
empty "nothing lies outside of PREFIX" "$TMP/found"
status 1 "the prefix compiled in is the last one" \
	elsewhere "$stage/opt/mill/bin/ncpost" -c fanuc -m no-such "$TMP/path.cl"
has "not that of the build before" 'in /opt/mill/share/cloudmill/machines' "$TMP/err"
ok "make uninstall DESTDIR=" build uninstall PREFIX=/opt/mill DESTDIR="$stage"
files "$stage" >"$TMP/found"
empty "uninstall leaves no file there" "$TMP/found"

# ---- a tarball of a tree that git does not know

cp -R "$SRC/Makefile" "$SRC/src" "$SRC/include" "$SRC/machines" "$SRC/controls" "$SRC/man" "$stage"
ok "make dist without git" env GIT_DIR="$TMP/none" "${MAKE:-make}" -C "$stage" dist
tar -tzf "$stage"/cloudmill-*.tar.gz >"$TMP/found"
has "the tarball holds the sources" '^cloudmill-[0-9.]*/src/ncpost.c$' "$TMP/found"

done_testing
