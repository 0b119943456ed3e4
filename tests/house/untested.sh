#!/bin/sh
# untested.sh - modules that have no unit test of their name and whose header none includes, longest
# first.
cd "$(dirname "$0")/../.." || exit 1
find src include -name '*.h' | while read -r header; do
	module=$(basename "$header" .h)
	folder=$(dirname "${header#*/}")
	source=src/$folder/$module.c
	[ -f "$source" ] && [ ! -f "tests/unit/$folder/check_$module.c" ] || continue
	grep -rqE "\"([a-z/]*/)?$module\.h\"" tests/unit tests/lib --include='*.[ch]' ||
		wc -l "$source"
done | sort -rn
