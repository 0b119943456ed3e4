#!/bin/sh
# samples-papers.t - the tasks of the gallery (samples/tasks): the tables of both papers.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
. "$SRC/tests/lib/task.sh"
tasks papers
done_testing
