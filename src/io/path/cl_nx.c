/*
 * cl_nx - the words of Siemens NX (CLSF): several tool paths, each from TOOL PATH to END-OF-PATH,
 * each in the coordinate system of its MSYS.
 */
#include <stdlib.h>
#include <string.h>

#include "math/elementary.h"

#include "cl_dialect.h"

#define AT(p) (p)->error, (p)->path->name, (p)->apt.line

static bool recognize(const struct apt *apt)
{
    return !apt->comment && (strcmp(apt->word, "TOOL PATH") == 0 ||
                             strcmp(apt->word, "TLDATA") == 0 || strcmp(apt->word, "MSYS") == 0);
}

/* TOOL PATH/name,TOOL,name of the tool */
static int read_tool_path(struct path_parse *p)
{
    p->whole = false;
    p->depth = 1;
    p->axis = vec(0, 0, 1);
    p->cycling = p->rapid = false;
    p->inverse = 0;
    for (size_t i = 0; i + 1 < p->apt.argument.n; i++)
        if (apt_is(&p->apt, i, "TOOL")) {
            path_tool_named(p, p->apt.argument.item[i + 1].text);
            break;
        }
    return 0;
}

static int read_end_of_path(struct path_parse *p)
{
    p->whole = true;
    p->depth = 0;
    return 0;
}

/*
 * TLDATA/MILL,diameter,corner radius,length,taper,tip angle; of DRILL and other tools only the
 * diameter is used.
 */
static int read_tldata(struct path_parse *p)
{
    double cutter[7] = {0}, v[5] = {0}, u = p->unit;
    size_t n = 0;
    for (size_t i = 0; i < p->apt.argument.n && n < 5; i++)
        if (p->apt.argument.item[i].is_number)
            v[n++] = p->apt.argument.item[i].number;
    if (!(n > 0 && v[0] > 0))
        return error_at(AT(p), "found no diameter in TLDATA, expected a number above 0");
    cutter[0] = u * v[0];
    if (!apt_is(&p->apt, 0, "MILL")) {
        path_tool_shape(p, cutter, 1);
        return 0;
    }
    cutter[1] = cutter[3] = u * v[1];
    cutter[2] = u * (v[0] / 2 - v[1]);
    cutter[4] = v[4];
    cutter[5] = v[3];
    cutter[6] = u * v[2];
    path_tool_shape(p, cutter, 7);
    return 0;
}

static bool vectors_equal(struct vec3 a, struct vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

static bool frames_equal(const struct frame *a, const struct frame *b)
{
    return vectors_equal(a->origin, b->origin) && vectors_equal(a->x, b->x) &&
           vectors_equal(a->y, b->y);
}

/* MSYS/origin, x axis, y axis: the coordinate system of what follows.  Its points are converted to
 * the first system of the stream. */
static int read_msys(struct path_parse *p)
{
    double v[9];
    struct frame f;
    p->framed = false;
    if (path_numbers(p, 0, 9, v, "origin, x axis, y axis") < 0 ||
        path_direction(p, v + 3, "an MSYS axis", &f.x) < 0 ||
        path_direction(p, v + 6, "an MSYS axis", &f.y) < 0)
        return -1;
    if (fabs(vec_dot(f.x, f.y)) > 1e-4)
        return error_at(AT(p), "found MSYS axes that are not square, expected them to be");
    f.origin = vec_scale(p->unit, vec(v[0], v[1], v[2]));
    f.y = vec_unit(vec_reject(f.y, f.x));
    if (p->frames++ == 0)
        p->first = f;
    p->frame = f;
    p->framed = !frames_equal(&p->first, &f);
    return 0;
}

/* ---- NURBS, KNOT/..., CNTRL/...: a cubic from where the tool is */
static int read_nurbs(struct path_parse *p)
{
    if (!p->moved || p->cycling)
        return error_at(AT(p), "found NURBS %s, expected a GOTO first",
                        p->moved ? "among the holes of a CYCLE" : "before any position");
    p->nurbs.open = true;
    p->nurbs.knot.n = p->nurbs.pole.n = 0;
    return 0;
}

static int expect_open(struct path_parse *p)
{
    if (p->nurbs.open)
        return 0;
    return error_at(AT(p), "found %.20s without NURBS, expected NURBS before it", p->apt.word);
}

static int read_knot(struct path_parse *p)
{
    if (expect_open(p) < 0)
        return -1;
    for (size_t i = 0; i < p->apt.argument.n; i++)
        if (path_numbers(p, i, 1, array_push(&p->nurbs.knot), "a knot") < 0)
            return -1;
    return 0;
}

static int read_cntrl(struct path_parse *p)
{
    double v[3];
    if (expect_open(p) < 0)
        return -1;
    if (p->apt.argument.n != 3)
        return error_at(AT(p),
                        "found %zu numbers in CNTRL, expected x, y, z (a NURBS with a fixed axis)",
                        p->apt.argument.n);
    if (path_numbers(p, 0, 3, v, "x, y, z") < 0)
        return -1;
    struct vec3 pole = path_point_of(p, v);
    if (!(vec_length(pole) < 1e8))
        return error_at(AT(p), "found a pole too far for any machine, expected less than 1e8 mm");
    *array_push(&p->nurbs.pole) = pole;
    return 0;
}

/* -1: the knots are not {0, 0, 0, 0, KNOT..., 1, 1, 1} with one KNOT for each pole but three. */
static int expect_knots(struct path_parse *p)
{
    const struct doubles *k = &p->nurbs.knot;
    size_t poles = p->nurbs.pole.n + 1;
    if (poles < 4 || k->n != poles - 3)
        return error_at(AT(p),
                        "found NURBS with %zu poles and %zu knots, expected %zu knots or "
                        "more poles",
                        poles, k->n, poles < 4 ? 1 : poles - 3);
    for (size_t i = 0; i < k->n; i++) {
        bool last = i + 1 == k->n;
        double before = i ? k->item[i - 1] : 0;
        bool rises = last ? k->item[i] == 1 && before < 1 : k->item[i] >= before && k->item[i] < 1;
        if (!rises || !(k->item[i] > 0) || (i >= 3 && k->item[i] == k->item[i - 3]))
            return error_at(AT(p),
                            "found knot %zu of NURBS to be %g, expected rising knots above "
                            "0, and 1 as the last",
                            i + 1, k->item[i]);
    }
    return 0;
}

static int add_curve(struct path_parse *p)
{
    size_t poles = p->nurbs.pole.n + 1;
    struct bspline c = bspline_new(3, poles, false);
    c.pole[0] = p->at.p;
    memcpy(c.pole + 1, p->nurbs.pole.item, (poles - 1) * sizeof *c.pole);
    for (size_t i = 0; i < poles + 4; i++)
        c.knot[i] = i < 4 ? 0 : i < poles + 1 ? p->nurbs.knot.item[i - 4] : 1;
    return cl_add_curve(p, c);
}

int cl_nx_nurbs_end(struct path_parse *p)
{
    if (strcmp(p->apt.word, "KNOT") == 0 || strcmp(p->apt.word, "CNTRL") == 0)
        return 0;
    p->nurbs.open = false;
    p->rapid = false;
    return expect_knots(p) < 0 ? -1 : add_curve(p);
}

static const struct path_row rows[] = {
    {"PAINT", path_ignore},  {"TOOL PATH", read_tool_path},
    {"TLDATA", read_tldata}, {"MSYS", read_msys},
    {"NURBS", read_nurbs},   {"KNOT", read_knot},
    {"CNTRL", read_cntrl},   {"END-OF-PATH", read_end_of_path},
};

const struct cl_dialect cl_nx = {"NX", recognize, rows, sizeof rows / sizeof *rows};
