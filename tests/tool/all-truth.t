#!/bin/sh
# all-truth.t - the panel of paper 1, whose surface is known exactly: how deep does the ball go?
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
panel=$SRC/samples/panel_17036.xyz
cd "$TMP" || exit 1

ok "the panel's mesh" cloud2mesh -q -t 4 -o mesh.ply "$panel"
ok "its path" meshnorm -q -r 8 --rows mesh -o path.cl mesh.ply
ok "arcs" biarcfit -q -e 0.01 -o biarcfit.cl path.cl
ok "B-splines" bsplfit -q -e 0.01 -o bsplfit.cl path.cl

status 0 "worst gouge at the nodes: 0.005 mm at most" "$READBACK" --panel --nodes 0.005 path.cl
grep ball out | sed 's/^/# /'
deepest=$(sed -n 's/^ball: deepest \([-0-9.]*\).*/\1/p' out)
for fitter in biarcfit bsplfit; do
	status 0 "$fitter: worst gouge along the whole path: 0.025 mm at most" \
		"$READBACK" --panel --deeper 0.025 $fitter.cl
	grep ball out | sed 's/^/# /'
	case $fitter in biarcfit) controls=fanuc ;; *) controls="siemens fanuc" ;; esac
	for control in $controls; do
		ok "$fitter, $control: a program" ncpost -q -c $control -o program $fitter.cl
		status 0 "$fitter, $control: the program too, and its own tolerance" \
			"$READBACK" -c $control --path $fitter.cl -e 0.0065 --axis 0.052 --panel --deeper 0.03 program
		grep ball out | sed 's/^/# /'
	done
done

# The ball touches everywhere: nothing would be proven by a path that stays away.
below "the path touches the panel" 0 "$deepest"

# As published: normals from facets, nothing lifted.  About 0.02 mm at the nodes.
ok "the paper's mesh" cloud2mesh -q -t 4 --paper --normals facet -o paper.ply "$panel"
ok "the paper's path" meshnorm -q -r 8 --paper -o paper.cl paper.ply
"$READBACK" --panel paper.cl >out
at_nodes=$(sed -n 's/^ball at the contact points: deepest \([-0-9.]*\).*/\1/p' out)
below "the paper's path: no deeper than 0.03 mm at the nodes" "$at_nodes" 0.03
below "the paper's path: about 0.02 mm" 0.01 "$at_nodes"
done_testing
