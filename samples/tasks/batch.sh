#!/bin/sh
# batch.sh [FOLDER] - a folder of scans to programs, several at a time: by GNU parallel where it is
# installed, else by xargs.  One scan is broken: the others are made all the same, and the job's log
# says which one is not.
# shellcheck source=samples/tasks/begin.sh
. "$(dirname "$0")/begin.sh"
mkdir -p scans programs
for k in 1 2 3 4; do
	awk -v k=$k 'BEGIN { for (i = 0; i < 3600; i++) { x = (i % 60) / 2; y = int(i / 60) / 2
		printf "%.3f %.3f %.3f\n", x, y, 4 + k * sin(x / 9) * cos(y / 11) } }' >scans/part-$k.xyz
done
echo "7.5 8.1 broken" >>scans/part-3.xyz

cat >one.sh <<'END'
name=$(basename "$1" .xyz)
cloudmill "$1" -r 3 -c siemens -o programs/"$name".mpf >programs/"$name".verdict 2>programs/"$name".log
echo "$? $name" >programs/"$name".status
END
if command -v parallel >/dev/null; then
	printf '%s\n' scans/*.xyz | parallel sh one.sh
else
	printf '%s\n' scans/*.xyz | xargs -P 2 -n 1 sh one.sh
fi
cat programs/*.status >log
cat log
figure programs "$(find programs -name '*.mpf' | wc -l)"
figure accepted "$(cat programs/*.verdict | grep -c '^verdict *accepted')"
figure failed "$(grep -cv '^0 ' log)"
grep -h 'part-3.xyz:' programs/part-3.log
