#!/bin/sh
# safety.t - nothing that may harm a machine is in a program: tests/safety/safety.c looks at the text
# of goldens and of random jobs (tests/safety/jobs.sh), which ncverify must accept, too.  A dozen
# jobs here; `make safety` runs SAFETY_JOBS of them, a thousand programs.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

SAFETY=$TMP/safety
export SAFETY
# shellcheck disable=SC2086 # CC may have options
ok "the checker builds" ${CC:-cc} -std=c11 -O2 -o "$SAFETY" "$SRC/tests/safety/safety.c" -lm

# ---- it finds what it looks for
awk 'BEGIN { for (y = -12; y <= 12.001; y += 0.5) for (x = -3; x <= 3.001; x += 0.5)
	printf "%.4f %.4f %.4f\n", x, y, 10 + sin(x / 3) * cos(y / 3) }' >scan.xyz
cloud2mesh -q -t 2 scan.xyz -o scan.ply
meshnorm -q -r 3 --avoid --scallop 0.1 --axis-play 0 scan.ply >path.cl
check() { # PROGRAM
	"$SAFETY" $control "$SRC/machines/table-ac.txt" 3 12 0.05 "$1" scan.xyz 8:30
}
finds() { # KIND "SED": the program changed so has a fault of the kind
	sed -E "$2" good.nc >bad.nc
	if cmp -s good.nc bad.nc; then result 1 "$control: $1 (the fault is not in)"; return; fi
	run check bad.nc
	if grep -q "^$1:" out; then result 0 "$control: found: $1"; else result 1 "$control: found: $1 ($2)"; fi
}
for control in fanuc siemens heidenhain; do
	ncpost -q -c $control path.cl >good.nc
	status 0 "$control: a good program" check good.nc
	case $control in
	fanuc)
		finds spindle 's/ M3$//'
		finds length '/G43\.4/d'
		finds length 's/^(N[0-9]+) G49 G91 G28/\1 G0 Z12.\n&/'
		finds rotary '/G28 Z0/d'
		finds start 's/ Z2[0-9.]+$/ Z12./'
		finds end '$!N;/G49 G91 G28/d;P;D'
		finds low '0,/ G1 /s/ G1 X?/ G0 X0. Y-5. Z10.5\n&/' ;;
	siemens)
		finds spindle 's/ M3$//'
		finds length '/TRAORI/d'
		finds rotary '/SUPA/d'
		finds start 's/ Z2[0-9.]+$/ Z12/' ;;
	heidenhain)
		finds spindle '/^[0-9]+ M3$/d'
		finds length '/FUNCTION TCPM F/d'
		finds rotary '/M91/d'
		finds start 's/ Z\+2[0-9.]+ R0/ Z+12 R0/' ;;
	esac
	# the tool 0.5 deeper, and tilted into the part
	case $control in heidenhain) z='Z\+' ;; *) z=Z ;; esac
	finds ball "s/ ($z)(9|10)\.[0-9]+\$/ \19.0/;s/ ($z)(9|10)\.[0-9]+ / \19.0 /"
done
control=fanuc
ncpost -q -c $control path.cl >good.nc
finds shaft 's/ A-?[1-9][0-9.]*/ A97./'
finds holder 's/ A-?[1-9][0-9.]*/ A80./'

# ---- the goldens, by their words alone
for program in "$SRC"/tests/data/golden/*.*.*; do
	case $program in
	*linuxcnc.ngc) control=linuxcnc machine=linuxcnc-xyzac ;;
	*notcp.nc) control=fanuc machine=table-ac-notcp ;;
	*notcp.ngc) control=linuxcnc machine=table-ac-notcp ;;
	*.nc) control=fanuc machine=table-ac ;;
	*.mpf) control=siemens machine=table-ac ;;
	*.h) control=heidenhain machine=table-ac ;;
	*) continue ;;
	esac
	status 0 "$(basename "$program"): nothing that may harm" \
		"$SAFETY" $control "$SRC/machines/$machine.txt" 1 0 9 "$program"
done

# ---- random jobs
mkdir jobs && cd jobs || exit 1
run sh "$SRC/tests/safety/jobs.sh" ${SAFETY_JOBS:-1 9}
sed 's/^/# /' "$TMP/out"
sums=$(tail -n 1 "$TMP/out")
result "$got" "jobs run: $sums"
# found by such jobs: a polynomial with factors of ten digits; a path that ended under its clearance
# plane, beside an axis that leans more than the last; points that planecut called out of reach and
# ncverify left; a tool that lay under the border of a scan flatter than its curtain's points are
# apart; a link as short as a turn back, whose feed ncverify took for that of the way across
for job in ${SAFETY_FOUND-980007 980273 20332 710025 262308}; do
	run sh "$SRC/tests/safety/jobs.sh" $job $job
	tail -n 1 "$TMP/out" | awk '{ exit !($4 + $6 > 0 && $8 == $4 && $10 == $4) }' # or told by a stage
	result $? "job $job: $(tail -n 1 "$TMP/out")"
done

# jobs N programs N refused-by-a-stage N accepted N safe N
echo "$sums" | awk '{ exit !($4 >= $2 && $8 == $4) }'
result $? "ncverify accepts all of them"
echo "$sums" | awk '{ exit !($10 == $4) }'
result $? "and the checker"

done_testing
