/*
 * trim_grid: the triangles have the area of the polygons and none is turned over; on random stars
 * with holes, on polygons along the lines, through the nodes, smaller than a cell and outside the
 * grid.
 */
#include <check.h>
#include <stdint.h>
#include <stdlib.h>

#include "nurbs/trim_grid.h"
#include "seed.h"

static uint64_t seed;

static double chance(void)
{
    seed = seed * 6364136223846793005u + seed_step();
    return (double)(seed >> 11) / 9007199254740992.0;
}

static double uniform(double low, double high)
{
    return low + (high - low) * chance();
}

static struct doubles lines(int n)
{
    struct doubles d = {0};
    for (int i = 0; i <= n; i++)
        *array_push(&d) = (double)i / n;
    return d;
}

static double area_of(struct uv a, struct uv b, struct uv c)
{
    return ((b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u)) / 2;
}

static double loop_area(const struct uvs *l)
{
    double sum = 0;
    for (size_t i = 0; i < l->n; i++)
        sum += area_of((struct uv){0, 0}, l->item[i], l->item[(i + 1) % l->n]);
    return fabs(sum);
}

/* A star about a centre; runs backwards now and then. */
static struct uvs star(double u, double v, double least, double most, int n)
{
    struct uvs s = {0};
    bool backwards = chance() < 0.5;
    for (int i = 0; i < n; i++) {
        double a = 2 * PI * (backwards ? n - i : i) / n, r = least + (most - least) * chance();
        *array_push(&s) = (struct uv){u + r * cos(a), v + r * sin(a)};
    }
    return s;
}

/* The sum of the triangles, each counter-clockwise. */
static double checked_area(const struct uvmesh *m)
{
    double sum = 0;
    for (size_t i = 0; i < m->face.n; i++) {
        const int *v = m->face.item[i].v;
        double a = area_of(m->at.item[v[0]], m->at.item[v[1]], m->at.item[v[2]]);
        ck_assert_double_gt(a, -1e-9);
        sum += a;
    }
    ck_assert_uint_eq(m->unclear, 0);
    return sum;
}

static void cut_and_compare(int nu, int nv, struct uv_polygon *loops, bool open, double area,
                            double within)
{
    struct doubles u = lines(nu), v = lines(nv);
    struct uvmesh mesh;
    trim_grid(&u, &v, loops, open, &mesh);
    double found = checked_area(&mesh);
    ck_assert_msg(fabs(found - area) < within, "area %.12g, expected %.12g (%d x %d)", found, area,
                  nu, nv);
    uvmesh_free(&mesh);
    array_free(&u);
    array_free(&v);
}

START_TEST(stars_with_holes)
{
    seed = 4;
    for (int turn = 0; turn < 300; turn++) {
        struct uv_polygon loops = {0};
        double area = 0;
        *array_push(&loops) = star(0.5, 0.5, 0.4, 0.49, 5 + (int)(60 * chance()));
        *array_push(&loops) = star(0.5, 0.5, 0.2, 0.3, 5 + (int)(40 * chance()));
        *array_push(&loops) = star(0.5, 0.5, 0.01, 0.15, 3 + (int)(9 * chance()));
        for (size_t i = 0; i < 3; i++)
            area += (i == 1 ? -1 : 1) * loop_area(&loops.item[i]);
        int nu = 1 + (int)(30 * chance()), nv = 1 + (int)(30 * chance());
        cut_and_compare(nu, nv, &loops, false, area, 1e-7);
        cut_and_compare(nu, nv, &loops, true, 1 - area, 1e-7);
        uv_polygon_free(&loops);
    }
}
END_TEST

static void add_box(struct uv_polygon *loops, double u0, double v0, double u1, double v1)
{
    struct uvs box = {0};
    *array_push(&box) = (struct uv){u0, v0};
    *array_push(&box) = (struct uv){u1, v0};
    *array_push(&box) = (struct uv){u1, v1};
    *array_push(&box) = (struct uv){u0, v1};
    *array_push(loops) = box;
}

/* Boxes whose sides lie on lines, and within rounding of them: no slivers, so no more triangles
 * than whole cells have. */
START_TEST(along_the_lines)
{
    static const double off[] = {0, 1e-12, -1e-12, 1e-9, -1e-9, 2e-8};
    for (size_t i = 0; i < sizeof off / sizeof *off; i++) {
        struct doubles u = lines(8), v = lines(8);
        struct uv_polygon loops = {0};
        struct uvmesh mesh;
        double e = off[i];
        add_box(&loops, 0.125 + e, 0.25 - e, 0.75 + e, 1 + e);
        trim_grid(&u, &v, &loops, false, &mesh);
        ck_assert_double_lt(fabs(checked_area(&mesh) - 0.625 * 0.75), 1e-6);
        size_t used = 0;
        for (size_t k = 0; k < mesh.face.n; k++) {
            const int *c = mesh.face.item[k].v;
            used += area_of(mesh.at.item[c[0]], mesh.at.item[c[1]], mesh.at.item[c[2]]) > 1e-6;
        }
        ck_assert_uint_eq(used, 2 * 5 * 6);
        uvmesh_free(&mesh);
        uv_polygon_free(&loops);
        array_free(&u);
        array_free(&v);
    }
}
END_TEST

START_TEST(whole_and_outside)
{
    struct uv_polygon loops = {0};
    add_box(&loops, 0, 0, 1, 1);
    cut_and_compare(7, 5, &loops, false, 1, 1e-12);
    uv_polygon_free(&loops);
    add_box(&loops, -0.5, -0.5, 1.5, 1.5);
    cut_and_compare(7, 5, &loops, false, 1, 1e-12);
    add_box(&loops, 0.5, 0.5, 0.50001, 0.50001);
    cut_and_compare(7, 5, &loops, false, 1 - 1e-10, 1e-9);
    uv_polygon_free(&loops);
    cut_and_compare(3, 3, &loops, true, 1, 1e-12);
}
END_TEST

/* Through the nodes, corner to corner. */
START_TEST(through_the_nodes)
{
    for (int n = 1; n <= 16; n *= 2) {
        struct uv_polygon loops = {0};
        struct uvs d = {0};
        *array_push(&d) = (struct uv){0.5, 0};
        *array_push(&d) = (struct uv){1, 0.5};
        *array_push(&d) = (struct uv){0.5, 1};
        *array_push(&d) = (struct uv){0, 0.5};
        *array_push(&loops) = d;
        cut_and_compare(n, n, &loops, false, 0.5, 1e-6);
        uv_polygon_free(&loops);
    }
}
END_TEST

START_TEST(inside)
{
    struct uv_polygon loops = {0};
    add_box(&loops, 0.2, 0.2, 0.8, 0.8);
    add_box(&loops, 0.4, 0.4, 0.6, 0.6);
    ck_assert(uv_polygon_inside(&loops, false, (struct uv){0.3, 0.5}));
    ck_assert(!uv_polygon_inside(&loops, false, (struct uv){0.5, 0.5}));
    ck_assert(!uv_polygon_inside(&loops, false, (struct uv){0.1, 0.5}));
    ck_assert(uv_polygon_inside(&loops, true, (struct uv){0.1, 0.5}));
    uv_polygon_free(&loops);
}
END_TEST

/* The snap: lines are even and rise, places odd and on the side of each line that they are on.
 */
START_TEST(sides_of_lines)
{
    for (int turn = 0; turn < 50; turn++) {
        struct doubles line = {0};
        double from = uniform(-1e6, 1e6), width = uniform(1e-3, 1e6), x = 0;
        while (x < 1) {
            *array_push(&line) = from + x * width;
            x += uniform(0.001, 0.2);
        }
        *array_push(&line) = from + width;
        struct trim_snap a = trim_snap_new(&line);
        ck_assert_uint_eq(a.n, line.n);
        for (size_t i = 0; i < a.n; i++) {
            ck_assert_int_eq(a.line[i] % 2, 0);
            ck_assert(i == 0 || a.line[i] > a.line[i - 1]);
        }
        for (int i = 0; i < 400; i++) {
            double place = from + uniform(0.0005, 0.9995) * width;
            size_t below = 0;
            double near = width;
            for (size_t k = 0; k < line.n; k++) {
                below += line.item[k] < place;
                near = fmin(near, fabs(line.item[k] - place));
            }
            int64_t at = trim_snap_place(&a, place, 1);
            ck_assert_int_eq(at & 1, 1);
            if (near > 4.6e-7 * width) /* nearer ones go to the side of `inwards` */
                ck_assert_uint_eq(trim_snap_below(&a, at), below);
        }
        trim_snap_free(&a);
        array_free(&line);
    }
}
END_TEST

START_TEST(on_a_line)
{
    double lines[] = {2, 3, 5};
    struct doubles line = {.n = 3, .item = lines};
    struct trim_snap a = trim_snap_new(&line);
    for (int k = -1; k <= 1; k++) { /* on it and within rounding */
        double off = k * 1e-8;
        ck_assert_int_eq(trim_snap_place(&a, 3 + off, 1), a.line[1] + 1);
        ck_assert_int_eq(trim_snap_place(&a, 3 + off, -1), a.line[1] - 1);
        ck_assert_int_eq(trim_snap_place(&a, 2 + off, 1), a.line[0] - 1);
        ck_assert_int_eq(trim_snap_place(&a, 5 + off, -1), a.line[2] + 1);
    }
    trim_snap_free(&a);
}
END_TEST

/* Clipping a cell: one line through a cell leaves what is on its left, two leave what is between or
 * beside; lines that cross are refused. */
/* Vertices 0 to 3 are the corners of the cell from the lower left, counter-clockwise; others lie at
 * `clip_x` and `clip_y`. */
static const double clip_x[] = {0, 1, 1, 0, 0.3, 0.3, 0.7, 0.7},
                    clip_y[] = {0, 0, 1, 1, 0, 1, 1, 0};
static const int corner[4] = {0, 1, 2, 3};

static double polygons_area(const struct polygons *p)
{
    double sum = 0;
    for (size_t k = 0, from = 0; k < p->end.n; from = p->end.item[k++]) {
        double part = 0;
        size_t n = p->end.item[k] - from;
        for (size_t i = 0; i < n; i++) {
            int a = p->id.item[from + i], b = p->id.item[from + (i + 1) % n];
            part += (clip_x[a] * clip_y[b] - clip_x[b] * clip_y[a]) / 2;
        }
        ck_assert_double_gt(part, 0);
        sum += part;
    }
    return sum;
}

/* From the bottom (0) to the top (2) at the place of vertices 4 and 5, or 6 and 7 downwards. */
static const struct trim_chain up = {
    .first = 0, .n = 2, .side_in = 0, .in = 0.3, .side_out = 2, .out = -0.3};
static const struct trim_chain down = {
    .first = 2, .n = 2, .side_in = 2, .in = -0.7, .side_out = 0, .out = 0.7};

START_TEST(one_line)
{
    static const int id[] = {4, 5, 6, 7};
    struct polygons p = {0};
    struct trim_chain chain[1] = {up};
    ck_assert(trim_clip(chain, 1, id, corner, &p));
    ck_assert_double_lt(fabs(polygons_area(&p) - 0.3), 1e-15);
    chain[0] = down;
    ck_assert(trim_clip(chain, 1, id, corner, &p));
    ck_assert_double_lt(fabs(polygons_area(&p) - 0.3), 1e-15); /* right of 0.7 is on its left */
    polygons_free(&p);
}
END_TEST

START_TEST(two_lines)
{
    static const int beside[] = {4, 5, 6, 7}, between[] = {7, 6, 5, 4};
    struct polygons p = {0};
    struct trim_chain chain[2] = {up, down};
    ck_assert(trim_clip(chain, 2, beside, corner, &p));
    ck_assert_uint_eq(p.end.n, 2);
    ck_assert_double_lt(fabs(polygons_area(&p) - 0.6), 1e-15);
    struct trim_chain inner[2] = {up, down};
    inner[0].in = 0.7, inner[0].out = -0.7, inner[1].in = -0.3, inner[1].out = 0.3;
    ck_assert(trim_clip(inner, 2, between, corner, &p));
    ck_assert_uint_eq(p.end.n, 1);
    ck_assert_double_lt(fabs(polygons_area(&p) - 0.4), 1e-15);
    polygons_free(&p);
}
END_TEST

START_TEST(both_upwards)
{
    static const int id[] = {4, 5, 7, 6};
    struct polygons p = {0};
    struct trim_chain chain[2] = {up, up};
    chain[1].first = 2;
    chain[1].in = 0.7, chain[1].out = -0.7;
    ck_assert(!trim_clip(chain, 2, id, corner, &p));
    polygons_free(&p);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("trim_grid");
    TCase *tests = tcase_create("trim_grid");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, stars_with_holes);
    tcase_add_test(tests, along_the_lines);
    tcase_add_test(tests, whole_and_outside);
    tcase_add_test(tests, through_the_nodes);
    tcase_add_test(tests, inside);
    tcase_add_test(tests, sides_of_lines);
    tcase_add_test(tests, on_a_line);
    tcase_add_test(tests, one_line);
    tcase_add_test(tests, two_lines);
    tcase_add_test(tests, both_upwards);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
