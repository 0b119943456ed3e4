#!/bin/sh
# faults.t - calls of the C library that fail, one after another, in every tool with every kind of
# input: nothing half done, nothing silently other.  FAULTS calls of each kind are tried, evenly
# spread (default 1; 0, which `make faults` sets: every one); ONLY: of the jobs whose names match.
# And SIGKILL at MOMENTS moments by chance (8; SEED) for each tool that writes.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1
MOST=${FAULTS:-1}
kinds=malloc,calloc,realloc,aligned,read,end,bytes,write,full,some,open,close,fsync,rename,kill,term
file_kinds=read,end,bytes,write,full,some,open,close,fsync,rename,kill,term

house=$SRC/tests/house
# shellcheck disable=SC2086 # CC may have options
if ! ${CC:-cc} -std=c11 -D_XOPEN_SOURCE=700 -O1 -shared -fPIC -o fault_lib.so "$house/fault_lib.c" \
	-ldl 2>cc.err || ! LD_PRELOAD=$TMP/fault_lib.so ncpost -V >cc.out 2>&1; then
	skip "calls that fail" "no library can be put before libc here"
	done_testing
fi
# shellcheck disable=SC2086
ok "the runner compiles" ${CC:-cc} -std=c11 -D_XOPEN_SOURCE=700 -O1 -o fault_run "$house/fault_run.c"

awk 'BEGIN { for (i = 0; i <= 10; i++) for (k = 0; k <= 8; k++) {
	x = 2 * i - 10; y = 2 * k - 8; print x, y, 10 - (x * x + y * y) / 120 } }' >cloud.xyz
cloud2mesh -q -t 4 cloud.xyz >mesh.ply
meshnorm -q -r 4 --rows mesh --fixed 0.1,0,1 mesh.ply >path.cl
biarcfit -q path.cl >arcs.cl
for control in fanuc siemens heidenhain linuxcnc; do
	ncpost -q -c $control arcs.cl >program.$control
done
printf '1 0 0 5\n0 1 0 0\n0 0 1 0\n0 0 0 1\n' >matrix.txt
printf 'include = own-base.txt\nx.max = 900\ntools = tools.tbl\n' >own.txt
cp "$SRC/machines/table-ac.txt" own-base.txt
printf '1 120.5 BALL\n' >tools.tbl
printf -- '-8 -6\n8 -6\n8 6\n-8 6\n' >region.txt
printf 'base = fanuc\nnumber.step = 5\n' >own-control.txt
cp "$SRC/tools/ball-8.txt" "$SRC/tools/hsk-a63-er20.txt" "$SRC/samples/saddle.nurbs" \
	"$SRC/tests/data/box.step" "$SRC/tests/data/awkward/surface.igs" \
	"$SRC/tests/data/cl/catia.apt" "$SRC/tests/data/cl/nx.cls" .
cp "$SRC/tests/data/awkward/mesh.off" "$SRC/tests/data/awkward/mesh-binary.stl" \
	"$SRC/tests/data/awkward/mesh-be.ply" "$SRC/tests/data/awkward/cloud.ptx" \
	"$SRC/tests/data/awkward/cloud.pcd" "$SRC/tests/data/awkward/cloud.obj" \
	"$SRC/tests/data/awkward/cloud-le.ply" .
awk 'BEGIN { for (i = 0; i < 20000; i++) print "(A REMARK AS LONG AS THIS ONE)" }' >remarks
sed '2r remarks' program.fanuc >long.nc
rm remarks

# faults DESC KINDS "FILES" COMMAND...: with these files in the folder, and `older` as the outputs
faults() {
	desc=$1 which=$2 files=$3
	shift 3
	echo "$desc" | grep -qE -e "${ONLY:-.}" || return 0
	rm -rf before work
	mkdir before
	for file in $files; do cp "$file" before; done
	for file in out other page.html; do echo older >before/$file; done
	if ./fault_run "$TMP/fault_lib.so" "$which" "$MOST" "$@" >faults.out 2>err; then
		[ -z "$ONLY" ] || grep -E ' calls, | killed, ' faults.out
		result 0 "$desc: $(awk '/ calls, / { n += $2 } END { print n }' faults.out) calls that fail"
	else
		grep '^bad' faults.out >>err
		result 1 "$desc"
	fi
}

meshnormal='meshnorm -j 1 -r 4 --rows mesh -o out'
path="path.cl cloud.xyz"
faults "cloud2mesh" $kinds "cloud.xyz" cloud2mesh -j 1 -t 4 -o out cloud.xyz
faults "cloud2mesh to standard output" $kinds "cloud.xyz" cloud2mesh -j 1 -t 4 cloud.xyz
faults "cloud2mesh, a matrix, two clouds, what is believed" $kinds "cloud.xyz matrix.txt" \
	cloud2mesh -j 1 -t 4 --matrix matrix.txt --clean other -o out cloud.xyz cloud.xyz
for file in cloud.ptx cloud.pcd cloud.obj cloud-le.ply; do
	faults "cloud2mesh, $file" malloc,calloc,realloc,read,end,bytes "$file" \
		cloud2mesh -j 1 -t 3 -o out $file
done
faults "cloud2surf" $kinds "cloud.xyz" cloud2surf -j 1 -e 0.05 -o out cloud.xyz
faults "cloud2surf, patches as IGES, a matrix" $kinds "cloud.xyz matrix.txt" \
	cloud2surf -j 1 --bezier -t 12 --iges --matrix matrix.txt cloud.xyz
# shellcheck disable=SC2086 # words
faults "meshnorm, the scan" $kinds "mesh.ply cloud.xyz" $meshnormal mesh.ply
# shellcheck disable=SC2086
faults "meshnorm, tool files, a machine" $kinds \
	"mesh.ply ball-8.txt hsk-a63-er20.txt own.txt own-base.txt tools.tbl" \
	$meshnormal --no-guard --tool-file ball-8.txt --tool-file hsk-a63-er20.txt --machine own.txt mesh.ply
for file in mesh.ply mesh-binary.stl mesh.off mesh-be.ply; do
	faults "planecut, $file" $kinds "$file" planecut -j 1 -r 4 -s 4 --no-guard -o out $file
done
faults "biarcfit" $kinds "$path" biarcfit -j 1 -o out path.cl
faults "bsplfit" $kinds "$path" bsplfit -j 1 --no-guard -o out path.cl
for control in fanuc siemens heidenhain linuxcnc own-control.txt; do
	faults "ncpost, $control" $kinds "arcs.cl own-control.txt own.txt own-base.txt tools.tbl" \
		ncpost -j 1 -c $control -m own.txt -o out arcs.cl
done
for control in fanuc siemens heidenhain linuxcnc; do
	faults "ncverify, $control" malloc,calloc,realloc,read,end,bytes \
		"cloud.xyz program.$control own.txt own-base.txt tools.tbl own-control.txt" \
		ncverify -j 1 -r 4 -c $control -m own.txt -g cloud.xyz -o out program.$control
done
faults "ncverify, a long program, told by its head" read,end,bytes,some "cloud.xyz long.nc" \
	ncverify -j 1 -r 4 -g cloud.xyz -o out long.nc
faults "ncverify, a path, a map, a page" $kinds "cloud.xyz program.fanuc arcs.cl own-control.txt" \
	ncverify -j 1 -r 4 -c own-control.txt -g cloud.xyz -p arcs.cl --map other --report page.html \
	-o out program.fanuc
for file in cloud.xyz mesh.ply arcs.cl program.siemens; do
	faults "ncplot, $file" $kinds "$file" ncplot -o out $file
done
faults "planecut, a region, a scan, surfaces" $kinds "mesh.ply cloud.xyz region.txt saddle.nurbs" \
	planecut -j 1 -r 4 -s 6 --region region.txt --surface saddle.nurbs -g cloud.xyz -o out mesh.ply
faults "cloud2surf, a net, IGES" malloc,calloc,realloc,read,end,bytes,write,full,some "cloud.xyz" \
	cloud2surf -j 1 --bezier -t 8 --iges -o out cloud.xyz
for file in saddle.nurbs box.step surface.igs; do
	faults "nurbs2mesh, $file" $kinds "$file" nurbs2mesh -j 1 -n 6 -o out $file
done
for file in catia.apt nx.cls; do
	faults "ncpost, $file" malloc,calloc,realloc,read,end,bytes "$file" \
		ncpost -j 1 --accept -c fanuc -o out $file
done
faults "ncpost, in parts" $kinds "arcs.cl" ncpost -j 1 -c fanuc --split 120 -o out arcs.cl
for file in box.step surface.igs saddle.nurbs mesh.ply; do # a large ball: fewer points
	faults "ncverify, a part in $file" malloc,calloc,realloc,read,end,bytes "$file program.fanuc" \
		ncverify -j 1 -r 4000 -g $file -o out program.fanuc
done
faults "cloud2mesh, threads" thread,kill-mem,term-mem "cloud.xyz" cloud2mesh -j 3 -t 4 -o out cloud.xyz
faults "planecut, threads" thread,kill-mem,term-mem "mesh.ply" \
	planecut -j 3 -r 4 -s 4 --no-guard -o out mesh.ply
faults "biarcfit, threads" thread,kill-mem,term-mem "$path" biarcfit -j 3 -o out path.cl

# calls that seldom fail, and standard input by a pipe
seldom=stat,seek,temp,mode,read-intr,write-intr
faults "cloud2mesh, seldom" $seldom "cloud.xyz" cloud2mesh -j 1 -t 4 --clean other -o out cloud.xyz
faults "ncpost, in parts, seldom" $seldom "arcs.cl" ncpost -j 1 -c fanuc --split 120 -o out arcs.cl
export FED
for FED in cloud.xyz mesh-binary.stl path.cl program.fanuc; do
	faults "ncplot, $FED by a pipe" $kinds,$seldom $FED ncplot -o out
done
FED=cloud.ptx
faults "cloud2mesh, by a pipe" $file_kinds,$seldom cloud.ptx cloud2mesh -j 1 -t 3 -o out
FED=surface.igs
faults "nurbs2mesh, by a pipe" $file_kinds,$seldom surface.igs nurbs2mesh -j 1 -n 4
FED=mesh.off
faults "planecut, by a pipe" $file_kinds,$seldom mesh.off planecut -j 1 -r 4 -s 8 --no-guard
FED=nx.cls
faults "ncpost, by a pipe" $file_kinds,$seldom nx.cls ncpost -c siemens --accept -o out
FED=program.fanuc
faults "ncverify, by a pipe" $file_kinds,$seldom "cloud.xyz program.fanuc arcs.cl" \
	ncverify -j 1 -c fanuc -r 4 -g cloud.xyz -p arcs.cl --map other --report page.html -o out
FED=

# at any moment: -o FILE old or new, whole, and what is left is in nobody's way
MOST=${MOMENTS:-8}
awk 'BEGIN { for (y = -30; y <= 30; y++) for (x = -30; x <= 30; x++)
	print x, y, 10 - (x * x + y * y) / 120 }' >fine.xyz
cloud2mesh -q -t 1 fine.xyz >fine.ply
cloud2mesh -q -t 2 cloud.xyz >mid.ply
meshnorm -q -r 4 --rows mesh --fixed 0.1,0,1 fine.ply >fine.cl
when="killed at any moment"
faults "cloud2mesh, $when" moment fine.xyz cloud2mesh -t 1 -o out fine.xyz
faults "cloud2surf, $when" moment cloud.xyz cloud2surf -e 0.05 -o out cloud.xyz
faults "nurbs2mesh, $when" moment saddle.nurbs nurbs2mesh -n 40 -o out saddle.nurbs
faults "meshnorm, $when" moment mid.ply meshnorm -r 4 --rows mesh --no-guard -o out mid.ply
faults "planecut, $when" moment mid.ply planecut -r 4 -s 2 --no-guard -o out mid.ply
faults "biarcfit, $when" moment path.cl biarcfit --no-guard -e 0.1 -o out path.cl
faults "bsplfit, $when" moment path.cl bsplfit --no-guard -o out path.cl
for control in fanuc siemens heidenhain linuxcnc; do
	faults "ncpost $control, $when" moment fine.cl ncpost -c $control -o out fine.cl
done
faults "ncpost, in parts, $when" moment fine.cl ncpost -c fanuc --split 40k -o out fine.cl
faults "ncverify, a map, a page, $when" moment "cloud.xyz program.fanuc" \
	ncverify -r 4 -g cloud.xyz --map other --report page.html -o out program.fanuc
faults "ncplot, $when" moment fine.cl ncplot -o out fine.cl
faults "cloudmill, $when" moment cloud.xyz \
	cloudmill -r 4 -c fanuc -k . -t 4 -f points -o out.nc cloud.xyz
done_testing
