#!/bin/sh
# diagnostics.t - each tool's page has the sections that a user looks for when something went wrong, and
# each diagnostic that a page names is a message of the sources, word for word; the pages make a
# site of HTML whose links all lead somewhere.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
LC_ALL=C
export LC_ALL

for page in "$SRC"/man/*.1; do
	for section in ENVIRONMENT "EXIT STATUS" EXAMPLES DIAGNOSTICS BUGS; do
		grep -q "^\.Sh $section\$" "$page" || echo "$(basename "$page"): no $section"
	done
done >"$TMP/missing"
empty "every tool's page has ENVIRONMENT, EXIT STATUS, EXAMPLES, DIAGNOSTICS, BUGS" "$TMP/missing"

# All strings of the sources, those that are broken over lines as one, a line each.
{
	find "$SRC/src" -name '*.[ch]' -exec cat {} + | tr '\n' ' ' | sed 's/" *PRI[a-z0-9]* *"/.../g; s/" *"//g' | tr '"' '\n'
	tr '"' '\n' <"$SRC/src/cloudmill.sh"
} >"$TMP/strings"
ok "strings of the sources" test "$(wc -l <"$TMP/strings")" -gt 3000

# The diagnostics of a page as extended regular expressions: what is `...` in it is anything.
for page in "$SRC"/man/*.1; do
	awk '/^\.Sh / { on = $2 == "DIAGNOSTICS" }
		on && /^\.It "/ { n = split($0, part, "\""); for (i = 2; i <= n; i += 2) if (part[i] != "") print part[i] }' "$page" |
		while IFS= read -r text; do
			pattern=$(printf '%s' "$text" | sed -E -e 's/[][()+*?|^$\\{}]/\\&/g' -e 's/ *\.\.\. */\n/g' -e 's/\./\\./g' |
				sed -e ':a' -e 'N' -e '$!ba' -e 's/\n/.*/g')
			echo "$text" >>"$TMP/all"
			grep -Eq -e "$pattern" "$TMP/strings" || echo "$(basename "$page"): $text"
		done
done >"$TMP/unknown"
below "diagnostics in the pages" 50 "$(wc -l <"$TMP/all")"
empty "each is a message of the sources" "$TMP/unknown"

# ---- make html

if ! command -v mandoc >/dev/null; then
	skip "the pages as HTML" "no mandoc"
	done_testing
fi
ok "the pages as HTML" "${MAKE:-make}" -s -C "$SRC" html HTML="$TMP/html"
ok "a page for each, and an index" test "$(find "$TMP/html" -name '*.html' | wc -l)" -eq \
	$(($(find "$SRC/man" -name '*.[157]' | wc -l) + 1))
(cd "$TMP/html" && grep -oE 'href="[^"#]*\.html' ./*.html | sed 's/^\.\/\([^:]*\):href="/\1 /' | sort -u |
	while read -r from to; do [ -e "$to" ] || echo "$from: $to"; done) >"$TMP/dead"
empty "no link leads nowhere" "$TMP/dead"
ok "the index names every page" sh -c "cd '$SRC/man' && for p in *.[157]; do grep -q \"href=\\\"\$p.html\\\"\" '$TMP/html/index.html' || exit 1; done"
done_testing
