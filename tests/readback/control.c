#include "control.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "reader.h"

/* Largest difference of an arc's radius at its start and its end, mm. */
#define RADIUS_DIFFERENCE 0.005

int control_error(const struct control *c, struct error *error, const char *what)
{
    if (c->block >= 0)
        return error_at(error, c->name, c->line, "N%ld: %s", c->block, what);
    return error_at(error, c->name, c->line, "%s", what);
}

int control_unknown(const struct control *c, const struct word *w, struct error *error)
{
    char text[120];
    if (w->kind == WORD_ADDRESS)
        snprintf(text, sizeof text, "found %s%.15g, which this reader does not know", w->name,
                 w->value[0]);
    else
        snprintf(text, sizeof text, "found %s, which this reader does not know", w->name);
    return control_error(c, error, text);
}

int control_m(struct control *c, const struct word *w, struct error *error)
{
    int code = (int)w->value[0];
    if (code == 3 || code == 4 || code == 5)
        c->spindle = code != 5;
    else if (code == 30)
        c->ended = true;
    else if (!(code == 0 || code == 1 || (code >= 6 && code <= 9)))
        return control_unknown(c, w, error);
    return 0;
}

int control_block(struct control *c, double number, struct error *error)
{
    c->block = (long)number;
    bool anew = c->last_block >= 9900 && c->block <= 100; /* the digits are used up */
    if (c->block <= c->last_block && !anew)
        return control_error(c, error, "its number does not rise");
    c->last_block = c->block;
    return 0;
}

bool control_axis(const struct control *c, const char *name, double value, struct place *to)
{
    if (strlen(name) != 1)
        return false;
    if (*name >= 'X' && *name <= 'Z') {
        to->at[*name - 'X'] = value;
        to->known[*name - 'X'] = true;
        return true;
    }
    char master = c->setup->rotary == ROTARY_AC ? 'A' : 'B';
    if (*name != master && *name != 'C')
        return false;
    to->turn[*name == 'C'] = c->setup->reversed ? -value : value;
    to->turned[*name == 'C'] = true;
    return true;
}

void control_turned(const struct control *c, struct place *to)
{
    if (to->turned[0] && to->turned[1]) {
        to->axis = rotary_axis(c->setup->rotary, to->turn[0], to->turn[1]);
        to->has_axis = true;
    }
}

void control_pointed(struct place *to, struct vec3 axis)
{
    to->axis = vec_unit(axis);
    to->has_axis = true;
    to->turned[0] = to->turned[1] = false;
}

static bool all_known(const struct place *place)
{
    return place->known[0] && place->known[1] && place->known[2];
}

static struct vec3 point_of(const struct place *place)
{
    return vec(place->at[0], place->at[1], place->at[2]);
}

struct piece control_piece(const struct control *c, const struct place *to)
{
    struct piece piece = {.line = c->line, .block = c->block};
    const struct place *from = &c->here;
    piece.p[0] = point_of(from);
    piece.p[1] = point_of(to);
    if (c->curve && from->has_head && to->has_head) {
        piece.swing = SWING_HEAD;
        piece.q[0] = from->head;
        piece.q[1] = to->head;
    } else if (c->vectors && c->setup->tcp) {
        piece.swing = SWING_GREAT;
        piece.q[0] = from->axis;
        piece.q[1] = to->axis;
    } else {
        piece.swing = SWING_ROTARY;
        piece.q[0] = vec(from->turn[0], from->turn[1], 0);
        piece.q[1] = vec(to->turn[0], to->turn[1], 0);
        piece.table = !c->setup->tcp;
    }
    return piece;
}

int control_ready(const struct control *c, struct error *error)
{
    if (!c->metric || !c->absolute)
        return control_error(c, error, "cuts before millimetres and absolute words are set");
    if (!c->spindle)
        return control_error(c, error, "cuts while the spindle stands");
    if (c->setup->tcp && !c->tcp)
        return control_error(c, error, "cuts without tool centre point control");
    if (!(c->feed > 0))
        return control_error(c, error, "cuts without a feed");
    if (c->inverse_time && !c->feed_here)
        return control_error(c, error, "no F in a block under inverse time feed");
    if (!all_known(&c->here) || !c->here.has_axis)
        return control_error(c, error, "cuts from a place or with an axis that is not known");
    return 0;
}

int control_go(struct control *c, const struct place *to, struct piece piece, bool rapid,
               struct error *error)
{
    if (!rapid && control_ready(c, error) < 0)
        return -1;
    piece.rapid = rapid;
    bool tracked = c->tcp || !c->setup->tcp;
    if (piece.swing == SWING_ROTARY && !rapid &&
        !(c->here.turned[0] && c->here.turned[1] && to->turned[0] && to->turned[1]))
        return control_error(c, error, "cuts with rotary axes whose place is not known");
    if (tracked && all_known(to) && to->has_axis) {
        if (!all_known(&c->here) || !c->here.has_axis) { /* from the dark: only its end is known */
            piece.p[0] = piece.p[1];
            piece.q[0] = piece.q[1];
        }
        *array_push(&c->course->piece) = piece;
        c->course->lines += piece.shape == SHAPE_LINE && !rapid;
        c->course->arcs += piece.shape == SHAPE_ARC;
        c->course->curves += piece.shape == SHAPE_CUBIC;
    }
    c->here = *to;
    if (!tracked) /* words of another frame: nothing is known of the tip */
        memset(c->here.known, 0, sizeof c->here.known);
    return 0;
}

static struct vec3 plane_normal(const struct control *c)
{
    return c->plane == 17 ? vec(0, 0, 1) : c->plane == 18 ? vec(0, 1, 0) : vec(1, 0, 0);
}

int control_arc(const struct control *c, struct piece *piece, struct vec3 centre, bool ccw,
                struct error *error)
{
    struct vec3 n = plane_normal(c);
    struct vec3 u = vec_reject(vec_sub(piece->p[0], centre), n);
    struct vec3 v = vec_reject(vec_sub(piece->p[1], centre), n);
    if (c->inverse_time)
        return control_error(c, error, "an arc under inverse time feed");
    if (vec_length(u) < 1e-6 || fabs(vec_length(u) - vec_length(v)) > RADIUS_DIFFERENCE)
        return control_error(c, error, "an arc whose ends are not at one distance from its centre");
    double angle = atan2(vec_dot(vec_cross(u, v), n), vec_dot(u, v));
    bool full = vec_distance(u, v) < 1e-9;
    piece->shape = SHAPE_ARC;
    piece->centre = centre;
    piece->normal = n;
    if (ccw)
        piece->angle = full ? 2 * PI : angle > 0 ? angle : angle + 2 * PI;
    else
        piece->angle = full ? -2 * PI : angle < 0 ? angle : angle - 2 * PI;
    return 0;
}

int control_arc_radius(const struct control *c, struct piece *piece, double radius, bool ccw,
                       struct error *error)
{
    struct vec3 n = plane_normal(c);
    struct vec3 chord = vec_reject(vec_sub(piece->p[1], piece->p[0]), n);
    double length = vec_length(chord), r = fabs(radius);
    if (length < 1e-9)
        return control_error(c, error, "an arc by its radius with no way between its ends");
    if (length / 2 > r + RADIUS_DIFFERENCE)
        return control_error(c, error, "an arc whose ends are further apart than its diameter");
    double high = sqrt(fmax(0, r * r - length * length / 4));
    /* the centre lies left of the chord for a short counter-clockwise arc */
    double side = (ccw == (radius > 0)) ? high : -high;
    struct vec3 left = vec_cross(n, vec_unit(chord));
    struct vec3 centre = vec_along(vec_along(piece->p[0], 0.5, chord), side, left);
    return control_arc(c, piece, centre, ccw, error);
}

int control_arc_through(const struct control *c, struct piece *piece, struct vec3 middle,
                        struct error *error)
{
    struct vec3 u = vec_sub(middle, piece->p[0]), v = vec_sub(piece->p[1], piece->p[0]);
    struct vec3 n = vec_cross(u, v);
    double area2 = vec_dot(n, n), lu = vec_dot(u, u), lv = vec_dot(v, v);
    if (!(area2 > 1e-12 * lu * lv))
        return control_error(c, error, "an arc through points that lie on a line");
    struct vec3 to_centre =
        vec_scale(0.5 / area2, vec_cross(vec_sub(vec_scale(lu, v), vec_scale(lv, u)), n));
    piece->shape = SHAPE_ARC;
    piece->centre = vec_add(piece->p[0], to_centre);
    piece->normal = vec_unit(n);
    struct vec3 from = vec_sub(piece->p[0], piece->centre);
    struct vec3 to = vec_sub(piece->p[1], piece->centre);
    double angle = atan2(vec_dot(vec_cross(from, to), piece->normal), vec_dot(from, to));
    piece->angle = angle > 0 ? angle : angle + 2 * PI;
    return 0;
}

void control_pole(struct control *c, const struct piece *piece, struct vec3 p, struct vec3 q)
{
    if (c->pole_p.n == 0)
        c->spline = *piece;
    *array_push(&c->pole_p) = p;
    *array_push(&c->pole_q) = q;
}

int control_spline(struct control *c, struct error *error)
{
    size_t n = c->pole_p.n, order = (size_t)c->order;
    const double *k = c->knot.item;
    if (n < order || c->knot.n != n + order)
        return control_error(c, error, "a spline whose numbers of poles and knots do not agree");
    for (size_t i = 1; i < c->knot.n; i++)
        if (k[i] < k[i - 1])
            return control_error(c, error, "a spline whose knots fall");
    for (size_t i = 1; i < order; i++)
        if (k[i] > k[0] || k[n + i] > k[n])
            return control_error(c, error, "a spline whose end knots are not repeated");
    for (size_t i = 1; i + order <= n; i++)
        if (!(k[i] < k[i + order]))
            return control_error(c, error, "a spline that is torn by a repeated knot");
    for (size_t i = 0; i < c->weight.n; i++)
        if (!(c->weight.item[i] > 0))
            return control_error(c, error, "a spline with a weight that is not above zero");
    struct nurbs b = {.order = c->order, .n = n};
    b.knot = c->knot.item;
    b.p = c->pole_p.item;
    b.q = c->pole_q.item;
    b.weight = c->weight.item;
    c->knot = c->weight = (struct doubles){0};
    c->pole_p = c->pole_q = (struct vec3s){0};
    course_add_spline(c->course, b, &c->spline);
    return 0;
}

static const struct {
    int (*block)(struct control *c, const char *line, struct error *error);
    int (*end)(struct control *c, struct error *error);
} reader[] = {
    [READ_FANUC] = {control_fanuc, control_fanuc_end},
    [READ_SIEMENS] = {control_siemens, control_siemens_end},
    [READ_HEIDENHAIN] = {control_heidenhain, control_heidenhain_end},
    [READ_CANON] = {control_canon, control_canon_end},
};

static int read_lines(struct control *c, struct reader *r, struct error *error)
{
    char *line;
    size_t n;
    int more;
    while ((more = reader_line(r, &line, &n, error)) > 0) {
        c->line = r->line;
        c->block = -1;
        c->feed_here = false;
        if (strlen(line) != n)
            return control_error(c, error, "a byte that no program holds");
        if (reader[c->setup->dialect].block(c, line, error) < 0)
            return -1;
    }
    return more;
}

int control_read(const char *file, const struct setup *setup, struct course *course,
                 struct error *error)
{
    struct control c = {.setup = setup, .course = course, .name = file, .last_block = -1};
    struct reader r;
    if (reader_open(&r, file, error) < 0)
        return -1;
    course->name = file;
    course->rotary = setup->rotary;
    int result = read_lines(&c, &r, error);
    c.block = -1;
    if (result == 0)
        result = reader[setup->dialect].end(&c, error);
    reader_close(&r);
    array_free(&c.words);
    array_free(&c.knot);
    array_free(&c.weight);
    array_free(&c.pole_p);
    array_free(&c.pole_q);
    return result;
}
