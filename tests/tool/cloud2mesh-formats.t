#!/bin/sh
# cloud2mesh-formats.t - the same scan in the formats that scanners and other programs write gives the
# same mesh; what is told of each; and what is not read is refused with the way to convert it.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

# A hill on a lattice of whole hundredths, so that every format holds it exactly enough.
awk 'BEGIN { for (i = 0; i < 900; i++) { x = i % 30; y = int(i / 30)
	printf "%.2f %.2f %.2f\n", x + 0.25, y + 0.5, 5 + 3 * sin(x / 8) * cos(y / 9) } }' >scan.xyz
python3 - <<'END' || skip_rest "no python3 to write binary files with"
import struct
P = [tuple(map(float, l.split())) for l in open('scan.xyz')]
n = len(P)
def las(minor, form, length):
    head = bytearray({4: 375, 3: 235}.get(minor, 227))
    head[0:4] = b'LASF'; head[24] = 1; head[25] = minor; head[104] = form
    struct.pack_into('<HI', head, 94, len(head), len(head) + 7); struct.pack_into('<H', head, 105, length)
    struct.pack_into('<Q' if minor == 4 else '<I', head, 247 if minor == 4 else 107, n + 1)
    struct.pack_into('<6d', head, 131, .01, .01, .01, 1, 2, 3)
    out = bytes(head) + bytes(7)
    for k, p in enumerate(P + [(500, 500, 500)]):
        r = bytearray(length)
        struct.pack_into('<3i', r, 0, *[round((p[i] - i - 1) * 100) for i in range(3)])
        if k == n: r[15] = 4 if form >= 6 else 0x80
        out += bytes(r)
    return out
open('v12.las', 'wb').write(las(2, 3, 34))
open('v14.las', 'wb').write(las(4, 7, 36))
open('cut.las', 'wb').write(las(4, 7, 36)[:-40])
laz = bytearray(las(2, 3, 34)); laz[104] |= 128; open('scan.laz', 'wb').write(laz)
open('scan.e57', 'wb').write(b'ASTM-E57' + bytes(100))
pcd = 'VERSION .7\nFIELDS x y z rgb\nSIZE 8 8 8 4\nTYPE F F F U\nCOUNT 1 1 1 1\nWIDTH %d\nHEIGHT 1\nPOINTS %d\nDATA %s\n'
open('binary.pcd', 'wb').write((pcd % (n, n, 'binary')).encode() + b''.join(struct.pack('<3dI', *p, 7) for p in P))
open('ascii.pcd', 'w').write(pcd % (n, n, 'ascii') + ''.join('%g %g %g 7\n' % p for p in P))
open('packed.pcd', 'w').write(pcd % (n, n, 'binary_compressed'))
ply = 'ply\nformat binary_%s_endian 1.0\nelement vertex %d\nproperty double x\nproperty double y\nproperty double z\nend_header\n'
for e, c in ('little', '<'), ('big', '>'):
    open(e + '.ply', 'wb').write((ply % (e, n)).encode() + b''.join(struct.pack(c + '3d', *p) for p in P))
row = lambda p: '%g %g %g -1200 10 20 30\n' % p
open('scan.pts', 'w').write('%d\n' % n + ''.join(map(row, P)))
open('scan.ptx', 'w').write('30\n30\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n' + ''.join(map(row, P)))
open('numbered.txt', 'w').write(''.join('%d\t%g\t%g\t%g\n' % (i + 1, *p) for i, p in enumerate(P)))
open('numbered.csv', 'w').write('Point,Easting,Northing,Elev,Code\n' + ''.join('%d,%g,%g,%g,9\n' % (i, *p) for i, p in enumerate(P)))
open('scan.obj', 'w').write('o scan\n' + ''.join('v %g %g %g\n' % p for p in P))
s = 'solid scan\n'
for k in range(0, n, 3):
    s += 'facet normal 0 0 0\nouter loop\n' + ''.join('vertex %g %g %g\n' % p for p in P[k:k + 3]) + 'endloop\nendfacet\n'
open('ascii.stl', 'w').write(s + 'endsolid scan\n')
END

mesh() { # FILE: the mesh without what its head says of the source
	cloud2mesh -t 2 "$1" 2>said | grep -vE '^comment (source|scan)' >got
}
mesh scan.xyz
cp got want
ok "a mesh of the text" grep -q '^element face [1-9]' want
for file in v12.las v14.las binary.pcd ascii.pcd little.ply big.ply scan.pts scan.ptx numbered.txt \
	numbered.csv scan.obj ascii.stl; do
	mesh $file
	same "$file: the same mesh" want got
	cp said "said-$file"
done
has "withheld points are told" 'v12.las: left out 1 point that the file marks as withheld' said-v12.las
has "so are numbers of rows" 'numbered.txt: the first column numbers the rows: x y z are the three' said-numbered.txt
has "with columns after the points" 'numbered.csv: ignored the columns after the fourth' said-numbered.csv
awk 'BEGIN { print "r,g,b,x,y,z"; for (i = 0; i < 30; i++) for (k = 0; k < 30; k++)
	print "1,2,3," i "," k "," i * k / 90 }' >named.csv
cloud2mesh named.csv 2>said >named.ply
has "columns that a heading names" 'named.csv: the heading says which columns are x y z' said
has "and the others" 'named.csv: ignored the others of 6 columns' said
hasnt "none of them wrongly" 'after the third' said
has "an STL is told to be a mesh" 'ascii.stl: a mesh: the corners of its 300 facets' said-ascii.stl

refused() { # FILE REGEX
	status 1 "$1 is refused" cloud2mesh -t 2 "$1"
	has "and says $2" "^cloud2mesh: $1:.*$2" err
	empty "and nothing is written" out
}
refused cut.las 'the file ends after 899 points, expected the 901 of its LAS head'
refused scan.laz 'laszip -i IN.laz'
refused scan.e57 'pdal translate IN.e57'
refused packed.pcd 'pcl_convert_pcd_ascii_binary'

# The guard and the verdict read the scan as the mesh did.
cloud2mesh -q -t 2 -o las.ply v14.las
status 0 "a LAS file guards the path of its mesh" meshnorm -r 2 -o las.cl las.ply
hasnt "it is the scan that the mesh names" 'gone|other points' err

# Cells without data, as programs for terrain write them: no holes 10 m deep, here, in the guard and
# the verdict, and the same scan whether they are there or not.
awk '{ print } NR % 37 == 0 { print $1 + 0.5, $2, -9999 }' scan.xyz >marked.xyz
status 0 "a grid with a mark for no data" cloud2mesh -t 2 -o marked.ply marked.xyz
has "they are left out" 'left out 24 rows with a height of -9999, which stands for no data' err
cloud2mesh -q -t 2 -o plain.ply scan.xyz
sed 's/marked/scan/' marked.ply >named.ply
same "it is the mesh without them" plain.ply named.ply
status 0 "by reading twice, too" cloud2mesh --stream --normals facet -t 2 -o twice.ply marked.xyz
has "they are left out" 'left out 24 rows with a height' err
hasnt "no vertex is down there" '-9999' twice.ply
status 0 "it guards" meshnorm -r 2 --scallop 0.2 -o marked.cl marked.ply
has "and they are left out" '^meshnorm: .*left out 24 rows with a height' err
hasnt "it is the scan that the mesh names" 'gone|other points' err
ncpost -q -c linuxcnc -o marked.ngc marked.cl
status 0 "and judges" ncverify -q -g marked.xyz marked.ngc
awk '{ $3 = -9999; print }' scan.xyz >empty.xyz
status 1 "nothing but marks" cloud2mesh -t 2 -o none.ply empty.xyz
has "is told" '^cloud2mesh: empty.xyz: no points .900 rows left out' err

# A writer that was killed: its last number may be cut, and no one can know.
head -c 1998 scan.xyz >cut.xyz
status 0 "a scan cut off within its last number" cloud2mesh -t 2 -o cut.ply cut.xyz
has "is told of" '^cloud2mesh: cut.xyz:[0-9]+: the last row has no line end' err
status 0 "a whole one" cloud2mesh -t 2 -o cut.ply scan.xyz
hasnt "is not" 'no line end' err
done_testing
