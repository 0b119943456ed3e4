#!/bin/sh
# samples-jobs.t - the tasks of the gallery (samples/tasks): a batch, a watched folder, a shop's script that stops, a stage of one's own.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
. "$SRC/tests/lib/task.sh"
tasks batch watch shop
if command -v python3 >/dev/null; then
	tasks normals
else
	skip "own normals" "no python3"
fi
done_testing
