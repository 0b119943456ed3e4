#!/bin/sh
# install.t - make install puts tools, pages and machines where PREFIX and DESTDIR say, what is
# installed runs from there, and make uninstall takes away all of it and nothing else.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"

# A make of its own: nothing of the one that runs the tests gets in.
unset MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES
build() { # TARGET VARIABLE=VALUE...
	"${MAKE:-make}" -C "$SRC" BUILD="$(dirname "$BIN")" "$@"
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

# ---- completions, from the options' one source

complete() { # WORD...: what bash offers for the last of them
	bash -c 'source "$1" && shift && COMP_WORDS=("$@") COMP_CWORD=$(($# - 1)) && "_cloudmill_$1" "$1" &&
		printf "%s\n" "${COMPREPLY[@]}"' - "$prefix/share/bash-completion/completions/$1" "$@" >"$TMP/offered" 2>&1
}
if command -v bash >/dev/null; then
	for tool in $tools; do
		elsewhere "$tool" --help all | sed -nE 's/^  (-[a-zA-Z], |    )--([a-z0-9-]+).*/--\2/p' | sort >"$TMP/want"
		elsewhere complete "$tool" - && sort "$TMP/offered" >"$TMP/sorted"
		same "bash: the options of $tool" "$TMP/want" "$TMP/sorted"
	done
	elsewhere complete ncpost -m table-
	has "bash: machines that are installed" '^table-bc$' "$TMP/offered"
	elsewhere complete meshnorm --rows s
	has "bash: the words of a choice" '^scallop$' "$TMP/offered"
else
	skip "completions of bash" "no bash"
fi
for shell in zsh fish; do
	if ! command -v $shell >/dev/null; then
		skip "completions of $shell" "no $shell"
		continue
	fi
	for tool in $tools; do
		file=$prefix/share/zsh/site-functions/_$tool
		[ $shell = zsh ] || file=$prefix/share/fish/vendor_completions.d/$tool.fish
		ok "$shell reads the completions of $tool" $shell -n "$file"
	done
done
if command -v fish >/dev/null; then
	elsewhere env HOME="$TMP" XDG_CONFIG_HOME="$TMP" fish -c \
		"source $prefix/share/fish/vendor_completions.d/ncpost.fish; complete -C 'ncpost -m table-'" >"$TMP/offered" 2>&1
	has "fish: machines that are installed" '^table-bc' "$TMP/offered"
fi
if command -v zsh >/dev/null && zsh -fc 'zmodload zsh/zpty' 2>/dev/null; then
	# A terminal of its own, as zsh completes in none but such a one.
	cat >"$TMP/type.zsh" <<'END'
zmodload zsh/zpty
zpty z zsh -f
zpty -w z "TERM=dumb; fpath=($1 \$fpath); autoload -U compinit; compinit -u -D; LISTMAX=500"
zpty -w -n z "$2"$'\t\t'
repeat 100; do
	zpty -r -t z part && print -rn -- "$part"
	[[ $part == *table-bc* ]] && break
	sleep 0.1
done
zpty -d z
END
	elsewhere zsh -f "$TMP/type.zsh" "$prefix/share/zsh/site-functions" \
		'ncpost -m table-' >"$TMP/offered" 2>&1
	has "zsh: machines that are installed" 'table-bc' "$TMP/offered"
else
	skip "zsh: machines that are installed" "no zsh"
fi

mine=$prefix/share/cloudmill/machines
cp "$prefix/share/man/man1/ncpost.1" "$TMP/page"
echo 'include = table-bc' >"$mine/shop.txt"
echo '# B is slow on ours' >>"$mine/table-bc.txt"
ok "make uninstall" build uninstall PREFIX="$prefix" DESTDIR=
has "says what it keeps" "kept.*table-bc.txt" "$TMP/out"
ok "a machine file of the user's is kept" test -s "$mine/shop.txt"
ok "and one that the user has changed" test -s "$mine/table-bc.txt"
ok "but no other" test "$(files "$prefix/share/cloudmill" | wc -l)" -eq 2
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
ok "a tool finds its data there" elsewhere "$stage/opt/mill/bin/ncpost" -c fanuc -m table-bc "$TMP/path.cl"
status 1 "and says where it looks" \
	elsewhere "$stage/opt/mill/bin/ncpost" -c fanuc -m no-such "$TMP/path.cl"
has "beside the tool" "in $stage/opt/mill/share/cloudmill/machines" "$TMP/err"
for folder in build/bin build/static/bin build/portable/musl/bin; do
	mkdir -p "$TMP/sources/$folder" && cp "$BIN/ncpost" "$TMP/sources/$folder"
	[ -e "$TMP/sources/machines" ] || { cp -R "$SRC/machines" "$TMP/sources" && cp "$SRC/VERSION" "$TMP/sources"; }
	ok "and from $folder, those of the sources" \
		elsewhere "$TMP/sources/$folder/ncpost" -c fanuc -m table-bc "$TMP/path.cl"
done
ln -s "$stage/opt/mill/bin/ncpost" "$TMP/elsewhere/post"
ok "also through a link" elsewhere ./post -c fanuc -m table-bc "$TMP/path.cl"
mv "$stage/opt" "$stage/moved"
ok "and wherever it is moved to" \
	elsewhere "$stage/moved/mill/bin/ncpost" -c fanuc -m table-bc "$TMP/path.cl"
mv "$stage/moved" "$stage/opt"
grep -rlE "/usr/local|$prefix|/opt/mill" "$stage/opt/mill" >"$TMP/found"
empty "no prefix is in what is installed" "$TMP/found"

# ---- small, quick, and content with what it may only read

for tool in $tools; do
	cp "$BIN/$tool" "$TMP/stripped"
	strip "$TMP/stripped" 2>/dev/null
	if nm "$BIN/$tool" 2>/dev/null | grep -Eq '__asan_init|__gcov'; then
		skip "$tool has at most 1 MB" "a sanitizer is built in"
	else
		below "$tool has at most 1 MB" "$(wc -c <"$TMP/stripped")" 1000000
	fi
done
chmod -R a-w "$stage/opt"
cp "$TMP/path.cl" "$TMP/elsewhere/path.cl"
chmod a-w "$TMP/elsewhere"
chmod a+rx "$TMP"
nobody=
[ "$(id -u)" -ne 0 ] || nobody="setpriv --reuid 65534 --regid 65534 --clear-groups"
if [ -n "$nobody" ] && ! $nobody true 2>/dev/null; then
	skip "a tool in a folder that is only read" "no setpriv"
else
	# shellcheck disable=SC2086 # words
	ok "a tool in a folder that is only read" \
		elsewhere $nobody "$stage/opt/mill/bin/ncpost" -c siemens -m table-bc path.cl
fi
chmod -R u+w "$stage/opt" "$TMP/elsewhere"
ok "make uninstall DESTDIR=" build uninstall PREFIX=/opt/mill DESTDIR="$stage"
files "$stage" >"$TMP/found"
empty "uninstall leaves no file there" "$TMP/found"

# ---- a tarball, with git or without

cp -R "$SRC"/[A-Z]* "$SRC"/.[a-z]* "$SRC/src" "$SRC/include" "$SRC/machines" "$SRC/tools" \
	"$SRC/controls" "$SRC/man" "$SRC/samples" "$SRC/completions" "$SRC/debian" "$TMP/stage"
rm -rf "$stage/.git"
mkdir -p "$stage/tests"
echo scratch >"$stage/notes"
dist() { "${MAKE:-make}" -C "$stage" dist; }
ok "make dist where git knows nothing" dist
version=$(cat "$SRC/VERSION")
ball=$stage/cloudmill-$version.tar.gz
cp "$ball" "$TMP/first.tar.gz"
touch "$stage"/src/*.c
ok "make dist again" dist
same "the same bytes from the same files" "$TMP/first.tar.gz" "$ball"
tar -tzf "$ball" >"$TMP/found"
has "the tarball holds the sources" "^cloudmill-$version/src/ncpost.c\$" "$TMP/found"
hasnt "and nothing that lies about" 'notes|\.tar|/build/' "$TMP/found"
if git -C "$SRC" ls-files >"$TMP/tracked" 2>/dev/null && [ -s "$TMP/tracked" ]; then
	grep -v '^tests/' "$TMP/tracked" | sed "s,^,cloudmill-$version/," | LC_ALL=C sort >"$TMP/want"
	LC_ALL=C sort "$TMP/found" | comm -23 "$TMP/want" - >"$TMP/missing"
	empty "all that git knows is in it" "$TMP/missing"
else
	skip "all that git knows is in it" "no git here"
fi

# ---- one version

for tool in "$BIN"/*; do
	ok "${tool##*/} --version" "$tool" --version
	has "is what the file VERSION says" "^${tool##*/} \(cloudmill\) $version\$" "$TMP/out"
done
has "debian/changelog begins with it" "^cloudmill \\($version-[0-9]+\\)" "$SRC/debian/changelog"
has "a manual that is installed says it" "^\\.Os cloudmill $version\$" "$TMP/page"
has "NEWS begins with it" "^## $version( |\$)" "$SRC/NEWS.md"

done_testing
