/* Arcs and B-splines of a CL file: see cl_state.h. */
#include <stdlib.h>
#include <string.h>

#include "cl_state.h"

/* Start and end of an arc this near are one point, mm: a full turn. */
#define CLOSED 2e-6

/* From where the tool is about the arc's axis to a point, above 0 up to a full turn, radians. */
static double angle_to(const struct cl_state *s, struct vec3 to)
{
    struct vec3 u = vec_reject(vec_sub(s->at, s->arc.centre), s->arc.axis);
    struct vec3 v = vec_reject(vec_sub(to, s->arc.centre), s->arc.axis);
    double angle = atan2(vec_dot(s->arc.axis, vec_cross(u, v)), vec_dot(u, v));
    return angle > 0 ? angle : angle + 2 * PI;
}

static double off_circle(const struct cl_arc *arc, struct vec3 p)
{
    return fabs(vec_length(vec_reject(vec_sub(p, arc->centre), arc->axis)) - arc->radius);
}

static int begin_arc(struct cl_state *s)
{
    if (!s->known)
        return cl_wrong(s, "an arc before the first GOTO");
    if (!(s->arc.radius > 0))
        return cl_wrong(s, "an arc without a radius");
    if (off_circle(&s->arc, s->at) > CL_NEAR)
        return cl_wrong(s, "an arc that does not start on its circle");
    s->arc.open = true;
    s->arc.lasting = false;
    return 0;
}

/* Centre, axis and radius: right-handed; with eleven numbers or more, as of NX, clockwise. */
int cl_read_circle(struct cl_state *s)
{
    double v[11];
    size_t n = cl_numbers(s->statement, 0, 11, v), times = cl_find(s->statement, "TIMES");
    if (n != 6 && n != 7 && n != 11)
        return cl_wrong(s, "CIRCLE with another number of numbers than 6, 7 or 11");
    s->arc = (struct cl_arc){.centre = cl_point(s, v)};
    if (!cl_direction(s, v + 3, &s->arc.axis))
        return cl_wrong(s, "CIRCLE with an axis of no length");
    if (n == 11)
        s->arc.axis = vec_scale(-1, s->arc.axis);
    s->arc.radius = n == 6 ? vec_length(vec_reject(vec_sub(s->at, s->arc.centre), s->arc.axis))
                           : s->unit * v[6];
    if (times < s->statement->argument.n && cl_expect(s, times + 1, 1, &s->arc.turns) < 0)
        return -1;
    return begin_arc(s);
}

int cl_arc_end(struct cl_state *s, struct vec3 to, struct vec3 axis)
{
    struct vec3 way = vec_sub(to, s->at);
    bool closed = vec_length(vec_reject(way, s->arc.axis)) < CLOSED;
    if (off_circle(&s->arc, to) > CL_NEAR)
        return cl_wrong(s, "an arc that does not end on its circle");
    double angle = closed ? 2 * PI : angle_to(s, to);
    if (s->arc.turns > 1)
        angle += 2 * PI * (s->arc.turns - 1);
    if (closed && fabs(vec_dot(way, s->arc.axis)) <= CL_NEAR)
        to = s->at;
    s->rapid = false;
    struct nc_piece piece = cl_piece(s, to, axis);
    piece.shape = SHAPE_ARC;
    piece.index = s->motion->arc.n;
    *array_push(&s->motion->arc) = (struct nc_motion_arc){s->arc.centre, s->arc.axis, angle};
    *array_push(&s->motion->piece) = piece;
    s->motion->arcs++;
    s->arc.open = false;
    s->arc.lasting = true;
    return 0;
}

bool cl_arc_goes_on(struct cl_state *s, struct vec3 to)
{
    double height = vec_dot(vec_sub(to, s->arc.centre), s->arc.axis);
    return s->creo && s->arc.lasting && fabs(height) <= CL_NEAR &&
           off_circle(&s->arc, to) <= CL_NEAR && vec_distance(to, s->at) >= CL_NEAR &&
           angle_to(s, to) < PI;
}

/* The n numbers after `(WORD/` in the text. */
static int numbers_in(struct cl_state *s, const char *word, size_t n, double *value)
{
    const char *at = strstr(s->statement->text, word);
    at = at ? strchr(at, '/') : NULL;
    for (size_t i = 0; at && i < n; i++) {
        char *end;
        value[i] = strtod(at + 1, &end);
        if (end == at + 1)
            break;
        if (i + 1 == n)
            return 0;
        at = strchr(at + 1, ',');
    }
    return cl_wrong(s, "TLON,GOFWD without its circle or its line");
}

/*
 * CATIA: TLON,GOFWD/(CIRCLE/centre, radius),ON,(LINE/..., end): from where the tool is in the
 * direction of INDIRV.  The direction has few digits: an arc across the tool axis is square to it.
 */
int cl_read_tlon(struct cl_state *s)
{
    double circle[4], line[6];
    if (numbers_in(s, "CIRCLE", 4, circle) < 0 || numbers_in(s, "LINE", 6, line) < 0)
        return -1;
    s->arc = (struct cl_arc){.centre = cl_point(s, circle), .radius = s->unit * circle[3]};
    struct vec3 to = cl_point(s, line + 3), spoke = vec_sub(s->at, s->arc.centre);
    s->arc.axis = vec_unit(vec_cross(spoke, s->tangent));
    double along = vec_dot(s->arc.axis, s->axis);
    if (fabs(along) > 0.999 && fabs(vec_dot(spoke, s->axis)) < CL_NEAR / 2)
        s->arc.axis = vec_scale(along > 0 ? 1 : -1, s->axis);
    if (vec_length(s->arc.axis) < 0.5)
        return cl_wrong(s, "TLON,GOFWD without a direction along its circle");
    return begin_arc(s) < 0 ? -1 : cl_arc_end(s, to, s->axis);
}

/* ---- B-splines */

static int add_spline(struct cl_state *s, size_t order)
{
    struct cl_spline *b = &s->spline;
    size_t n = b->tip.n;
    if (n < order || b->knot.n != n + order || (b->head.n > 0 && b->head.n != n))
        return cl_wrong(s, "a B-spline whose knots and poles do not belong together");
    for (size_t i = 1; i < b->knot.n; i++)
        if (b->knot.item[i] < b->knot.item[i - 1])
            return cl_wrong(s, "a B-spline whose knots fall");
    if (!s->known || vec_distance(b->tip.item[0], s->at) > CL_NEAR)
        return cl_wrong(s, "a B-spline whose first pole is not where the tool is");
    struct vec3 end = b->tip.item[n - 1], axis = s->axis;
    if (b->head.n > 0)
        axis = vec_unit(vec_sub(b->head.item[n - 1], end));
    s->rapid = false;
    struct nc_piece piece = cl_piece(s, end, axis);
    struct nc_motion_spline curve = {
        .order = (int)order, .n = n, .knot = b->knot.item, .p = b->tip.item};
    if (b->head.n > 0) {
        curve.q = b->head.item;
        piece.interpolation = AXIS_BY_HEAD;
    }
    nc_motion_add_spline(s->motion, curve, &piece);
    *b = (struct cl_spline){0}; /* its arrays are the motion's now */
    return 0;
}

static int read_poles(struct cl_state *s, struct vec3s *poles)
{
    for (size_t i = 1; i < s->statement->argument.n; i += 3) {
        double v[3];
        if (cl_expect(s, i, 3, v) < 0)
            return -1;
        *array_push(poles) = cl_point(s, v);
    }
    return poles->n == s->spline.poles ? 0 : cl_wrong(s, "MOVNRB with another number of poles");
}

static int read_knots(struct cl_state *s, size_t from)
{
    for (size_t i = from; i < s->statement->argument.n; i++)
        if (cl_expect(s, i, 1, array_push(&s->spline.knot)) < 0)
            return -1;
    return 0;
}

static int movnrb_complete(struct cl_state *s)
{
    struct cl_spline *b = &s->spline;
    if (b->five != (b->head.n > 0) || b->five == b->fixed || b->knot.n != b->knots)
        return cl_wrong(s, "MOVNRB/NEXT before all of the curve was there");
    for (int i = 0; i < 2 && b->five && b->tip.n == b->head.n; i++) {
        size_t k = i ? b->tip.n - 1 : 0;
        if (fabs(vec_distance(b->tip.item[k], b->head.item[k]) - b->length) > CL_NEAR)
            return cl_wrong(s, "a head that is not LENGTH from the tip");
    }
    return add_spline(s, b->order);
}

int cl_read_movnrb(struct cl_state *s)
{
    const struct cl_statement *t = s->statement;
    struct cl_spline *b = &s->spline;
    const char *what = t->argument.n ? t->argument.item[0].text : "";
    double v[4];
    if (strcmp(what, "5AXIS") == 0) {
        b->five = true;
        if (cl_expect(s, cl_find(t, "LENGTH") + 1, 1, &b->length) < 0)
            return -1;
        b->length *= s->unit;
    } else if (strcmp(what, "M3AXIS") == 0) {
        b->fixed = true;
    } else if (strcmp(what, "ON") == 0) {
        if (cl_expect(s, 1, 4, v) < 0)
            return -1;
        if (v[2] != 0)
            return cl_wrong(s, "MOVNRB with weights");
        b->open = true;
        b->order = (size_t)v[0];
        b->knots = (size_t)v[1];
        b->poles = (size_t)v[3];
    } else if (strcmp(what, "OFF") == 0) {
        if (!b->fallback)
            return cl_wrong(s, "MOVNRB/OFF without NEXT");
        b->fallback = false;
    } else if (!b->open) {
        return cl_wrong(s, "MOVNRB out of its order");
    } else if (strcmp(what, "1") == 0) {
        return read_knots(s, 1);
    } else if (strcmp(what, "2") == 0) {
        return read_poles(s, &b->tip);
    } else if (strcmp(what, "3") == 0) {
        return read_poles(s, &b->head);
    } else if (strcmp(what, "NEXT") == 0) {
        if (movnrb_complete(s) < 0)
            return -1;
        b->fallback = true;
    } else {
        return cl_wrong(s, "MOVNRB with a word that is not known");
    }
    return 0;
}

/* NX: a cubic from where the tool is, on the knots 0 0 0 0 KNOT ... 1 1 1. */
int cl_read_nurbs(struct cl_state *s)
{
    const char *word = s->statement->word;
    double v[3];
    if (strcmp(word, "NURBS") == 0) {
        s->spline = (struct cl_spline){.open = true};
        *array_push(&s->spline.tip) = s->at;
        for (int i = 0; i < 4; i++)
            *array_push(&s->spline.knot) = 0;
        return 0;
    }
    if (!s->spline.open)
        return cl_wrong(s, "KNOT or CNTRL without NURBS");
    if (strcmp(word, "KNOT") == 0)
        return read_knots(s, 0);
    if (cl_expect(s, 0, 3, v) < 0)
        return -1;
    *array_push(&s->spline.tip) = cl_point(s, v);
    return 0;
}

int cl_nurbs_end(struct cl_state *s)
{
    for (int i = 0; i < 3; i++)
        *array_push(&s->spline.knot) = 1;
    return add_spline(s, 4);
}

/* The number after a name and its `=`; NAN: there is none. */
static double value_of(const struct cl_statement *t, const char *name)
{
    const char *at = strstr(t->text, name);
    return at ? strtod(at + strlen(name), NULL) : NAN;
}

/*
 * CATIA V5: BEGIN NURBS_SIEMENS(D=3,AXIS=...), a pole a statement with XT= YT= ZT=, XH= YH= ZH=
 * where the tool turns, and DK=, its knot interval; END NURBS.  With end knots repeated, DK of pole
 * i is t[i + D - 1] - t[i + D - 2].
 */
int cl_read_nurbs_siemens(struct cl_state *s)
{
    const struct cl_statement *t = s->statement;
    struct cl_spline *b = &s->spline;
    double v[6], step = value_of(t, "DK=");
    static const char *const name[] = {"XT=", "YT=", "ZT=", "XH=", "YH=", "ZH="};
    if (strncmp(t->word, "BEGIN", 5) == 0) {
        *b = (struct cl_spline){.open = true, .catia = true};
        b->order = (size_t)value_of(t, "D=") + 1;
        return 0;
    }
    for (int i = 0; i < 6; i++)
        v[i] = value_of(t, name[i]);
    if (isnan(v[0] + v[1] + v[2] + step))
        return cl_wrong(s, "a pole of NURBS_SIEMENS without XT= YT= ZT= or DK=");
    *array_push(&b->tip) = cl_point(s, v);
    if (!isnan(v[3] + v[4] + v[5]))
        *array_push(&b->head) = cl_point(s, v + 3);
    *array_push(&b->knot) = step; /* until the curve is complete */
    return 0;
}

int cl_nurbs_siemens_end(struct cl_state *s)
{
    struct cl_spline *b = &s->spline;
    size_t n = b->tip.n, order = b->order;
    struct doubles step = b->knot;
    if (!b->open || n < order)
        return cl_wrong(s, "END NURBS without its poles");
    b->knot = (struct doubles){0};
    for (size_t k = 0; k < n + order; k++) {
        double before = k > 0 ? b->knot.item[k - 1] : 0;
        bool inner = k >= order && k <= n;
        *array_push(&b->knot) = before + (inner ? step.item[k - order + 2] : 0);
    }
    array_free(&step);
    return add_spline(s, order);
}
