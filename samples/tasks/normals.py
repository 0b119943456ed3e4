#!/usr/bin/env python3
# normals.py - own normals between cloud2mesh and meshnorm: those of the facets, weighted by area.
import sys
head, body = sys.stdin.read().split("end_header\n")
n = int(head.split("element vertex ")[1].split()[0])
rows = [line.split() for line in body.splitlines()]
point = [tuple(map(float, r[:3])) for r in rows[:n]]
normal = [[0.0, 0.0, 0.0] for _ in range(n)]
for a, b, c in (map(int, r[1:4]) for r in rows[n:]):
    u, v = ([point[i][k] - point[a][k] for k in range(3)] for i in (b, c))
    for i in (a, b, c):
        for k in range(3):
            normal[i][k] += u[k - 2] * v[k - 1] - u[k - 1] * v[k - 2]
for r, m in zip(rows, normal):
    r[3:6] = ["%.9f" % (x / (sum(y * y for y in m) ** 0.5 or 1)) for x in m]
print(head + "end_header\n" + "\n".join(map(" ".join, rows)))
