/*
 * run - tangents and the smooth reference curve of a cutting run.
 *
 * Repeated points have no direction of their own: points whose ball centres coincide form one
 * station, and tangents belong to stations.
 */
#include "run.h"

#include <stdlib.h>

static const double SAME = 1e-7;          /* mm: centres nearer than this are one station */
static const double CORNER = PI / 3;      /* a turn above this in one point is a corner */
static const double STEEP = 0.7;          /* slope of the centres against the surface: no tangent */
static const double AXIS_SMOOTH = PI / 3; /* axes further apart than this: great circle */
enum { PARTS_MAX = 10000 };               /* pieces of one interval */

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

/* How far the centre stands above its contact point along the normal, mm; the radius, unless the
 * ball was lifted. */
static double height_of(const struct run_point *p)
{
    return vec_dot(vec_sub(p->ball, p->contact), p->normal);
}

/*
 * The centre of a ball that touches moves perpendicular to the normal; one that is being lifted
 * moves by the slope of its lift against it.
 */
static struct vec3 along_surface(struct vec3 tangent, struct vec3 normal, double slope)
{
    struct vec3 t = vec_reject(tangent, normal);
    if (fabs(slope) > STEEP || vec_length(t) < STEEP)
        return tangent;
    return vec_unit(vec_along(vec_unit(t), slope, normal));
}

static bool touches(const struct run_point *p)
{
    return vec_dot(p->normal, p->normal) > 0.5;
}

/* Derivative at the middle one of three values on a parabola; h: the lengths between them. */
static double bessel(double before, double h0, double here, double h1, double after)
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
    if (!touches(a) || !touches(b) || !touches(c))
        return t;
    return along_surface(t, b->normal, bessel(height_of(a), h0, height_of(b), h1, height_of(c)));
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
    if (!touches(a) || !touches(b))
        return t;
    double slope = (height_of(b) - height_of(a)) / h;
    return along_surface(t, a->normal, next > end ? slope : -slope);
}

static void bessel_tangents(const struct run *run, struct stations *s)
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
static void forward_tangents(const struct run *run, struct stations *s)
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
        forward_tangents(run, &s);
    else
        bessel_tangents(run, &s);
    for (size_t k = 0; k < s.n; k++) {
        for (size_t i = s.item[k].first; i <= s.item[k].last; i++)
            tangent[i] = s.item[k].tangent;
    }
    array_free(&s);
}

void run_corners(const struct run *run, struct sizes *corner)
{
    struct stations s = find_stations(run);
    for (size_t k = 1; k + 1 < s.n; k++)
        if (vec_angle(chord_of(run, &s, k - 1), chord_of(run, &s, k)) > CORNER)
            *array_push(corner) = s.item[k].first;
    array_free(&s);
}

/* The axis' turn from station k to the next, by the length between them. */
static struct vec3 turn_after(const struct run *run, const struct stations *s, size_t k)
{
    struct vec3 from = run->item[s->item[k].last].axis, to = point_of(run, s, k + 1)->axis;
    return vec_scale(1 / vec_length(chord_of(run, s, k)), vec_sub(to, from));
}

/*
 * How fast the axis turns at each station: of the parabola through three axes, but never more than
 * three times as fast as in the slower of the two intervals, so that it does not overshoot; not at
 * all where the axis turns while the centre stands still.
 */
static void axis_turns(const struct run *run, struct stations *s)
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
        here->turn = l > most ? vec_scale(most / l, r) : r;
    }
}

/* One interval of the reference curve. */
struct interval {
    const struct run_point *a, *b;
    struct vec3 va, vb; /* derivatives of the centre at its ends, mm */
    struct vec3 wa, wb; /* derivatives of the axis */
    bool great_circle;  /* the axis has no derivatives */
};

/*
 * The speed at the ends is that at which a cubic is nearest to a circle with these tangents:
 * 2 d / (1 + cos(turn / 2)) for a chord of length d.
 */
static struct interval interval_between(const struct run_point *a, const struct run_point *b,
                                        const struct station *sa, const struct station *sb)
{
    double half = sqrt(fmax(0, (1 + vec_dot(sa->tangent, sb->tangent)) / 2));
    double speed = 2 * vec_distance(a->ball, b->ball) / (1 + half);
    return (struct interval){
        .a = a,
        .b = b,
        .va = vec_scale(speed, sa->tangent),
        .vb = vec_scale(speed, sb->tangent),
        .wa = vec_scale(speed, sa->turn),
        .wb = vec_scale(speed, sb->turn),
        .great_circle = sa == sb || vec_angle(a->axis, b->axis) > AXIS_SMOOTH,
    };
}

static struct vec3 hermite(struct vec3 p, struct vec3 v, struct vec3 q, struct vec3 w, double t)
{
    struct vec3 d = vec_sub(q, p);
    double s = 1 - t;
    struct vec3 r = vec_along(p, t * t * (3 - 2 * t), d);
    return vec_along(vec_along(r, t * s * s, v), -t * t * s, w);
}

static struct run_point interval_at(const struct interval *c, double t, double radius)
{
    struct run_point p = {.ball = hermite(c->a->ball, c->va, c->b->ball, c->vb, t)};
    p.axis = c->great_circle ? vec_slerp(c->a->axis, c->b->axis, t)
                             : vec_unit(hermite(c->a->axis, c->wa, c->b->axis, c->wb, t));
    p.tip = vec_along(p.ball, -radius, p.axis);
    if (touches(c->a) && touches(c->b)) {
        p.normal = vec_slerp(c->a->normal, c->b->normal, t);
        double h = (1 - t) * height_of(c->a) + t * height_of(c->b);
        p.contact = vec_along(p.ball, -h, p.normal);
    }
    return p;
}

static double segment_distance(struct vec3 p, struct vec3 a, struct vec3 b)
{
    struct vec3 d = vec_sub(b, a);
    double l2 = vec_dot(d, d);
    double t = l2 > 0 ? vec_dot(vec_sub(p, a), d) / l2 : 0;
    return vec_distance(p, vec_along(a, fmin(1, fmax(0, t)), d));
}

/* Largest distance between the curve and `parts` straight pieces, at the tip and the centre. */
static double interval_chord(const struct interval *c, size_t parts, double radius)
{
    enum { SAMPLES = 4 };
    double worst = 0, n = (double)parts;
    struct run_point from = *c->a;
    for (size_t k = 0; k < parts; k++) {
        struct run_point to = k + 1 < parts ? interval_at(c, (double)(k + 1) / n, radius) : *c->b;
        for (int i = 1; i < SAMPLES; i++) {
            struct run_point p = interval_at(c, ((double)k + (double)i / SAMPLES) / n, radius);
            worst = fmax(worst, segment_distance(p.ball, from.ball, to.ball));
            worst = fmax(worst, segment_distance(p.tip, from.tip, to.tip));
        }
        from = to;
    }
    return worst;
}

static double densify_interval(const struct interval *c, double chord, struct run *dense)
{
    size_t parts = 1;
    double whole = interval_chord(c, 1, dense->radius), off = whole;
    while (off > chord && parts < PARTS_MAX) {
        double more = 1.01 * (double)parts * sqrt(off / chord);
        parts = more < PARTS_MAX ? (size_t)more + 1 : PARTS_MAX;
        off = interval_chord(c, parts, dense->radius);
    }
    for (size_t k = 1; k < parts; k++)
        *array_push(dense) = interval_at(c, (double)k / (double)parts, dense->radius);
    *array_push(dense) = *c->b;
    return whole;
}

/* A piece of the run without corners, but for its first point, which is there already. */
static double densify_piece(const struct run *piece, double chord, struct run *dense)
{
    struct stations s = find_stations(piece);
    bessel_tangents(piece, &s);
    axis_turns(piece, &s);
    double worst = 0;
    size_t at = 0; /* station of point i */
    for (size_t i = 0; i + 1 < piece->n; i++) {
        const struct station *here = &s.item[at];
        if (at + 1 < s.n && s.item[at + 1].first == i + 1)
            at++;
        struct interval c =
            interval_between(&piece->item[i], &piece->item[i + 1], here, &s.item[at]);
        worst = fmax(worst, densify_interval(&c, chord, dense));
    }
    array_free(&s);
    return worst;
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
        struct run piece = {.n = to - from + 1, .item = run->item + from, .radius = run->radius};
        worst = fmax(worst, densify_piece(&piece, chord, dense));
        from = to;
    }
    array_free(&corner);
    return worst;
}
