#!/bin/sh
# old-control.sh [FOLDER] - three axes on a control of the eighties with room for 40 kilobytes: the tool
# stands upright, programs of lines and arcs in the plane, in parts that fit, each beginning above
# the work.
# shellcheck source=samples/tasks/begin.sh
. "$(dirname "$0")/begin.sh"

# What that control lacks: no tool-centre-point control (three axes), no digits beyond the third.
cat >old.txt <<'END'
include = three-axis
name = Knee mill, 1984
control = fanuc
digits.linear = 3
x.min = -200
x.max = 200
y.min = -150
y.max = 150
z.min = -100
z.max = 200
END
cloud2mesh -q "$samples/panel_17036.xyz" -o panel.ply
meshnorm -q -r 6 --scallop 0.05 --fixed 0,0,1 -m ./old.txt panel.ply -o panel.cl
biarcfit -q -e 0.01 panel.cl -o arcs.cl
ncpost -q -m ./old.txt --split 40k arcs.cl -o panel.nc
figure parts "$(find . -name 'panel-*.nc' | wc -l)"
figure largest "$(wc -c panel-*.nc | awk '!/total/ && $1 > most { most = $1 } END { print most }')"
ncpost -q -m ./old.txt arcs.cl -o whole.nc
figure rotary "$(grep -cE '^N[0-9]+ .*[ABC]-?[0-9]' whole.nc || true)"
check whole whole.nc -m ./old.txt -g "$samples/panel_17036.xyz" -r 6 -e 0.02
