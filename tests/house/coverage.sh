#!/bin/sh
# coverage.sh COVERED - lines of src/ that the tests run, folder by folder, by what lines.sh found
# in COVERED/lines; modules below 90 % by name, folders below it in a line, and the tests that
# failed there.
cd "${1:-build/coverage}" || exit 1
find lines/tests -type f -exec cat {} + | LC_ALL=C sort -u >lines/run
LC_ALL=C comm -12 lines/all lines/run | awk -F: '
	FNR == NR { run[$1]++; next }
	{ lines[$1]++ }
	END { for (file in lines) print file, lines[file], run[file] + 0 }' - lines/all | sort |
	awk '{ folder = $1; sub(/\/[^\/]*$/, "", folder); lines[folder] += $2; run[folder] += $3
		all += $2; any += $3
		if ($3 < 0.9 * $2)
			low[folder] = low[folder] sprintf(" %s:%.0f", substr($1, length(folder) + 2), 100 * $3 / $2) }
	END { for (f in lines) printf "%-18s %5.1f %%%s\n", f, 100 * run[f] / lines[f], low[f]
		for (f in lines) if (run[f] < 0.9 * lines[f]) below = below " " f
		printf "%-18s %5.1f %%\n", "all", 100 * any / all
		printf "%-18s%s\n", "below 90 %:", below == "" ? " no folder" : below }' | sort
find seconds -name '*.exit' | while read -r file; do
	[ "$(cat "$file")" -eq 0 ] || echo "failed: ${file#seconds/}"
done
