/* ncread_state - see ncread_state.h. */
#include "ncread_state.h"

#include <stdio.h>
#include <string.h>

int ncread_error(const struct ncread *c, struct error *error, const char *what)
{
    if (c->block >= 0)
        return error_at(error, c->name, c->line, "N%ld: %s", c->block, what);
    return error_at(error, c->name, c->line, "%s", what);
}

/* Words of axes that are not this machine's, and of repeated calls. */
static bool letter_moves(char letter)
{
    return strchr("ABCUVWXYZIJKRL", letter) != NULL;
}

enum { NAMED = WORD_TEXT + 24 };

/* A word as it is told. */
static void word_text(const struct ncread_word *w, char text[NAMED])
{
    if (w->kind == WORD_ADDRESS)
        snprintf(text, NAMED, "%s%.15g", w->name, w->value[0]);
    else
        snprintf(text, NAMED, "%s", w->name);
}

int ncread_unread(struct ncread *c, const struct ncread_word *w, struct error *error)
{
    char text[160], word[NAMED];
    word_text(w, word);
    snprintf(text, sizeof text, "found %s, which this reader does not know", word);
    return ncread_error(c, error, text);
}

int ncread_unknown(struct ncread *c, const struct ncread_word *w, struct error *error)
{
    char text[160], word[NAMED];
    bool address = w->kind == WORD_ADDRESS, number = address && strchr("GM", *w->name);
    const char *what =
        number ? ncread_meaning_moves(*w->name, (int)lround(10 * w->value[0])) : NULL;
    bool places = false;
    word_text(w, word);
    for (size_t i = 0; number && i < c->words.n; i++)
        places = places || (c->words.item[i].kind == WORD_ADDRESS &&
                            strchr("XYZABC", *c->words.item[i].name));
    if (what)
        snprintf(text, sizeof text, "found %s, %s, which this reader does not read", word, what);
    else if (places && *w->name == 'G')
        snprintf(text, sizeof text, "found %s with a place, which this reader does not know", word);
    else if (address ? *w->name != 'G' && !letter_moves(*w->name) : w->kind == WORD_SET) {
        ncread_meaning_note(c, number ? word : w->name);
        return 0;
    } else
        return ncread_unread(c, w, error);
    return ncread_error(c, error, text);
}

int ncread_m(struct ncread *c, const struct ncread_word *w, struct error *error)
{
    static const int idle[] = {0, 1, 6, 7, 8, 9, 10, 11, 12, 13, 29, 48, 49, 60, 88, 89};
    int code = (int)w->value[0];
    enum ncread_meaning meaning = ncread_meaning_of_word(c, w);
    if (meaning != MEANS_NOTHING_KNOWN)
        return ncread_meaning_apply(c, meaning, error);
    if (code == 3 || code == 4 || code == 5 || code == 19) /* M19 turns it to an angle: it stands */
        c->spindle = code == 3 || code == 4;
    else if (code == 30 || code == 2)
        c->ended = true;
    else if (code == 6 && c->pole_p.n > 0)
        return ncread_error(c, error, "a change of the tool amid a spline");
    else if (code == 6) {
        ncread_tool_stops(c);
        if (c->watch.cuts) /* to where tools are changed */
            memset(c->here.known, 0, sizeof c->here.known);
    } else {
        for (size_t i = 0; i < sizeof idle / sizeof *idle; i++)
            if (code == idle[i])
                return 0;
        return ncread_unknown(c, w, error);
    }
    return 0;
}

bool ncread_ours(const struct ncread *c)
{
    return c->options->head && c->options->head->numbered;
}

/* ncpost numbers blocks evenly, the first one with the step itself: where a number is missing, so
 * is a block. */
static void watch_step(struct ncread *c)
{
    char text[120];
    bool first = c->last_block < 0, second = c->last_block == c->step;
    long step = first ? c->block : c->block - c->last_block;
    if (!ncread_ours(c))
        return;
    if (c->step == 0 || (second && step < c->step)) {
        c->step = step;
    } else if (step > c->step) {
        snprintf(text, sizeof text, "the block N%ld before it is missing", c->last_block + c->step);
        ncread_watch_remark(c, c->line, c->block, text);
    }
}

int ncread_block(struct ncread *c, double number, struct error *error)
{
    c->block = (long)number;
    bool anew = c->last_block >= 9900 && c->block <= 100; /* the digits are used up */
    if (c->block <= c->last_block && !anew)
        return ncread_error(c, error, "its number does not rise");
    if (!anew)
        watch_step(c);
    c->last_block = c->block;
    return 0;
}

bool ncread_axis(const struct ncread *c, const char *name, double value, struct ncread_place *to)
{
    if (strlen(name) != 1)
        return false;
    if (*name >= 'X' && *name <= 'Z') {
        to->at[*name - 'X'] = value;
        to->known[*name - 'X'] = true;
        return true;
    }
    for (int i = 0; i < c->options->kinematics.n; i++)
        if (*name == c->options->kinematics.axis[i].letter) {
            if (c->options->wraps[i])
                return ncread_nearest(c, *name, fabs(value), to);
            to->turn[i] = value;
            to->turned[i] = true;
            return true;
        }
    return false;
}

bool ncread_axis_by(const struct ncread *c, const char *name, double value, struct ncread_place *to)
{
    if (strlen(name) != 1)
        return false;
    if (*name >= 'X' && *name <= 'Z') {
        to->at[*name - 'X'] += value;
        return true;
    }
    for (int i = 0; i < c->options->kinematics.n; i++)
        if (*name == c->options->kinematics.axis[i].letter) {
            to->turn[i] += value;
            return true;
        }
    return false;
}

bool ncread_nearest(const struct ncread *c, char name, double value, struct ncread_place *to)
{
    for (int i = 0; i < c->options->kinematics.n; i++)
        if (name == c->options->kinematics.axis[i].letter) {
            if (c->here.turned[i])
                value += 360 * round((c->here.turn[i] - value) / 360);
            to->turn[i] = value;
            to->turned[i] = true;
            return true;
        }
    return false;
}

static bool all_turned(const struct ncread *c, const struct ncread_place *place)
{
    for (int i = 0; i < c->options->kinematics.n; i++)
        if (!place->turned[i])
            return false;
    return true;
}

void ncread_turned(const struct ncread *c, struct ncread_place *to)
{
    if (all_turned(c, to)) {
        to->axis = verify_kinematics_axis_at(&c->options->kinematics, to->turn);
        to->has_axis = true;
    } else if (to->turned[0] || to->turned[1]) { /* one alone, after a vector */
        to->has_axis = false;
    }
}

void ncread_pointed(struct ncread_place *to, struct vec3 axis)
{
    to->axis = vec_unit(axis);
    to->has_axis = true;
    to->turned[0] = to->turned[1] = false;
}

static bool all_known(const struct ncread_place *place)
{
    return place->known[0] && place->known[1] && place->known[2];
}

static struct vec3 point_of(const struct ncread_place *place)
{
    return vec(place->at[0], place->at[1], place->at[2]);
}

struct nc_piece ncread_piece(const struct ncread *c, const struct ncread_place *to)
{
    struct nc_piece piece = {
        .line = c->line, .block = (int)c->block, .feed = c->feed, .inverse = c->inverse_time};
    const struct ncread_place *from = &c->here;
    piece.p[0] = point_of(from);
    piece.p[1] = point_of(to);
    if (c->tilted.on) {
        piece.interpolation = AXIS_GREAT_CIRCLE;
        piece.q[0] = piece.q[1] = vec(0, 0, 1);
    } else if (c->curve && from->has_head && to->has_head) {
        piece.interpolation = AXIS_BY_HEAD;
        piece.q[0] = from->head;
        piece.q[1] = to->head;
    } else if (c->vectors && c->options->tcp) {
        piece.interpolation = AXIS_GREAT_CIRCLE;
        piece.q[0] = from->axis;
        piece.q[1] = to->axis;
    } else {
        piece.interpolation = AXIS_ROTARY_LINEAR;
        piece.q[0] = vec(from->turn[0], from->turn[1], 0);
        piece.q[1] = vec(to->turn[0], to->turn[1], 0);
        piece.table = !c->options->tcp;
    }
    return piece;
}

bool ncread_upright(const struct ncread *c)
{
    for (int i = 0; i < c->options->kinematics.n; i++)
        if (!c->here.turned[i] || c->here.turn[i] != 0)
            return false;
    return true;
}

/* Rotary axes of the head, or those of tool-centre-point control, are not at zero or not known:
 * without the length X Y Z are not the tip. */
static bool length_counts(const struct ncread *c)
{
    for (int i = 0; i < c->options->kinematics.n; i++)
        if ((c->options->tcp || !c->options->kinematics.axis[i].table) &&
            !(c->here.turned[i] && c->here.turn[i] == 0))
            return true;
    return false;
}

bool ncread_nose(const struct ncread *c)
{
    bool by_machine = c->options->dialect == &ncread_linuxcnc; /* TCP is on all the time there */
    return c->lengthened && !c->length && (!c->tcp || by_machine);
}

int ncread_length(struct ncread *c, struct error *error)
{
    if (c->length)
        return 0;
    if (ncread_ours(c) || c->lengthened || c->tilted.on || length_counts(c))
        return ncread_error(c, error, "cuts without the tool's length, G43");
    if (!c->length_assumed)
        c->length_assumed = c->line;
    return 0;
}

int ncread_length_watch(struct ncread *c, struct error *error)
{
    char text[120];
    c->lengthened = c->lengthened || c->length;
    if (!c->length || !c->length_assumed)
        return 0;
    snprintf(text, sizeof text, "the tool's length comes on after the cut without it in line %zu",
             c->length_assumed);
    return ncread_error(c, error, text);
}

int ncread_ready(struct ncread *c, struct error *error)
{
    if (!(c->unit > 0) || !c->said)
        return ncread_error(c, error,
                            "cuts before its unit and absolute or incremental words are set");
    if (!c->spindle)
        return ncread_error(c, error, "cuts while the spindle is off");
    if (c->options->tcp && !c->tcp && !c->tilted.on && !ncread_upright(c))
        return ncread_error(c, error, "cuts without tool centre point control");
    if (!ncread_plane_reached(c))
        return ncread_error(c, error,
                            "cuts in a tilted plane to which the tool was not turned (G53.1)");
    if (ncread_watch_still(c))
        return ncread_error(c, error, "cuts at a speed of the spindle that is not above 0");
    if (!(c->feed > 0))
        return ncread_error(c, error, "cuts without a feed");
    if (c->inverse_time && !c->feed_here)
        return ncread_error(c, error, "no F in a block under inverse time feed");
    if (!all_known(&c->here) || !(c->here.has_axis || c->tilted.on))
        return ncread_error(c, error, "cuts from a place or with an axis that is not known");
    ncread_watch_cut(c);
    return 0;
}

int ncread_go(struct ncread *c, const struct ncread_place *to, struct nc_piece piece, bool rapid,
              struct error *error)
{
    if (!rapid && ncread_ready(c, error) < 0)
        return -1;
    piece.rapid = rapid;
    bool nose = ncread_nose(c); /* X and Y are the tip's where the axes allow that, Z is not */
    bool aligned = c->tcp || !c->options->tcp || c->tilted.on || ncread_upright(c);
    bool tracked = aligned && !nose;
    if (piece.interpolation == AXIS_ROTARY_LINEAR && !rapid &&
        !(all_turned(c, &c->here) && all_turned(c, to)))
        return ncread_error(c, error, "cuts with rotary axes whose place is not known");
    if (tracked && all_known(to) && (to->has_axis || c->tilted.on)) {
        bool axis = c->here.has_axis || c->tilted.on;
        if (!all_known(&c->here) || !axis) { /* from the dark: only its end is known */
            piece.p[0] = piece.p[1];
            piece.q[0] = piece.q[1];
            piece.dark = !(c->here.known[0] && c->here.known[1]);
        }
        ncread_plane_turn(c, &piece);
        ncread_unit_piece(c, &piece);
        if (ncread_tool_piece(c, &piece, error) < 0)
            return -1;
        *array_push(&c->motion->piece) = piece;
        c->motion->lines += piece.shape == SHAPE_LINE && !rapid;
        c->motion->arcs += piece.shape == SHAPE_ARC;
        c->motion->curves += piece.shape == SHAPE_POLYNOMIAL;
    }
    ncread_home_go(c, to, rapid, tracked);
    c->here = *to;
    if (!aligned) /* words of another frame: nothing is known of the tip */
        memset(c->here.known, 0, sizeof c->here.known);
    else if (nose)
        c->here.known[2] = false;
    return 0;
}

/* ---- arcs and splines */

/* Largest difference of an arc's radius at its start and its end, mm, in the program's unit. */
static double radius_slack(const struct ncread *c)
{
    return 0.005 / (c->unit > 0 ? c->unit : 1);
}

static void set_arc(struct ncread *c, struct nc_piece *piece, struct nc_motion_arc arc)
{
    piece->shape = SHAPE_ARC;
    piece->index = c->motion->arc.n;
    *array_push(&c->motion->arc) = arc;
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
    if (vec_length(u) < 1e-6 || fabs(vec_length(u) - vec_length(v)) > radius_slack(c))
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
        return ncread_error(c, error, "an arc by its radius whose ends coincide");
    if (length / 2 > r + radius_slack(c))
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
    for (size_t i = first; i < c->motion->piece.n; i++) {
        struct nc_piece *piece = &c->motion->piece.item[i];
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
    if (ncread_tool_piece(c, &c->spline, error) < 0)
        return -1;
    ncread_plane_turn_poles(c);
    ncread_unit_poles(c);
    struct nc_motion_spline b = {.order = c->order, .n = n};
    b.knot = c->knot.item;
    b.p = c->pole_p.item;
    b.q = c->pole_q.item;
    b.weight = c->weight.item;
    c->knot = c->weight = (struct doubles){0};
    c->pole_p = c->pole_q = (struct vec3s){0};
    size_t first = c->motion->piece.n;
    nc_motion_add_spline(c->motion, b, &c->spline);
    name_spans(c, &b, first);
    return 0;
}

/* ---- units */

int ncread_unit(struct ncread *c, double mm, struct error *error)
{
    if (c->unit > 0 && c->unit != mm)
        return ncread_error(c, error, "millimetres and inches in one program");
    c->unit = c->motion->unit = mm;
    return 0;
}

static void ends(double unit, struct nc_piece *piece)
{
    for (int i = 0; i < 2; i++) {
        piece->p[i] = vec_scale(unit, piece->p[i]);
        if (piece->interpolation == AXIS_BY_HEAD)
            piece->q[i] = vec_scale(unit, piece->q[i]);
    }
    if (!piece->inverse)
        piece->feed *= unit;
}

void ncread_unit_piece(struct ncread *c, struct nc_piece *piece)
{
    if (!(c->unit > 0)) /* only rapid moves: the frame is set later */
        return;
    ends(c->unit, piece);
    if (piece->shape == SHAPE_ARC) {
        struct nc_motion_arc *arc = &c->motion->arc.item[piece->index];
        arc->centre = vec_scale(c->unit, arc->centre);
    } else if (piece->shape == SHAPE_POLYNOMIAL) {
        struct nc_motion_polynomial *sum = &c->motion->polynomial.item[piece->index];
        for (int i = 0; i < NC_MOTION_DEGREE; i++) {
            sum->p[i] = vec_scale(c->unit, sum->p[i]);
            sum->q[i] = vec_scale(c->unit, sum->q[i]);
        }
    }
}

void ncread_unit_poles(struct ncread *c)
{
    for (size_t i = 0; i < c->pole_p.n; i++) {
        c->pole_p.item[i] = vec_scale(c->unit, c->pole_p.item[i]);
        if (c->spline.interpolation == AXIS_BY_HEAD)
            c->pole_q.item[i] = vec_scale(c->unit, c->pole_q.item[i]);
    }
    ends(c->unit, &c->spline);
}
