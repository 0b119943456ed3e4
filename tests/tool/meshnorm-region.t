#!/bin/sh
# meshnorm-region.t - what of a mesh is cut: --box and --region, of a mesh of one part and of several;
# the rest stays what the tool is kept clear of.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

# A dome of 20 x 20 mm with a post in the middle of one side
awk 'BEGIN { for (i = -20; i <= 20; i++) for (k = -20; k <= 20; k++) {
	x = i / 2; y = k / 2; z = -(x * x + y * y) / 80
	if (x > 6 && x < 9 && y > -2 && y < 2) z += 4
	printf "%.4f %.4f %.5f\n", x, y, z } }' >scan.xyz
cloud2mesh -q scan.xyz >mesh.ply
cloud2mesh -q --subdivide scan.xyz >parts.ply

contacts() { # NAME ARGS...: contact points of the path NAME.cl, as `x y z i j k`
	name=$1
	shift
	meshnorm -r 2 --avoid "$@" >"$name.cl" 2>"$name.err" && sed -n 's/^\$\$-> CONTCT\///p' "$name.cl" | tr , ' ' >"$name"
}
every() { # DESC NAME CONDITION: there are contacts, and all of them are so
	ok "$1" awk "!($3) { bad++ } END { exit !(NR > 80 && bad == 0) }" "$2"
}

box='$1 > -5.001 && $1 < 4.001 && $2 > -6.001 && $2 < 3.001'
contacts box --box=-5,-6,-50,4,3,50 mesh.ply
every "--box: inside it" box "$box"
ok "up to its sides" awk '$1 < -4.99 { a++ } $1 > 3.99 { b++ } $2 < -5.9 { c++ } $2 > 2.9 { d++ }
	END { exit !(a > 5 && b > 5 && c > 5 && d > 5) }' box
contacts box --box=-5,-6,-50,4,3,50 parts.ply
every "also of a mesh of several parts" box "$box"

# Two triangles, away from the border of the scan
printf '# two\n0 0\n5 0\n5 3.75\n\n-8 -8\n-3 -8\n-3 -3\n' >two
contacts region --region two mesh.ply
every "--region: inside its polygons" region \
	'($2 > -0.001 && $2 < 0.75 * $1 + 0.01 && $1 < 5.001) || ($1 < -2.999 && $2 > -8.001 && $2 < $1 + 0.01)'
ok "in each of them" awk '$1 > 0 { a++ } $1 < 0 { b++ } END { exit !(a > 20 && b > 20) }' region

# The post beside it guards: the ball and its flute stay clear of it
printf '3 -1.5\n6 -1.5\n6 1.5\n3 1.5\n' >foot
contacts foot --region foot mesh.ply
biarcfit -q foot.cl >arcs.cl && ncpost -q --accept -c siemens arcs.cl >foot.mpf
status 0 "what is outside of the region guards" ncverify -q -g scan.xyz -e 0.03 --partial --left 1000 foot.mpf
has "and is accepted" '^verdict *accepted' out

# A ball comes near to points beside the region, too, and leaves more on them than is promised
meshnorm -q -r 5 --avoid --scallop 0.01 --box=-8,-8,-50,-1,8,50 mesh.ply >half.cl
biarcfit -q half.cl | ncpost -q -c siemens -o half.mpf
status 0 "points beside it are none of it" ncverify -q -g scan.xyz --partial half.mpf
has "and it is accepted" '^verdict *accepted' out

# A mesh finer than its scan has holes: what rows leave there is seen and cut, in a region too
awk 'BEGIN { srand(9 + ENVIRON["SEED"]); for (i = 0; i < 1500; i++) { x = 39 * rand(); y = 38 * rand()
	printf "%.4f %.4f %.5f\n", x, y, 0.012 * ((x - 19) ^ 2 - (y - 19) ^ 2) } }' >few.xyz
cloud2mesh -q -t 0.8 --noise 0 few.xyz >few.ply
status 0 "holes of the mesh" meshnorm -v -r 3 --avoid --scallop 0.05 --box 8,7,-50,31,27,50 -o few.cl few.ply
has "rest passes" 'rest passes: [0-9]* strips for [0-9]* points' err
biarcfit -q few.cl | ncpost -q -c siemens -o few.mpf
status 0 "are cut" ncverify -q -g few.xyz --partial few.mpf

# The program says its region: what is left there is found, whatever the ball comes near to
biarcfit -q half.cl >arcs.cl
meshnorm -q -r 5 --avoid --scallop 0.01 --box=-8,-8,-50,-1,0,50 mesh.ply | biarcfit -q >less.cl
for control in fanuc siemens heidenhain linuxcnc; do
	ncpost -q -c $control arcs.cl >half.nc
	has "$control: the head says it" 'REGION: BORDER 1.25 BOX -8 -8 -50 -1 8 50' half.nc
	ncverify -q -g scan.xyz --partial half.nc >out
	has "what is in it is counted" '^part .*, [0-9]+ of them in the region that is to be cut' out
	# a program of half of it that says the whole
	ncpost -q -c $control less.cl | sed 's/-1 0 50/-1 8 50/' >less.nc
	status 3 "$control: what is not cut of it" ncverify -q -g scan.xyz --partial less.nc
	has "is found" 'mm of material is left at' out
done
status 0 "without a head the path says it" sh -c "sed '/REGION/d' half.nc >none.nc && ncverify -q -g scan.xyz --partial -p arcs.cl none.nc"
has "and it is asked for" 'in the region that is to be cut' out
status 3 "without --partial all is asked for" ncverify -q -g scan.xyz half.nc
cat half.cl half.cl | sed '/^FINI/d' >twice.cl && echo FINI >>twice.cl
biarcfit -q --no-guard twice.cl 2>/dev/null | ncpost -q --accept -c fanuc >twice.nc 2>err
hasnt "of two paths no region is said" REGION twice.nc

status 2 "rows of the mesh have no region" meshnorm -r 2 --rows mesh --region two mesh.ply
has "which is said" 'found --region with the rows of the mesh' err
status 2 "a box without inside" meshnorm -r 2 --box 0,0,0,0,1,1 mesh.ply
status 1 "nothing in the box" meshnorm -r 2 --box 50,50,50,60,60,60 mesh.ply
has "is said" 'nothing of the mesh is in the region' err
status 1 "no polygon" meshnorm -r 2 --region mesh.ply mesh.ply
status 0 "cloudmill takes it after --" cloudmill scan.xyz -r 2 -c siemens -o c.mpf -- --avoid --box=-5,-6,-50,4,3,50

done_testing
