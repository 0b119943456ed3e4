#!/bin/sh
# samples-parts.t - the tasks of the gallery (samples/tasks): a blade, a path of another CAM system, three axes on an old control.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
. "$SRC/tests/lib/task.sh"
tasks blade foreign old-control
done_testing
