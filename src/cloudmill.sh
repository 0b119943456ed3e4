#!/bin/sh
# cloudmill - the whole pipe in one command, for those who do not want to see every stage: it prints
# the commands that it runs, and ends with the verdict of ncverify.  cloudmill(1).
set -u
PATH=$(dirname "$0"):$PATH
export PATH

usage() {
	cat <<'END'
usage: cloudmill SCAN -r MM -c CONTROL -o PROGRAM [options] [-- OPTIONS]
       cloudmill doctor SCAN [-u UNIT]
Makes a 5-axis program from a scan or a CAD model (IGES, STEP, NURBS text), then
checks and draws it.  OPTIONS are those of meshnorm (of planecut for a model).
doctor: says what is in a scan, and which options suit it.

  -r MM          radius of the ball
  -c CONTROL     control to write for, as of ncpost
  -m MACHINE     machine, as of ncpost
  -o PROGRAM     output; beside it a picture (.svg) and the verdict (.html)
  -t MM          spacing of the mesh (default: as the surface needs)
  -s MM          height of the scallops between rows (default: 0.02)
  -e MM          tolerance of each stage (default: 0.01)
  -f arcs|splines|points
                 fit arcs (default), B-splines, or leave the points
  -u UNIT        unit of the scan: mm (default), cm, m, um, inch
  -O             move the origin: smallest x and y of the scan to 0
  -k FOLDER      keep the streams between the stages there
  -n             print the commands and run nothing
  -h, -V         help, version

Exit status: 0 done and accepted, 1 input or output failed, 2 wrong usage,
3 written, but something is not kept, or ncverify refuses it.  man cloudmill
END
}

die() { # STATUS TEXT...
	status=$1
	shift
	echo "cloudmill: $*" >&2
	exit "$status"
}

# A word as a shell reads it again.
quoted() {
	case $1 in
	'' | *[!A-Za-z0-9_./,:=+-]*) printf "'%s'" "$(printf %s "$1" | sed "s/'/'\\\\''/g")" ;;
	*) printf %s "$1" ;;
	esac
}

worst=0

# run COMMAND...: shows it, runs it; 3 is remembered, anything else ends.
run() {
	line='$'
	for word; do line="$line $(quoted "$word")"; done
	echo "$line" >&2
	[ -z "$dry" ] || return 0
	"$@"
	code=$?
	[ $code -ne 3 ] || worst=3
	[ $code -eq 0 ] || [ $code -eq 3 ] || exit $code
	return 0
}

# The three coordinates' ranges and kmax of a mesh: lines `size X Y Z`, `ball R SHARE`.
describe() { # MESH
	awk '
	$1 == "element" && $2 == "vertex" { n = $3 }
	$1 == "property" && $NF == "kmax" { column = properties + 1 }
	$1 == "property" { properties++ }
	/^end_header/ { body = NR; next }
	body && NR <= body + n {
		for (i = 1; i <= 3; i++) {
			if (NR == body + 1 || $i < low[i]) low[i] = $i
			if (NR == body + 1 || $i > high[i]) high[i] = $i
		}
		k[++m] = $column
	}
	END {
		printf "size %.4g %.4g %.4g\n", high[1] - low[1], high[2] - low[2], high[3] - low[3]
		split("0.25 0.5 1 2 3 4 5 6 8 10 12 16 20 25", ball, " ")
		for (i = 1; (i in ball); i++) {
			fits = 0
			for (v = 1; v <= m; v++) fits += k[v] * ball[i] <= 1
			printf "ball %g %.1f\n", ball[i], m ? 100 * fits / m : 0
		}
	}' "$1"
}

doctor() {
	scan=
	unit=
	while [ $# -gt 0 ]; do
		case $1 in
		-u) [ $# -ge 2 ] || die 2 "option -u has no value"; unit=$2 && shift ;;
		-*) die 2 "option $1 is unknown, expected doctor SCAN [-u UNIT]" ;;
		*) [ -z "$scan" ] || die 2 "found a second scan, $1"; scan=$1 ;;
		esac
		shift
	done
	[ -n "$scan" ] || die 2 "found no scan, expected doctor SCAN"
	folder=$(mktemp -d "${TMPDIR:-/tmp}/cloudmill.XXXXXX" 2>/dev/null) ||
		die 1 "no folder can be made in ${TMPDIR:-/tmp}, expected room for files (TMPDIR)"
	trap 'rm -rf "$folder"' EXIT
	cloud2mesh -v ${unit:+-u "$unit"} -o "$folder/mesh.ply" "$scan" 2>"$folder/said"
	code=$?
	[ $code -eq 0 ] || [ $code -eq 3 ] || {
		sed 's/^cloud2mesh: /cloudmill: /' "$folder/said" >&2
		exit $code
	}
	# What the mesh alone is made of is for those who make one.
	sed -e 's/^cloud2mesh: //' -e '/vert[a-z]* .*\(stand at\|moved\|are off\)/d' -e '/^moved by/d' \
		-e '/edges.*, more than/d' -e '/^left out .*facet/d' -e '/ points in, /d' "$folder/said"
	describe "$folder/mesh.ply" >"$folder/found"
	spacing=$(sed -n 's/^comment spacing //p' "$folder/mesh.ply")
	move=$(sed -n 's/.*--origin moves it there$/ -O/p' "$folder/said")
	SCAN=$(quoted "$scan") awk -v spacing="$spacing" -v unit="${unit:+ -u $unit}" -v move="$move" '
	$1 == "size" { for (i = 2; i <= 4; i++) longest = $i > longest ? $i : longest }
	# Balls below 1 mm are for small parts, and none is wider than its part.
	$1 == "ball" && ($2 >= 1 || $2 >= longest / 40) && (!n || 2 * $2 <= longest) {
		share[++n] = $3; ball[n] = $2
		if ($3 == 100) whole = $2
		if ($3 >= 99) most = $2
		if ($3 >= 85) main = n
		if (!least && $2 >= spacing) least = n
	}
	END {
		scan = ENVIRON["SCAN"]
		other = unit ? "" : longest < 1 ? "m" : longest < 10 ? "inch" : longest > 3000 ? "um" : ""
		name["m"] = "metres"; name["inch"] = "inches"; name["um"] = "micrometres"
		if (other) print "unit      the part is " longest " mm long: " name[other] "? Try -u " other
		if (longest < 1 || longest > 3000) {
			print "suggested " (other ? "cloudmill doctor " scan " -u " other : "another unit (-u)")
			exit
		}
		for (i = 1; i <= n; i++)
			list = list sprintf("%s R %g: %g %%", i > 1 ? "," : "", ball[i], share[i])
		print "balls     share of the surface whose hollows a ball fits:" list
		# Hollows narrower than the mesh are not known, and a ball for the last of them takes all
		# day: then the one for most of the surface, and what it leaves is for a smaller one.
		k = !most && main > least ? main : least ? least : n
		r = most >= spacing ? most : ball[k]
		if (whole >= spacing && 2 * whole >= r) r = whole
		if (whole) print "          the largest usual ball that fits everywhere: R " whole
		else print "          none of these fits everywhere; the others leave material there" \
			" (--avoid)"
		print "suggested cloudmill " scan unit move " -r " r " -c CONTROL -o part.nc" \
			(whole >= r ? "" : " -- --avoid")
		if (r != most && r != whole) {
			printf "          R %s fits %s %% of the surface; ", r, share[k]
			print "what it leaves is for a smaller ball"
		}
	}' "$folder/found"
	exit $code
}

scan='' radius='' control='' machine='' output='' spacing='' scallop='' tolerance=0.01 fit=arcs
unit='' keep='' dry='' origin=''
[ "${1:-}" != doctor ] || { shift && doctor "$@"; }
while [ $# -gt 0 ]; do
	case $1 in
	--) shift && break ;;
	-h | --help) usage && exit 0 ;;
	-V | --version) cloud2mesh -V | sed 's/^cloud2mesh/cloudmill/' && exit 0 ;;
	-n) dry=yes && shift && continue ;;
	-O) origin=--origin && shift && continue ;;
	-[rcmotsefuk]) [ $# -ge 2 ] && [ -n "$2" ] || die 2 "option $1 has no value" ;;
	-*) die 2 "option $1 is unknown; options of meshnorm come after --" ;;
	*)
		[ -z "$scan" ] || die 2 "found a second input, $1, expected one"
		scan=$1
		shift
		continue
		;;
	esac
	case $1 in
	-r) radius=$2 ;;
	-c) control=$2 ;;
	-m) machine=$2 ;;
	-o) output=$2 ;;
	-t) spacing=$2 ;;
	-s) scallop=$2 ;;
	-e) tolerance=$2 ;;
	-f) fit=$2 ;;
	-u) unit=$2 ;;
	-k) keep=$2 ;;
	esac
	shift 2
done
[ -n "$scan" ] || { usage >&2 && exit 2; }
[ -n "$radius" ] ||
	die 2 "found no radius of the ball, expected -r MM (cloudmill doctor $scan suggests one)"
[ -n "$control$machine" ] || die 2 "found no control, expected -c CONTROL"
[ -n "$output" ] || die 2 "found no name of the program, expected -o PROGRAM"
case $fit in
arcs | splines | points) ;;
*) die 2 "option -f: found \`$fit', expected arcs, splines or points" ;;
esac
[ -r "$scan" ] || die 1 "$scan: cannot open"
[ -f "$scan" ] || die 1 "$scan: found no file, expected one: it is read more than once"
# Picture and page are beside the program, and nothing is written over another or over the scan.
name=${output##*/}
base=${output%"$name"}${name%.*}
[ -n "${base##*/}" ] || base=$output
[ "$output" != - ] && [ -n "$name" ] || die 2 "option -o: found $output, expected a file's name"
for beside in "$base.svg" "$base.html"; do
	[ "$output" != "$beside" ] ||
		die 2 "option -o: found $output, expected another name: that is the picture's or the page's"
done
for written in "$output" "$base.svg" "$base.html" \
	${keep:+"$keep/mesh.ply" "$keep/path.cl" "$keep/fitted.cl"}; do
	# shellcheck disable=SC3013 # every shell here has it
	[ ! "$scan" -ef "$written" ] || die 2 "$written: found the scan, expected another file to write"
done

if [ -n "$dry$keep" ]; then
	folder=${keep:-streams}
	run mkdir -p "$folder"
else
	folder=$(mktemp -d "${TMPDIR:-/tmp}/cloudmill.XXXXXX" 2>/dev/null) ||
		die 1 "no folder can be made in ${TMPDIR:-/tmp}, expected room for files (TMPDIR)"
	trap 'rm -rf "$folder"' EXIT
	trap 'exit 130' INT TERM
fi
mesh=$folder/mesh.ply path=$folder/path.cl fitted=$folder/path.cl

case $scan in
*.[iI][gG][sS] | *.[iI][gG][eE][sS] | *.[sS][tT][pP] | *.[sS][tT][eE][pP] | *.nurbs)
	[ -z "$origin" ] || die 2 "found -O with a model, expected it with a scan"
	run nurbs2mesh -e "$tolerance" ${unit:+-u "$unit"} -o "$mesh" "$scan"
	run planecut -r "$radius" -e "$tolerance" --scallop "${scallop:-0.02}" \
		${machine:+-m "$machine"} "$@" -o "$path" "$mesh"
	guard=$mesh
	;;
*)
	run cloud2mesh ${spacing:+-t "$spacing"} ${unit:+-u "$unit"} $origin -o "$mesh" "$scan"
	run meshnorm -r "$radius" -e "$tolerance" ${scallop:+--scallop "$scallop"} \
		${machine:+-m "$machine"} "$@" -o "$path" "$mesh"
	guard=$scan
	;;
esac
case $fit in
arcs) fitted=$folder/fitted.cl && run biarcfit -e "$tolerance" -o "$fitted" "$path" ;;
splines) fitted=$folder/fitted.cl && run bsplfit -e "$tolerance" -o "$fitted" "$path" ;;
esac
run ncpost ${control:+-c "$control"} ${machine:+-m "$machine"} -o "$output" "$fitted"
# Of faces and slopes no point knows whether it is of them: gouges alone are judged.
partial=
for option; do
	case $option in
	--faces* | --steep*) partial="--partial --left 1000" ;;
	--box* | --region*) partial=${partial:---partial} ;;
	esac
done
run ncplot ${machine:+-m "$machine"} --cut -o "$base.svg" "$mesh" "$output"
# What is deepest: the path by its tolerance, and motions fitted to it by another.
[ "$guard" != "$mesh" ] || unit=
run ncverify --accept -g "$guard" ${unit:+-u "$unit"} ${control:+-c "$control"} \
	${machine:+-m "$machine"} $partial -r "$radius" \
	-e "$(awk -v e="$tolerance" 'BEGIN { print 2 * e }')" --report "$base.html" "$output"
[ -z "$dry" ] || exit 0
if [ "$code" -eq 3 ]; then
	echo "cloudmill: $output is written, but ncverify refuses it:" \
		"see \`fault' above, and $base.html" >&2
elif [ $worst -eq 3 ]; then
	echo "cloudmill: $output is written, but not all that was asked is kept:" \
		"see UNMET in its head, and $base.html" >&2
else
	echo "cloudmill: $output is written and accepted; look at $base.svg and $base.html" >&2
fi
exit $worst
