#!/bin/sh
# ncverify-lost.t - words that somebody took out of a program before it cuts, or the wrong tool:
# what was on before stays on, another tool cuts, or its length is none.  Its head and the file of
# its control tell, without a path.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

awk 'BEGIN { for (y = -5; y <= 5.001; y += 0.5) for (x = -7; x <= 7.001; x += 0.5)
	printf "%.5f %.5f %.5f\n", x, y, 2 - (x * x + y * y) / 60 }' >dome.xyz
cloud2mesh -q -t 2 -o dome.ply dome.xyz
meshnorm -q -r 5 --scallop 0.2 -o dome.cl dome.ply
bsplfit -q -o curve.cl dome.cl

post() { # CONTROL MACHINE [OPTION ...]
	control=$1 machine=$2
	shift 2
	ncpost -q -c "$control" -m "$machine" -o good.nc "$@"
}
judge() { # STATUS DESC PROGRAM [OPTION ...]
	expected=$1 desc=$2 program=$3
	shift 3
	status "$expected" "$control: $desc" \
		ncverify -o report -g dome.xyz -m "$machine" "$@" "$program"
}
# lost SED MESSAGE [DESC]: by a change that leaves the numbers of all blocks as they are
lost() {
	sed -E "$1" good.nc >bad.nc
	if cmp -s good.nc bad.nc; then result 1 "$control: $1 changes nothing"; fi
	judge 3 "${3:-$1}" bad.nc
	has "$control: $1 is told with its block" "^ncverify: bad.nc: N[0-9]+ \(line [0-9]+\): $2" err
}

# ---- modal words of its start
all=' before it, which the control.s file has'
post fanuc table-ac dome.cl
lost 's/^(N[0-9]+) G69$/\1/' "cuts without G69$all at its start"
for c in fanuc haas okuma siemens linuxcnc; do
	machine=table-ac
	[ $c = linuxcnc ] && machine=linuxcnc-xyzac
	post $c $machine dome.cl
	judge 0 "the good program" good.nc
	for g in 17 40 94; do
		lost "1,/ G$g /s/ G$g / /" "cuts without G$g$all at its start"
	done
	judge 0 "its head is left aside" bad.nc --accept
done
post linuxcnc linuxcnc-xyzac dome.cl
lost 's/^(N[0-9]+) G64 P.*/\1/' "cuts without G61 or G64$all" "corners within no tolerance"
post linuxcnc linuxcnc-xyzac --set smooth=no dome.cl
judge 0 "G61 in place of G64" good.nc
lost 's/^(N[0-9]+) G61$/\1/' "cuts without G61 or G64$all" "without it"
post siemens table-ac dome.cl
lost 's/ORIWKS //' "cuts without ORIWKS$all after TRAORI"

lost '1,/TRAFOOF/s/^(N[0-9]+) TRAFOOF$/\1/' "cuts without TRAFOOF$all at its start"
lost '1,/CYCLE800/s/^(N[0-9]+) CYCLE800\(\)$/\1/' "cuts without CYCLE800$all at its start"
post heidenhain table-ac dome.cl
lost 's/^([0-9]+) PLANE RESET STAY$/\1 ;/' "cuts without PLANE RESET$all at its start"
lost '1,/RESET TCPM/s/^([0-9]+) FUNCTION RESET TCPM$/\1 ;/' \
	"cuts without FUNCTION RESET TCPM$all at its start"
meshnorm -q -r 5 --scallop 0.2 --fixed 0,0,1 -o up.cl dome.ply
for c in heidenhain siemens; do
	post $c three-axis up.cl
	judge 0 "a machine that turns nothing has no plane to reset" good.nc
done

# ---- where the rotary axes stand when tool centre point control goes on; a way home of no axis
for c in fanuc siemens heidenhain; do
	post $c table-ac dome.cl
	lost 's/^(N?[0-9]+) (G0 A.*C.*|L A\+0 C\+0 R0 FMAX)$/\1 ;/' \
		"tool centre point control goes on before all rotary axes go to where they start"
done
post fanuc table-ac dome.cl
lost 's/^(N[0-9]+) G91 G28 Z0\.$/\1 G91 G28/' "goes home without an axis"

# ---- the tool, its edge and its length
sed 's/G43.4 H1/G43.4 H2/' good.nc >bad.nc
judge 0 "another length may be meant" bad.nc
has "but it is told" 'notice: .*tool 1 cuts with the length of another number, 2' err
sed 's/^LOADTL.*/LOADTL\/1,ADJUST,2/' dome.cl >other.cl
post fanuc table-ac other.cl
judge 0 "as the path asks for" good.nc -p other.cl
hasnt "nothing is told" 'another number' err
post heidenhain table-ac dome.cl
awk '/TOOL CALL 1 / { call = $0; sub(/^[0-9]+ /, "", call) } { print } NR > 60 && !done++ {
	print $1 + 0, call }' good.nc | awk '{ $1 = NR - 1; print }' >bad.nc
judge 3 "the tool is called amid a cut" bad.nc
has "is told" 'N[0-9]+ .*: a tool is called where tool centre point control is on' err
for c in fanuc siemens linuxcnc; do
	machine=table-ac
	[ $c = linuxcnc ] && machine=linuxcnc-xyzac
	post $c $machine dome.cl
	lost 's/ T1 (D1 )?M6/ T1 \1/' "cuts without M6$all with the tool"
	lost 's/ T1 / /' "the program's head says tool 1, it calls none"
	judge 3 "nor with a path" bad.nc -p dome.cl
	lost 's/ T1 / T2 /' "the program's head says tool 1, it takes tool 2"
done
post heidenhain table-ac dome.cl
lost 's/CALL 1 /CALL 2 /' "the program's head says tool 1, it takes tool 2"
lost 's/CALL 1 /CALL /' "the program's head says tool 1, it calls none"
post siemens table-ac dome.cl
lost 's/ D1 M6/ M6/' "cuts without D1$all with the tool"
lost 's/ D1 M6/ D2 M6/' "cuts without D1$all with the tool"
post fagor table-ac dome.cl
lost 's/ D1 M6/ M6/' "cuts without D$all with the tool"
sed 's/ D1 M6/ D2 M6/' good.nc >bad.nc
judge 3 "another length than the path's" bad.nc -p dome.cl
has "fagor: is told" 'N[0-9]+ .*: the path is for the length H1, the program switches on H2' err
for c in fanuc haas okuma hurco; do
	machine=table-ac
	[ $c = fanuc ] && machine=table-ac-notcp
	post $c $machine dome.cl
	lost 's/(G43|G234|G169 .*) H1/\1/' "the tool's length goes on without its number, H"
done
post hurco table-ac dome.cl
sed -E 's/^(N[0-9]+) M129$/\1/' good.nc >bad.nc
judge 1 "TCPM that is not off at the end" bad.nc
has "is refused" 'bad.nc:[0-9]+: N[0-9]+: G28 or G53 under tool centre point control' err
lost 's/ G43 H1 / /' "cuts without G43$all in its approach"
post linuxcnc linuxcnc-xyzac dome.cl
sed 's/G43 H1 /G43 /' good.nc >bad.nc
judge 0 "which takes the tool's own length" bad.nc
lost 's/ G53 G0 Z0\.$/ G0 Z0./' "a rapid move to a place of the work without the tool's length"

# ---- the spindle
for c in fanuc siemens heidenhain linuxcnc; do
	machine=table-ac
	[ $c = linuxcnc ] && machine=linuxcnc-xyzac
	post $c $machine dome.cl
	lost 's/^(N?[0-9]+ .*)?M3$/\1M4/' "the spindle turns anticlockwise, and .*SPINDLE: CCLW"
	judge 0 "its head is left aside" bad.nc --accept
	lost 's/ S8000//' "cuts before a speed of the spindle, S, is said"
	awk '/T1 (D1 )?M6$|TOOL CALL/ { change = $0; n = $1; sub(/^[^ ]* /, "", change); next }
		change { m = $1; sub(/^[^ ]* /, ""); print n, $0; print m, change; change = ""; next }
		{ print }' good.nc >bad.nc
	judge 1 "M3 before the tool is changed" bad.nc
	has "$c: is refused" 'cuts while the spindle is off' err
	sed 's/CLW/CCLW/' dome.cl >left.cl
	post $c $machine left.cl
	has "$c: the head says it" 'SPINDLE: CCLW' good.nc
	judge 0 "as the path asks for" good.nc
done

# ---- a file of a control of one's own, which has other words
sed '/^G90 G17/d; s/G40 G49 G80 G94/G80 G94/; s/M6$/M66/' "$SRC/controls/fanuc.txt" >own.txt
post ./own.txt table-ac dome.cl
judge 0 "without G40 and M6 in it" good.nc -c ./own.txt

# ---- a change of the tool within a spline; DC() beyond a turn
post siemens table-ac curve.cl
awk '{ print } /BSPLINE|SD=3/ && !done++ { print "M6" }' good.nc >bad.nc
if cmp -s good.nc bad.nc; then skip "no BSPLINE here"; else
	judge 1 "M6 amid a spline" bad.nc
	has "is refused" 'bad.nc:[0-9]+: (N[0-9]+: )?a change of the tool amid a spline' err
fi
sed 's/C=DC(\([0-9.]*\))/C=DC(-\1)/; s/DC(-0)/DC(361)/' good.nc >bad.nc
judge 1 "DC() of another turn" bad.nc
has "is refused" 'N[0-9]+: DC\(\) of less than 0 or more than 360 degrees' err

# ---- what TCPM does between blocks
post heidenhain table-ac dome.cl
lost 's/PATHCTRL AXIS/PATHCTRL VECTOR/' \
	'rotary words under PATHCTRL VECTOR, expected PATHCTRL AXIS'
lost 's/ F TCP / F CONT /' 'F CONT: F is not the speed of the tip where the tool turns'
post heidenhain table-ac --vectors dome.cl
judge 0 "vectors" good.nc
lost 's/PATHCTRL VECTOR/PATHCTRL AXIS/' 'TX TY TZ under PATHCTRL AXIS, expected PATHCTRL VECTOR'

# ---- a tilted plane to which nothing turns the tool
meshnorm -q -r 5 --scallop 0.2 --fixed 0.2,0.1,1 -o fixed.cl dome.ply
for c in fanuc siemens; do
	post $c table-ac --plane fixed.cl
	judge 0 "a tilted plane" good.nc
	sed -E 's/^(N[0-9]+) G53\.1$/\1/; s/(CYCLE800\(.*),1,0,1\)/\1,0,0,1)/' good.nc >bad.nc
	judge 1 "to which the tool is not turned" bad.nc
	has "$c: is refused with the block that cuts" \
		'bad.nc:[0-9]+: N[0-9]+: cuts in a tilted plane to which the tool was not turned' err
done

# ---- far beside the part and back
post fanuc table-ac dome.cl
awk '/^N[0-9]+ X-?[0-9.]+ / && NR > 60 && !done++ { sub(/ X[-0-9.]+/, " X-95.") } { print }' \
	good.nc >bad.nc
judge 3 "a place far beside it" bad.nc
has "is told" 'the ball leaves the part amid a cut, [0-9.]+ mm off it at -9[45]' err
awk '/^N[0-9]+ X/ && NR > 60 && done < 3 { done++; if (done == 1) sub(/ Y[-0-9.]+/, " Y-95.")
	else sub(/ Y[-0-9.]+/, "") } { print }' good.nc >bad.nc
judge 3 "several blocks far beside it" bad.nc
has "are told" 'the ball leaves the part amid a cut, [0-9.]+ mm off it at [-0-9.]+ -9[45]' err

done_testing
