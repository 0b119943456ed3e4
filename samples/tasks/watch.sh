#!/bin/sh
# watch.sh [FOLDER] - a job beside a control: what is put into in/ becomes a program in out/, a broken
# scan goes to refused/ with the reason.  A program appears in out/ whole or not at all, and only with
# exit status 0: a control that fetches from there never sees half of one, nor one that does not keep
# what was asked.  Runs for ever in a shop; here until in/ is empty, after two scans were put there.
# shellcheck source=samples/tasks/begin.sh
. "$(dirname "$0")/begin.sh"
mkdir -p in out refused making
awk 'BEGIN { for (i = 0; i < 2500; i++) { x = (i % 50) / 2; y = int(i / 50) / 2
	printf "%.3f %.3f %.3f\n", x, y, 5 + 2 * cos(x / 7) * sin(y / 8) } }' >in/good.xyz
printf '1 2 3\n4 5\n' >in/bad.xyz

serve() { # SCAN
	name=$(basename "$1" .xyz) code=0
	mv "$1" making/
	cloudmill "making/$name.xyz" -r 3 -c heidenhain -o "making/$name.h" >"making/$name.verdict" \
		2>"making/$name.log" || code=$?
	if [ $code -eq 0 ]; then
		mv "making/$name.h" out/ # on one disk mv is a single step
	else
		mv "making/$name.xyz" "making/$name.log" refused/
	fi
	echo "$(basename "$1"): exit status $code"
}

while scans=$(ls in) && [ -n "$scans" ]; do # in a shop: while sleep 5
	for scan in in/*.xyz; do
		[ -e "$scan" ] && serve "$scan"
	done
done
figure out "$(find out -name '*.h' | wc -l)"
figure refused "$(find refused -name '*.xyz' | wc -l)"
figure half "$(find out -size -1k | wc -l)"
tail -n 1 refused/bad.log
