#!/bin/sh
# seeds.sh [READER] - the readers that have seeds, or the files that one begins with, a line each: those
# in seeds/READER, those that seeds.txt names, and what was found before.
cd "$(dirname "$0")/../.." || exit 1
if [ $# -eq 0 ]; then
	{ ls tests/fuzz/seeds && sed -n 's/^\([a-z][-a-z]*\) .*/\1/p' tests/fuzz/seeds.txt; } | sort -u
	exit
fi
for file in tests/fuzz/seeds/"$1"/* tests/fuzz/found/"$1"/* $(sed -n "s/^$1 //p" tests/fuzz/seeds.txt); do
	[ -f "$file" ] && echo "$PWD/$file"
done
exit 0
