#!/bin/sh
# layers.t - the arrows between the folders go one way, what is private stays private, the
# mathematics is pure, and the judge of programs shares nothing with their writers.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
LC_ALL=C
export LC_ALL

# From the ground up: a folder includes its own headers and those of folders further left.
order="base math curve mesh cloud meshing feature nurbs machine gouge arcfit splinefit toolpath \
simulate io stage post ncread verify plot"
# What judges a program, and what it may use: mathematics, itself, and of other folders data alone,
# FOLDER HEADER: what a machine file says, points, meshes and surfaces as read, and what of a scan is
# noise and outliers, about which all stages agree.
judge="simulate ncread verify"
judge_uses="base math $judge"
judge_data="ncread machine/machine.h
ncread machine/control.h
verify cloud/believed.h
verify cloud/judged_scan.h
verify cloud/plan_extent.h
verify cloud/roof.h
verify cloud/steep_facets.h
verify io/cloud/cloud.h
verify io/mesh/
verify io/nurbs/
verify mesh/mesh.h
verify nurbs/patch.h
verify nurbs/tessellate.h"

# arrows: FOLDER FILE HEADER'S-FOLDER HEADER, a line for each include of another folder's header
arrows() {
	find "$SRC/src" "$SRC/include" -name '*.[ch]' | while read -r file; do
		folder=${file#"$SRC"/src/}
		folder=${folder#"$SRC"/include/}
		case $folder in */*) folder=${folder%%/*} ;; *) folder=tools ;; esac
		sed -n 's|^#include "\([a-z]*\)/\(.*\)"|\1 \2|p' "$file" | sed "s|^|$folder ${file#"$SRC"/} |"
	done
}

arrows | sort >"$TMP/arrows"
ok "the includes are found" test "$(wc -l <"$TMP/arrows")" -ge 800

awk -v order="$order" 'BEGIN { n = split(order, o); for (i = 1; i <= n; i++) rank[o[i]] = i; rank["tools"] = n + 1 }
	!($1 in rank) || !($3 in rank) { print $2 ": no such folder: " $1 " or " $3; next }
	rank[$3] > rank[$1] { print $2 " includes " $3 "/" $4 }' "$TMP/arrows" >"$TMP/found"
empty "no folder includes from further right: $order" "$TMP/found"

# uses FOLDER FILE OTHER-FOLDER HEADER lines: those that the judge may not use
not_for_the_judge() {
	awk -v judge="$judge" -v uses="$judge_uses" -v data="$judge_data" 'BEGIN {
			n = split(judge, j, " "); for (i = 1; i <= n; i++) judges[j[i]]
			n = split(uses, u, " "); for (i = 1; i <= n; i++) may[u[i]]
			datas = split(data, d, "\n") }
		$1 in judges && !($3 in may) {
			for (i = 1; i <= datas; i++) if (index($1 " " $3 "/" $4, d[i]) == 1) next
			print $2 " uses " $3 "/" $4 }'
}
not_for_the_judge <"$TMP/arrows" >"$TMP/found"
empty "the judge uses nothing of the writers, and of others only data" "$TMP/found"
echo "verify src/verify/x.c curve biarc.h
ncread src/ncread/x.c machine kinematics.h
simulate src/simulate/x.c math vec.h" | not_for_the_judge >"$TMP/found"
ok "and would be found to" test "$(wc -l <"$TMP/found")" -eq 2
# What the tests' reader of paths is, is in readback.t.

# ---- headers: public ones stand under include/, and another folder or a tool needs them

find "$SRC/include" -name '*.h' | sed "s|^$SRC/include/||" | while read -r header; do
	folder=${header%%/*}
	grep -E -v "^$folder " "$TMP/arrows" | grep -Fq " $folder ${header#*/}" && continue
	# or a public header of its own folder is built on it
	grep -rFlq "#include \"$header\"" "$SRC/include" || echo "include/$header"
done >"$TMP/found"
empty "every public header is needed outside of its folder" "$TMP/found"
grep -rnE '#include "[a-z_]+\.h"' "$SRC/include" >"$TMP/found"
empty "no public header includes a private one" "$TMP/found"
find "$SRC/src" -name '*.h' | while read -r header; do
	grep -rlq "#include \"$(basename "$header")\"" "$(dirname "$header")" || echo "$header"
done >"$TMP/found"
empty "every private header is included" "$TMP/found"

# Within a folder too: no two modules (NAME.c with NAME.h) need each other, by however many steps;
# a folder's door, FOLDER/FOLDER.h, is for all.
one_way="machine post"
for folder in $one_way; do
	for file in "$SRC/src/$folder"/*.[ch] "$SRC/include/$folder"/*.h; do
		module=$(basename "$file" | sed 's/\.[ch]$//')
		sed -n "s|^#include \"\($folder/\)\{0,1\}\([a-z_0-9]*\)\.h\"|$module \2|p" "$file" |
			awk -v door="$folder" '$1 != $2 && $2 != door'
	done >"$TMP/needs"
	ok "the modules of $folder are found" test "$(wc -l <"$TMP/needs")" -ge 10
	tsort "$TMP/needs" 2>"$TMP/found" >"$TMP/order"
	empty "the modules of $folder need each other in one direction" "$TMP/found"
done

# ---- who may do what

pure="math curve mesh cloud meshing feature nurbs gouge arcfit splinefit toolpath simulate"
for folder in $pure; do
	grep -nE '#include <(stdio|unistd|fcntl|signal|time|pthread|getopt)\.h>' "$SRC/src/$folder"/*.[ch]
	grep -nE '\b(exit|abort|printf|fprintf|puts|die|die_error|die_usage|say|note|rand|time|clock)\(' \
		"$SRC/src/$folder"/*.[ch]
done >"$TMP/found"
empty "the mathematics does no input or output and ends nothing" "$TMP/found"
for folder in $order; do
	[ "$folder" = base ] || grep -rnE '\b(exit|abort|die|die_error|die_usage)\(' "$SRC/src/$folder"
done >"$TMP/found"
empty "base alone ends the process" "$TMP/found"
grep -rn 'setlocale' "$SRC/src" >"$TMP/found"
empty "nobody calls setlocale" "$TMP/found"

# What the unit tests make by chance follows $SEED (tests/lib/seed.h), for make check-seeds.  The bits
# that are compared between platforms are always the same; decimals.h has its callers begin.
grep -rlE '6364136223846793005|1664525|1103515245|69069|16807|48271|<< 13;|\b[dls]?rand(om|48)?\(' \
	"$SRC/tests/unit" "$SRC/tests/lib" --include='*.[ch]' | grep -v -e elementary_bits -e /decimals |
	xargs grep -LE 'seed_(step|begin)' >"$TMP/found"
empty "random numbers of the unit tests follow SEED" "$TMP/found"

# What a sanitizer puts into objects and tools is not ours.
nm "$BIN/cloud2mesh" | grep -q '__asan_init' && skip_rest "a sanitizer is built in"
for folder in $pure; do
	ok "objects of $folder are found" test -n "$(find "$BIN/../src/$folder" -name '*.o' 2>/dev/null)"
	nm -A "$BIN/../src/$folder"/*.o 2>/dev/null | grep -E ' [BbDdC] ' | grep -vE '\.part|\.cold' >"$TMP/found"
	empty "$folder has no variables that outlive a call" "$TMP/found"
done

done_testing
