#!/bin/sh
# ncpost-head.t - what a program says at its head, in the comments of each control: the tool as
# ncverify reads it back, scallop and tolerance, the scans, and what was assumed.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

long="a scan with a name so long that no line of a program can hold it whole, however.xyz"
cat >tool.cl <<END
UNITS/MM
CUTTER/10,5
LOADTL/1
SPINDL/RPM,8000,CLW
\$\$-> CLOUDMILL/1
\$\$-> TOOL/FLUTE,20,HOLDER,5:60
\$\$-> LEDGER/meshnorm,0.004
\$\$-> SCALLOP/0.02
\$\$-> SCAN/26493,0123456789abcdef,$long
FEDRAT/MMPM,800
GOTO/0,0,0
GOTO/10,0,0
FINI
END
sed 's/^CUTTER.*/CUTTER\/10,2/; /\$\$->/d' tool.cl >flat.cl
sed 's/TOOL\/.*/TOOL\/BALL-ONLY/; /SCALLOP\|SCAN/d' tool.cl >ball.cl
head_of() { # CONTROL PATH: its comments without numbers and signs around
	ncpost -q -c "$1" "$2" >program
	sed -n 's/^[0-9 ]*\(;\|(\) *\([A-Z+]*:\)/\2/p' program | sed 's/)$//'
}
for control in fanuc siemens heidenhain linuxcnc; do
	head_of $control tool.cl >head.txt
	has "$control: the tool with flute and holder" '^TOOL: BALL R5 FLUTE 20 HOLDER 5:60$' head.txt
	has "$control: scallop and tolerance" '^SCALLOP: 0\.02 TOLERANCE: 0\.00[4-9][0-9]?$' head.txt
	printf '26493,0123456789abcdef,%s\n' "$long" | tr a-z A-Z >want
	sed -n 's/^SCAN+*: //p' head.txt | tr a-z A-Z | tr '\n' ' ' | sed 's/ $//' >got
	echo >>got
	same "$control: the scan, in as many lines as it needs" want got
	awk '/^[0-9 ]*[;(]/ && length > 84 { exit 1 }' program
	result $? "$control: no line of the head is longer than a control takes"
	head_of $control flat.cl >head.txt
	has "$control: a tool that is no ball" '^TOOL: CUTTER D10 R2$' head.txt
	hasnt "$control: no scallop is said where there is none" SCALLOP head.txt
	has "$control: the tolerance alone" '^TOLERANCE: [0-9.]+$' head.txt
	head_of $control ball.cl >head.txt
	has "$control: the ball alone" '^TOOL: BALL R5 BALL-ONLY$' head.txt
	hasnt "$control: no noise is said where the path says none" NOISE head.txt
	sed 's/^.*SCAN/$$-> NOISE\/0.0125\n&/' tool.cl >noisy.cl
	head_of $control noisy.cl >head.txt
	has "$control: the noise that the scan was said to have" '^NOISE: 0\.0125$' head.txt
done

# ---- names of programs, the shortest and the longest, and what is none
printf 'UNITS/MM\nGOTO/0,0,9\nGOTO/5,0,9\nFINI\n' >bare.cl
names() { # CONTROL STATUS NAME...
	control=$1 want=$2
	shift 2
	for name; do
		status "$want" "$control: the name $name" \
			ncpost -q --no-spindle -c $control --program "$name" bare.cl
	done
}
names siemens 0 AB ABCDEFGHIJKLMNOPQRSTUVWX
names siemens 2 A A1 AB- 12A ABCDEFGHIJKLMNOPQRSTUVWXY
names heidenhain 0 A 12A AB- ABCDEFGHIJKLMNOPQRSTUVWX
names heidenhain 2 A+ ABCDEFGHIJKLMNOPQRSTUVWXY
names fanuc 0 1 99999999
names fanuc 2 0 A 100000000
done_testing
