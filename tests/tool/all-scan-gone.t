#!/bin/sh
# all-scan-gone.t - a scan that a mesh or path names by a relative name, and that is gone or has
# other points, is told in one line by each tool that would guard by it, with what it does instead;
# under -q, too, and with exit status 3.  A mesh or path that names none is told of in one line,
# but not where no guard is asked for.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

awk 'BEGIN { for (y = -6; y <= 6; y += 0.5) for (x = -6; x <= 6; x += 0.5)
	printf "%.4f %.4f %.4f\n", x, y, 10 + sin(x / 3) * cos(y / 3) }' >scan.xyz
cloud2mesh -q -t 2 scan.xyz -o mesh.ply
meshnorm -q -r 3 --scallop 0.1 mesh.ply -o path.cl
mkdir other && cd other || exit 1

told() { # WHAT TOOL: its standard error is in err
	grep -c '^'"$2"': the scan that the [a-z]* names does not guard: scan\.xyz: '"$1" "$TMP/err" |
		grep -qx 1
	result $? "$2 tells it in one line: $1"
}
unguarded() { # WHAT TOOL [ARGUMENTS]: -q does not hide it
	why=$1
	shift
	tool=$1
	shift
	status 3 "$tool -q does not end with 0: $why" "$tool" -q -o out.cl "$@"
	told "$why" "$tool"
	has "$tool: it is in the path" "^..-> UNMET/$tool,the scan that " out.cl
}
for why in 'cannot open' 'found other points' 'found 624 points' 'found a pipe'; do
	case $why in
	*other*) sed '3s/ 9/ 8/;3s/ 10/ 11/' ../scan.xyz >scan.xyz ;;
	*624*) sed 1d ../scan.xyz >scan.xyz ;;
	*pipe*) rm scan.xyz && mkfifo scan.xyz ;; # nobody writes to it: not waited for
	esac
	for tool in meshnorm planecut; do
		run $tool -r 3 --scallop 0.1 ../mesh.ply
		told "$why" $tool
		grep -q 'guarded by the mesh alone' "$TMP/err"
		result $? "$tool guards by the mesh"
		unguarded "$why" $tool -r 3 --scallop 0.1 ../mesh.ply
	done
	for tool in biarcfit bsplfit; do
		run $tool -e 0.01 ../path.cl
		told "$why" $tool
		grep -q 'what is fitted is not checked' "$TMP/err"
		result $? "$tool checks nothing, and says so"
		unguarded "$why" $tool -e 0.01 ../path.cl
	done
done
rm scan.xyz && cp ../scan.xyz . || exit 1
for tool in meshnorm planecut; do
	run $tool -r 3 --scallop 0.1 ../mesh.ply
	grep 'does not guard' "$TMP/err" >"$TMP/found"
	empty "$tool: there again, it guards" "$TMP/found"
done
cat scan.xyz | cloud2mesh -q -t 2 -o piped.ply
# a mesh alone may be far off the scan that it was made from: no 0 for what nobody looked at
for tool in meshnorm planecut; do
	status 3 "$tool: a scan that was piped in does not guard" $tool -q -r 3 --scallop 0.1 -o out.cl piped.ply
	has "... and it is said with -q, too" 'read from standard input; guarded by the mesh alone' "$TMP/err"
	has "... and in the path" "UNMET/$tool,.*standard input" out.cl
	status 0 "... which --no-guard accepts" $tool -q -r 3 --scallop 0.1 --no-guard -o out.cl piped.ply
	status 0 "... and -g mends" $tool -q -r 3 --scallop 0.1 -g scan.xyz -o out.cl piped.ply
done
meshnorm -q -r 3 --scallop 0.1 -o out.cl piped.ply 2>"$TMP/err"
for tool in biarcfit bsplfit; do
	status 3 "$tool checks nothing against it" $tool -q -e 0.01 -o fit.cl out.cl
	has "... and says so" 'read from standard input; what is fitted is not checked' "$TMP/err"
done
cat scan.xyz | cloud2mesh -q -t 2 --clean believed.xyz -o piped.ply
status 0 "with --clean there is a file" meshnorm -q -r 3 --scallop 0.1 -o out.cl piped.ply

grep -v '^comment' ../mesh.ply >bare.ply
for tool in meshnorm planecut; do
	run $tool -r 3 --scallop 0.1 -o bare.cl bare.ply
	grep -c "^$tool: the mesh names no scan: " "$TMP/err" | grep -qx 1
	result $? "$tool says in a line that the mesh names no scan"
	run $tool -r 3 --scallop 0.1 --no-guard -o out.cl bare.ply
	grep 'names no scan' "$TMP/err" >"$TMP/found"
	empty "$tool: not to who asks for no guard" "$TMP/found"
	run $tool -r 3 --scallop 0.1 -g scan.xyz -o out.cl bare.ply
	grep 'names no scan' "$TMP/err" >"$TMP/found"
	empty "$tool: nor where it is named" "$TMP/found"
done
for tool in biarcfit bsplfit; do
	run $tool -e 0.01 -o out.cl bare.cl
	grep -c "^$tool: the path names no scan: " "$TMP/err" | grep -qx 1
	result $? "$tool says in a line that the path names no scan"
	run $tool -e 0.01 --no-guard -o out.cl bare.cl
	grep 'names no scan' "$TMP/err" >"$TMP/found"
	empty "$tool: not to who asks for no guard" "$TMP/found"
done

# Another scan, as one in another unit: that is known before anything is made of its points.
awk '{ print 1000 * $1, 1000 * $2, 1000 * $3 } END { print 0, 0, 90000 }' scan.xyz >metres.xyz
for tool in meshnorm planecut; do
	status 1 "$tool: another scan" $tool -r 3 --scallop 0.1 -g metres.xyz -o out.cl ../mesh.ply
	has "... is told" 'expected the scan that the mesh was made from' "$TMP/err"
	hasnt "... at once" 'outlier' "$TMP/err"
done
done_testing
