/*
 * cl_catia - the words of CATIA V5: the tool axis by TLAXIS, arcs by INDIRV and
 *
 *   TLON,GOFWD/ (CIRCLE/ xc,yc,zc,r),ON,(LINE/ xc,yc,zc,xe,ye,ze)
 *
 * from where the tool is, in the direction of INDIRV, to the second point of the line; and
 * B-splines (Manufacturing Infrastructure User's Guide, NURBS Formats in APT Output):
 *
 *   BEGIN NURBS_SIEMENS(D=3,F=4000,AXIS=0,0,1);      or AXIS=VAR,LENGTH=100
 *   N0,XT=0,YT=0,ZT=0,DK=0,W=1;                      with VAR XH= YH= ZH= too
 *   END NURBS;
 *
 * The first pole is where the tool is.  DK of pole i is the knot interval t[i+D-1] - t[i+D-2], end
 * knots repeated: in the guide's cubic of four poles the third one has the only interval.
 */
#include <string.h>

#include "math/elementary.h"
#include "base/num.h"
#include "cl_dialect.h"

#define AT(p) (p)->error, (p)->path->name, (p)->apt.line

static const double level = 0.005; /* mm, how far points in one plane may differ in height */

static bool recognize(const struct apt *apt)
{
    if (apt->comment)
        return strstr(apt->raw, "CATIA APT VERSION") || strncmp(apt->raw, "$$*CATIA0", 9) == 0;
    return strcmp(apt->word, "INDIRV") == 0 || strcmp(apt->word, "TLON,GOFWD") == 0;
}

static int read_indirv(struct path_parse *p)
{
    double v[3];
    return path_numbers(p, 0, 3, v, "i, j, k") < 0
               ? -1
               : path_direction(p, v, "an arc's direction", &p->tangent);
}

/* Reads n numbers with commas between, from the character before the first to a `)`. */
static bool read_list(const char *s, size_t n, double *value)
{
    for (size_t i = 0; i < n; i++) {
        s++;
        s += strspn(s, " \t");
        if (!num_read(&s, &value[i]) || !isfinite(value[i]))
            return false;
        s += strspn(s, " \t");
        if (*s != (i + 1 == n ? ')' : ','))
            return false;
    }
    return true;
}

/* Reads the n numbers after `(WORD/` in the statement. */
static int numbers_in(struct path_parse *p, const char *word, size_t n, double *value)
{
    const char *s = strstr(p->apt.raw, word);
    s = s ? strchr(s, '/') : NULL;
    if (s && read_list(s, n, value))
        return 0;
    return error_at(AT(p), "found TLON,GOFWD without (%s/ and %zu numbers), expected them", word,
                    n);
}

/* An arc whose points lie in a plane square to the tool axis gets that axis exactly: INDIRV has few
 * digits. */
static void square_to_tool(struct vec3 tool, struct vec3 spoke, struct vec3 chord,
                           struct vec3 *axis)
{
    double along = vec_dot(*axis, tool);
    if (fabs(along) > 0.999 && fabs(vec_dot(spoke, tool)) < level &&
        fabs(vec_dot(chord, tool)) < level)
        *axis = vec_scale(along > 0 ? 1 : -1, tool);
}

static int read_tlon(struct path_parse *p)
{
    double c[4] = {0}, l[6] = {0};
    if (numbers_in(p, "CIRCLE", 4, c) < 0 || numbers_in(p, "LINE", 6, l) < 0)
        return -1;
    if (vec_length(p->tangent) == 0)
        return error_at(AT(p), "found TLON,GOFWD without a direction, expected INDIRV before it");
    struct path_arc arc = {.centre = path_point_of(p, c), .radius = p->unit * c[3]};
    struct vec3 spoke = vec_sub(p->at.p, arc.centre);
    arc.axis = vec_unit(vec_cross(spoke, p->tangent));
    if (vec_length(vec_cross(spoke, p->tangent)) < 0.5 * vec_length(spoke))
        return error_at(AT(p), "found an arc whose direction points to its centre, expected one "
                               "along the circle");
    struct vec3 end = path_point_of(p, l + 3);
    square_to_tool(p->axis, spoke, vec_sub(end, p->at.p), &arc.axis);
    p->tangent = vec(0, 0, 0);
    if (path_begin_arc(p, arc) < 0)
        return -1;
    return path_move_to(p, (struct pose){end, p->axis});
}

static const struct path_row rows[] = {
    {"INDIRV", read_indirv},
    {"TLON,GOFWD", read_tlon},
    {"AUTOPS", path_ignore}, /* the plane of an arc, which INDIRV gives too */
    {"PSIS", path_ignore},
};

const struct cl_dialect cl_catia = {"CATIA", recognize, rows, sizeof rows / sizeof *rows};

/* ---- B-splines */

enum { DEGREE_MAX = 7 };
static const double near = 0.01; /* mm, between the first pole and the tool */

/* Reads the number after `NAME=` in the statement; false: there is none. */
static bool value_of(const struct path_parse *p, const char *name, double *value)
{
    const char *s = strstr(p->apt.raw, name);
    if (!s)
        return false;
    s += strlen(name);
    s += strspn(s, " \t");
    return num_read(&s, value) && isfinite(*value);
}

static int begin_nurbs(struct path_parse *p)
{
    struct catia_parse *c = &p->catia;
    double degree = 3, feed, axis[3];
    if (!p->moved || p->cycling || p->circle.open)
        return error_at(AT(p), "found NURBS_SIEMENS here, expected a GOTO before it");
    value_of(p, "D=", &degree);
    if (!(degree >= 1 && degree <= DEGREE_MAX && degree == floor(degree)))
        return error_at(AT(p), "found D=%g in NURBS_SIEMENS, expected a degree of 1 to %d", degree,
                        DEGREE_MAX);
    c->degree = (int)degree;
    c->turns = strstr(p->apt.raw, "AXIS=VAR") != NULL;
    if (c->turns && !(value_of(p, "LENGTH=", &c->length) && c->length > 0))
        return error_at(AT(p), "found AXIS=VAR without LENGTH, expected it above 0");
    c->length *= p->unit;
    const char *s = strstr(p->apt.raw, "AXIS=");
    if (s && !c->turns) {
        s += strlen("AXIS=");
        for (int i = 0; i < 3; i++, s += *s == ',') {
            s += strspn(s, " \t");
            if (!num_read(&s, &axis[i]))
                return error_at(AT(p), "found AXIS= without three numbers, expected i, j, k");
        }
        if (path_direction(p, axis, "a tool axis", &p->axis) < 0)
            return -1;
    }
    if (value_of(p, "F=", &feed) && feed > 0) {
        p->feed = feed * p->unit;
        p->by_turn = 0;
        path_add_feed(p->path, p->feed);
    }
    c->interval.n = c->pole.n = c->head.n = 0;
    c->open = true;
    return 1;
}

static int read_nurbs_pole(struct path_parse *p)
{
    static const char *const tip[] = {"XT=", "YT=", "ZT="}, *const head[] = {"XH=", "YH=", "ZH="};
    struct catia_parse *c = &p->catia;
    double t[3], h[3], interval, weight = 1;
    for (int i = 0; i < 3; i++)
        if (!value_of(p, tip[i], &t[i]) || (c->turns && !value_of(p, head[i], &h[i])))
            return error_at(AT(p), "found a pole of NURBS_SIEMENS without %s, expected %s", tip[i],
                            c->turns ? "XT YT ZT and XH YH ZH" : "XT YT ZT");
    if (!value_of(p, "DK=", &interval) || interval < 0)
        return error_at(AT(p),
                        "found a pole of NURBS_SIEMENS without DK of 0 or more, expected it");
    value_of(p, ",W=", &weight);
    if (weight != 1)
        return error_at(AT(p),
                        "found weight %g in NURBS_SIEMENS, expected 1: a curve that is not "
                        "rational",
                        weight);
    struct vec3 pole = path_point_of(p, t);
    if (!(vec_length(pole) < 1e8))
        return error_at(AT(p), "found a pole too far for any machine, expected less than 1e8 mm");
    *array_push(&c->pole) = pole;
    if (c->turns)
        *array_push(&c->head) = path_point_of(p, h);
    *array_push(&c->interval) = interval;
    return 1;
}

/* -1: the intervals are not those of a curve whose end knots are repeated. */
static int expect_intervals(struct path_parse *p)
{
    const struct catia_parse *c = &p->catia;
    size_t n = c->pole.n, first = 2, last = n - (size_t)c->degree + 1;
    double whole = 0;
    for (size_t i = 0; i < n; i++) {
        bool inside = i >= first && i <= last;
        whole += c->interval.item[i];
        if (c->interval.item[i] != 0 && !inside)
            return error_at(AT(p), "found DK %g at pole %zu of NURBS_SIEMENS, expected 0 there",
                            c->interval.item[i], i);
    }
    return whole > 0 ? 0
                     : error_at(AT(p), "found NURBS_SIEMENS whose DK are all 0, expected knots "
                                       "that rise");
}

static int end_nurbs(struct path_parse *p)
{
    struct catia_parse *c = &p->catia;
    size_t n = c->pole.n, order = (size_t)c->degree + 1;
    c->open = false;
    p->rapid = false;
    if (n < order)
        return error_at(AT(p), "found NURBS_SIEMENS with %zu poles, expected at least %zu", n,
                        order);
    if (vec_distance(c->pole.item[0], p->at.p) > near)
        return error_at(AT(p),
                        "found the first pole %.4f mm from where the tool is, expected it "
                        "there",
                        vec_distance(c->pole.item[0], p->at.p));
    if (expect_intervals(p) < 0)
        return -1;
    struct bspline curve = bspline_new(c->degree, n, c->turns);
    memcpy(curve.pole, c->pole.item, n * sizeof *curve.pole);
    curve.pole[0] = p->at.p;
    if (c->turns)
        memcpy(curve.head, c->head.item, n * sizeof *curve.head);
    curve.length = c->length;
    for (size_t i = 1; i < n + order; i++) {
        size_t of = i + 1 - (size_t)c->degree; /* the pole whose interval ends at knot i */
        bool has = i + 1 >= (size_t)c->degree && of < n;
        curve.knot[i] = curve.knot[i - 1] + (has ? c->interval.item[of] : 0);
    }
    return cl_add_curve(p, curve) < 0 ? -1 : 1;
}

int cl_catia_nurbs(struct path_parse *p)
{
    const char *raw = p->apt.raw;
    if (p->apt.comment)
        return 0;
    if (strncmp(raw, "BEGIN", 5) == 0 && strstr(raw, "NURBS_SIEMENS"))
        return begin_nurbs(p);
    if (!p->catia.open)
        return 0;
    if (strncmp(raw, "END", 3) == 0 && strstr(raw, "NURBS"))
        return end_nurbs(p);
    if (strstr(raw, "XT="))
        return read_nurbs_pole(p);
    return error_at(AT(p), "found %.40s within NURBS_SIEMENS, expected END NURBS first", raw);
}
