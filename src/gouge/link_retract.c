/* link_retract - see link_retract.h. */
#include "gouge/link_retract.h"

#include "link_sweep.h"

enum { SIDES = 8 };

/* A direction flatter than this does not lead to the clearance plane: sin 10 degrees. */
static const double FLAT = 0.17364817766693033;

static const double RAPID = 0.2;     /* mm: what a rapid leaves free */
static const double OFF = 0.3;       /* of the radius: where one ends, for a scan is sparse ... */
static const double OFF_MOST = 0.9;  /* ... but of the approach distance, which was asked for */
static const double SHORTEST = 0.02; /* mm: a holder that is followed moves no less at a time */
static const double ABOVE = 1;       /* mm: of the whole tool over the guard's top */
static const double DIPS = 0.01;     /* radians: a turn that leans so much further dips */
static const double SHORTER = 0.8;   /* of a retract: one that is worth a corner */
static const double STEEP = 0.7;     /* z of a direction: none that leads up so is left for it */

/* Half-way round z from one direction to another, level. */
static struct vec3 level_between(struct vec3 a, struct vec3 b)
{
    struct vec3 from = vec_unit(vec(a.x, a.y, 0)), to = vec_unit(vec(b.x, b.y, 0));
    struct vec3 mean = vec_add(from, to);

    if (vec_length(mean) > 1e-6)
        return vec_unit(mean);
    return vec_length(from) > 0 ? vec(-from.y, from.x, 0) : vec(1, 0, 0);
}

bool link_axis_dips(struct vec3 from, struct vec3 to, struct vec3 *way)
{
    struct vec3 normal = vec_unit(vec_cross(from, to));
    double lowest = -sqrt(fmax(0, 1 - normal.z * normal.z));
    bool falls = vec_cross(normal, from).z<0, rises = vec_cross(normal, to).z> 0;
    bool back = vec_dot(from, to) < -1 + 1e-6; /* any great circle leads there */

    if (!back && !(falls && rises && acos(lowest) > DIPS + acos(fmin(from.z, to.z))))
        return false;
    double tilt = acos(fmin(1, fmax(from.z, to.z))) / 2;
    *way = vec_along(vec(0, 0, cos(tilt)), sin(tilt), level_between(from, to));
    return true;
}

double link_height(const struct link_options *options, double least, double most)
{
    const struct gouge_check *guard = options->lift->guard;
    const struct holder *holder = options->holder;
    double lowest = 0, up = options->radius; /* below the tip; of an outline's corner over it */

    if (!guard)
        return options->clearance;
    for (int i = 0; i < 2 * holder->n; i++) {
        const struct holder_part *part = &holder->part[i / 2];
        double r = i % 2 ? part->high : part->low;
        up += i % 2 ? part->length : 0;
        /* up cos(tilt) - r sin(tilt) is least at an end, or where it is -hypot(up, r) */
        double deepest = PI - atan2(r, up);
        if (deepest > least && deepest < most)
            lowest = fmin(lowest, -hypot(up, r));
        lowest = fmin(lowest, up * cos(least) - r * sin(least));
        lowest = fmin(lowest, up * cos(most) - r * sin(most));
    }
    /* the ball, below the tip of a tool that leans */
    lowest = fmin(lowest, options->radius * (cos(most) - 1));
    return fmax(options->clearance, gouge_top(guard) + ABOVE - lowest);
}

/* A tool with one axis, and what it leaves free on its way (below 0: how deep it may be). */
struct follower {
    const struct link_options *options;
    struct vec3 axis;
    double ball, holder;
    struct kdtree_touch *blocked; /* what was in the way of shank and holder last */
};

static bool is_ball_clear(const struct follower *f, struct vec3 from, struct vec3 to)
{
    const struct link_options *options = f->options;

    return gouge_clear_along(options->lift->guard, from, to, options->lift->offset + f->ball, 0);
}

static bool is_holder_clear(const struct follower *f, struct vec3 at)
{
    return gouge_holder_clear(f->options->lift->guard, f->options->holder, at, f->axis, f->holder,
                              f->blocked);
}

static bool is_holder_clear_along(const struct follower *f, struct vec3 from, struct vec3 to)
{
    return gouge_holder_clear_along(f->options->lift->guard, f->options->holder, from, to, f->axis,
                                    f->holder, f->blocked);
}

/* Straight from one corner to the next of some; what is soon told first. */
static bool is_clear_by(const struct follower *f, const struct vec3 *corner, size_t n)
{
    for (size_t i = 1; i < n; i++)
        if (!is_ball_clear(f, corner[i - 1], corner[i]))
            return false;
    for (size_t i = n; i-- > 0;)
        if (!is_holder_clear(f, corner[i]))
            return false;
    for (size_t i = 1; i < n; i++)
        if (!is_holder_clear_along(f, corner[i - 1], corner[i]))
            return false;
    return true;
}

static bool is_leg_clear(const struct follower *f, struct vec3 from, struct vec3 to)
{
    const struct vec3 corner[] = {from, to};

    return is_clear_by(f, corner, 2);
}

/* The way from near (at[0]) on. */
static bool is_way_clear(const struct follower *f, const struct retract *r)
{
    return r->n < 2 || is_clear_by(f, r->at, r->n);
}

/* The ball alone, from the point on. */
static bool is_way_open(const struct follower *f, struct vec3 from, const struct retract *r)
{
    for (size_t i = 0; i < r->n; i++)
        if (!is_ball_clear(f, i > 0 ? r->at[i - 1] : from, r->at[i]))
            return false;
    return true;
}

/* How far it is in a direction to the plane that is `rise` above, or where that is too flat to
 * where the part and the tool beside it end. */
static double length_out(const struct link_options *options, struct vec3 from,
                         struct vec3 direction, double rise)
{
    if (direction.z > FLAT)
        return fmax(0, rise) / direction.z;
    if (!options->lift->guard)
        return 0;
    return fmax(0, gouge_extent(options->lift->guard, from, direction) + options->lift->offset);
}

/* What becomes of ways that are tried for a point. */
struct search {
    const struct link_options *options;
    const struct run_point *p;
    struct follower feed, rapid;
    double plane;        /* z of the ball's centre at the end */
    struct retract best; /* the first that is clear at feed */
    bool done;           /* it is clear at rapid, too */
};

/*
 * The rapid moves of a way end off the part, and not on the flank that it leads along: at[0] goes
 * on along the way until it is.  False, and the way as it was: there is no such place, or it cannot
 * be reached straight at feed, or another corner is on the part.
 */
static bool ends_off(const struct search *s, struct retract *r)
{
    const struct link_options *options = s->options;
    const struct gouge_check *guard = options->lift->guard;
    double gap = fmin(OFF * options->radius, OFF_MOST * options->approach);
    double off = options->lift->offset + gap, at = 0, near;
    struct vec3 begin = r->at[0];

    if (r->n < 2)
        return true;
    for (size_t i = 1; i + 1 < r->n; i++)
        if (gouge_distance(guard, r->at[i], off) < off)
            return false;
    double length = vec_distance(r->at[0], r->at[1]);
    while ((near = gouge_distance(guard, begin, off)) < off) {
        at += fmax(off - near, SHORTEST);
        if (at >= length)
            return false;
        begin = vec_mix(r->at[0], r->at[1], at / length);
    }
    if (at > 0 && !is_leg_clear(&s->feed, s->p->ball, begin))
        return false;
    r->at[0] = begin;
    return true;
}

/* The way at feed as the path is judged in the end: step by step it may come a little deeper than
 * where the steps are. */
static bool is_feed_clear(const struct search *s, const struct retract *r)
{
    struct link_sweep sweep = link_sweep_begin(s->options);
    struct run_point last = *s->p;
    bool clear = true;

    for (size_t i = 0; i < (r->rapid ? 1 : r->n) && clear; i++) {
        struct run_point next = {.ball = r->at[i], .axis = s->p->axis};
        link_sweep_to(&sweep, &last, &next);
        clear = !(gouge_refit_beyond(&sweep.tool, &sweep.gouges).depth > 0);
        last = next;
    }
    link_sweep_end(&sweep);
    return clear;
}

/* No corner of it is far below the part, where nobody knows what is. */
static bool is_over_floor(const struct search *s, const struct retract *r)
{
    for (size_t i = 0; i < r->n; i++)
        if (r->at[i].z < fmin(s->options->floor, s->p->ball.z))
            return false;
    return true;
}

/* Tries a way whose corners are known: near, and up from the last of them to the plane. */
static void try_way(struct search *s, struct retract r)
{
    struct vec3 last = r.at[r.n - 1];

    if (!is_over_floor(s, &r))
        return;

    if (s->plane > last.z + 1e-6)
        r.at[r.n++] = vec(last.x, last.y, s->plane);
    if (s->done || !is_way_open(&s->feed, s->p->ball, &r) ||
        !is_leg_clear(&s->feed, s->p->ball, r.at[0]))
        return;
    r.rapid = is_way_clear(&s->rapid, &r) && ends_off(s, &r);
    r.clear = r.rapid || (!s->best.clear && is_way_clear(&s->feed, &r));
    if (r.clear && !is_feed_clear(s, &r))
        return;
    if (r.rapid || (r.clear && !s->best.clear))
        s->best = r;
    s->done = r.rapid;
}

/* Straight in one direction. */
static void try_straight(struct search *s, struct vec3 direction)
{
    struct retract r = {.n = 1};
    double length = vec_length(direction);

    if (length < 1e-6 || s->done)
        return;
    direction = vec_scale(1 / length, direction);
    r.at[0] = vec_along(s->p->ball, s->options->approach, direction);
    double out = length_out(s->options, r.at[0], direction, s->plane - r.at[0].z);
    if (out > 0)
        r.at[r.n++] = vec_along(r.at[0], out, direction);
    try_way(s, r);
}

/* First in one direction as far as `first`, then along the axis or straight up. */
static void try_bent(struct search *s, struct vec3 direction, double first)
{
    struct vec3 axis = s->p->axis;
    double near = fmin(s->options->approach, first);
    struct retract r = {.n = 1, .at = {vec_along(s->p->ball, near, direction)}};

    if (first > near)
        r.at[r.n++] = vec_along(s->p->ball, first, direction);
    try_way(s, r);
    struct vec3 corner = r.at[r.n - 1];
    double out = length_out(s->options, corner, axis, s->plane - corner.z);
    if (s->done || out <= 0)
        return;
    r.at[r.n++] = vec_along(corner, out, axis);
    try_way(s, r);
}

/* To all sides of `about`, leaned by `lean` from it. */
static void try_around(struct search *s, struct vec3 about, double lean)
{
    const double reach[] = {0.5, 1, 2, 4, 8}; /* radii */
    struct vec3 side = vec_perpendicular(about);

    for (int k = 0; k < SIDES && !s->done; k++) {
        struct vec3 d = vec_turn(about, vec_turn(side, about, 2 * PI * k / SIDES), lean);
        if (d.z > FLAT)
            try_straight(s, d);
        for (size_t i = 0; i < sizeof reach / sizeof *reach && !s->done; i++) {
            double first = reach[i] * s->options->radius;
            if (!is_leg_clear(&s->feed, s->p->ball, vec_along(s->p->ball, first, d)))
                break;
            try_bent(s, d, first);
        }
        if (d.z <= FLAT && d.z > -FLAT)
            try_straight(s, d);
    }
}

static void search_all(struct search *s)
{
    const struct vec3 z = vec(0, 0, 1), axis = s->p->axis, normal = link_outward(s->p);

    try_straight(s, z);
    try_straight(s, vec_add(axis, z));
    try_straight(s, vec_add(axis, normal));
    try_straight(s, normal);
    try_straight(s, vec_add(normal, z));
    try_around(s, axis, RADIANS(30));
    try_around(s, normal, RADIANS(30));
    try_around(s, axis, RADIANS(60));
    try_around(s, z, RADIANS(60));
    try_around(s, z, RADIANS(85));
}

static double length_of(const struct retract *r, struct vec3 from)
{
    double length = 0;

    for (size_t i = 0; i < r->n; from = r->at[i++])
        length += vec_distance(from, r->at[i]);
    return length;
}

/* Of a way's legs the last that does not lead straight up: where it ends; 0: at[0] is its end. */
static size_t slanted_leg(const struct retract *r)
{
    const double upright = 1e-6; /* mm */
    size_t k = r->n - 1;

    while (k > 0 && hypot(r->at[k].x - r->at[k - 1].x, r->at[k].y - r->at[k - 1].y) < upright)
        k--;
    return k;
}

static struct vec3 start_of(const struct search *s, size_t leg)
{
    return leg > 0 ? s->best.at[leg - 1] : s->p->ball;
}

static struct vec3 direction_of(const struct search *s, size_t leg)
{
    return vec_unit(vec_sub(s->best.at[leg], start_of(s, leg)));
}

/* The way with a corner on its slanted leg, from where it leads straight up: at rapid, as it is, or
 * at feed up to there. */
static struct retract cut_short(const struct search *s, size_t leg, double first)
{
    struct retract r = s->best;

    r.at[leg] = vec_along(start_of(s, leg), first, direction_of(s, leg));
    r.n = leg + 1;
    return r;
}

/* A flat axis leads far aside before it is over the part: the way goes along it only until it is
 * clear straight up, if that is shorter, or rapid at last. */
static void shorten(struct search *s)
{
    static const double out[] = {2, 4, 8, 16, 32}; /* radii along the leg */
    size_t leg = s->done ? slanted_leg(&s->best) : 0;
    double most = (s->done ? SHORTER : 1) * length_of(&s->best, s->p->ball);

    if ((s->done && leg == 0) || leg + 1 >= LINK_LEGS || direction_of(s, leg).z > STEEP)
        return;
    for (size_t i = 0; i < sizeof out / sizeof *out; i++) {
        struct search bent = *s;
        struct retract r = cut_short(s, leg, out[i] * s->options->radius);
        if (length_of(&r, s->p->ball) + fmax(0, s->plane - r.at[leg].z) > most)
            return;
        bent.best = (struct retract){.n = 0};
        bent.done = false;
        try_way(&bent, r);
        if (bent.done && length_of(&bent.best, s->p->ball) <= most) {
            s->best = bent.best;
            s->done = true;
            return;
        }
    }
}

struct retract link_retract(const struct link_options *options, const struct run_point *p)
{
    const struct gouge_lift_options *lift = options->lift;
    double tilt = vec_angle(p->axis, vec(0, 0, 1));
    double may = LINK_FEED * lift->tolerance;
    struct kdtree_touch blocked = {.n = 0};
    struct search s = {.options = options,
                       .p = p,
                       .feed = {options, p->axis, -may, -may, &blocked},
                       .rapid = {options, p->axis, RAPID, RAPID, &blocked},
                       .plane = link_height(options, tilt, tilt) + options->radius * p->axis.z};

    if (!lift->guard) {
        struct vec3 near = vec_along(p->ball, options->approach, p->axis);
        double out = length_out(options, near, p->axis, s.plane - near.z);
        struct retract r = {.clear = true, .rapid = true, .n = 2, .at = {near}};
        r.at[1] = vec_along(near, out, p->axis);
        if (s.plane > r.at[1].z + 1e-6)
            r.at[r.n++] = vec(r.at[1].x, r.at[1].y, s.plane);
        return r;
    }
    try_straight(&s, p->axis);
    if (s.best.clear && !s.done)
        shorten(&s);
    if (!s.done)
        search_all(&s);
    if (s.done)
        shorten(&s);
    return s.best;
}
