#!/bin/sh
# man.t - the manual says what the tools do: pages without lint, every option of --help in its page
# and no other, every key of the machine file, every example runs, HACKING.md knows every folder.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
LC_ALL=C
export LC_ALL

pages=$SRC/man

# ---- the set of pages

for tool in "$BIN"/*; do
	name=$(basename "$tool")
	[ -f "$tool" ] && [ -x "$tool" ] && [ ! -e "$pages/$name.1" ] && echo "$name has no page"
done >"$TMP/found"
empty "every tool has a page" "$TMP/found"

# The table of all options, and a letter that is one name everywhere.
BIN=$BIN sh "$SRC/tests/house/options.sh" >"$TMP/help"
sed -n '/^\.\\" options$/,/^\.\\" end of options$/{/^\.\\"/!p}' "$pages/cloudmill.7" >"$TMP/page"
diff "$TMP/help" "$TMP/page" >"$TMP/found"
empty "cloudmill.7: all options of all tools (tests/house/options.sh --write)" "$TMP/found"
awk '$4 == "Fl" { if ($5 in seen) print $5, seen[$5], $3; seen[$5] = $3 }' "$TMP/help" >"$TMP/found"
empty "a letter is one option" "$TMP/found"

for page in "$pages"/*.1; do
	name=$(basename "$page" .1)
	[ -e "$SRC/src/$name.c" ] || [ -e "$SRC/src/$name.sh" ] || echo "$page is of no tool"
done >"$TMP/found"
empty "every page of section 1 is of a tool" "$TMP/found"

for name in cloudmill.7 cloudmill-mesh.5 cloudmill-path.5 cloudmill-machine.5 cloudmill-control.5 cloudmill-controls.7; do
	ok "$name is there" test -s "$pages/$name"
done

# ---- form

if command -v mandoc >/dev/null; then
	for page in "$pages"/*.[157]; do
		mandoc -T lint -W style "$page" |
			grep -v -e 'referenced manual not found' -e 'operating system explicitly' >"$TMP/found"
		empty "$(basename "$page"): no lint" "$TMP/found"
	done
else
	result 1 "mandoc is installed (make deps)"
fi

# groff takes other words for its macros than mandoc; packagers look at its messages.
if command -v groff >/dev/null && command -v man >/dev/null; then
	for page in "$pages"/*.[157]; do
		# shellcheck disable=SC2069 # the messages alone
		LC_ALL=C.UTF-8 man --warnings -E UTF-8 -l -Tutf8 -Z "$page" 2>&1 >/dev/null
	done >"$TMP/found"
	empty "groff has nothing to say of them" "$TMP/found"
else
	skip "groff has nothing to say of the pages" "no groff or no man"
fi

# Short paragraphs: at most some nine lines of 78 columns.
long_paragraphs() { # PAGE...
	awk 'function flush() { if (n > 600) print FILENAME ": " n " characters: " substr(text, 1, 60); n = 0; text = "" }
	FNR == 1 { flush(); literal = references = 0 }
	/^\.Sh / { references = $2 == "SEE" }
	/^\.Bd -literal/ { flush(); literal = 1 }
	/^\.Ed/ { literal = 0 }
	/^\.(Pp|Sh|Ss|Bl|El|Bd|It)/ { flush(); next }
	!literal && !references && !/^\.\\"/ { n += length($0) + 1; text = text $0 " " }
	END { flush() }' "$@"
}
long_paragraphs "$pages"/*.[157] >"$TMP/found"
empty "no paragraph is longer than some nine lines" "$TMP/found"
{ echo .Pp; yes "A line of text that is far from short, and another." | head -n 13; } >"$TMP/long.7"
long_paragraphs "$TMP/long.7" >"$TMP/found"
ok "one that is would be found" test -s "$TMP/found"

# Each page says which page it is, and refers to pages of ours that there are.
for page in "$pages"/*.[157]; do
	file=$(basename "$page")
	name=${file%.*} section=${file##*.}
	grep -qix "\.Dt $name $section" "$page" || echo "$file: no .Dt $name $section"
	grep -qx "\.Nm $name" "$page" || echo "$file: no .Nm $name"
	sed -n 's/^\.Xr \([^ ]*\) \([157]\).*/\1.\2/p' "$page" | while read -r other; do
		[ -e "$pages/$other" ] || echo "$file: refers to $other"
	done
done >"$TMP/found"
empty "pages carry their names and refer to pages that there are" "$TMP/found"

# ---- options

# Heads of the options as --help has them: `-t --spacing mm`, one a line, arguments in lower case.
options_of_help() { # TOOL
	"$1" --help all | awk '/^  (-|    --)/ {
		line = substr($0, 3)
		if (line ~ /^-[A-Za-z], /) line = substr(line, 1, 2) " " substr(line, 5)
		sub(/^ +/, "", line)
		n = match(line, /--[a-z0-9-]+/)
		head = substr(line, 1, n + RLENGTH - 1)
		rest = substr(line, n + RLENGTH)
		if (rest ~ /^ [^ ]/) { split(rest, w, " "); head = head " " tolower(w[1]) }
		print head
	}' | sort
}

# The same of a page: the .It lines with a Fl in the section OPTIONS.
options_of_page() { # PAGE
	awk '/^\.Sh / { on = $2 == "OPTIONS" }
	on && /^\.It Fl / {
		line = substr($0, 5)
		gsub(/ , /, " ", line); gsub(/Fl /, "-", line)
		gsub(/ (Ar|Cm) /, " ", line); gsub(/ \| /, "|", line)
		match(line, /--[a-z0-9-]+/)
		print substr(line, 1, RSTART + RLENGTH - 1) tolower(substr(line, RSTART + RLENGTH))
	}' "$1" | sort
}

# The numbers that --help gives as defaults: option and number, as `--tilt 15`.
defaults_of_help() { # TOOL
	"$1" --help all | awk '
	function flush() {
		while (match(text, /\((default:? [0-9.]+|[0-9.]+\))/)) {
			value = substr(text, RSTART, RLENGTH)
			gsub(/[^0-9.]/, "", value)
			print name, value
			text = substr(text, RSTART + RLENGTH)
		}
		text = ""
	}
	/^  (-|    --)/ { flush(); match($0, /--[a-z0-9-]+/); name = substr($0, RSTART, RLENGTH) }
	/^$/ { flush(); name = "" }
	name { $1 = $1; text = text " " $0 }'
}

# Those of them that the option's paragraph in the page does not say.
defaults_not_in_page() { # TOOL PAGE
	defaults_of_help "$1" | while read -r name value; do
		awk -v name="${name#--}" -v value="$value" '
		/^\.(It|Sh) / { on = index($0 " ", "Fl -" name " ") > 0 }
		on { gsub(/[(),;]/, " "); gsub(/\.$/, " ")
			for (i = 1; i <= NF; i++) { w = $i; sub(/\.$/, "", w); if (w == value) found = 1 } }
		END { exit !found }' "$2" || echo "$name: no default $value"
	done
}

# Every option that a page names anywhere; `Fl qv` is two.
flags_of_page() { # PAGE
	awk '/^\./ { for (i = 1; i < NF; i++) if ($i == "Fl" || $i == ".Fl") {
		if ($(i + 1) ~ /^-/) print "-" $(i + 1)
		else for (k = 1; k <= length($(i + 1)); k++) print "-" substr($(i + 1), k, 1)
	} }' "$1" | sort -u
}

for page in "$pages"/*.1; do
	name=$(basename "$page" .1)
	tool=$BIN/$name
	[ -x "$tool" ] || continue
	head -c 2 "$tool" | grep -q '^#!' && continue # cloudmill has letters alone
	options_of_help "$tool" >"$TMP/help"
	options_of_page "$page" >"$TMP/page"
	ok "$name --help lists options" test "$(wc -l <"$TMP/help")" -ge 6
	diff "$TMP/help" "$TMP/page" >"$TMP/found"
	empty "$name.1: the options are those of --help, with their arguments" "$TMP/found"
	defaults_not_in_page "$tool" "$page" >"$TMP/found"
	empty "$name.1: defaults are those of --help" "$TMP/found"
	tr ' ' '\n' <"$TMP/help" | grep '^-' | sort >"$TMP/known"
	flags_of_page "$page" | comm -23 - "$TMP/known" >"$TMP/found"
	empty "$name.1: names no option that $name does not have" "$TMP/found"
done

# ---- keys of the machine file: the table in machine.c, with its %c for the axes written out

keys_of_source() {
	grep -oE '(add_[a-z]+|keys_add)\(&?keys, "[a-z.]+"|sizeof name, "[^"]+"' \
		"$SRC/src/machine/machine.c" | sed 's/.*"\(.*\)"/\1/' | while read -r key; do
		case $key in
		%c.m* | %c.acceleration | %c.jerk) for axis in x y z a b c; do echo "$axis${key#%c}"; done ;;
		%c.*) for axis in a b c; do echo "$axis${key#%c}"; done ;;
		*%c) for axis in A B C; do echo "${key%?c}$axis"; done ;;
		*) echo "$key" ;;
		esac
	done
	echo include
	echo base
}

keys_of_page() {
	awk '/^\.Sh / { on = $2 == "KEYS" } on && /^\.It Cm / {
		for (i = 3; i <= NF && $i != "="; i++) if ($i != "," && $i != "Cm") print $i }' \
		"$pages/cloudmill-machine.5" "$pages/cloudmill-control.5"
}

keys_of_source | sort >"$TMP/source"
keys_of_page | sort >"$TMP/page"
ok "the key table is found" test "$(wc -l <"$TMP/source")" -ge 20
diff "$TMP/source" "$TMP/page" >"$TMP/found"
empty "cloudmill-machine.5 and -control.5: the keys are those of machine.c" "$TMP/found"

# ---- examples: each as printed, from the root of the project, where each third point of the middle
# of the panel does for what takes long with all of them

# The n-th block of the section EXAMPLES: a .Dl line, or a .Bd -literal display.
example() { # PAGE N
	awk -v want="$2" '
	/^\.Sh / { on = $2 == "EXAMPLES"; next }
	!on { next }
	/^\.Dl / { n++; if (n == want) print substr($0, 5); next }
	/^\.Bd -literal/ { n++; inside = 1; next }
	/^\.Ed/ { inside = 0; next }
	inside && n == want { print }' "$1" | sed -e 's/^\\&//' -e 's/\\(aq/'"'"'/g' -e 's/\\-/-/g' -e 's/\\e/\\/g'
}

# A tool in the middle of a pipe has an exit status too: these stand in front and take it down.
mkdir "$TMP/front"
for tool in "$BIN"/*; do
	name=$(basename "$tool")
	cat >"$TMP/front/$name" <<END
#!/bin/sh
"$tool" "\$@"
code=\$?
[ \$code -eq 0 ] || echo "$name exits with \$code" >>"$TMP/codes"
exit \$code
END
	chmod +x "$TMP/front/$name"
done

mkdir "$TMP/samples"
ln -s "$SRC/samples"/* "$TMP/samples"
rm "$TMP/samples/panel_17036.xyz"
awk 'NR % 3 == 0 && $1 * $1 < 484 && $2 * $2 < 289' "$SRC/samples/panel_17036.xyz" \
	>"$TMP/samples/panel_17036.xyz"

for page in "$pages"/*.[157]; do
	file=$(basename "$page")
	n=1
	while example "$page" $n >"$TMP/script" && [ -s "$TMP/script" ]; do
		if grep -q 'parallel\.sh' "$TMP/script" && ! command -v parallel >/dev/null; then
			skip "$file: example $n runs" "no GNU parallel"
			n=$((n + 1))
			continue
		fi
		rm -rf "$TMP/root" "$TMP/codes"
		mkdir "$TMP/root"
		ln -s "$TMP/samples" "$SRC/machines" "$TMP/root"
		run env PATH="$TMP/front:$PATH" sh -c "cd '$TMP/root' && . '$TMP/script'"
		[ -s "$TMP/codes" ] && cat "$TMP/codes" >>"$TMP/err" && got=1
		result "$got" "$file: example $n runs: $(head -n 1 "$TMP/script" | cut -c 1-60)"
		n=$((n + 1))
	done
	ok "$file has examples" test $n -gt 1
done

# A line that a terminal would break, or cut, cannot be taken over as it stands.
for page in "$pages"/*.[157]; do
	awk -v page="$(basename "$page")" '
	/^\.Sh / { on = $2 == "EXAMPLES" }
	/^\.Bd -literal/ { inside = 1; next }
	/^\.Ed/ { inside = 0 }
	on && (inside || /^\.Dl /) {
		line = $0; sub(/^\.Dl /, "", line); gsub(/\\e/, "\\", line)
		if (length(line) > 67) print page ": " line
	}' "$page"
done >"$TMP/found"
empty "examples fit on a line of 78" "$TMP/found"

# The sample at the top of cloudmill-path.5 is a path.
awk '/^\.Bd -literal/ { on = 1; next } /^\.Ed/ { exit } on' "$pages/cloudmill-path.5" >"$TMP/sample.cl"
ok "cloudmill-path.5: the sample is read" biarcfit -q "$TMP/sample.cl"
same "and written as it stands" "$TMP/sample.cl" "$TMP/out"

# ---- the map of the house

find "$SRC/src" -mindepth 1 -type d | sed "s|^$SRC/||" | while read -r folder; do
	grep -q "$folder/" "$SRC/HACKING.md" || echo "$folder"
done >"$TMP/found"
empty "HACKING.md names every folder" "$TMP/found"

done_testing
