/* access - see access.h. */
#include "access.h"

#include <stdlib.h>

#include "math/box.h"

enum { BINS = 256, LEVELS = 9 };

static const double ROUNDING = 1e-9; /* of cosines of bounds, many times */

/* The cap that a stack blocks, by the distance of a guard point. */
struct caps {
    struct holder holder;
    double reach;              /* points further away block nothing, mm */
    double span;               /* of the bins, mm; the last has all beyond it too */
    double most[LEVELS][BINS]; /* the largest angle within 2^level bins from each, radians */
    struct sine_cosine most_of[LEVELS][BINS]; /* of it, of half a turn if it is more */
};

struct access {
    struct access_options options;
    struct kdtree *near;     /* of the guard, thinned; NULL: no guard, or its own does */
    bool *kept;              /* with its own: by their numbers those that are looked at; or NULL */
    struct caps open, clear; /* with margin and slope; with neither */
};

/* ---- the cap of a point */

/* The largest angle at which the part's slanted side, a to b as (r, h), is d from the centre. */
static double angle_at(double r0, double h0, double r1, double h1, double d)
{
    double dr = r1 - r0, dh = h1 - h0, a = dr * dr + dh * dh, b = r0 * dr + h0 * dh;
    double c = r0 * r0 + h0 * h0 - d * d, root = b * b - a * c, angle = 0;

    if (a == 0 || root < 0)
        return 0;
    for (int sign = -1; sign <= 1; sign += 2) {
        double s = (-b + sign * sqrt(root)) / a;
        if (s >= 0 && s <= 1)
            angle = fmax(angle, atan2(r0 + s * dr, h0 + s * dh));
    }
    return angle;
}

/* How far from a point's direction axes are blocked, if it is d from the ball's centre. */
static double cap_angle(const struct holder *holder, double d)
{
    double angle = 0, r = 0, h = 0;

    for (int i = 0; i < holder->n; i++) {
        const struct holder_part *part = &holder->part[i];
        angle = fmax(angle, angle_at(r, h, part->low, h, d));
        angle = fmax(angle, angle_at(part->low, h, part->high, h + part->length, d));
        h += part->length;
        r = part->high;
    }
    return fmax(angle, angle_at(r, h, 0, h, d));
}

enum { FINE = 8 }; /* places of a bin */

/* The largest angle in n bins so wide from `from` on. */
static double widest_in(const struct holder *holder, double from, double bin, int n)
{
    double most = 0;

    for (int k = -1; k <= n * FINE + 1; k++)
        most = fmax(most, cap_angle(holder, from + bin * k / FINE));
    return most + 0.01;
}

/* The outline is piecewise smooth, and between its corners the angle has at most one extreme: a
 * bin gets the largest of some places in it and what neighbours have, rounded up.  Of a stack that
 * reaches far beyond the guard, `span` in size, bins of all its length would tell nothing. */
static void fill_caps(struct caps *caps, struct holder holder, double span)
{
    caps->holder = holder;
    caps->reach = holder_reach(&holder);
    caps->span = span > 0 ? fmin(caps->reach, span) : caps->reach;
    for (int i = 0; i < BINS; i++)
        caps->most[0][i] = widest_in(&holder, caps->span * i / BINS, caps->span / BINS, 1);
    if (caps->span < caps->reach) {
        double beyond = widest_in(&holder, caps->span, (caps->reach - caps->span) / BINS, BINS);
        caps->most[0][BINS - 1] = fmax(caps->most[0][BINS - 1], beyond);
    }
    for (int level = 1; level < LEVELS; level++)
        for (int i = 0; i < BINS; i++) {
            int other = i + (1 << (level - 1));
            double here = caps->most[level - 1][i];
            caps->most[level][i] = other < BINS ? fmax(here, caps->most[level - 1][other]) : here;
        }
    for (int level = 0; level < LEVELS; level++)
        for (int i = 0; i < BINS; i++)
            caps->most_of[level][i] = elementary_sine_cosine(fmin(caps->most[level][i], PI));
}

/* Of an angle no smaller than that at any distance between the two. */
static struct sine_cosine widest_cap(const struct caps *caps, double near, double far)
{
    int i = (int)fmin(fmax(near / caps->span * BINS, 0), BINS - 1), level = 0;
    int j = (int)fmin(fmax(far / caps->span * BINS, i), BINS - 1);

    while (level + 1 < LEVELS && 2 << level <= j - i + 1)
        level++;
    struct sine_cosine a = caps->most_of[level][i];
    struct sine_cosine b = caps->most_of[level][j - (1 << level) + 1];
    return a.cosine < b.cosine ? a : b;
}

static bool every_box(void *context, int depth, struct vec3 middle, struct vec3 half)
{
    (void)context, (void)depth, (void)middle, (void)half;
    return true;
}

struct collecting {
    const bool *kept;
    struct vec3s points;
};

static void collect(void *context, int depth, struct vec3 p, size_t index)
{
    struct collecting *c = context;

    (void)depth;
    if (c->kept[index])
        *array_push(&c->points) = p;
}

/* The guard's points, thinned: in a tree of their own where they are few, else in the guard's. */
static struct box take_points(struct access *access)
{
    const struct access_options *o = &access->options;
    size_t n = gouge_points(o->guard);
    struct collecting few = {.kept = access->kept = mem_alloc(n, sizeof *access->kept)};
    struct kdtree_visitor visitor = {every_box, collect, &few};
    struct box around;

    if (gouge_thinned(o->guard, o->gap, access->kept, &around) <= n / 2) {
        gouge_visit(o->guard, around.low, &visitor);
        access->near = kdtree_new_by(few.points.item, few.points.n, o->threads);
        array_free(&few.points);
        free(access->kept);
        access->kept = NULL;
    }
    return around;
}

struct access *access_new(const struct access_options *options)
{
    struct access *access = mem_alloc(1, sizeof *access);
    double span = HUGE_VAL;

    access->options = *options;
    if (options->guard) {
        struct box box = take_points(access);
        span = 2 * vec_distance(box.low, box.high);
    }
    if (options->holder->n > 0) {
        fill_caps(&access->clear, holder_widened(options->holder, -options->slack, 0), span);
        fill_caps(&access->open, holder_widened(options->holder, options->margin, options->slope),
                  span);
    }
    return access;
}

void access_free(struct access *access)
{
    if (access) {
        kdtree_free(access->near);
        free(access->kept);
    }
    free(access);
}

/* ---- the open directions at a place */

/* Holds directions: those no farther from its axis than an angle. */
struct cone {
    struct vec3 axis; /* unit */
    double cosine, sine;
};

/* Directions by their numbers, and for each box that is looked into those that its points may
 * block: a box in another has some of the other's.  Where points are beside them all they need not
 * be told apart: that is done after DOUBTFUL points which are not, at each NARROWED-th depth. */
enum { DOUBTFUL = 16, NARROWED = 3 };

struct search {
    const struct caps *caps;
    const bool *kept; /* points that are looked at; NULL: all */
    struct vec3 centre;
    const struct vec3 *at; /* the directions */
    struct cone cone;      /* all of them */
    bool *blocked;
    int open;                /* how many are not */
    int doubtful;            /* points that were not beside all */
    int n[KDTREE_DEPTH + 1]; /* by the depth of the box, from 1 */
    short *some[KDTREE_DEPTH + 1];
    const short *list[KDTREE_DEPTH + 1]; /* these, or those of the depth above, where all may be */
};

/* Only if none of the directions is nearer than an angle to `to`, which is so long: most boxes and
 * points are beside all of them. */
static bool is_beside(const struct cone *cone, struct vec3 to, double length, double cosine)
{
    const double rounding = 1e-7; /* of the root of a small difference */
    double along = vec_dot(cone->axis, to), across = sqrt(fmax(length * length - along * along, 0));

    return along < length * cone->cosine &&
           along * cone->cosine + across * cone->sine < length * (cosine - rounding);
}

/* Of the directions at the depth those, not blocked, that are nearer than an angle to `to`, a
 * unit vector, into the depth below. */
static int find_within(struct search *s, int depth, struct vec3 to, double cosine)
{
    const short *from = s->list[depth];
    short *near = s->some[depth + 1];
    int n = 0;

    for (int i = 0; i < s->n[depth]; i++) {
        near[n] = from[i];
        n += vec_dot(s->at[from[i]], to) > cosine && !s->blocked[from[i]];
    }
    s->list[depth + 1] = near;
    s->n[depth + 1] = n;
    return n;
}

/* All of the depth may be blocked at the depth below. */
static bool keep_all(struct search *s, int depth)
{
    s->list[depth + 1] = s->list[depth];
    s->n[depth + 1] = s->n[depth];
    return true;
}

static bool may_block(void *context, int depth, struct vec3 middle, struct vec3 half)
{
    struct search *s = context;
    struct vec3 to = vec_sub(middle, s->centre);
    double d = vec_length(to), around = vec_length(half);

    if (s->open == 0 || d - around >= s->caps->reach || depth >= KDTREE_DEPTH)
        return false;
    if (around >= d)
        return keep_all(s, depth);
    /* the cap and the angle of the ball about the box together, or half a turn */
    struct sine_cosine cap = widest_cap(s->caps, d - around, d + around);
    double sine = around / d, cosine = sqrt(1 - sine * sine);
    double both = cap.cosine <= -cosine ? -2 : cap.cosine * cosine - cap.sine * sine - ROUNDING;
    if (is_beside(&s->cone, to, d, both))
        return false;
    if (s->doubtful < DOUBTFUL || depth % NARROWED != 0)
        return keep_all(s, depth);
    return find_within(s, depth, vec_scale(1 / d, to), both) > 0;
}

static void block_by(void *context, int depth, struct vec3 p, size_t index)
{
    struct search *s = context;
    struct vec3 to = vec_sub(p, s->centre);
    double d = vec_length(to);
    const short *some = s->list[depth + 1];

    if (d >= s->caps->reach || d == 0 || (s->kept && !s->kept[index]))
        return;
    double widest = widest_cap(s->caps, d, d).cosine - ROUNDING, most = d * widest;
    bool any = false;
    if (is_beside(&s->cone, to, d, widest))
        return;
    s->doubtful++;
    for (int i = 0; i < s->n[depth + 1] && !any; i++)
        any = !s->blocked[some[i]] && vec_dot(s->at[some[i]], to) > most;
    if (!any)
        return;
    double angle = cap_angle(&s->caps->holder, d), least = d * cos(angle);
    for (int i = 0; angle > 0 && i < s->n[depth + 1]; i++) {
        int k = some[i];
        if (!s->blocked[k] && vec_dot(s->at[k], to) > least) {
            s->blocked[k] = true;
            s->open--;
        }
    }
}

/* Room for n directions. */
static struct search new_search(struct vec3 centre, const struct vec3 *at, int n)
{
    struct search s = {.centre = centre, .at = at};
    short *room = mem_alloc((size_t)n * (KDTREE_DEPTH + 1), sizeof *room);

    s.blocked = mem_alloc((size_t)n, sizeof *s.blocked);
    for (int i = 0; i <= KDTREE_DEPTH; i++)
        s.some[i] = room + (size_t)n * (size_t)i;
    return s;
}

static void free_search(struct search *s)
{
    free(s->blocked);
    free(s->some[0]);
}

/* Blocks what there is in some[0]. */
static void block(const struct access *access, const struct caps *caps, struct search *s)
{
    struct kdtree_visitor visitor = {may_block, block_by, s};

    s->caps = caps;
    s->kept = access->kept;
    s->open = s->n[0];
    s->doubtful = 0;
    s->list[0] = s->some[0];
    for (int i = 0; i < s->n[0]; i++)
        s->blocked[s->some[0][i]] = false;
    if (access->options.holder->n == 0 || s->open == 0)
        return;
    if (access->near)
        kdtree_visit(access->near, s->centre, &visitor);
    else if (access->kept)
        gouge_visit(access->options.guard, s->centre, &visitor);
}

int access_find(const struct access *access, struct vec3 centre, struct vec3 normal,
                struct vec3 rule, double within, unsigned char *state)
{
    const struct sphere_grid *grid = access->options.grid;
    struct search s = new_search(centre, grid->at, grid->n);
    double least = vec_length(normal) == 0 ? -1 : cos(ACCESS_STEEPEST);
    double nearest = within < PI ? cos(within) : -2, farthest = 1;
    enum access_state as = ACCESS_OPEN;

    for (int i = 0; i < grid->n; i++) {
        state[i] = ACCESS_BLOCKED;
        double along = vec_dot(grid->at[i], rule);
        if (!(vec_dot(grid->at[i], normal) >= least && along >= nearest))
            continue;
        s.some[0][s.n[0]++] = (short)i;
        farthest = fmin(farthest, along);
    }
    s.cone = (struct cone){rule, farthest, sqrt(fmax(1 - farthest * farthest, 0))};
    block(access, &access->open, &s);
    if (s.open == 0) {
        as = ACCESS_TIGHT;
        block(access, &access->clear, &s);
    }
    for (int i = 0; i < s.n[0]; i++)
        if (!s.blocked[s.some[0][i]])
            state[s.some[0][i]] = (unsigned char)as;
    free_search(&s);
    return s.open;
}

static bool is_free(const struct access *access, const struct caps *caps, struct vec3 centre,
                    struct vec3 axis)
{
    bool blocked = false;
    short first = 0, some = 0;
    struct search s = {.centre = centre, .at = &axis, .cone = {axis, 1, 0}, .blocked = &blocked};

    for (int i = 1; i <= KDTREE_DEPTH; i++)
        s.some[i] = &some;
    s.some[0] = &first;
    s.n[0] = 1;
    block(access, caps, &s);
    return s.open > 0;
}

bool access_is_open(const struct access *access, struct vec3 centre, struct vec3 axis)
{
    return is_free(access, &access->open, centre, axis);
}

bool access_is_clear(const struct access *access, struct vec3 centre, struct vec3 axis)
{
    return is_free(access, &access->clear, centre, axis);
}
