/* post_time - see post_time.h. */
#include "post_time.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/num.h"
#include "machine/axis_time.h"
#include "machine/ik_near.h"
#include "math/elementary.h"
#include "post_feed.h"

enum { LOOKS_MOST = 400, TURNED_ON_MOST = 64 };

static const double STEP = 0.2;        /* mm: between places on curves and where the tool turns */
static const double PER_DEGREE = 0.05; /* mm of way for each degree that the tool turns */

struct timing {
    struct nc_plan *plan;
    const struct machine *machine;
    struct axis_time_limits limits;
    struct axis_time_way way; /* of the run at feed */
    struct {
        bool any;         /* of a move ... */
        size_t move;      /* ... of the plan, ... */
        double seconds;   /* ... whose steps took so long up to now */
    } steps;              /* for feeds as times */
    size_t n;             /* places of the run */
    double reached;       /* how far along the way the last of them is */
    double wished;        /* seconds of the run at its feeds */
    double q[ROTARY_MAX]; /* of the last place, ... */
    struct turned turned; /* ... and its cosines and sines, ... */
    unsigned turned_on;   /* ... so many places from where they were reckoned from the angles */
};

static double per_second(const struct machine *m, int axis)
{
    return m->rapid[axis] / 60;
}

static struct axis_time_limits limits_of(const struct machine *m, double unit)
{
    struct axis_time_limits limits = {.smoothing = fmax(m->smoothing, 0.02) / unit};
    for (int k = 0; k < AXIS_TIME_AXES; k++) {
        bool slides = k <= MACHINE_Z, is = slides || k - 3 < m->chain.n;
        int axis = slides ? k : is ? m->letter[k - 3] : MACHINE_X;
        double per = slides ? unit : 1;
        limits.speed[k] = per_second(m, axis);
        limits.acceleration[k] = m->acceleration[axis] / per;
        limits.jerk[k] = m->jerk[axis] / per;
    }
    return limits;
}

/* The rotary axes turn to q: mostly by little, which needs no sine of it, and never many times in a
 * row, so that rounding does not add up. */
static void turn_to(struct timing *t, const double q[])
{
    const double by[ROTARY_MAX] = {q[0] - t->q[0], q[1] - t->q[1]};
    bool near = fabs(by[0]) <= IK_TURNED_MOST && fabs(by[1]) <= IK_TURNED_MOST;
    t->turned_on = near && t->turned_on < TURNED_ON_MOST ? t->turned_on + 1 : 0;
    t->turned = t->turned_on ? ik_turned_on(&t->turned, by) : chain_turned(&t->machine->chain, q);
    t->q[0] = q[0], t->q[1] = q[1];
}

/* Where the axes are when the tip is at p and the rotary axes at q. */
static void axes_at(struct timing *t, struct vec3 p, const double q[], double axis[])
{
    const struct kinematic_chain *chain = &t->machine->chain;
    struct vec3 linear = p;
    if (t->plan->ability.mode != INTERPOLATE_JOINT) {
        turn_to(t, q);
        linear = chain_linear_of(chain, p, &t->turned);
    }
    axis[0] = linear.x, axis[1] = linear.y, axis[2] = linear.z;
    for (int k = 0; k < 2; k++)
        axis[3 + k] = k < chain->n ? DEGREES(q[k]) : 0;
}

static struct vec3 tip_at(const struct nc_plan *plan, const struct nc_move *move,
                          const struct block_pose *from, const struct block_pose *to, double s)
{
    if (move->kind == NC_ARC) {
        struct motion arc = nc_arc_motion(&plan->arc.item[move->index], from, to);
        return motion_at(&arc, s).p;
    }
    const struct nc_spline *spline =
        move->kind == NC_SPLINE ? &plan->spline.item[move->index] : NULL;
    if (spline && spline->form != NC_POLY) {
        const struct bspline *b = &spline->curve;
        double first = b->knot[b->degree];
        return bspline_at(b, b->pole, first + s * (b->knot[b->poles] - first));
    }
    return vec_mix(from->p, to->p, s);
}

/* Seconds of a block by its F. */
static double block_seconds(const struct timing *t, const struct nc_move *move, double tip,
                            double straight, const double from[], const double to[])
{
    enum nc_feeds feeds = t->plan->ability.feeds;
    if (!(move->feed > 0))
        return 0;
    if (feeds == NC_FEEDS_INVERSE)
        return 60 / move->feed;
    if (feeds == NC_FEEDS_TIP && tip > 0)
        return 60 * tip / move->feed;
    double around = DEGREES(hypot(to[0] - from[0], to[1] - from[1]));
    return 60 * (feeds == NC_FEEDS_COMBINED ? hypot(straight, around) : around) / move->feed;
}

static void add_place(struct timing *t, struct vec3 tip, const double q[], double way, double feed,
                      size_t move)
{
    struct axis_time_place *place = axis_time_add(&t->way);
    axes_at(t, tip, q, place->axis);
    place->way = way;
    place->feed = feed;
    place->mark = move;
    t->n++;
    t->reached = way;
}

/* The places of a move at feed: one at its end, and on the way to it where it bends or turns. */
static void add_move(struct timing *t, size_t index, const struct block_pose *from,
                     const struct block_pose *to)
{
    const struct nc_move *move = &t->plan->move.item[index];
    double turn = DEGREES(larger(fabs(to->q[0] - from->q[0]), fabs(to->q[1] - from->q[1])));
    double unit = t->plan->ability.unit, straight = vec_distance(from->p, to->p), length = straight;
    if (move->kind == NC_ARC)
        length = nc_arc_length(&t->plan->arc.item[move->index], from, to);
    double way = larger(length, PER_DEGREE / unit * turn);
    double seconds = block_seconds(t, move, length, straight, from->q, to->q);
    bool even = move->kind == NC_LINE && (turn == 0 || way * unit <= STEP);
    if (!(way > 0) || !(seconds > 0))
        return;
    double start = t->n == 0 ? 0 : t->reached, feed = way / seconds;
    if (t->n == 0)
        add_place(t, from->p, from->q, 0, feed, index);
    int n = even ? 1 : (int)fmin(LOOKS_MOST, fmax(1, ceil(way * unit / STEP)));
    for (int i = 1; i < n; i++) {
        double s = (double)i / n;
        double q[ROTARY_MAX] = {from->q[0] + s * (to->q[0] - from->q[0]),
                                from->q[1] + s * (to->q[1] - from->q[1])};
        add_place(t, tip_at(t->plan, move, from, to, s), q, start + s * way, feed, index);
    }
    struct vec3 end = move->kind == NC_LINE ? to->p : tip_at(t->plan, move, from, to, 1);
    add_place(t, end, to->q, start + way, feed, index);
    t->wished += seconds;
}

/* The block whose steps were added up gets the time that it takes. */
static void set_inverse(struct timing *t)
{
    const struct nc_ability *ability = &t->plan->ability;
    struct nc_move *move = &t->plan->move.item[t->steps.move];
    double feed = 60 / fmax(t->steps.seconds, 1e-9);
    int digits = post_feed_digits(ability, feed);
    double said = num_round(feed, digits), least = 1 / num_ten[digits];
    if (feed < move->feed)
        move->feed = said > 0 ? said : least;
    t->steps.any = false;
    t->steps.seconds = 0;
}

static void add_step(void *context, size_t move, double seconds)
{
    struct timing *t = context;
    if (t->steps.any && t->steps.move != move)
        set_inverse(t);
    t->steps.any = true;
    t->steps.move = move;
    t->steps.seconds += seconds;
}

static void end_run(struct timing *t)
{
    double seconds = axis_time_end(&t->way);
    if (t->steps.any)
        set_inverse(t);
    if (t->n > 1)
        t->plan->total.minutes += fmax(0, seconds - t->wished) / 60;
    t->n = 0;
    t->wished = 0;
}

static void add_rapid(struct timing *t, const struct block_pose *from, const struct block_pose *to)
{
    double a[AXIS_TIME_AXES], b[AXIS_TIME_AXES], way = 0;
    axes_at(t, from->p, from->q, a);
    axes_at(t, to->p, to->q, b);
    for (int k = 0; k < AXIS_TIME_AXES; k++)
        way = fmax(way, fabs(b[k] - a[k]) / t->limits.speed[k]);
    t->plan->total.minutes += fmax(0, axis_time_rapid(&t->limits, a, b) - way) / 60;
}

void post_time(struct nc_plan *plan, const struct machine *machine)
{
    struct timing t = {.plan = plan,
                       .machine = machine,
                       .limits = limits_of(machine, plan->ability.unit),
                       .turned_on = TURNED_ON_MOST};
    const struct nc_move *last = NULL;
    struct block_pose at = {.a = vec(0, 0, 1)};
    t.way.limits = t.limits;
    if (plan->ability.feeds == NC_FEEDS_INVERSE) {
        t.way.step = add_step;
        t.way.context = &t;
    }
    for (size_t i = 0; i < plan->move.n; i++) {
        const struct nc_move *move = &plan->move.item[i];
        if (!nc_moves(move)) {
            if (move->kind == NC_TOOL || move->kind == NC_PLANE)
                end_run(&t);
            continue;
        }
        struct block_pose to;
        to.p = move->p;
        to.q[0] = move->q[0], to.q[1] = move->q[1];
        if (move->kind == NC_ARC && last) { /* nothing else asks for the tool axes */
            at = nc_plan_pose(plan, &machine->chain, last);
            to = nc_plan_pose(plan, &machine->chain, move);
        }
        if (move->kind == NC_RAPID || move->kind == NC_HOLE || !last) {
            end_run(&t);
            if (last && move->kind == NC_RAPID)
                add_rapid(&t, &at, &to);
        } else {
            add_move(&t, i, &at, &to);
        }
        at.p = to.p;
        at.q[0] = to.q[0], at.q[1] = to.q[1];
        last = move;
    }
    end_run(&t);
    axis_time_free(&t.way);
}
