/* ncread_shape - arcs and splines: see ncread.h. */
#include "ncread/ncread.h"
#include "ncread_unit.h"

/* Largest difference of an arc's radius at its start and its end, mm, in the program's unit. */
static double slack(const struct ncread *c)
{
    return 0.005 / (c->unit > 0 ? c->unit : 1);
}

static void set_arc(struct ncread *c, struct nc_piece *piece, struct nc_motion_arc arc)
{
    piece->shape = SHAPE_ARC;
    piece->index = c->nc_motion->arc.n;
    *array_push(&c->nc_motion->arc) = arc;
}

static struct vec3 plane_normal(const struct ncread *c)
{
    return c->plane == 17 ? vec(0, 0, 1) : c->plane == 18 ? vec(0, 1, 0) : vec(1, 0, 0);
}

int ncread_arc(struct ncread *c, struct nc_piece *piece, struct vec3 centre, bool ccw,
               struct error *error)
{
    struct vec3 n = plane_normal(c);
    struct vec3 u = vec_reject(vec_sub(piece->p[0], centre), n);
    struct vec3 v = vec_reject(vec_sub(piece->p[1], centre), n);
    if (c->inverse_time)
        return ncread_error(c, error, "an arc under inverse time feed");
    if (vec_length(u) < 1e-6 || fabs(vec_length(u) - vec_length(v)) > slack(c))
        return ncread_error(c, error, "an arc whose ends are not at one distance from its centre");
    double angle = atan2(vec_dot(vec_cross(u, v), n), vec_dot(u, v));
    bool full = vec_distance(u, v) < 1e-9;
    if (ccw)
        angle = full ? 2 * PI : angle > 0 ? angle : angle + 2 * PI;
    else
        angle = full ? -2 * PI : angle < 0 ? angle : angle - 2 * PI;
    set_arc(c, piece, (struct nc_motion_arc){centre, n, angle});
    return 0;
}

int ncread_arc_radius(struct ncread *c, struct nc_piece *piece, double radius, bool ccw,
                      struct error *error)
{
    struct vec3 n = plane_normal(c);
    struct vec3 chord = vec_reject(vec_sub(piece->p[1], piece->p[0]), n);
    double length = vec_length(chord), r = fabs(radius);
    if (length < 1e-9)
        return ncread_error(c, error, "an arc by its radius with no way between its ends");
    if (length / 2 > r + slack(c))
        return ncread_error(c, error, "an arc whose ends are further apart than its diameter");
    double high = sqrt(fmax(0, r * r - length * length / 4));
    /* the centre lies left of the chord for a short counter-clockwise arc */
    double side = (ccw == (radius > 0)) ? high : -high;
    struct vec3 left = vec_cross(n, vec_unit(chord));
    struct vec3 centre = vec_along(vec_along(piece->p[0], 0.5, chord), side, left);
    return ncread_arc(c, piece, centre, ccw, error);
}

int ncread_arc_through(struct ncread *c, struct nc_piece *piece, struct vec3 middle,
                       struct error *error)
{
    struct vec3 u = vec_sub(middle, piece->p[0]), v = vec_sub(piece->p[1], piece->p[0]);
    struct vec3 n = vec_cross(u, v);
    double area2 = vec_dot(n, n), lu = vec_dot(u, u), lv = vec_dot(v, v);
    if (!(area2 > 1e-12 * lu * lv))
        return ncread_error(c, error, "an arc through points that lie on a line");
    struct vec3 to_centre =
        vec_scale(0.5 / area2, vec_cross(vec_sub(vec_scale(lu, v), vec_scale(lv, u)), n));
    struct nc_motion_arc arc = {vec_add(piece->p[0], to_centre), vec_unit(n), 0};
    struct vec3 from = vec_sub(piece->p[0], arc.centre), to = vec_sub(piece->p[1], arc.centre);
    arc.angle = atan2(vec_dot(vec_cross(from, to), arc.normal), vec_dot(from, to));
    if (arc.angle <= 0)
        arc.angle += 2 * PI;
    set_arc(c, piece, arc);
    return 0;
}

void ncread_pole(struct ncread *c, const struct nc_piece *piece, struct vec3 p, struct vec3 q)
{
    if (c->pole_p.n == 0)
        c->spline = *piece;
    *array_push(&c->pole_p) = p;
    *array_push(&c->pole_q) = q;
    *array_push(&c->pole_block) = (int)c->block;
    *array_push(&c->pole_line) = c->line;
}

/* Each span of the spline is named by the block of the pole in the middle of those it follows. */
static void name_spans(struct ncread *c, const struct nc_motion_spline *b, size_t first)
{
    size_t span = (size_t)b->order - 1;
    for (size_t i = first; i < c->nc_motion->piece.n; i++) {
        struct nc_piece *piece = &c->nc_motion->piece.item[i];
        while (span + 1 < b->n && b->knot[span + 1] <= piece->u[0])
            span++;
        size_t pole = span + 1 - (size_t)b->order / 2;
        piece->block = c->pole_block.item[pole];
        piece->line = c->pole_line.item[pole];
    }
    c->pole_block.n = c->pole_line.n = 0;
}

int ncread_spline(struct ncread *c, struct error *error)
{
    size_t n = c->pole_p.n, order = (size_t)c->order;
    const double *k = c->knot.item;
    if (n < order || c->knot.n != n + order)
        return ncread_error(c, error, "a spline whose numbers of poles and knots do not agree");
    for (size_t i = 1; i < c->knot.n; i++)
        if (k[i] < k[i - 1])
            return ncread_error(c, error, "a spline whose knots fall");
    for (size_t i = 1; i < order; i++)
        if (k[i] > k[0] || k[n + i] > k[n])
            return ncread_error(c, error, "a spline whose end knots are not repeated");
    for (size_t i = 1; i + order <= n; i++)
        if (!(k[i] < k[i + order]))
            return ncread_error(c, error, "a spline that is torn by a repeated knot");
    for (size_t i = 0; i < c->weight.n; i++)
        if (!(c->weight.item[i] > 0))
            return ncread_error(c, error, "a spline with a weight that is not above zero");
    ncread_plane_turn_poles(c);
    ncread_unit_poles(c);
    struct nc_motion_spline b = {.order = c->order, .n = n};
    b.knot = c->knot.item;
    b.p = c->pole_p.item;
    b.q = c->pole_q.item;
    b.weight = c->weight.item;
    c->knot = c->weight = (struct doubles){0};
    c->pole_p = c->pole_q = (struct vec3s){0};
    size_t first = c->nc_motion->piece.n;
    nc_motion_add_spline(c->nc_motion, b, &c->spline);
    name_spans(c, &b, first);
    return 0;
}
