/*
 * run - tangents and the smooth reference curve of a cutting run.
 *
 * Repeated points have no direction of their own: points whose ball centres coincide form one
 * station, and tangents belong to stations.
 */
#include "curve/run.h"

#include <stdlib.h>

static const double SAME = 1e-7;          /* mm: centres nearer than this are one station */
static const double CORNER = PI / 3;      /* a turn above this in one point is a corner */
static const double AXIS_SMOOTH = PI / 3; /* axes further apart than this: great circle */
static const double SWING = PI / 12;      /* axes further apart than this swing the ball */
static const double EVEN = PI / 180;      /* a tip's path that turns by less is straight */
static const double SHARP = PI / 18;      /* and one above this may be beside one */
static const double ASTRAY = 0.01;        /* mm: what a curve may be off a chord unasked */
static const double NEAR = 0.003;         /* mm: a curve so near a chord is as good as it */
static const double FLUTE = 4;            /* radii: the usual one's end from the centre */
static const double UNEVEN = 1.5;         /* times as long as the other is a long interval */
static const double STEEP = 0.7;          /* slope of the centres against the surface: no tangent */

enum { PARTS_MAX = 10000 }; /* pieces of one interval */

struct station {
    size_t first, last;  /* of its points */
    struct vec3 tangent; /* unit */
    struct vec3 turn;    /* derivative of the axis by the length of the centre's path, 1/mm */
};

struct stations {
    size_t n, cap;
    struct station *item;
};

static struct stations find_stations(const struct run *run)
{
    struct stations s = {0};
    for (size_t i = 0; i < run->n; i++) {
        const struct run_point *p = &run->item[i];
        if (i == 0 || vec_distance(p->ball, run->item[s.item[s.n - 1].first].ball) > SAME)
            *array_push(&s) = (struct station){.first = i};
        s.item[s.n - 1].last = i;
    }
    return s;
}

static const struct run_point *point_of(const struct run *run, const struct stations *s, size_t k)
{
    return &run->item[s->item[k].first];
}

static struct vec3 chord_of(const struct run *run, const struct stations *s, size_t k)
{
    return vec_sub(point_of(run, s, k + 1)->ball, point_of(run, s, k)->ball);
}

/* The ball does not touch both contacts, or not alone: its centre is lifted off them, and what
 * stops it need not be what their normals tell of. */
static bool is_lifted(const struct run_point *a, const struct run_point *b)
{
    const double printed = 1e-5; /* mm: heights that are as good as the same */

    return fabs(run_point_height(a) - run_point_height(b)) > printed;
}

/* How far a curve over the chord that begins or ends along the tangent, and else along the chord,
 * is off it: a cubic's 4/27 of length and slope. */
static double bulge_of(struct vec3 chord, struct vec3 tangent)
{
    return 4 / 27.0 * vec_length(vec_reject(chord, tangent));
}

static bool is_near(struct vec3 chord, struct vec3 tangent)
{
    return bulge_of(chord, tangent) <= NEAR;
}

/*
 * The centre of a ball that touches moves perpendicular to the normal; one that is being lifted
 * moves by the slope of its lift against it.  False where it is too steep to tell.
 */
static bool along_surface(struct vec3 tangent, struct vec3 normal, double slope, struct vec3 *along)
{
    struct vec3 t = vec_reject(tangent, normal);
    if (fabs(slope) > STEEP || vec_length(t) < STEEP)
        return false;
    *along = vec_unit(vec_along(vec_unit(t), slope, normal));
    return true;
}

/* The larger bulge of curves along the tangent over the chords before and after it. */
static double worst_bulge(struct vec3 tangent, struct vec3 in, struct vec3 out)
{
    return fmax(bulge_of(in, tangent), bulge_of(out, tangent));
}

/* A path at a point, with what may be its tangent there. */
struct way {
    struct vec3 in, out;       /* chords before and after it */
    struct vec3 before, after; /* chords before and after these; zero: there are none */
};

static struct way way_at(const struct run *run, const struct stations *s, size_t k)
{
    struct way w = {.in = chord_of(run, s, k - 1), .out = chord_of(run, s, k)};
    if (k > 1)
        w.before = chord_of(run, s, k - 2);
    if (k + 2 < s->n)
        w.after = chord_of(run, s, k + 1);
    return w;
}

/* What a way turns for each mm at a point between two chords, 1/mm; zero where one is missing. */
static struct vec3 bend_of(struct vec3 in, struct vec3 out)
{
    double length = vec_length(in) + vec_length(out);
    if (vec_length(in) <= 0 || vec_length(out) <= 0)
        return (struct vec3){0, 0, 0};
    return vec_scale(2 / length, vec_sub(vec_unit(out), vec_unit(in)));
}

/* A bend does not go on as it would if it were one: its way has an edge here. */
static bool ends_bend(struct vec3 here, struct vec3 there)
{
    return vec_dot(there, here) < vec_dot(here, here) / 2;
}

/* The way turns sharply, or with `any` does not turn so at the longer chord's other end. */
static bool is_edge(const struct way *w, bool any)
{
    struct vec3 there = vec_length(w->in) > vec_length(w->out) ? bend_of(w->before, w->in)
                                                               : bend_of(w->out, w->after);
    return vec_angle(w->in, w->out) > SHARP || (any && ends_bend(bend_of(w->in, w->out), there));
}

/*
 * A tangent along which a curve goes astray gives way to one along which it does so less: to that
 * of the centres alone, for what stops a ball need not be what the normals tell of; and where the
 * way has an edge between a short chord and a long one, as beside an inner edge, to the long one.
 */
static struct vec3 least_bulge(struct vec3 tangent, struct vec3 of_centres, const struct way *w,
                               bool any)
{
    struct vec3 in = w->in, out = w->out;
    double worst = worst_bulge(tangent, in, out), centres = worst_bulge(of_centres, in, out);
    struct vec3 longer = vec_unit(vec_length(in) > vec_length(out) ? in : out);
    if (worst <= ASTRAY)
        return tangent;
    if (worst_bulge(longer, in, out) < fmin(worst, centres) && is_edge(w, any))
        return longer;
    return centres < worst ? of_centres : tangent;
}

/* Derivative at the middle one of three values on a parabola; h: the lengths between them. */
static double parabola_slope(double before, double h0, double here, double h1, double after)
{
    return (h1 * (here - before) / h0 + h0 * (after - here) / h1) / (h0 + h1);
}

static struct vec3 bessel_tangent(const struct run *run, const struct stations *s, size_t k)
{
    struct vec3 in = chord_of(run, s, k - 1), out = chord_of(run, s, k);
    double h0 = vec_length(in), h1 = vec_length(out);
    struct vec3 t = vec_unit(vec_add(vec_scale(h1 / h0, in), vec_scale(h0 / h1, out)));
    if (vec_dot(t, t) < 0.5)
        return vec_unit(out); /* straight back */
    const struct run_point *a = point_of(run, s, k - 1), *b = point_of(run, s, k),
                           *c = point_of(run, s, k + 1);
    if (!run_point_touches(a) || !run_point_touches(b) || !run_point_touches(c))
        return t;
    if ((is_lifted(a, b) || is_lifted(b, c)) && is_near(in, t) && is_near(out, t))
        return t;
    double slope =
        parabola_slope(run_point_height(a), h0, run_point_height(b), h1, run_point_height(c));
    struct vec3 along;
    struct way way = way_at(run, s, k);
    return least_bulge(along_surface(t, b->normal, slope, &along) ? along : t, t, &way, run->edges);
}

/* At an end: the tangent of the circle that the end chord and the tangent beyond it make. */
static struct vec3 end_tangent(const struct run *run, const struct stations *s, size_t end,
                               size_t next)
{
    const struct run_point *a = point_of(run, s, end), *b = point_of(run, s, next);
    struct vec3 v = vec_sub(b->ball, a->ball);
    double h = vec_length(v);
    v = vec_unit(v);
    struct vec3 beyond = s->item[next].tangent;
    struct vec3 t = vec_unit(vec_sub(vec_scale(2 * vec_dot(v, beyond), v), beyond));
    if (!run_point_touches(a) || !run_point_touches(b) ||
        (is_lifted(a, b) && is_near(vec_scale(h, v), t)))
        return t;
    double slope = (run_point_height(b) - run_point_height(a)) / h;
    struct vec3 along, chord = vec_scale(h, v);
    bool found = along_surface(t, a->normal, next > end ? slope : -slope, &along);
    struct way way = {chord, chord, {0, 0, 0}, {0, 0, 0}};
    return found ? least_bulge(along, t, &way, run->edges) : t;
}

static void set_bessel_tangents(const struct run *run, struct stations *s)
{
    for (size_t k = 1; k + 1 < s->n; k++)
        s->item[k].tangent = bessel_tangent(run, s, k);
    if (s->n == 2) {
        s->item[0].tangent = s->item[1].tangent = vec_unit(chord_of(run, s, 0));
    } else if (s->n > 2) {
        s->item[0].tangent = end_tangent(run, s, 0, 1);
        s->item[s->n - 1].tangent = end_tangent(run, s, s->n - 1, s->n - 2);
    }
}

/* Paper 1, 3.4: ti = ni x (PiPi+1 x ni); the last point takes the chord before it. */
static void set_forward_tangents(const struct run *run, struct stations *s)
{
    for (size_t k = 0; s->n > 1 && k < s->n; k++) {
        struct vec3 v = chord_of(run, s, k + 1 < s->n ? k : k - 1);
        struct vec3 n = point_of(run, s, k)->normal;
        struct vec3 t = vec_unit(vec_cross(n, vec_cross(v, n)));
        s->item[k].tangent = vec_dot(t, t) > 0.5 ? t : vec_unit(v);
    }
}

void run_tangents(const struct run *run, bool forward, struct vec3 *tangent)
{
    struct stations s = find_stations(run);
    if (forward)
        set_forward_tangents(run, &s);
    else
        set_bessel_tangents(run, &s);
    for (size_t k = 0; k < s.n; k++) {
        for (size_t i = s.item[k].first; i <= s.item[k].last; i++)
            tangent[i] = s.item[k].tangent;
    }
    array_free(&s);
}

/* Every tangent takes a curve astray over one of the chords, and the way bends so much nowhere
 * beside: it has an edge, as a ball's has where it comes from one face to another. */
static bool has_no_tangent(const struct run *run, const struct stations *s, size_t k)
{
    struct way w = way_at(run, s, k);
    struct vec3 here = bend_of(w.in, w.out);
    bool alone = vec_length(w.before) <= 0 && vec_length(w.after) <= 0;

    return !alone && ends_bend(here, bend_of(w.before, w.in)) &&
           ends_bend(here, bend_of(w.out, w.after)) &&
           worst_bulge(bessel_tangent(run, s, k), w.in, w.out) > ASTRAY;
}

/* The tip's path does not turn at point i of the run, where it is between two others. */
static bool is_tip_straight(const struct run *run, size_t i)
{
    if (i == 0 || i + 1 >= run->n)
        return true;
    struct vec3 in = vec_sub(run->item[i].tip, run->item[i - 1].tip);
    struct vec3 out = vec_sub(run->item[i + 1].tip, run->item[i].tip);
    return vec_length(vec_cross(in, out)) <= EVEN * vec_length(in) * vec_length(out);
}

/*
 * In the block off the part from point i on the axis turns so far that centre and tip cannot both
 * go nearly straight, and the centre is swung about: the tip goes straight, as a control has it.
 * Unless its points are on a line, an axis that turns less, or about the centre, may be that of a
 * round way of both.
 */
static bool is_swing(const struct run *run, size_t i)
{
    const struct run_point *a = &run->item[i], *b = &run->item[i + 1];
    double way = vec_distance(a->ball, b->ball);

    if (run_point_touches(a) || run_point_touches(b) || way <= SAME)
        return false;
    double half = vec_length(vec_mix(a->axis, b->axis, 0.5)); /* cosine of half the turn */
    if (half < cos(SWING / 2) && vec_distance(a->tip, b->tip) < way)
        return true;
    return run->radius * (1 - half) > NEAR && is_tip_straight(run, i) &&
           is_tip_straight(run, i + 1);
}

/* The same from station k to the next. */
static bool is_swing_after(const struct run *run, const struct stations *s, size_t k)
{
    return is_swing(run, s->item[k].last);
}

void run_corners(const struct run *run, struct sizes *corner)
{
    struct stations s = find_stations(run);
    for (size_t k = 1; k + 1 < s.n; k++)
        if (vec_angle(chord_of(run, &s, k - 1), chord_of(run, &s, k)) > CORNER ||
            is_swing_after(run, &s, k - 1) || is_swing_after(run, &s, k) ||
            (run->edges && has_no_tangent(run, &s, k)))
            *array_push(corner) = s.item[k].first;
    array_free(&s);
}

/* ---- the smooth curve from one point to the next: the cubic Hermite curve of the centre and of
 * the axis, and the tip that follows from both */

/* What it starts or ends with. */
struct run_curve_end {
    const struct run_point *point;
    struct vec3 tangent; /* of the ball's path, unit */
    struct vec3 turn;    /* derivative of the axis by the length of that path, 1/mm */
};

struct run_curve {
    const struct run_point *a, *b;
    struct vec3 va, vb; /* derivatives of the centre at its ends, mm */
    struct vec3 wa, wb; /* derivatives of the axis */
    bool great_circle;  /* that has the axis instead of these: its ends are more than 60 degrees
                           apart */
    bool swing;         /* so it has, and the tip goes straight */
};

/*
 * The speed at the ends is that at which a cubic is nearest to a circle with these tangents:
 * 2 d / (1 + cos(turn / 2)) for a chord of length d.
 */
static double speed_between(double length, struct vec3 from, struct vec3 to)
{
    double half = sqrt(fmax(0, (1 + vec_dot(from, to)) / 2));
    return 2 * length / (1 + half);
}

static struct run_curve run_curve_between(struct run_curve_end a, struct run_curve_end b)
{
    double length = vec_distance(a.point->ball, b.point->ball);
    double speed = speed_between(length, a.tangent, b.tangent);
    return (struct run_curve){
        .a = a.point,
        .b = b.point,
        .va = vec_scale(speed, a.tangent),
        .vb = vec_scale(speed, b.tangent),
        .wa = vec_scale(speed, a.turn),
        .wb = vec_scale(speed, b.turn),
        .great_circle = vec_angle(a.point->axis, b.point->axis) > AXIS_SMOOTH,
    };
}

static struct vec3 hermite(struct vec3 p, struct vec3 v, struct vec3 q, struct vec3 w, double t)
{
    struct vec3 d = vec_sub(q, p);
    double s = 1 - t;
    struct vec3 r = vec_along(p, t * t * (3 - 2 * t), d);
    return vec_along(vec_along(r, t * s * s, v), -t * t * s, w);
}

/* Centre, axis and tip at t in [0, 1].  `radius` of the ball, mm. */
static struct run_point run_curve_pose(const struct run_curve *c, double t, double radius)
{
    struct run_point p = {.ball = {0}};

    if (c->swing) {
        p.axis = vec_slerp(c->a->axis, c->b->axis, t);
        p.tip = vec_mix(c->a->tip, c->b->tip, t);
        p.ball = vec_along(p.tip, radius, p.axis);
        return p;
    }
    p.ball = hermite(c->a->ball, c->va, c->b->ball, c->vb, t);
    p.axis = c->great_circle ? vec_slerp(c->a->axis, c->b->axis, t)
                             : vec_unit(hermite(c->a->axis, c->wa, c->b->axis, c->wb, t));
    p.tip = vec_along(p.ball, -radius, p.axis);
    return p;
}

/* The same with normal and contact, where both ends have them. */
static struct run_point run_curve_at(const struct run_curve *c, double t, double radius)
{
    struct run_point p = run_curve_pose(c, t, radius);

    if (run_point_touches(c->a) && run_point_touches(c->b)) {
        p.normal = vec_slerp(c->a->normal, c->b->normal, t);
        double h = (1 - t) * run_point_height(c->a) + t * run_point_height(c->b);
        p.contact = vec_along(p.ball, -h, p.normal);
    }
    return p;
}

/* Largest distance between the curve and `parts` straight pieces, at the tip and the centre. */
static double chord_error(const struct run_curve *c, size_t parts, double radius)
{
    enum { SAMPLES = 4 };
    double worst = 0, n = (double)parts;
    struct run_point from = *c->a;
    for (size_t k = 0; k < parts; k++) {
        struct run_point to =
            k + 1 < parts ? run_curve_pose(c, (double)(k + 1) / n, radius) : *c->b;
        for (int i = 1; i < SAMPLES; i++) {
            struct run_point p = run_curve_pose(c, ((double)k + (double)i / SAMPLES) / n, radius);
            worst = fmax(worst, vec_segment_distance(from.ball, to.ball, p.ball));
            worst = fmax(worst, vec_segment_distance(from.tip, to.tip, p.tip));
        }
        from = to;
    }
    return worst;
}

/*
 * Appends as many points, and its end, that straight lines from its start on stay within `chord` mm
 * of it at the tip and the centre.  Returns how far the straight line from its start to its end is
 * off.
 */
static double run_curve_densify(const struct run_curve *c, double chord, struct run *dense)
{
    size_t parts = 1;
    double whole = chord_error(c, 1, dense->radius), off = whole;
    while (off > chord && parts < PARTS_MAX) {
        double more = 1.01 * (double)parts * sqrt(off / chord);
        parts = more < PARTS_MAX ? (size_t)more + 1 : PARTS_MAX;
        off = chord_error(c, parts, dense->radius);
    }
    for (size_t k = 1; k < parts; k++)
        *array_push(dense) = run_curve_at(c, (double)k / (double)parts, dense->radius);
    *array_push(dense) = *c->b;
    return whole;
}

/* ---- the smooth curve of a run */

/* The axis' turn from station k to the next, by the length between them. */
static struct vec3 turn_after(const struct run *run, const struct stations *s, size_t k)
{
    struct vec3 from = run->item[s->item[k].last].axis, to = point_of(run, s, k + 1)->axis;
    return vec_scale(1 / vec_length(chord_of(run, s, k)), vec_sub(to, from));
}

/* By how much an axis that begins or ends with this turn is beside those that go evenly from one
 * end to the other, radians for each mm between them. */
static double axis_bulge(struct vec3 turn, struct vec3 even)
{
    return 4 / 27.0 * vec_length(vec_reject(turn, vec_unit(even)));
}

/*
 * How fast the axis turns at each station: of the parabola through three axes, but never more than
 * three times as fast as in the slower of the two intervals, so that it does not overshoot, and not
 * so fast that it takes the flute's end astray, as a swing between two near stations would the long
 * way to the next; not at all where the axis turns while the centre stands still.
 */
static void set_axis_turns(const struct run *run, struct stations *s)
{
    for (size_t k = 0; s->n > 1 && k < s->n; k++) {
        struct station *here = &s->item[k];
        if (vec_distance(run->item[here->first].axis, run->item[here->last].axis) > 0)
            continue;
        size_t i = k > 0 ? k - 1 : 0, j = k + 1 < s->n ? k : k - 1;
        double h0 = vec_length(chord_of(run, s, i)), h1 = vec_length(chord_of(run, s, j));
        struct vec3 r0 = turn_after(run, s, i), r1 = turn_after(run, s, j);
        struct vec3 r = vec_mix(r0, r1, h0 / (h0 + h1));
        double most = 3 * fmin(vec_length(r0), vec_length(r1)), l = vec_length(r);
        r = l > most ? vec_scale(most / l, r) : r;
        double astray = fmax(h0 * axis_bulge(r, r0), h1 * axis_bulge(r, r1)) * FLUTE * run->radius;
        bool uneven = fmax(h0, h1) > UNEVEN * fmin(h0, h1);
        here->turn = uneven && astray > ASTRAY ? vec_scale(ASTRAY / astray, r) : r;
    }
}

/* From station k on the path goes straight. */
static bool is_straight(const struct run *run, const struct stations *s, size_t k)
{
    return k + 1 < s->n && run->item[s->item[k].last].straight;
}

/* Beside a straight line the smooth curve begins and ends along it; between two lines is a kink. */
static void set_line_tangents(const struct run *run, struct stations *s)
{
    for (size_t k = 0; k + 1 < s->n; k++) {
        if (!is_straight(run, s, k))
            continue;
        struct vec3 along = vec_unit(chord_of(run, s, k));
        if (k > 0 && !is_straight(run, s, k - 1))
            s->item[k].tangent = along;
        if (!is_straight(run, s, k + 1))
            s->item[k + 1].tangent = along;
    }
}

/* A piece of the run without corners, but for its first point, which is there already. */
static double densify_piece(const struct run *piece, double chord, struct run *dense)
{
    struct stations s = find_stations(piece);
    set_bessel_tangents(piece, &s);
    set_line_tangents(piece, &s);
    set_axis_turns(piece, &s);
    double worst = 0;
    size_t at = 0; /* station of point i */
    for (size_t i = 0; i + 1 < piece->n; i++) {
        const struct station *here = &s.item[at];
        if (at + 1 < s.n && s.item[at + 1].first == i + 1)
            at++;
        const struct station *next = &s.item[at];
        struct run_curve c = run_curve_between(
            (struct run_curve_end){&piece->item[i], here->tangent, here->turn},
            (struct run_curve_end){&piece->item[i + 1], next->tangent, next->turn});
        c.great_circle = c.great_circle || here == next; /* the axis turns in one place */
        c.swing = is_swing(piece, i);
        if (piece->item[i].straight) {
            c.va = c.vb = vec_sub(c.b->ball, c.a->ball);
            c.great_circle = true;
        }
        worst = fmax(worst, run_curve_densify(&c, chord, dense));
    }
    array_free(&s);
    return worst;
}

struct vec3 run_middle(const struct run *run, const struct vec3 *tangent, size_t i)
{
    struct vec3 a = run->item[i].ball, b = run->item[i + 1].ball;
    double speed = speed_between(vec_distance(a, b), tangent[i], tangent[i + 1]);

    return vec_along(vec_mix(a, b, 0.5), speed / 8, vec_sub(tangent[i], tangent[i + 1]));
}

double run_densify(const struct run *run, double chord, struct run *dense)
{
    if (run->n == 0)
        return 0;
    struct sizes corner = {0};
    run_corners(run, &corner);
    *array_push(&corner) = run->n - 1;
    *array_push(dense) = run->item[0];
    double worst = 0;
    size_t from = 0;
    for (size_t k = 0; k < corner.n; k++) {
        size_t to = corner.item[k];
        struct run piece = {.n = to - from + 1,
                            .item = run->item + from,
                            .radius = run->radius,
                            .edges = run->edges};
        worst = fmax(worst, densify_piece(&piece, chord, dense));
        from = to;
    }
    array_free(&corner);
    return worst;
}

size_t run_motion_at(const struct run *run, size_t from, size_t to, struct vec3 place)
{
    double least = HUGE_VAL;
    size_t at = from;

    for (size_t i = from; i < to; i++) {
        struct vec3 a = run->item[i].ball, b = run->item[i + 1].ball;
        double detour = vec_distance(a, place) + vec_distance(place, b) - vec_distance(a, b);
        if (detour < least) {
            least = detour;
            at = i;
        }
    }
    return at;
}
