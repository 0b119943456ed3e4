#!/bin/sh
# samples-face.t - the tasks of the gallery (samples/tasks): a face on two controls.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
. "$SRC/tests/lib/task.sh"
tasks face
done_testing
