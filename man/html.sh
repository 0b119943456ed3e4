#!/bin/sh
# html.sh FOLDER - the manuals as pages for a browser, with an index; by mandoc.  `make html` calls it.
set -eu
man=$(cd "$(dirname "$0")" && pwd)
command -v mandoc >/dev/null || { echo "html.sh: found no mandoc, expected it on PATH (make deps)" >&2 && exit 1; }
mkdir -p "$1"
cd "$1"

# What is ours is linked, what is of the system is not.
for page in "$man"/*.[157]; do
	file=$(basename "$page")
	mandoc -T html -O style=style.css,man=%N.%S.html "$page" >"$file.html.new"
	mv "$file.html.new" "$file.html"
done
for other in $(grep -ohE 'href="[^"#]*\.html' ./*.[157].html | sed 's/href="//' | sort -u); do
	[ -e "$other" ] || sed -i "s|href=\"${other}[^\"]*\"||g" ./*.html
done

cat >style.css <<'END'
body { font-family: sans-serif; line-height: 1.4; max-width: 48em; margin: 1em auto; padding: 0 1em; color: #222; }
pre, code { font-family: monospace; font-size: 95%; }
pre { background: #f3f3f0; padding: 0.6em 0.8em; overflow-x: auto; }
dd { margin-bottom: 0.5em; }
table.head, table.foot { width: 100%; color: #777; font-size: 85%; }
td.head-vol, td.foot-os { text-align: center; }
td.head-rtitle, td.foot-date { text-align: right; }
a { color: #05609a; }
END

# One line of the index: the page and what its NAME says.
entry() { # PAGE
	file=$(basename "$1")
	printf '<li><a href="%s.html">%s(%s)</a> - %s</li>\n' "$file" "${file%.*}" "${file##*.}" \
		"$(sed -n 's/^\.Nd //p' "$1" | sed -e 's/&/\&amp;/g' -e 's/</\&lt;/g')"
}

{
	cat <<'END'
<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>cloudmill: the manuals</title>
<link rel="stylesheet" href="style.css"></head><body><h1>cloudmill: the manuals</h1>
<p>Begin with <a href="cloudmill.7.html">cloudmill(7)</a>, the overview, and its
<a href="cloudmill.7.html#TUTORIAL">tutorial</a>.</p>
END
	for section in '1 The tools' '5 The files' '7 The whole'; do
		printf '<h2>%s</h2>\n<ul>\n' "${section#* }"
		for page in "$man"/*."${section%% *}"; do entry "$page"; done
		echo '</ul>'
	done
	echo '</body></html>'
} >index.html
echo "$(find . -name '*.html' | wc -l) pages: $PWD/index.html"
