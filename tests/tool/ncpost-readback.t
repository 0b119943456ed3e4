#!/bin/sh
# ncpost-readback.t - the tests' own reader, tested: programs written by hand that follow a path
# written by hand are found to follow it, and every kind of fault in them is found.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

# The path, twice: with an arc in the plane (Fanuc) and in space (Siemens), each with a line on
# which the axis swings by 30 degrees, and a B-spline.  (0.5, 0, 0.866) is A30 C90 and B30 C0.
head_of_path() {
	cat <<-END
		PARTNO/HAND
		UNITS/MM
		MULTAX/ON
		CUTTER/8,4,0,4,0,0,60
		LOADTL/1
		SPINDL/RPM,8000,CLW
		\$\$-> CLOUDMILL/1
		\$\$-> PASS/1
		RAPID
		GOTO/0,0,50,0,0,1
		RAPID
		GOTO/0,0,5,0,0,1
		FEDRAT/MMPM,800
		GOTO/0,0,0,0,0,1
		GOTO/10,0,0,0,0,1
		GOTO/20,0,0,0.5,0,0.866025404
	END
}

tail_of_path() {
	cat <<-END
		GOTO/38,18,5,$1
		\$\$-> PASS/2
		RAPID
		GOTO/38,18,50,$1
		RAPID
		GOTO/38,20,50,$1
		RAPID
		GOTO/38,20,5,$1
		GOTO/38,20,0,$1
		GOTO/30,20,0,$1
		GOTO/20,21,0,$1
		GOTO/20,21,5,$1
		RAPID
		GOTO/20,21,50,$1
		FINI
	END
}

{
	head_of_path
	cat <<-'END'
		CIRCLE/20,10,0,0,0,1,10
		GOTO/30,10,0,0.5,0,0.866025404
		MOVNRB/5AXIS,LENGTH,100
		MOVNRB/ON,4,8,0,4,13
		MOVNRB/1,0,0,0,0,10,10,10,10
		MOVNRB/2,30,10,0,30,14,0,34,18,0,38,18,-1
		MOVNRB/3,80,10,86.6025404,80,14,86.6025404,84,18,86.6025404,88,18,85.6025404
		MOVNRB/NEXT
		GOTO/38,18,-1,0.5,0,0.866025404
		MOVNRB/OFF
	END
	tail_of_path 0.5,0,0.866025404
} >fanuc.cl

# The arc in space: from (20,0,0) about the axis y through (20,*,10), half a turn up to (20,0,20);
# then the spline turns the axis from (0.5, 0, 0.866) back to upright.
{
	head_of_path
	cat <<-'END'
		CIRCLE/20,0,10,0,-1,0,10
		GOTO/30,0,10,0,0,1
		MOVNRB/5AXIS,LENGTH,100
		MOVNRB/ON,4,9,0,5,20
		MOVNRB/1,0,0,0,0,4,10,10,10,10
		MOVNRB/2,30,0,10,30,4,10,34,8,10,38,18,9,38,18,-1
		MOVNRB/3,30,0,110,30,4,110,35,8,109.995,58,18,107,88,18,85.6025404
		MOVNRB/NEXT
		GOTO/38,18,-1,0.5,0,0.866025404
		MOVNRB/OFF
	END
	tail_of_path 0.5,0,0.866025404
} >siemens.cl

cat >fanuc.nc <<'END'
%
O0001(HAND)
N10 G90 G17 G21 G40 G49 G80 G94 G54
N20 G53 G0 Z0.
N30 T1 M6
N40 S8000 M3
N50 G0 A0. C90.
N60 G43.4 H1
N70 X0. Y0. Z50.
N80 Z5.
N90 G1 Z0. F800.
N100 X10.
N110 X20. A30.
N120 G3 X30. Y10. I0. J10.
N130 G6.2 P4 K0. X30. Y10. Z0. A30. C90.
N140 K0. X30. Y14. Z0. A30. C90.
N150 K0. X34. Y18.
N160 K0. X38. Z-1.
N170 K10.
N180 K10.
N190 K10.
N200 K10.
N210 G1 Z5.
N220 G0 Z50.
N230 Y20.
N240 Z5.
N250 G1 Z0.
N260 X30.
N270 X20. Y21.
N280 Z5.
N290 G0 Z50.
N300 G49
N310 G53 Z0. (UP)
N320 M5
N330 M30
%
END

# The same as vectors: no G06.2 under G43.5, so the spline goes as its own chords.
sed -e 's/G43.4/G43.5/' -e 's/^\(N70.*\)/\1 I0. J0. K1./' -e 's/A30\./I.5 J0. K.866025/' \
	-e 's/I0\. J10\./R10./' -e '/^N1[3-9]0\|^N200/d' fanuc.nc >vectors.nc
awk 'BEGIN { for (i = 1; i <= 64; i++) { t = i / 64; u = 1 - t
	z = t^3 > 5e-5 ? -t^3 : 0
	printf "N%d G1 X%.4f Y%.4f Z%.4f\n", 130 + i, 30 * u^3 + 90 * u^2 * t + 102 * u * t^2 + 38 * t^3,
	10 * u^3 + 42 * u^2 * t + 54 * u * t^2 + 18 * t^3, z } }' >chords
sed -i '/^N120/r chords' vectors.nc

cat >siemens.mpf <<'END'
%_N_HAND_MPF
; by hand
N10 G90 G17 G71 G40 G94 G54
N20 SUPA G0 Z0 D0
N30 T="BALL8" D1 M6
N40 S8000 M3
N50 TRAORI
N60 ORIWKS ORIVECT
N70 G0 X0 Y0 Z50 A3=0 B3=0 C3=1
N80 Z5
N90 G1 Z0 F800
N100 X10
N110 X20 A3=0.5 B3=0 C3=0.8660254
N120 CIP X30 Y0 Z10 I1=AC(27.0710678) J1=AC(0) K1=AC(2.9289322) A3=0 B3=0 C3=1
N130 ORICURVE UPATH
N140 G1 X30 Y0 Z10 XH=30 YH=0 ZH=110
N150 POLY PO[X]=(34.6656,0.6816,-0.1224) PO[Y]=(8.64,0.1,0.01) PO[Z]=(9.5,0.5,0.25) PL=4 PO[XH]=(1,2,3) PO[YH]=(1) PO[ZH]=(2)
END
# The spline as two polynomials, worked out in awk by de Boor's scheme and its derivatives.
awk 'function boor(k, u, c,    i, j, d, s) {
	for (i = 0; i < 4; i++) d[i] = pole[c, k - 3 + i]
	for (j = 1; j < 4; j++) for (i = 3; i >= j; i--) {
		s = (u - knot[k - 3 + i]) / (knot[k + 1 + i - j] - knot[k - 3 + i])
		d[i] = d[i - 1] * (1 - s) + d[i] * s }
	return d[3] }
function word(c, k,    a, h, f0, f1, f2, f3, d3, d2) {
	a = knot[k]; h = (knot[k + 1] - a) / 3
	f0 = boor(k, a, c); f1 = boor(k, a + h, c); f2 = boor(k, a + 2 * h, c); f3 = boor(k, a + 3 * h, c)
	d3 = (f3 - 3 * f2 + 3 * f1 - f0) / (6 * h^3)
	d2 = (f2 - 2 * f1 + f0) / (2 * h^2) - 3 * h * d3
	if (d2 < 0 && d2 > -5e-9) d2 = 0
	if (d3 < 0 && d3 > -5e-9) d3 = 0
	return sprintf(" PO[%s]=(%.6f,%.8f,%.8f)", c, f3, d2, d3) }
BEGIN {
	split("0 0 0 0 4 10 10 10 10", n); for (i = 0; i < 9; i++) knot[i] = n[i + 1]
	split("X 30 30 34 38 38 Y 0 4 8 18 18 Z 10 10 10 9 -1 XH 30 30 35 58 88 YH 0 4 8 18 18 " \
		"ZH 110 110 109.995 107 85.6025404", p)
	for (c = 0; c < 6; c++) for (i = 0; i < 5; i++) pole[p[c * 6 + 1], i] = p[c * 6 + i + 2]
	for (k = 3; k < 5; k++) {
		printf "N%d POLY", 110 + 40 + 10 * (k - 3)
		for (c = 0; c < 6; c++) printf "%s", word(p[c * 6 + 1], k)
		print " PL=" knot[k + 1] - knot[k] } }' >poly
cat >rest <<'END'
N170 ORIVECT
N180 G1 Z5 A3=0.5 B3=0 C3=0.8660254
N190 G0 Z50
N200 Y20
N210 Z5
N220 G1 Z0
N230 X30
N240 X20 Y21
N250 Z5
N260 G0 Z50
N270 TRAFOOF
N280 SUPA G0 Z0 D0
N290 M5
N300 M30
END
sed -i '/^N150/d' siemens.mpf
cat poly rest >>siemens.mpf

follows() { # DESC FILE OPTIONS...
	desc=$1 file=$2
	shift 2
	ok "$desc" "$READBACK" "$@" "$file"
}

follows "Fanuc: G43.4, arc and G06.2 follow the path" fanuc.nc -c fanuc --path fanuc.cl
follows "Fanuc: G43.5, R and chords follow the path" vectors.nc -c fanuc --path fanuc.cl -e 0.002
follows "Siemens: vectors, CIP and POLY follow the path" siemens.mpf -c siemens --path siemens.cl

# Small letters are words too; a G word that nothing is known of is told, and moves nothing.
sed -e 's/^N260 X30\./N260 x30./' fanuc.nc >small.nc
status 0 "Fanuc: a small letter" "$READBACK" -c fanuc --path fanuc.cl small.nc
sed -e 's/^N260 X30\./N255 G199\nN260 X30./' fanuc.nc >small.nc
status 1 "Fanuc: an unknown G word" "$READBACK" -c fanuc --path fanuc.cl small.nc
has "... and says so" 'small\.nc:[0-9]+: N255: found G199, which this reader does not know' err
sed -e 's/^N260 X30\./N260 x30.02/' fanuc.nc >small.nc
status 3 "Fanuc: what a small letter moves is judged" "$READBACK" -c fanuc --path fanuc.cl small.nc

# The same by B and C: (sin B cos C, sin B sin C, cos B).
sed -e 's/A0\. C90\./B0. C0./' -e 's/A30\. C90\./B30. C0./' -e 's/A30\./B30./' fanuc.nc >bc.nc
follows "Fanuc: B and C" bc.nc -c fanuc --axes bc --path fanuc.cl

# A uniform B-spline, its first pole where the tool is; here the knots are 0 0 0 0 1 2 2 2 2.
sed -e 's/0,0,0,0,4,10,10,10,10/0,0,0,0,1,2,2,2,2/' siemens.cl >uniform.cl
{
	sed '/^N150/,$d' siemens.mpf
	cat <<-'END'
		N150 BSPLINE SD=3 X30 Y4 Z10 XH=30 YH=4 ZH=110
		N152 X34 Y8 Z10 XH=35 YH=8 ZH=109.995
		N154 X38 Y18 Z9 XH=58 YH=18 ZH=107
		N156 X38 Y18 Z-1 XH=88 YH=18 ZH=85.60254
	END
	cat rest
} >bspline.mpf
follows "Siemens: BSPLINE on uniform knots" bspline.mpf -c siemens --path uniform.cl

# Without tool centre point control: the tip in the machine, the table turned under it.
cat >table.cl <<'END'
PARTNO/TABLE
UNITS/MM
MULTAX/ON
CUTTER/8,4,0,4,0,0,60
RAPID
GOTO/0,0,50,0.5,0,0.866025404
FEDRAT/MMPM,800
GOTO/0,0,0,0.5,0,0.866025404
GOTO/10,0,0,0.5,0,0.866025404
GOTO/10,6,3,0.5,0,0.866025404
RAPID
GOTO/10,6,50,0.5,0,0.866025404
FINI
END
cat >table.nc <<'END'
%
O0002
G90 G17 G21 G40 G49 G80 G94 G54
G91 G28 Z0.
G90
T1 M6
S8000 M3
G0 A30. C90.
G43 H1 X0. Y25. Z43.3013
G93 G1 X0. Y0. Z0. F16.
X0. Y-8.6603 Z5. F80.
X6. Y-7.1603 Z7.5981 F119.257
G94
G0 X6. Y16.3397 Z48.3013
G49
G91 G28 Z0.
M5
M30
%
END
follows "no TCP: the table's turn is taken back" table.nc -c fanuc --no-tcp --path table.cl

# --- faults: each must be found, with its place ------------------------------------------------

broken() { # STATUS DESC MESSAGE FILE SED [control]: the program with this change
	sed -e "$5" "$4" >bad.prog
	cmp -s "$4" bad.prog && { echo "not ok - $2: the change does not fit"; test_failed=1; return; }
	case $4 in *.nc) set -- "$@" fanuc fanuc.cl ;; *) set -- "$@" siemens siemens.cl ;; esac
	status "$1" "$2" "$READBACK" -c "$6" --path "$7" bad.prog
	has "... and says so: $3" "$3" err
}

# the way
broken 3 "a block left out" "N110.*beyond" fanuc.nc '/^N100 /d'
broken 3 "a block left out (Siemens)" "N240.*beyond" siemens.mpf '/^N230 /d'
broken 3 "two blocks swapped" "N270.*beyond|N260.*beyond" fanuc.nc \
	's/^N260 X30\./N260 X20. Y21./; s/^N270 X20\. Y21\./N270 X30. Y20./'
broken 3 "a pass left out" "fanuc.cl: line" fanuc.nc '/^N2[4-8]0 /d'
broken 3 "a point 0.02 off" "N270.*beyond" fanuc.nc 's/^N270 X20\./N270 X20.02/'
broken 3 "a tool axis 0.1 degrees off" "N110.*beyond" fanuc.nc 's/A30\./A30.1/'
broken 3 "a rotary axis turning the wrong way" "N110.*beyond" fanuc.nc 's/A30\./A-30./'
broken 3 "an arc the wrong way round" "N120.*beyond" fanuc.nc 's/^N120 G3/N120 G2/'
broken 3 "a middle point on the other side" "N120.*beyond" siemens.mpf 's/K1=AC(2.92/K1=AC(-2.92/'
broken 3 "a spline's pole off" "N150.*beyond" fanuc.nc 's/^N150 K0. X34\./N150 K0. X34.1/'
broken 3 "a polynomial's length wrong" "N160.*beyond" siemens.mpf '/^N160/s/PL=6/PL=5/'
broken 3 "a second point off" "N160.*beyond" siemens.mpf '/^N160/s/PO\[XH\]=(88/PO[XH]=(89/'
broken 3 "a tool vector wrong" "N110.*beyond" siemens.mpf '/^N110/s/A3=0.5/A3=-0.5/'
broken 3 "a rapid move into the part" "N230.*not in the path" fanuc.nc 's/^N230 Y20\./N230 Y20. Z1./'
broken 3 "a retract left out" "no rapid move" fanuc.nc '/^N290 /d'
broken 3 "a feed move made a rapid one" "beyond" fanuc.nc 's/^N260 X30/N260 G0 X30/; s/^N270 X/N270 G1 X/'

# what the control refuses, or what leaves it open where the tool goes
# shellcheck disable=SC2016 # $d is sed's
broken 1 "a program cut off" "without M30" fanuc.nc '/^N270 /,$d'
# shellcheck disable=SC2016
broken 1 "a program without its last %" "without %" fanuc.nc '$d'
broken 1 "no M30" "without M30|behind M30|N330|%" fanuc.nc '/M30/d'
broken 1 "no M30 (Siemens)" "without M30" siemens.mpf '/M30/d'
broken 1 "blocks behind M30" "M30" fanuc.nc 's/^N320 M5/N320 M5\nN325 M30/'
broken 1 "an exponent" "N270.*exponent" fanuc.nc 's/^N270 X20\./N270 X2.E1/'
broken 1 "minus zero" "N250.*minus zero" fanuc.nc 's/^N250 G1 Z0\./N250 G1 Z-0.000/'
broken 1 "a word without its decimal point" "N260.*decimal point" fanuc.nc 's/^N260 X30\./N260 X30/'
broken 1 "not a number" "N260.*number" fanuc.nc 's/^N260 X30\./N260 Xnan/'
broken 1 "a G word of an interpolation that is not read" "N260.*found G12\.1" fanuc.nc 's/^N260/N260 G12.1/'
broken 1 "an unknown word (Siemens)" "N230.*know" siemens.mpf 's/^N230/N230 SPIRAL/'
broken 1 "a rotary axis that the machine has not" "N110.*know" fanuc.nc 's/A30\./B30./'
broken 1 "a word twice" "N260.*twice" fanuc.nc 's/^N260 X30\./N260 X30. X31./'
broken 1 "block numbers that fall" "N100.*rise" fanuc.nc 's/^N110/N100/'
broken 1 "a comment in a comment" "comment" fanuc.nc 's/(UP)/(UP (AND AWAY))/'
broken 1 "no feed" "N90.*feed" fanuc.nc 's/ F800\.//'
broken 1 "no spindle" "spindle" fanuc.nc 's/ M3$//'
broken 1 "no tool centre point control" "N90.*tool centre point" fanuc.nc '/G43/d'
broken 1 "TRAORI left on" "TRAORI" siemens.mpf '/TRAFOOF/d; /SUPA/d'
broken 1 "retract to G53 under tool centre point control" "G53 under" fanuc.nc '/G49$/d'
broken 1 "an arc whose radius differs" "N120.*distance" fanuc.nc 's/J10\./J9.9/'
broken 1 "a spline that starts elsewhere" "N130.*first pole" fanuc.nc '/^N130/s/Y10\./Y11./'
broken 1 "a spline with a knot too few" "N210.*not complete|N200" fanuc.nc '/^N200 /d'
broken 1 "two of the three vector words" "N110.*three" siemens.mpf '/^N110/s/B3=0 //'
broken 1 "CIP without its middle point" "N120.*I1" siemens.mpf '/^N120/s/I1=AC([0-9.]*) //'
broken 1 "ORICURVE from an unknown second point" "N150.*second point" siemens.mpf '/^N140/d'
broken 1 "inverse time feed without F" "N100.*inverse" fanuc.nc 's/^N90 G1/N90 G93 G1/'

# the ball
printf '10 0 0\n30 20 -1\n' >scan.xyz
status 0 "the ball over a scan that it does not touch" \
	"$READBACK" -c fanuc --path fanuc.cl --scan scan.xyz --deeper 0.001 fanuc.nc
printf '30 20 0.5\n' >>scan.xyz
status 3 "the ball in a point of the scan" \
	"$READBACK" -c fanuc --path fanuc.cl --scan scan.xyz --deeper 0.1 fanuc.nc
has "... is found as deep as it is, at its block" 'deepest 1.029[0-9]* mm at N270' out

done_testing
