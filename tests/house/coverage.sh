#!/bin/sh
# coverage.sh BUILD - lines of src/ that the tests run, folder by folder, from a build with --coverage
# whose tests have run; modules below 90 % by name.  Needs gcovr.
cd "$(dirname "$0")/../.." || exit 1
gcovr -r . --object-directory "${1:-build/coverage}" -f src/ --csv |
	awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) col[$i] = i; next }
	{ file = $col["filename"]; folder = file; sub(/\/[^\/]*$/, "", folder)
	  lines[folder] += $col["line_total"]; run[folder] += $col["line_covered"]
	  if ($col["line_covered"] < 0.9 * $col["line_total"])
		low[folder] = low[folder] sprintf(" %s:%.0f", substr(file, length(folder) + 2),
			100 * $col["line_covered"] / $col["line_total"]) }
	END { for (f in lines) printf "%-18s %5.1f %%%s\n", f, 100 * run[f] / lines[f], low[f] }' | sort
