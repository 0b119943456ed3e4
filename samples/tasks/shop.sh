#!/bin/sh
# shop.sh [FOLDER] - a shop's script that does not load what is not as it was asked: a pipe, and what its
# exit status says.  A dent in a block, of radius 6.4 at its bottom, is cut with a ball of 8 mm, which
# does not fit, and with one of 5 mm.
#
# In a pipe the shell sees the status of the last tool.  ncpost ends with 3 if it, or any stage before
# it, could not keep what was asked: so the last is enough for that.  What fails outright (1) leaves an
# empty pipe, so that ncpost fails too.
# shellcheck source=samples/tasks/begin.sh
. "$(dirname "$0")/begin.sh"
awk 'BEGIN { for (i = 0; i < 6400; i++) { x = (i % 80) / 4 - 10; y = int(i / 80) / 4 - 10; r = sqrt(x * x + y * y)
	printf "%.3f %.3f %.4f\n", x, y, r < 7 ? 10 - 0.776 * (1 + cos(3.14159265 * r / 7)) : 10 } }' >dent.xyz
mkdir -p control

make_and_load() { # BALL
	code=0
	cloud2mesh -q dent.xyz | meshnorm -q -r "$1" | biarcfit -q -e 0.01 |
		ncpost -q -c fanuc -o "dent-$1.nc" || code=$?
	case $code in
	0) ncverify -q -g dent.xyz -r "$1" -e 0.02 "dent-$1.nc" >"dent-$1.verdict" &&
		cp "dent-$1.nc" control/ && echo "ball $1: loaded" ;;
	3) echo "ball $1: not loaded; not kept:" && sed -n 's/^(UNMET/  &/p' "dent-$1.nc" ;;
	*) echo "ball $1: failed with $code" ;;
	esac
	figure "ball$1.status" $code
}
make_and_load 8
make_and_load 5
figure loaded "$(find control -name '*.nc' | wc -l)"
