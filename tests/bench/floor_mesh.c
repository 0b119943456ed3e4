/*
 * floor_mesh - the floor for a mesh with normals of the facets: the file is read and parsed twice,
 * for the extent and for the point nearest to each node of a 1 mm grid, then the facets between
 * neighbouring nodes and the mean of their normals, as ASCII PLY.  No checks, no ties, no holes.
 *
 *     floor_mesh SPACING FILE
 */
#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "floor.h"

static char text[FLOOR_CHUNK + 512];
static size_t used;

struct node {
    double x, y, z, d2;
};

static double low[2] = {1e30, 1e30}, high[2] = {-1e30, -1e30}, t;
static long columns, rows;
static struct node *node;

static void extend(double x, double y, double z)
{
    (void)z;
    low[0] = x < low[0] ? x : low[0];
    low[1] = y < low[1] ? y : low[1];
    high[0] = x > high[0] ? x : high[0];
    high[1] = y > high[1] ? y : high[1];
}

static void compete(double x, double y, double z)
{
    double v = (y - low[1]) / (t * 0.8660254037844386), u = (x - low[0]) / t;
    long row = (long)(v + 0.5), column = (long)(u + (row & 1 ? 0 : 0.5));
    double dx = (u - (double)column - (row & 1 ? 0.5 : 0)) * t,
           dy = y - low[1] - (double)row * t * 0.8660254037844386;
    double d2 = dx * dx + dy * dy;
    struct node *n = &node[row * columns + column];
    if (d2 < n->d2)
        *n = (struct node){x, y, z, d2};
}

static int read_all(const char *file, void (*take)(double x, double y, double z))
{
    int fd = open(file, O_RDONLY);
    floor_rows(fd, take);
    close(fd);
    return fd < 0;
}

static void flush(void)
{
    if (write(1, text, used) < 0)
        exit(1);
    used = 0;
}

static void put(double value, double scale, int places, char after)
{
    char digits[32], *p = digits + sizeof digits;
    long n = lrint(fabs(value) * scale);
    *--p = after;
    for (int i = 0; i <= places || n; i++, n /= 10) {
        if (i == places && places)
            *--p = '.';
        *--p = (char)('0' + n % 10);
    }
    if (value < 0)
        *--p = '-';
    memcpy(text + used, p, (size_t)(digits + sizeof digits - p));
    used += (size_t)(digits + sizeof digits - p);
    if (used > FLOOR_CHUNK)
        flush();
}

/* The corners of the two facets that begin at a node. */
static void corners(long row, long column, long corner[2][3])
{
    long at = row * columns + column, up = at + columns, odd = row & 1;
    corner[0][0] = at, corner[0][1] = at + 1, corner[0][2] = up + odd;
    corner[1][0] = at + !odd, corner[1][1] = up + 1, corner[1][2] = up;
    if (odd)
        corner[1][0] = at, corner[1][1] = up + 1, corner[1][2] = up;
}

static int is_facet(const long c[3])
{
    return node[c[0]].d2 < 1e29 && node[c[1]].d2 < 1e29 && node[c[2]].d2 < 1e29;
}

int main(int argc, char **argv)
{
    long facets = 0, vertices = 0, corner[2][3];
    if (argc < 3)
        return 2;
    t = atof(argv[1]);
    if (read_all(argv[2], extend))
        return 1;
    columns = (long)((high[0] - low[0]) / t) + 3;
    rows = (long)((high[1] - low[1]) / t / 0.8660254037844386) + 3;
    node = malloc((size_t)(rows * columns) * sizeof *node);
    for (long i = 0; i < rows * columns; i++)
        node[i].d2 = 1e30;
    read_all(argv[2], compete);
    float(*sum)[3] = calloc((size_t)(rows * columns), sizeof *sum);
    int *name = malloc((size_t)(rows * columns) * sizeof *name);
    for (long i = 0; i < rows * columns; i++)
        name[i] = node[i].d2 < 1e29 ? (int)vertices++ : -1;
    for (long row = 0; row + 1 < rows; row++)
        for (long column = 0; column + 1 < columns; column++) {
            corners(row, column, corner);
            for (int k = 0; k < 2; k++) {
                const long *c = corner[k];
                if (!is_facet(c))
                    continue;
                struct node p = node[c[0]], q = node[c[1]], r = node[c[2]];
                double ax = q.x - p.x, ay = q.y - p.y, az = q.z - p.z, bx = r.x - p.x,
                       by = r.y - p.y, bz = r.z - p.z;
                double x = ay * bz - az * by, y = az * bx - ax * bz, z = ax * by - ay * bx;
                double length = sqrt(x * x + y * y + z * z);
                facets++;
                for (int i = 0; i < 3; i++) {
                    sum[c[i]][0] += (float)(x / length);
                    sum[c[i]][1] += (float)(y / length);
                    sum[c[i]][2] += (float)(z / length);
                }
            }
        }
    used = (size_t)sprintf(
        text,
        "ply\nformat ascii 1.0\nelement vertex %ld\nproperty double x\nproperty double y\n"
        "property double z\nproperty double nx\nproperty double ny\nproperty double nz\n"
        "element face %ld\nproperty list uchar int vertex_indices\nend_header\n",
        vertices, facets);
    for (long i = 0; i < rows * columns; i++) {
        if (name[i] < 0)
            continue;
        double length = sqrt(sum[i][0] * sum[i][0] + sum[i][1] * sum[i][1] + sum[i][2] * sum[i][2]);
        put(node[i].x, 1e6, 6, ' ');
        put(node[i].y, 1e6, 6, ' ');
        put(node[i].z, 1e6, 6, ' ');
        put(sum[i][0] / length, 1e9, 9, ' ');
        put(sum[i][1] / length, 1e9, 9, ' ');
        put(sum[i][2] / length, 1e9, 9, '\n');
    }
    for (long row = 0; row + 1 < rows; row++)
        for (long column = 0; column + 1 < columns; column++) {
            corners(row, column, corner);
            for (int k = 0; k < 2; k++)
                if (is_facet(corner[k])) {
                    put(3, 1, 0, ' ');
                    put(name[corner[k][0]], 1, 0, ' ');
                    put(name[corner[k][1]], 1, 0, ' ');
                    put(name[corner[k][2]], 1, 0, '\n');
                }
        }
    flush();
    return 0;
}
