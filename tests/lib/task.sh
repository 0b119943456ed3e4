# tests/lib/task.sh - tasks TASK...: each task of samples/tasks ends well, and each of its figures in
# samples/tasks/expected.txt is within its bounds.  A test sources it after lib.sh.
#
# shellcheck shell=sh disable=SC2154 # of lib.sh

tasks() {
	for task; do
		status 0 "samples/tasks/$task.sh" sh "$SRC/samples/tasks/$task.sh" "$TMP/$task"
		cp "$TMP/out" "$TMP/said"
		sed -n "s/^$task //p" "$SRC/samples/tasks/expected.txt" >"$TMP/wanted"
		ok "$task has figures to meet" test -s "$TMP/wanted"
		while read -r name least most; do
			found=$(sed -n "s/^figure $name //p" "$TMP/said")
			below "$task: $name is not less" "$least" "${found:-nothing}"
			below "$task: $name is not more" "$found" "$most"
		done <"$TMP/wanted"
	done
}
