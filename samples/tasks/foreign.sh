#!/bin/sh
# foreign.sh [FOLDER] - a path of another CAM system (a CL file as Siemens NX writes it) for four controls.
# Each program is read back, compared with the path (-p: the same tip, axis and feed) and checked
# against the part.
# shellcheck source=samples/tasks/begin.sh
. "$(dirname "$0")/begin.sh"

awk 'BEGIN {
	print "TOOL PATH/FINISH,TOOL,BALL_8\nTLDATA/MILL,8.0000,4.0000,75.0000,0.0000,0.0000"
	print "MSYS/0.0000,0.0000,0.0000,1.0000000,0.0000000,0.0000000,0.0000000,1.0000000,0.0000000"
	print "SPINDL/RPM,6000,CLW\nPAINT/PATH\nRAPID\nGOTO/-20.0000,0.0000,60.0000,0.0000000,0.0000000,1.0000000"
	print "FEDRAT/MMPM,900.0000"
	for (k = 0; k <= 8; k++) for (i = 0; i <= 20; i++) {  # rows over a dome, the axis leaning outward
		x = -20 + 2 * (k % 2 ? 20 - i : i); y = -12 + 3 * k; z = 30 - (x * x + y * y) / 80
		n = sqrt(x * x + y * y + 1600)
		printf "GOTO/%.4f,%.4f,%.4f,%.7f,%.7f,%.7f\n", x, y, z, x / n, y / n, 40 / n
	}
	print "RAPID\nGOTO/20.0000,12.0000,60.0000,0.0000000,0.0000000,1.0000000\nPAINT/TOOL,NOMORE\nEND-OF-PATH" }' >dome.cls

awk 'BEGIN { for (i = 0; i < 4331; i++) { x = -20 + (i % 71) * 40 / 70; y = -12 + int(i / 71) * 24 / 60
	printf "%.4f %.4f %.4f\n", x, y, 30 - (x * x + y * y) / 80 } }' >dome.xyz

ncpost -q -c fanuc -m table-ac dome.cls -o dome-fanuc.nc
ncpost -q -c siemens -m head-ca dome.cls -o dome-siemens.mpf
ncpost -q -c heidenhain -m hermle-c42u dome.cls -o dome-heidenhain.h
ncpost -q -c linuxcnc -m linuxcnc-xyzac dome.cls -o dome-linuxcnc.ngc
for control in fanuc,table-ac,nc siemens,head-ca,mpf heidenhain,hermle-c42u,h linuxcnc,linuxcnc-xyzac,ngc; do
	name=${control%%,*} machine=${control#*,}
	program=dome-$name.${machine#*,}
	check "$name" "$program" -c "$name" -m "${machine%,*}" -p dome.cls -g dome.xyz -r 4 -e 0.03 --scallop 0.4
	figure "$name.blocks" "$(wc -l <"$program")"
done
