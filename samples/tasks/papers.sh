#!/bin/sh
# papers.sh [FOLDER] - the tables of both papers that the suite rests on, beside our figures: the number of
# vertices of the first (paper1.sh), control points of the second (paper2.sh).
# shellcheck source=samples/tasks/begin.sh
. "$(dirname "$0")/begin.sh"
sh "$samples/paper1.sh" | tee paper1.txt
awk '/^panel.*--paper/ { print "figure panel.vertices", $(NF - 3) } /^face.*3.8 --paper/ { print "figure face.vertices", $(NF - 3) }' paper1.txt
sh "$samples/paper2.sh" | tee paper2.txt
awk '/^Table/ { t = $2 + 0 } /default: control points/ { print "figure table" t ".CC", $(NF - 2); print "figure table" t ".CE", $(NF - 1) }
	/default: distance both ways/ { print "figure table" t ".distance", $(NF - 1) }' paper2.txt
