#!/bin/sh
# all-travel.t - machines whose rotary axes travel little: where a path ends with 0 its program is
# written and accepted, for no axis of a cut, of a link or on the way over the part is out of it.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

awk 'BEGIN { for (x = 0; x <= 12; x += 0.5) for (y = 0; y <= 12; y += 0.5)
	print x, y, 2 * sin(x / 3) * cos(y / 4) }' >scan.xyz
cloud2mesh -q -o scan.ply scan.xyz

through() { # DESC CONTROL COMMAND...: from the mesh to the verdict
	desc=$1
	control=$2
	shift 2
	status 0 "$desc: a path" "$@" -q -r 2 --scallop 0.06 --avoid -m ./own.txt -o path.cl scan.ply
	status 0 "... a program" ncpost -q -c "$control" -m ./own.txt -o program path.cl
	status 0 "... that is accepted" ncverify -q -g scan.xyz -m ./own.txt program
}
for machine in table-bc nutating-head; do
	for travel in "-30 30" "-45 20" "-200 100"; do
		printf 'include = %s\nc.min = %s\nc.max = %s\n' "$machine" $travel >own.txt
		through "$machine, C from $travel" fanuc meshnorm
	done
done
printf 'include = table-ac-notcp\nc.min = -30\nc.max = 30\n' >own.txt
through "no tool centre point control" siemens planecut --lead 10

# What is fitted to a path is off its axes, by which it would leave a travel that they end at.
awk 'BEGIN { for (x = 0; x <= 12; x += 0.5) for (y = 0; y <= 12; y += 0.5)
	print x, y, 3 * exp(-((x - 6)^2 + (y - 6)^2) / 10) }' >hill.xyz
cloud2mesh -q -o hill.ply hill.xyz
for machine in table-bc nutating-head; do
	printf 'include = %s\nc.min = -45\nc.max = 45\n' "$machine" >own.txt
	meshnorm -q -r 1.5 --scallop 0.06 --avoid -m ./own.txt -o path.cl hill.ply
	for fit in biarcfit bsplfit; do
		status 0 "$machine, C from -45 45: $fit" $fit -q -e 0.01 -o fitted.cl path.cl
		status 0 "... a program" ncpost -q -c fanuc -m ./own.txt -o program fitted.cl
		status 0 "... that is accepted" ncverify -q -g hill.xyz -m ./own.txt program
	done
done

# A head at 45 degrees lays the tool flat at most, however far it travels: a fit that is off such an
# axis is off what the machine reaches.
awk 'BEGIN { for (a = 0; a <= 88; a += 2) for (y = 0; y <= 12; y += 0.4)
	print 12 * sin(a / 57.29578), y + 0.1 * sin(a), 12 * cos(a / 57.29578) + 0.3 * sin(y / 2)
}' >bent.xyz
cloud2mesh -q -o bent.ply bent.xyz
status 0 "nutating-head: a path down to where it is upright" meshnorm -q -r 2 --scallop 0.06 \
	--avoid -m nutating-head -a 90 --lead 20 -o path.cl bent.ply
ok "... its axes are no flatter than half a degree" awk -F, '/^GOTO/ && NF > 5 {
	if ($6 < 0.0087) bad = 1
	n++
} END { exit bad || n < 100 }' path.cl
done_testing
