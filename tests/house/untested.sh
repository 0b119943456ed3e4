#!/bin/sh
# untested.sh - the modules that no unit test includes the header of, longest first.
cd "$(dirname "$0")/../.." || exit 1
find src include -name '*.h' | while read -r header; do
	module=$(basename "$header" .h)
	folder=$(dirname "${header#*/}")
	source=src/$folder/$module.c
	[ -f "$source" ] || continue
	grep -rqE "\"([a-z/]*/)?$module\.h\"" tests/unit tests/lib --include='*.[ch]' ||
		wc -l "$source"
done | sort -rn
