#!/usr/bin/env python3
"""Makes the awkward inputs of this folder, and checks the tools against them.

  make_awkward.py [DIR]                  write the files and expected.csv (default: beside this script)
  make_awkward.py --machine GOOD [DIR]   the same, the machine files made from a good one of yours
  make_awkward.py --big DIR              also the few that are too large to keep (1 MB lines and the like)
  make_awkward.py --check BIN [DIR]      run every row of expected.csv with the tools in BIN; 'N of M' (exit 0 when all hold)
  make_awkward.py --tool NAME --check BIN [DIR]   the same, the rows of this tool alone; --no-limit: without the limit of
                                                  2 GiB, which a tool built with a sanitizer does not fit into

Python standard library only; the same bytes on every run.
"""
import csv, math, os, random, re, resource, struct, subprocess, sys, tempfile

rows = []                      # what goes into expected.csv
out_dir = None


def put(name, data, command, expect, points="", must="", box=None, note="", edge=""):
    """Write one file and note what is expected of it."""
    if data is not None:
        if isinstance(data, str):
            data = data.encode("utf-8")
        with open(os.path.join(out_dir, name), "wb") as f:
            f.write(data)
    rows.append(dict(file=name, command=command, expect=expect, points=points, must_name=must,
                     box=" ".join("%.4f" % v for v in box) if box else "", longest_edge=edge, note=note))


# ---------------------------------------------------------------- clouds
NX, NY, STEP = 30, 20, 1.5


def height(x, y):
    return 4 * math.sin(x / 11) * math.cos(y / 13)


def cloud(seed=1, nx=NX, ny=NY, step=STEP, jitter=0.5):
    r = random.Random(seed)
    pts = []
    for j in range(ny):
        for i in range(nx):
            x = (i + jitter * (r.random() - 0.5)) * step
            y = (j + jitter * (r.random() - 0.5)) * step
            pts.append((x, y, height(x, y)))
    return pts


def box_of(p, k=1.0):
    return [k * f(q[a] for q in p) for a in range(3) for f in (min, max)]


def text(p, sep=" ", fmt="%.4f", end="\n"):
    return "".join(sep.join(fmt % v for v in q) + end for q in p)


def make_clouds():
    P = cloud()
    N = len(P)
    B = box_of(P)
    c2m = "cloud2mesh @"
    lines = text(P).splitlines(True)

    def ok(name, data, n=N, box=B, **k):
        put(name, data, c2m, "ok", n, box=box, **k)

    def bad(name, data, must="", **k):
        put(name, data, c2m, "refused", must=must, **k)

    # how the same 600 points are spelt
    ok("plain.xyz", text(P))
    ok("head-count.xyz", "%d\n" % N + text(P), note="the count is no point")
    ok("head-names.xyz", "X Y Z\n" + text(P))
    ok("head-names-quoted.csv", '"x [mm]","y [mm]","z [mm]"\n' + text(P, ","))
    ok("head-prose.asc", "Scan of panel 7, 12.3.2019, 600 points\nOperator: H. M.\n\nx y z\n" + text(P), note="a heading with digits in it")
    ok("comment-hash.xyz", "# exported\n#x y z\n" + "".join(lines[:300]) + "# second half\n" + "".join(lines[300:]))
    ok("comment-slashes.asc", "//X Y Z\n" + text(P), note="as CloudCompare writes it")
    ok("comment-semicolon.txt", "; exported 1 2 3\n" + text(P), note="numbers inside the comment are no point")
    ok("comment-behind.xyz", lines[0].rstrip() + "   # first\n" + "".join(lines[1:]))
    ok("commas.csv", text(P, ","))
    ok("comma-space.csv", text(P, ", "))
    ok("semicolons.csv", text(P, ";"))
    ok("tabs.txt", text(P, "\t"))
    ok("spaces.xyz", text(P, "   ", "%12.4f"))
    ok("leading-spaces.xyz", "".join("    " + l for l in lines))
    ok("leading-tab.xyz", "".join("\t" + l for l in lines))
    ok("trailing-separator.csv", text(P, ",", end=",\n"), note="a comma behind the last number")
    ok("cols-intensity.xyz", "".join(l.rstrip() + " %d\n" % (i * 7 % 2048) for i, l in enumerate(lines)))
    ok("cols-rgb.xyz", "".join(l.rstrip() + " %d %d %d\n" % (i % 256, 128, 255) for i, l in enumerate(lines)))
    ok("cols-normals.xyz", "".join(l.rstrip() + " 0.0000 0.1000 0.9950\n" for l in lines))
    ok("cols-label.csv", "x,y,z,class\n" + "".join(l.rstrip().replace(" ", ",") + ",ground\n" for l in lines), note="a fourth column of words")
    ok("crlf.xyz", text(P, end="\r\n"))
    ok("cr.xyz", text(P, end="\r"), note="line ends of old Macs")
    ok("mixed-ends.xyz", "".join(l.rstrip() + ("\r\n" if i % 3 else "\n") for i, l in enumerate(lines)))
    ok("bom.xyz", "\ufeff" + text(P))
    ok("bom-head.csv", "\ufeffx,y,z\r\n" + text(P, ",", end="\r\n"))
    bad("utf16le.xyz", ("\ufeff" + text(P)).encode("utf-16-le"), "utf-16|utf16|encoding")
    bad("utf16be.xyz", ("\ufeff" + text(P)).encode("utf-16-be"), "utf-16|utf16|encoding")
    ok("exponents.xyz", text(P, fmt="%.6e"))
    ok("exponents-mixed.xyz", "".join(" ".join(("%.5E" if (i + a) % 2 else "%.4f") % v for a, v in enumerate(q)) + "\n" for i, q in enumerate(P)))
    ok("plus-signs.xyz", text(P, fmt="%+.4f"))
    ok("bare-points.xyz", re.sub(r"(^|[ -])0\.", r"\1.", text(P), flags=re.M), note=".5 and -.5 without the nought")
    ok("integers.xyz", "".join("%d %d %d\n" % tuple(round(v * 100) for v in q) for q in P), box=box_of(P, 100))
    ok("many-digits.xyz", text(P, fmt="%.17f"), note="more digits than a double holds")
    ok("decimal-comma.csv", text(P, ";").replace(".", ","), note="decimal comma, semicolon between")
    put("decimal-comma-space.txt", text(P).replace(".", ","), c2m, "either", N, "comma", B, note="decimal comma, blank between: read rightly or refused, never read wrongly")
    ok("trailing-blank-lines.xyz", text(P) + "\n\n   \n\n")
    ok("no-final-newline.xyz", text(P).rstrip("\n"))
    ok("blank-lines-between.xyz", "\n".join("".join(lines[k:k + NX]) for k in range(0, N, NX)), note="rows parted by empty lines")
    # rows that are no points
    nan = list(lines); nan[50] = "nan nan nan\n"; nan[51] = "12.0 NaN 3.0\n"; nan[300] = "-nan(ind) 1 2\n"
    put("nan-rows.xyz", "".join(nan), c2m, "warn", N - 3, "nan|finite|skip|ignor", B, note="left out, counted in one warning")
    inf = list(lines); inf[10] = "inf 1 2\n"; inf[11] = "1 -Infinity 2\n"; inf[12] = "1 2 1e999\n"
    put("inf-rows.xyz", "".join(inf), c2m, "warn", N - 3, "inf|finite|range|skip|ignor", B)
    # where the points lie
    ok("duplicates.xyz", "".join(l * 2 for l in lines), n=2 * N)
    dup = list(lines); dup += ["%.4f %.4f %.4f\n" % (x, y, z + 0.5) for x, y, z in P[::50]]
    ok("same-xy-other-z.xyz", "".join(dup), n=len(dup), box=box_of(P), note="two heights over one place: criterion C, larger z")
    reg = [(i * 1.5, j * 1.5, height(i * 1.5, j * 1.5)) for j in range(NY) for i in range(NX)]
    ok("regular-grid.xyz", text(reg), box=box_of(reg), note="equal distances everywhere: criteria A, B, C decide")
    h = math.sqrt(3) / 2
    hexa = [((i + (j & 1) / 2) * 2, j * 2 * h, height((i + (j & 1) / 2) * 2, j * 2 * h)) for j in range(16) for i in range(22)]
    ok("hex-grid.xyz", text(hexa, fmt="%.6f"), n=len(hexa), box=box_of(hexa), note="points exactly on, or midway between, the nodes")
    ok("flat.xyz", text([(x, y, 0) for x, y, z in P]), box=box_of([(x, y, 0) for x, y, z in P]), note="a plane is a good part")
    tilt = [(x, y, 0.5 * x - 0.25 * y + 3) for x, y, z in P]
    ok("flat-tilted.xyz", text(tilt), box=box_of(tilt))
    bad("points-1.xyz", "1 2 3\n", "point|few|area|three|3")
    bad("points-2.xyz", "1 2 3\n4 5 6\n", "point|few|area|three|3")
    put("points-3.xyz", "0 0 0\n10 0 0\n0 10 1\n", c2m, "either", 3, "point|few|area", note="one triangle, or too few: both are honest")
    bad("collinear-x.xyz", "".join("%d 5 0\n" % i for i in range(200)), "line|collinear|area|width|extent|flat")
    bad("collinear-diagonal.xyz", "".join("%.3f %.3f %.3f\n" % (i * .1, i * .2, i * .3) for i in range(200)), "line|collinear|area|width|extent|flat")
    bad("one-place.xyz", "7.5 2.25 1\n" * 200, "same|one place|coincid|identical|area|extent|distinct|width")
    utm = [(x + 500123.4, y + 4649776.2, z + 212.75) for x, y, z in P]
    ok("utm-offset.xyz", text(utm, fmt="%.3f"), box=box_of(utm), note="kept to 0.001: a float would lose it")
    put("inch.xyz", text([(x / 25.4, y / 25.4, z / 25.4) for x, y, z in P], fmt="%.6f"), "cloud2mesh -u inch @", "ok", N, box=B, note="in mm on the way out")
    put("metre.xyz", text([(x / 1e3, y / 1e3, z / 1e3) for x, y, z in P], fmt="%.7f"), "cloud2mesh -u m @", "ok", N, box=B)
    hole = [q for q in P if math.hypot(q[0] - 22, q[1] - 14) > 7]
    ok("hole.xyz", text(hole), n=len(hole), box=box_of(hole), edge=9)
    isl = P + [(x + 80, y, z) for x, y, z in P]
    ok("islands.xyz", text(isl), n=len(isl), box=box_of(isl), edge=20, note="no facet may bridge the 36 mm between")
    put("outliers-z.xyz", text(P[:100] + [(20, 12, 500)] + P[100:400] + [(30, 6, -800)] + P[400:]), c2m, "either", N + 2, "outlier|spike|alone", note="kept, or dropped with a warning; no crash")
    put("outlier-far.xyz", text(P + [(9e8, -9e8, 0)]), c2m, "either", N + 1, "outlier|extent|large|grid|far|spacing", note="the grid must not be allocated over 1e9 mm")
    wall = [(i * .8, j * .8, 0) for i in range(25) for j in range(20)] + [(20, j * .8, k * .8) for j in range(20) for k in range(1, 12)] + \
           [(20.4 + i * .8, j * .8, 9.6) for i in range(20) for j in range(20)]
    ok("wall.xyz", text(wall), n=len(wall), box=box_of(wall), note="a vertical wall at x = 20")
    sh = list(P); random.Random(5).shuffle(sh)
    ok("order-shuffled.xyz", text(sh), note="the mesh of plain.xyz again")
    ok("order-x.xyz", text(sorted(P)), note="the mesh of plain.xyz again")
    ok("order-backwards.xyz", text(P[::-1]), note="the mesh of plain.xyz again")
    zd = [(x, -y, -z - 100) for x, y, z in P]
    ok("z-down.xyz", text(zd), box=box_of(zd), note="depths: z points down and the part lies at -100")
    ng = [(x - 1000, y - 500, z - 30) for x, y, z in P]
    ok("negative.xyz", text(ng), box=box_of(ng))
    steep = [(x, y, 40 * z) for x, y, z in P]
    ok("steep.xyz", text(steep), box=box_of(steep))
    thin = [(x * 20, y / 20, z) for x, y, z in P]
    put("thin-strip.xyz", text(thin, fmt="%.5f"), c2m, "either", N, "width|narrow|spacing|strip|area", box=box_of(thin), note="900 mm long, 1.5 mm wide")
    # damage
    put("long-comment.xyz", "# " + "x" * 150000 + "\n" + text(P), c2m, "ok", N, box=B, note="one line of 150 kB; --big makes one of 1 MB")
    put("long-number.xyz", "".join(lines[:9]) + "1" * 150000 + " 2 3\n" + "".join(lines[9:]), c2m, "either", N, "10:|line 10|long|number|range|finite", B,
        note="a number of 150,000 digits is infinite: left out with a warning, or refused")
    r = random.Random(9)
    bad("binary.xyz", bytes(r.randrange(256) for _ in range(4000)), "binary|text|number|point|charact|byte")
    bad("gzip.xyz", b"\x1f\x8b\x08\x00\x00\x00\x00\x00\x00\x03" + bytes(r.randrange(256) for _ in range(500)), "gzip|compress|binary|text|number|point|charact|byte")
    bad("las.las", b"LASF" + bytes(223) + bytes(r.randrange(256) for _ in range(600)), "las|binary|text|number|point|charact|byte")
    bad("e57.e57", b"ASTM-E57" + struct.pack("<IIQQQQ", 1, 0, 1024, 48, 900, 1024) + bytes(976), "e57|binary|text|number|point|charact|byte")
    bad("nul-inside.xyz", "".join(lines[:20]).encode() + b"1.0 2.0\x00 3.0\n" + "".join(lines[20:]).encode(), "21:|line 21|nul|binary|byte|charact|number")
    bad("empty.xyz", "", "empty|no point|point")
    bad("only-newlines.xyz", "\n\n\n", "empty|no point|point")
    bad("only-head.xyz", "# x y z\nX Y Z\n", "empty|no point|point")
    os.makedirs(os.path.join(out_dir, "directory.xyz"), exist_ok=True)
    with open(os.path.join(out_dir, "directory.xyz", "keep"), "w") as f:
        f.write("a directory where a file is expected\n")
    bad("directory.xyz", None, "directory")
    bad("missing.xyz", None, "no such|not found|cannot open|exist", note="there is no such file")
    bad("cut-mid-line.xyz", text(P)[:9000].rsplit("\n", 1)[0] + "\n12.3456 7.1", "number|column|expected|cut|trunc|short|coordinate", note="the last line has two numbers: the file was cut")
    bad("two-columns.xyz", "".join(l.rsplit(" ", 1)[0] + "\n" for l in lines), "column|number|three|3|z|coordinate")
    mid = list(lines); mid[199] = "12.5 oops 3.5\n"
    bad("word-inside.xyz", "".join(mid), "200", note="names line 200")
    mid = list(lines); mid[199] = "12.5 1.2.3 3.5\n"
    bad("number-inside.xyz", "".join(mid), "200", note="names line 200")
    # other formats of clouds
    inten = "".join(l.rstrip() + " -1200 90 91 92\n" for l in lines)
    ok("cloud.pts", "%d\n" % N + inten)
    bad("cloud-short.pts", "%d\n" % (N + 50) + inten, "650|600|count|fewer|expected", note="650 said, 600 there: cut")
    put("cloud-two.pts", "%d\n" % N + inten + "%d\n" % N + "".join(text([(x + 60, y, z) for x, y, z in P], end=" 5 9 9 9\n")), c2m, "either", 2 * N,
        "601|602|count|line|number|column", note="two scans behind each other: both read, or refused at line 602")
    mat = "1 0 0 0\n0 1 0 0\n0 0 1 0\n%s 0 0 1\n"
    ptx = "%d\n%d\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n" % (NX, NY) + mat % "0"
    put("cloud.ptx", ptx + "".join(l.rstrip() + " 0.5\n" for l in lines), c2m, "either", N, "ptx|column|number|point|format", B, note="ten lines of head are no points")
    put("cloud-empty-cells.ptx", ptx + "".join(("0 0 0 0.5\n" if i % 9 == 4 else l.rstrip() + " 0.5\n") for i, l in enumerate(lines)), c2m, "either", N - 67,
        "ptx|column|number|point|format", B, note="0 0 0 stands for 'nothing measured'")
    put("cloud.pcd", "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH %d\nHEIGHT 1\n"
        "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS %d\nDATA ascii\n" % (N, N) + text(P), c2m, "either", N, "pcd|line|number|column|format", B)
    put("cloud.obj", "# Wavefront\n" + "".join("v " + l for l in lines), c2m, "either", N, "obj|number|line|point|column", B)
    # PLY clouds
    def ply(name, fmt, props, extra_before="", extra_after="", n=N, tail=b"", body=None):
        head = "ply\nformat %s 1.0\ncomment awkward\n%selement vertex %d\n" % (fmt, extra_before[0] if extra_before else "", n)
        head += "".join("property %s %s\n" % (t, p) for t, p in props) + (extra_after[0] if extra_after else "") + "end_header\n"
        code = dict(double="d", float="f", uchar="B", short="h", int="i", uint8="B", float32="f", float64="d", int16="h")
        val = lambda q, p: dict(x=q[0], y=q[1], z=q[2]).get(p, 7)
        if fmt == "ascii":
            b = "".join(" ".join(("%.4f" % val(q, p)) if p in "xyz" else "7" for t, p in props) + "\n" for q in P).encode()
        else:
            e = "<" if "little" in fmt else ">"
            b = b"".join(struct.pack(e + "".join(code[t] for t, p in props), *[val(q, p) for t, p in props]) for q in P)
        return head.encode() + (extra_before[1] if extra_before else b"") + b + (extra_after[1] if extra_after else b"") + tail
    F, D = [("float", a) for a in "xyz"], [("double", a) for a in "xyz"]
    ok("cloud-ascii.ply", ply("", "ascii", F))
    ok("cloud-le.ply", ply("", "binary_little_endian", F))
    ok("cloud-be.ply", ply("", "binary_big_endian", D))
    sh = [("uchar", "red"), ("float", "z"), ("short", "intensity"), ("double", "x"), ("float", "nx"), ("float", "y")]
    ok("cloud-shuffled-ascii.ply", ply("", "ascii", sh), note="z comes before x and y")
    ok("cloud-shuffled-le.ply", ply("", "binary_little_endian", sh))
    ok("cloud-shuffled-be.ply", ply("", "binary_big_endian", [("float32", "y"), ("uint8", "class"), ("float64", "z"), ("int16", "k"), ("float32", "x")]))
    cam = ("element camera 2\nproperty float focal\nproperty list uchar int tags\n",
           b"".join(struct.pack("<fB", 35.0, k) + struct.pack("<%di" % k, *range(k)) for k in (3, 0)))
    ok("cloud-extra-before-le.ply", ply("", "binary_little_endian", F, cam), note="an element of lists before the vertices")
    ok("cloud-extra-after.ply", ply("", "ascii", F, "", ("element range 1\nproperty int a\n", b"4\n")))
    ok("cloud-crlf-head.ply", ply("", "ascii", F).replace(b"\n", b"\r\n"))
    bad("cloud-short.ply", ply("", "ascii", F, n=N + 5), "605|600|vert|end|trunc|fewer|expected")
    bad("cloud-short-le.ply", ply("", "binary_little_endian", F, n=N + 5), "605|600|vert|end|trunc|fewer|expected")
    put("cloud-long.ply", ply("", "ascii", F, n=N - 5), c2m, "either", N - 5, "595|600|vert|more|end|behind|extra", B, note="more rows than said: warned of, or refused")
    bad("cloud-4-billion.ply", ply("", "binary_little_endian", F, n=4294967295), "4294967295|vert|end|trunc|memory|large|count", note="refused without reserving for the count")
    bad("cloud-no-z.ply", ply("", "ascii", F[:2]), "z|propert")


# ---------------------------------------------------------------- meshes
def grid_mesh(nx=13, ny=9, s=3.0):
    v = [(i * s, j * s, height(i * s, j * s)) for j in range(ny) for i in range(nx)]
    f = []
    for j in range(ny - 1):
        for i in range(nx - 1):
            a = j * nx + i
            f += [(a, a + 1, a + nx), (a + 1, a + nx + 1, a + nx)]
    return v, f


def mesh_ply(v, f, fmt="ascii", nv=None, nf=None, head="", listtype="uchar int"):
    h = "ply\nformat %s 1.0\n%selement vertex %s\n" % (fmt, head, len(v) if nv is None else nv)
    h += "".join("property float %s\n" % a for a in "xyz")
    h += "element face %s\nproperty list %s vertex_indices\nend_header\n" % (len(f) if nf is None else nf, listtype)
    if fmt == "ascii":
        return (h + text(v) + "".join("%d %s\n" % (len(t), " ".join(map(str, t))) for t in f)).encode()
    e = "<" if "little" in fmt else ">"
    return h.encode() + b"".join(struct.pack(e + "3f", *q) for q in v) + b"".join(struct.pack(e + "B%di" % len(t), len(t), *t) for t in f)


def make_meshes():
    V, F = grid_mesh()
    B = box_of(V)
    cut = "planecut -r 4 -s 2 -a 90 @"

    def ok(name, data, **k):
        put(name, data, cut, "ok", **k)

    def bad(name, data, must="", **k):
        put(name, data, cut, "refused", must=must, **k)

    ok("mesh.ply", mesh_ply(V, F))
    ok("mesh-le.ply", mesh_ply(V, F, "binary_little_endian"))
    ok("mesh-be.ply", mesh_ply(V, F, "binary_big_endian"))
    put("mesh-no-rows.ply", mesh_ply(V, F), "meshnorm -r 8 --rows mesh @", "refused", must="planecut", note="a mesh without rows: the message says 'use planecut'")
    quads = [(j * 13 + i, j * 13 + i + 1, j * 13 + i + 14, j * 13 + i + 13) for j in range(8) for i in range(12)]
    six = quads[:94] + [(7 * 13 + 10, 7 * 13 + 11, 7 * 13 + 12, 8 * 13 + 12, 8 * 13 + 11, 8 * 13 + 10)]
    ok("mesh-ngons.ply", mesh_ply(V, six), note="quads and a hexagon")
    ok("mesh-degenerate.ply", mesh_ply(V, F + [(3, 3, 4), (5, 5, 5), (0, 1, 2)]), note="facets of no area are passed over")
    put("mesh-one-flipped.ply", mesh_ply(V, [t[::-1] if k == 40 else t for k, t in enumerate(F)]), cut, "either", must="orient|flip|normal|facet")
    put("mesh-all-flipped.ply", mesh_ply(V, [t[::-1] for t in F]), cut, "either", must="orient|flip|normal|down|facet", note="an open sheet whose normals point down")
    put("mesh-doubled.ply", mesh_ply(V, F + F), cut, "either", must="facet|edge|manifold|twice|double|face")
    bad("mesh-index-high.ply", mesh_ply(V, F[:50] + [(0, 1, 117)] + F[50:]), "117|index|vertex")
    bad("mesh-index-negative.ply", mesh_ply(V, F[:50] + [(0, -1, 5)] + F[50:]), "-1|index|vertex")
    bad("mesh-index-high-le.ply", mesh_ply(V, F[:50] + [(0, 1, 2147483647)] + F[50:], "binary_little_endian"), "2147483647|index|vertex")
    bad("mesh-4-billion.ply", mesh_ply(V, F, nv=4000000000), "4000000000|vert|end|trunc|memory|large|count|number", note="refused without reserving for the count")
    bad("mesh-4-billion-faces.ply", mesh_ply(V, F, "binary_little_endian", nf=4294967295), "4294967295|face|end|trunc|memory|large|count")
    bad("mesh-count-overflow.ply", mesh_ply(V, F, nv="18446744073709551617"), "18446744073709551617|vert|count|large|number|range")
    bad("mesh-count-negative.ply", mesh_ply(V, F, nv=-5), "-5|vert|count|number")
    bad("mesh-list-huge.ply", mesh_ply(V, F[:3], "binary_little_endian", listtype="uint int")[:-39] + struct.pack("<I3i", 4294967295, 0, 1, 2),
        "4294967295|list|face|end|trunc|long|count", note="a facet that claims 4 billion corners")
    bad("mesh-list-short.ply", mesh_ply(V, F[:50] + [(1, 2)] + F[50:]), "2|corner|face|facet|vertices|list", note="a facet of two corners")
    bad("mesh-faces-short.ply", mesh_ply(V, F, nf=len(F) + 1), "face|end|trunc|expected|fewer")
    bad("mesh-cut-le.ply", mesh_ply(V, F, "binary_little_endian")[:-7], "face|end|trunc|expected|fewer|short")
    bad("mesh-nan.ply", mesh_ply(V, F).replace(text(V[20:21]).encode(), b"nan 1.0 nan\n", 1), "nan|finite|number|vertex")
    bad("mesh-no-faces.ply", mesh_ply(V, []), "face|facet|triang")
    bad("mesh-empty.ply", mesh_ply([], []), "vert|face|empty|no ")
    bad("mesh-no-end-header.ply", mesh_ply(V, F).replace(b"end_header\n", b""), "header|end_header|line")
    bad("mesh-format.ply", mesh_ply(V, F).replace(b"format ascii", b"format binary_middle_endian"), "format|binary_middle_endian")
    bad("mesh-type.ply", mesh_ply(V, F).replace(b"property float y", b"property quad y"), "quad|type|property")
    bad("not-ply.ply", "plyx\n" + "1 2 3\n" * 20, "ply")
    bad("empty.ply", "", "empty|ply|end")
    stl = "solid part\n" + "".join("facet normal 0 0 1\n outer loop\n" + "".join("  vertex %.4f %.4f %.4f\n" % V[i] for i in t) + " endloop\nendfacet\n" for t in F) + "endsolid part\n"
    put("mesh-ascii.stl", stl, cut, "either", must="stl|ply", note="read, or refused by name")
    put("mesh-binary.stl", b"solid not really".ljust(80) + struct.pack("<I", len(F)) + b"".join(struct.pack("<12fH", 0, 0, 1, *[c for i in t for c in V[i]], 0) for t in F),
        cut, "either", must="stl|ply", note="a binary STL whose head begins with 'solid'")
    bad("mesh-4-billion.stl", bytes(80) + struct.pack("<I", 4294967295) + bytes(50), "stl|ply|facet|face|end|trunc|count")
    put("mesh.off", "OFF\n%d %d 0\n" % (len(V), len(F)) + text(V) + "".join("3 %d %d %d\n" % t for t in F), cut, "either", must="off|ply")


# ---------------------------------------------------------------- IGES
def iges_lines(data, letter, width=72, ptr=None):
    o = []
    for k in range(0, max(len(data), 1), width):
        body = data[k:k + width].ljust(width)
        o.append(body + ("%8d" % ptr if ptr is not None else "") + letter + "%7d" % (k // width + 1))
    return o


def iges(params, unit=2, uname="2HMM", end="\n", ptr_shift=0, typ=128, terminate=True, scale="1.0"):
    s = iges_lines("awkward surface", "S")
    g = iges_lines("1H,,1H;,7Hawkward,7Hawk.igs,4Hmake,1H1,32,38,6,308,15,7Hawkward,%s,%d,%s,1,0.01,13H261121.101010,1D-6,200.,4Hnone,4Hnone,11,0;" % (scale, unit, uname), "G")
    body, p, first = [], [], 1
    # a parameter line breaks at a comma
    cur = ""
    for w in re.findall(r"[^,;]*[,;]", params):
        if len(cur) + len(w) > 64:
            body.append(cur); cur = ""
        cur += w
    body.append(cur)
    for k, b in enumerate(body):
        p.append(b.ljust(64) + "%8d" % 1 + "P%7d" % (k + 1))
    d = ["%8d%8d%8d%8d%8d%8d%8d%8d%8sD%7d" % (typ, first + ptr_shift, 0, 0, 0, 0, 0, 0, "00000000", 1),
         "%8d%8d%8d%8d%8d%16s%8s%8dD%7d" % (typ, 0, 0, len(p), 0, "", "", 0, 2)]
    t = ["S%7dG%7dD%7dP%7d" % (len(s), len(g), len(d), len(p))]
    t[0] = t[0].ljust(72) + "T%7d" % 1
    return end.join(s + g + d + p + (t if terminate else [])) + end


def patch(K1=3, K2=3, M1=3, M2=3, knots=None, weights=None, ranges="0.,1.,0.,1.", poles=None):
    ku = knots or [0] * 4 + [1] * 4
    w = weights or [1.0] * 16
    pol = poles or [(i * 40 / 3, j * 10.0, 5.0 * ((i in (1, 2)) + (j in (1, 2)))) for j in range(4) for i in range(4)]
    num = lambda v: "%.6g" % v if "." in "%.6g" % v or "e" in "%.6g" % v or "n" in "%.6g" % v else "%.6g." % v
    return "128,%s,%s,%s,%s,0,0,1,0,0," % (K1, K2, M1, M2) + ",".join(map(num, ku)) + "," + ",".join(map(num, [0] * 4 + [1] * 4)) + "," + \
        ",".join(map(num, w)) + "," + ",".join(",".join(map(num, q)) for q in pol) + "," + ranges + ";"


def make_iges():
    n2m = "nurbs2mesh @"
    B = [0, 40, 0, 30, 0, 7.5]

    def ok(name, data, box=B, **k):
        put(name, data, n2m, "ok", box=box, **k)

    def bad(name, data, must="", **k):
        put(name, data, n2m, "refused", must=must, **k)

    good = iges(patch())
    ok("surface.igs", good)
    ok("surface-crlf.igs", iges(patch(), end="\r\n"))
    ok("surface-inch.igs", iges(patch(), 1, "4HINCH"), [v * 25.4 for v in B])
    ok("surface-d-exponent.igs", iges(patch().replace("13.3333", "1.33333D+1").replace("26.6667", "2.66667D1")), note="exponents spelt D")
    ok("surface-default-range.igs", iges(patch(ranges="0.,1.,,1.")), note=",, means the default, 0")
    ok("surface-half-range.igs", iges(patch(ranges="0.,0.5,0.,1.")), [0, 20, 0, 30, 0, 7.5], note="the range in u is half the knots")
    ok("surface-no-newline.igs", good.rstrip("\n"))
    put("surface-fixed-records.igs", good.replace("\n", ""), n2m, "either", must="80|line|length|record", box=B, note="80-column records without line ends")
    put("surface-no-terminate.igs", iges(patch(), terminate=False), n2m, "either", must="terminate|T section|end|trunc", box=B)
    bad("surface-no-128.igs", iges("110,0.,0.,0.,10.,0.,0.;", typ=110), "128|surface", note="one line (110), no surface")
    bad("surface-short-line.igs", "\n".join(l[:60] if "P" in l[72:73] and l[73:].strip() == "3" else l for l in good.split("\n")), "line|column|80|length")
    bad("surface-bad-pointer.igs", iges(patch(), ptr_shift=900), "901|pointer|parameter|directory|P ")
    bad("surface-negative-pointer.igs", iges(patch(), ptr_shift=-5), "-4|pointer|parameter|directory|number")
    bad("surface-cut.igs", "\n".join(good.split("\n")[:10]) + "\n", "end|trunc|P|parameter|missing|short")
    bad("surface-few-numbers.igs", iges(patch()[:300].rsplit(",", 1)[0] + ";"), "number|parameter|expected|few|128")
    bad("surface-huge-counts.igs", iges(patch(K1=2147483647, K2=2147483647)), "2147483647|pole|count|number|large|few|parameter")
    bad("surface-negative-counts.igs", iges(patch(K1=-3)), "-3|pole|count|number|degree|index")
    bad("surface-degree-high.igs", iges(patch(M1=9)), "9|degree|pole|knot")
    bad("surface-knots-fall.igs", iges(patch(knots=[0, 0, 0, 0.5, 0.2, 1, 1, 1])), "knot")
    bad("surface-zero-weight.igs", iges(patch(weights=[1.0] * 5 + [0.0] + [1.0] * 10)), "weight")
    bad("surface-nan-pole.igs", iges(patch().replace("13.3333", "nan", 1)), "nan|number|finite")
    bad("not-iges.igs", "this is a letter, not a drawing\n" * 12, "iges|line|column|section")
    bad("empty.igs", "", "empty|iges|end")


# ---------------------------------------------------------------- CL files
HEAD = "PARTNO/AWKWARD\nUNITS/MM\nMULTAX/ON\nCUTTER/16.000000,8.000000,0.000000,8.000000,0.000000,0.000000,60.000000\nLOADTL/1\nSPINDL/RPM,8000.000000,CLW\n"


def goto(x, y, z, a=0.0, b=0.1):
    l = math.sqrt(a * a + b * b + 1)
    return "GOTO/%.6f,%.6f,%.6f,%.9f,%.9f,%.9f\n" % (x, y, z, a / l, b / l, 1 / l)


def path_body(n=20):
    s = "$$-> PASS/1\nRAPID\n" + goto(0, 0, 30, 0, 0.1) + "FEDRAT/MMPM,800.000000\n"
    return s + "".join(goto(i * 1.5, 5, height(i * 1.5, 5), 0.02 * math.sin(i / 5), 0.1) for i in range(n))


def make_cl():
    post = "ncpost -c fanuc @"
    body, fini = path_body(), "RAPID\n" + goto(30, 5, 40, 0, 0.1) + "FINI\n"
    good = HEAD + body + fini

    def ok(name, data, **k):
        put(name, data, post, "ok", **k)

    def bad(name, data, must="", **k):
        put(name, data, post, "refused", must=must, **k)

    def with_(extra):
        return HEAD + body + extra + fini

    at = goto(28.5, 5, 0)          # where the arcs begin
    arc = at + "CIRCLE/34.500000,5.000000,0.000000,0.000000,0.000000,1.000000,%s\n"
    ok("path.cl", good)
    ok("path-arc.cl", with_(arc % "6.0" + goto(40.5, 5, 0)))
    ok("path-full-circle.cl", with_(arc % "6.0" + at), note="start = end is a full circle")
    ok("path-crlf.cl", good.replace("\n", "\r\n"))
    ok("path-bom.cl", "\ufeff" + good)
    ok("path-tabs.cl", good.replace(",", ",\t"))
    put("path-lower.cl", good.lower(), post, "either", must="partno|units|goto|word|case", note="lower case: read, or refused at the first word")
    ok("path-inch.cl", good.replace("UNITS/MM", "UNITS/INCHES"))
    ok("path-three-numbers.cl", (HEAD + "GOTO/0,0,10\nGOTO/5,0,9\nGOTO/9,0,9\nFINI\n").replace("MULTAX/ON\n", ""))
    ok("path-behind-fini.cl", good + "this is not\nread any more \x01 nan\n", note="what stands behind FINI is ignored")
    ok("path-latin1.cl", good.replace("AWKWARD", "M\xdcLLER $ no continuation").encode("latin-1"), note="raw text behind PARTNO")
    ok("path-continued.cl", with_("GOTO/33.0,5.0, $ $$ first half\n  2.0,0,0, $\n1\n"))
    put("path-unknown-word.cl", with_("FROBNI/ON,3\n"), post, "warn", must="FROBNI", note="a post-processor word nobody knows: one warning")
    put("path-unknown-many.cl", with_("FROBNI/ON,3\n" * 500), post, "warn", must="FROBNI", note="the same word 500 times: not 500 lines of warning")
    put("path-unknown-strict.cl", with_("FROBNI/ON,3\n"), "ncpost -c fanuc --strict @", "refused", must="FROBNI")
    bad("path-no-fini.cl", HEAD + body, "FINI")
    put("path-no-fini-biarc.cl", HEAD + body, "biarcfit @", "refused", must="FINI")
    put("path-no-fini-bspl.cl", HEAD + body, "bsplfit -e 0.01 @", "refused", must="FINI")
    bad("path-cut-mid-number.cl", good[:700], "FINI|end|trunc|line|number")
    bad("path-only-head.cl", HEAD, "FINI")
    put("path-no-motion.cl", HEAD + "FINI\n", post, "either", must="motion|GOTO|empty|no ", note="nothing to cut")
    bad("path-empty.cl", "", "empty|FINI|end")
    bad("path-binary.cl", bytes(range(256)) * 8, "1:|line 1|charact|binary|word|text|byte")
    bad("path-nan.cl", with_("GOTO/nan,1,2,0,0,1\n"), "nan|number|finite")
    bad("path-inf-axis.cl", with_("GOTO/1,1,2,0,inf,1\n"), "inf|number|finite")
    bad("path-overflow.cl", with_("GOTO/1e308,1,2e308,0,0,1\n"), "large|range|limit|travel|number|finite|e308|far")
    bad("path-goto-5.cl", with_("GOTO/1,2,3,0,1\n"), "5|six|6|number|GOTO")
    bad("path-goto-2.cl", with_("GOTO/1,2\n"), "2|three|3|number|GOTO")
    bad("path-goto-word.cl", with_("GOTO/1,2,three\n"), "three|number")
    bad("path-axis-zero.cl", with_("GOTO/33,5,2,0,0,0\n"), "axis|zero|length|vector")
    put("path-axis-long.cl", with_("GOTO/33,5,2,0,0,2.5\n"), post, "either", must="axis|unit|length|vector|normal")
    bad("path-circle-fini.cl", HEAD + body + arc % "6.0" + "FINI\n", "CIRCLE|GOTO|arc")
    bad("path-circle-circle.cl", with_(arc % "6.0" + arc[len(at):] % "6.0" + goto(40.5, 5, 0)), "CIRCLE|GOTO|arc")
    bad("path-circle-zero.cl", with_(arc % "0.0" + goto(34.5, 5, 0)), "radius|CIRCLE|arc")
    bad("path-circle-negative.cl", with_(arc % "-6.0" + goto(40.5, 5, 0)), "radius|CIRCLE|arc")
    bad("path-circle-axis-zero.cl", with_(at + "CIRCLE/34.5,5,0,0,0,0,6\n" + goto(40.5, 5, 0)), "axis|zero|CIRCLE|arc")
    bad("path-circle-off.cl", with_(arc % "6.0" + goto(90, 50, 0)), "radius|CIRCLE|arc|end|start", note="start and end are not at the radius from the centre")
    bad("path-circle-5.cl", with_(at + "CIRCLE/34.5,5,0,0,1\n" + goto(40.5, 5, 0)), "CIRCLE|number|arc")
    bad("path-unknown-geometry.cl", with_("SPLINE/1,2,3,4\nTHRU/9\nCYLNDR/1,2,3,4,5,6,7\n"), "SPLINE|THRU|CYLNDR", note="an unknown geometry word is always an error")
    bad("path-continued-eof.cl", good.replace("FINI\n", "GOTO/1,2,$\n"), "FINI|continu|end|number")
    put("path-continued-long.cl", with_("FROBNI/" + ",".join(["1.25"] * 60 + ["$\n"]) * 500 + "1\n"), post, "either", must="FROBNI|long|line|continu",
        note="one statement of 150 kB; --big makes one of more than a million characters")
    bad("path-units.cl", good.replace("UNITS/MM", "UNITS/CUBITS"), "CUBITS|unit")
    bad("path-fedrat-nan.cl", with_("FEDRAT/MMPM,nan\nGOTO/33,5,2,0,0,1\n"), "nan|number|feed|FEDRAT")
    put("path-fedrat-zero.cl", with_("FEDRAT/MMPM,0\nGOTO/33,5,2,0,0,1\n"), post, "either", must="feed|FEDRAT|zero|0")


# ---------------------------------------------------------------- machine files
MACHINE = """# as the design's 2-streams.md has it: key = value, one a line
name     = Table-table A/C trunnion
control  = fanuc
type     = table-table
axes     = A C                    # outer (master) first
axis.A   = 1 0 0
centre.A = 0 0 0
tcp      = yes
x.min    = -400
x.max    = 400
a.min    = -110
a.max    = 30
c.min    = -99999
c.max    = 99999
rapid    = 30000
digits.linear = 3
"""


def make_machines(good):
    text_ = open(good).read() if good else MACHINE
    cmd = "ncpost -c fanuc -m @ path.cl"
    note = "made from %s" % os.path.basename(good) if good else ""
    # lines 'key SEPARATOR value'
    kv = [(k, l) for k, l in enumerate(text_.splitlines()) if re.match(r"\s*[A-Za-z]", l) and re.search(r"[=:\s]", l.strip())]
    lines = text_.splitlines()
    numeric = [(k, l) for k, l in kv if re.search(r"[=:\s][-+]?\d[\d.]*\s*$", l)] or kv
    join = lambda L: "\n".join(L) + "\n"
    m = re.match(r"(\s*)([A-Za-z][\w.-]*)(\s*[=:]?\s*)(.*)", numeric[-1][1])

    def bad(name, data, must):
        put(name, data, cmd, "refused", must=must, note=note)

    put("machine.txt", text_, cmd, "ok", note=note)
    bad("machine-unknown-key.txt", join(lines + [m.group(1) + "frobnicate" + m.group(3) + "7"]), "frobnicate")
    bad("machine-duplicate-key.txt", join(lines + [numeric[-1][1]]), m.group(2) + "|twice|again|duplicate")
    bad("machine-bad-number.txt", join(lines[:numeric[-1][0]] + [m.group(1) + m.group(2) + m.group(3) + "12.3.4"] + lines[numeric[-1][0] + 1:]), r"12.3.4|number")
    bad("machine-nan.txt", join(lines[:numeric[-1][0]] + [m.group(1) + m.group(2) + m.group(3) + "nan"] + lines[numeric[-1][0] + 1:]), "nan|number|finite")
    bad("machine-no-value.txt", join(lines[:numeric[-1][0]] + [m.group(1) + m.group(2)] + lines[numeric[-1][0] + 1:]), m.group(2) + "|value|expected")
    # limits the wrong way round: either 'k.min = a' and 'k.max = b', or 'key = a b' with a < b
    sw = list(lines)
    for k, l in kv:
        two = re.match(r"(.*?)([-+]?\d[\d.]*)([\s,:]+|\.\.)([-+]?\d[\d.]*)\s*$", l)
        if two and float(two.group(2)) < float(two.group(4)) and re.search("limit|travel|range", l):
            sw[k] = two.group(1) + two.group(4) + two.group(3) + two.group(2)
            break
        if re.search("min", l) and re.search(r"[-+]?\d[\d.]*\s*$", l):
            sw[k] = re.sub(r"[-+]?\d[\d.]*\s*$", "99999", l)
            break
    bad("machine-limits-swapped.txt", join(sw), "min|max|limit|travel|range")
    bad("machine-empty-name.txt", join(lines + ["= 5"]), "key|name|line|expected|=")
    bad("machine-include-self.txt", "include = machine-include-self.txt\n" + text_, "include|itself|loop|cycle|deep")
    bad("machine-include-missing.txt", "include = nowhere.txt\n" + text_, "nowhere.txt")
    bad("machine-binary.txt", bytes(range(256)), "1:|line|charact|binary|text|key|byte")
    put("machine-missing.txt", None, cmd, "refused", must="no such|not found|cannot open|exist", note="there is no such file")


def make_big():
    P = cloud()
    lines = text(P)
    put("big-comment.xyz", "# " + "x" * 1000000 + "\n" + lines, "cloud2mesh @", "ok", len(P), box=box_of(P))
    put("big-row.xyz", lines + "1 2 3" + " 4" * 500000 + "\n", "cloud2mesh @", "either", len(P) + 1, "line|long|column|number|601", note="a row of half a million columns")
    put("big-number.xyz", lines + "0" * 1000000 + "1 2 3\n", "cloud2mesh @", "either", len(P) + 1, "line|long|number|601")
    put("big-no-newline.xyz", "7" * 3000000, "cloud2mesh @", "refused", must="line|long|number|point|column")
    put("big-continuation.cl", HEAD + path_body() + "FROBNI/" + "1.25,$\n" * 300000 + "1\nFINI\n", "ncpost -c fanuc @", "either", must="FROBNI|long|line|continu")
    put("big-comment.cl", HEAD + "$$ " + "y" * 2000000 + "\n" + path_body() + "FINI\n", "ncpost -c fanuc @", "ok")


FIELDS = ["file", "command", "expect", "points", "must_name", "box", "longest_edge", "note"]


def write_expected():
    with open(os.path.join(out_dir, "expected.csv"), "w", newline="") as f:
        w = csv.DictWriter(f, FIELDS, lineterminator="\n")
        w.writeheader()
        w.writerows(rows)


# ---------------------------------------------------------------- checking
def read_ply(b):
    """Vertices and faces of an ASCII PLY as the suite writes it; ValueError when it is not complete."""
    head, _, rest = b.partition(b"end_header\n")
    if not head.startswith(b"ply\nformat ascii 1.0\n") or not _:
        raise ValueError("no ASCII PLY on standard output")
    t = head.decode("ascii", "replace")
    nv = int(re.search(r"element vertex (\d+)", t).group(1))
    nf = int((re.search(r"element face (\d+)", t) or re.match("(0)?", "0")).group(1))
    props = re.findall(r"property \w+ (\w+)\n", t.split("element face")[0])
    L = rest.decode("ascii", "replace").splitlines()
    if len(L) != nv + nf:
        raise ValueError("PLY says %d + %d rows, %d are there" % (nv, nf, len(L)))
    ix = [props.index(a) for a in "xyz"]
    v = []
    for l in L[:nv]:
        w = [float(x) for x in l.split()]
        if len(w) != len(props) or not all(map(math.isfinite, w)):
            raise ValueError("PLY vertex row '%s'" % l[:60])
        v.append(tuple(w[i] for i in ix))
    f = [tuple(map(int, l.split()))[1:] for l in L[nv:]]
    if any(not 0 <= i < nv for t in f for i in t):
        raise ValueError("PLY face index out of range")
    return v, f


def complete(out):
    """Does this output look finished to whoever reads it next?"""
    if out.startswith(b"ply"):
        try:
            read_ply(out)
            return True
        except (ValueError, AttributeError, IndexError):
            return False
    return bool(re.search(rb"(?m)^FINI\b|\bM0?30\b|\bM0?2\b\s*$|^\d*\s*END PGM", out))


def tidy(err, tool, most):
    L = [l for l in err.split(b"\n") if l.strip()]
    if not L:
        return "nothing on standard error"
    if not L[0].startswith(tool.encode() + b":"):
        return "message does not begin with '%s:': %r" % (tool, L[0][:60])
    if len(L) > most:
        return "%d lines on standard error" % len(L)
    if any(len(l) > 400 for l in L):
        return "a message of %d characters" % max(map(len, L))
    if re.search(rb"[\x00-\x08\x0b-\x1f\x7f]", err):
        return "control characters in the message"
    return ""


def named(must, err):
    return not must or any(w.lower() in err.decode("utf-8", "replace").lower() for w in must.split("|"))


def judge(row, rc, out, err, tool):
    """'' when the run is what the row expects, else what is wrong."""
    if rc < 0:
        return "killed by signal %d" % -rc
    e = row["expect"]
    if e == "refused" or (e == "either" and rc != 0):
        if rc not in ((1,) if not tool == "ncpost" else (1, 2, 3) if "machine" in row["file"] else (1, 3) if "overflow" in row["file"] else (1,)):
            return "exit %d, not 1" % rc
        if complete(out):
            return "refused, yet the output looks complete"
        return tidy(err, tool, 3) or ("" if named(row["must_name"], err) else "message names none of %s: %r" % (row["must_name"], err[:120])) or \
            ("" if os.path.basename(row["file"]) in err.decode("utf-8", "replace") else "message does not name the file: %r" % err[:120])
    if rc != 0:
        return "exit %d, not 0: %r" % (rc, err[:120])
    if e == "warn":
        bad = tidy(err, tool, 20) or ("" if named(row["must_name"], err) else "warning names none of %s: %r" % (row["must_name"], err[:120]))
        if bad:
            return bad
    if tool in ("cloud2mesh", "nurbs2mesh"):
        try:
            v, f = read_ply(out)
        except (ValueError, AttributeError, IndexError) as x:
            return "output: %s" % x
        if not f:
            return "a mesh without facets"
        if row["box"]:
            b, m = list(map(float, row["box"].split())), box_of(v)
            for a in range(3):
                lo, hi = b[2 * a], b[2 * a + 1]
                s = hi - lo
                if m[2 * a] < lo - .1 * s - .6 or m[2 * a + 1] > hi + .1 * s + .6 or m[2 * a] > lo + .3 * s + .6 or m[2 * a + 1] < hi - .3 * s - .6:
                    return "%s runs %.3f … %.3f, the points %.3f … %.3f" % ("xyz"[a], m[2 * a], m[2 * a + 1], lo, hi)
        if row["longest_edge"]:
            worst = max(math.dist(v[t[k]][:2], v[t[k - 1]][:2]) for t in f for k in range(len(t)))
            if worst > float(row["longest_edge"]):
                return "a facet edge of %.2f in xy" % worst
    elif not complete(out):
        return "exit 0, yet the output is not complete"
    return ""


def check(bin_dir, only, limit):
    with open(os.path.join(out_dir, "expected.csv"), newline="") as f:
        todo = [r for r in csv.DictReader(f) if only in (None, r["command"].split()[0])]
    bin_dir = os.path.abspath(bin_dir)
    if limit:
        resource.setrlimit(resource.RLIMIT_AS, (2 << 30, 2 << 30))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    held = 0
    for row in todo:
        words = row["command"].split()
        tool, exe = words[0], os.path.join(bin_dir, words[0])
        if not os.access(exe, os.X_OK):
            why = "no tool %s in %s" % (tool, bin_dir)
        else:
            argv = [tool] + [row["file"] if w == "@" else w for w in words[1:]]
            try:
                with tempfile.TemporaryFile() as o:
                    p = subprocess.run(argv, executable=exe, cwd=out_dir, stdin=subprocess.DEVNULL, stdout=o, stderr=subprocess.PIPE, timeout=10)
                    o.seek(0)
                    why = judge(row, p.returncode, o.read(), p.stderr, tool)
            except subprocess.TimeoutExpired:
                why = "still running after 10 s"
        held += not why
        if why:
            print("%-30s %s" % (row["file"], why))
    print("%d of %d" % (held, len(todo)))
    return 0 if held == len(todo) else 1


def main(a):
    global out_dir
    machine = big = bin_dir = only = None
    limit = True
    while a and a[0].startswith("--"):
        o = a.pop(0)
        if o == "--machine":
            machine = a.pop(0)
        elif o == "--check":
            bin_dir = a.pop(0)
        elif o == "--tool":
            only = a.pop(0)
        elif o == "--no-limit":
            limit = False
        elif o == "--big":
            big = True
        else:
            sys.stdout.write(__doc__)
            return 0 if o == "--help" else 2
    out_dir = a[0] if a else os.path.dirname(os.path.abspath(__file__))
    if bin_dir:
        return check(bin_dir, only, limit)
    os.makedirs(out_dir, exist_ok=True)
    make_clouds(); make_meshes(); make_iges(); make_cl(); make_machines(machine)
    if big:
        make_big()
    write_expected()
    print("%d rows in expected.csv" % len(rows))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
