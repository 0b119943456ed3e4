/* ncstep - see ncstep.h. */
#include "ncstep.h"

#include "ncreach.h"
#include "num.h"

enum { DEPTH_MAX = 14, ARC_DEPTH_MAX = 5, TURN_STEP = 2 /* degrees */ };
static const double rapid_chord = 1; /* mm, where a rapid has to be split at all */
static const double return_height = 2; /* mm above the part, down to which the return is a rapid */

/* The longest that an axis of the machine needs between two stations, minutes. */
static double axes_minutes(const struct nc_step *step, const struct station *a,
                           const struct station *b)
{
    const struct machine *m = step->machine;
    double minutes = 0;
    for (int i = 0; i < m->chain.n; i++)
        minutes = fmax(minutes, DEGREES(fabs(b->q[i] - a->q[i])) / m->rapid[m->letter[i]]);
    if (step->follow.mode == FOLLOW_JOINT)
        minutes = fmax(minutes, vec_distance(a->p, b->p) / m->rapid[MACHINE_X]);
    return minutes;
}

/* The way of all axes together, mm and degrees. */
static double joint_way(const struct nc_step *step, const struct station *a,
                        const struct station *b)
{
    double way = vec_distance(a->p, b->p);
    for (int i = 0; i < step->machine->chain.n; i++)
        way = hypot(way, DEGREES(b->q[i] - a->q[i]));
    return way;
}

/* F for a block of that length that is to take so long: never 0, never beyond the control's. */
static double feed_word(const struct nc_step *step, const struct station *to, double length,
                        double minutes)
{
    const struct nc_ability *ability = &step->plan->ability;
    static const double last_digit[] = {1,    0.1,  0.01, 1e-3, 1e-4,  1e-5,
                                        1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11};
    double least = last_digit[ability->digits.feed], feed = step->state.feed * step->state.faster;
    if (ability->feeds == NC_FEEDS_INVERSE)
        feed = 1 / fmax(minutes, 1e-9);
    else if (ability->feeds == NC_FEEDS_COMBINED)
        feed = joint_way(step, &step->state.at, to) / fmax(minutes, 1e-9);
    else if (length > 0 && minutes > length / feed)
        feed = length / minutes;
    return fmax(num_round(fmin(feed, ability->feed_max), ability->digits.feed), least);
}

static void add_move(struct nc_step *step, enum nc_kind kind, const struct station *to,
                     double length, size_t index)
{
    struct nc_total *total = &step->plan->total;
    double minutes = axes_minutes(step, &step->state.at, to);
    struct nc_move *move = array_push(&step->plan->move);
    *move = (struct nc_move){.kind = kind,
                             .why = step->state.why,
                             .line = step->state.line,
                             .to = *to,
                             .index = index};
    if (kind == NC_RAPID) {
        minutes = fmax(minutes, length / step->machine->rapid[MACHINE_X]);
        total->rapid += length;
        total->rapids++;
    } else {
        minutes = fmax(minutes, length / (step->state.feed * step->state.faster));
        move->feed = feed_word(step, to, length, minutes);
        total->cut += length;
        total->lines += kind == NC_LINE;
        total->arcs += kind == NC_ARC;
        total->splines += kind == NC_SPLINE;
    }
    total->minutes += minutes;
    step->state.at = *to;
    step->first = false;
}

static bool same_station(const struct station *a, const struct station *b, bool vectors)
{
    bool same = vec_distance(a->p, b->p) == 0;
    if (vectors)
        return same && vec_distance(a->a, b->a) == 0;
    return same && a->q[0] == b->q[0] && a->q[1] == b->q[1];
}

static double most_turn(const struct chain *chain, const double a[], const double b[])
{
    double most = 0;
    for (int i = 0; i < chain->n; i++)
        most = fmax(most, fabs(a[i] - b[i]));
    return most;
}

/* Angles for the pose where the program is, in the middle of the travel as far as can be, from
 * which the goal is in reach too. */
static bool turned(const struct nc_step *step, struct pose goal, double q[])
{
    const struct chain *chain = &step->machine->chain;
    double middle[ROTARY_MAX] = {0}, next[ROTARY_MAX];
    int over;
    for (int i = 0; i < chain->n; i++) {
        double span = chain->rotary[i].max - chain->rotary[i].min;
        if (span < 8 * PI)
            middle[i] = chain->rotary[i].min + span / 2;
    }
    for (int only = 0; only < 2; only++)
        if (chain_choose(chain, step->state.pose.a, middle, false, only, q, &over) == 0 &&
            chain_choose(chain, goal.a, q, true, -1, next, &over) == 0 &&
            most_turn(chain, q, step->state.at.q) > RADIANS(1) &&
            most_turn(chain, q, next) < RADIANS(90))
            return true;
    return false;
}

/* The rotary axes to q while the tip stays where it is. */
static void turn_to(struct nc_step *step, const double q[])
{
    double from[ROTARY_MAX] = {step->state.at.q[0], step->state.at.q[1]};
    double far = DEGREES(most_turn(&step->machine->chain, q, from));
    int n = step->follow.mode == FOLLOW_JOINT ? (int)ceil(far / TURN_STEP) : 1;
    for (int k = 1; k <= n; k++) {
        double part[ROTARY_MAX];
        for (int i = 0; i < ROTARY_MAX; i++)
            part[i] = from[i] + (q[i] - from[i]) * k / n;
        struct station to = nc_station(step, step->state.pose, part);
        add_move(step, NC_RAPID, &to, 0, 0);
    }
}

/* Retract along the tool axis, above all rapids of the path where it leads up; turn; return. */
static int retract_turn_return(struct nc_step *step, const double q[])
{
    struct pose here = step->state.pose, up = here, near = here;
    double far = step->machine->retract, clear = step->clear;
    if (here.a.z > 0.2 && clear > here.p.z)
        far = fmax(far, (clear - here.p.z) / here.a.z);
    up.p = vec_along(here.p, far, here.a);
    near.p = vec_along(here.p, fmin(return_height / step->wish.unit, far), here.a);
    enum nc_why why = step->state.why;
    double faster = step->state.faster;
    step->state.why = NC_WHY_TURN;
    step->state.faster = 1;
    if (nc_step_rapid(step, up) != 0)
        return -1;
    turn_to(step, q);
    struct motion back = motion_line(near, here);
    step->plan->total.turns++;
    int result = nc_step_rapid(step, near) == 0 ? nc_step_motion(step, &back) : -1;
    step->state.why = why;
    step->state.faster = faster;
    return result;
}

int nc_step_turn(struct nc_step *step, const double q[])
{
    double at[ROTARY_MAX] = {0};
    int over;
    if (chain_choose(&step->machine->chain, step->state.pose.a, q, true, -1, at, &over) != 0)
        return 0;
    return retract_turn_return(step, at);
}

/* How far the block to a station is off the motion. */
static struct deviation block_deviation(const struct nc_step *step, const struct station *to,
                                        const struct motion *motion, double s0, double s1,
                                        struct deviation allowed)
{
    const struct station *at = &step->state.at;
    struct deviation d = follow_block(&step->follow, at, to, motion, s0, s1, allowed);
    if (step->plan->ability.doubtful && deviation_within(d, allowed)) {
        struct follow other = step->follow;
        other.mode = FOLLOW_ROTARY;
        d = deviation_worst(d, follow_block(&other, at, to, motion, s0, s1, allowed));
    }
    return d;
}

/*
 * The rotary axes cannot go on as they stand: the next pose is out of their travel, or it takes a
 * turn that no block in the cut can make.  Off the part they turn where they are.
 */
static int go_on_turned(struct nc_step *step, const struct motion *motion, double s0, double s1,
                        enum nc_kind kind, struct station *to)
{
    struct pose goal = motion_at(motion, s1);
    if (kind == NC_RAPID) {
        if (nc_reach(step, goal, to) != 0)
            return -1;
        turn_to(step, to->q);
        return 0;
    }
    double q[ROTARY_MAX] = {0};
    bool may = step->may_turn && step->follow.mode != FOLLOW_VECTOR && turned(step, goal, q);
    if (may && retract_turn_return(step, q) == 0 && nc_reach(step, goal, to) == 0 &&
        deviation_within(block_deviation(step, to, motion, s0, s1, step->allowed), step->allowed))
        return 0;
    if (step->plan->unmet)
        return -1;
    step->plan->unmet = true;
    return error_at(step->error, step->path->name, step->state.line,
                    "pass %zu: the rotary axes of %s have no way on within their travel and the "
                    "tolerance",
                    step->state.pass, step->machine->name);
}

static void take(struct nc_step *step, const struct station *to, struct pose goal,
                 enum nc_kind kind, struct deviation d)
{
    struct nc_total *total = &step->plan->total;
    if (!same_station(&step->state.at, to, step->follow.mode == FOLLOW_VECTOR))
        add_move(step, kind, to, vec_distance(step->state.pose.p, goal.p), 0);
    step->state.pose = goal;
    if (kind == NC_LINE)
        total->spent = deviation_worst(total->spent, d);
}

/* Straight blocks along the motion from s0, where the program is, to s1. */
static int straight(struct nc_step *step, const struct motion *motion, double s0, double s1,
                    enum nc_kind kind, struct deviation allowed, int depth)
{
    struct pose goal = motion_at(motion, s1);
    struct station to;
    struct deviation d = {HUGE_VAL, HUGE_VAL};
    bool reached = nc_reach(step, goal, &to) == 0;
    if (!reached && !step->may_turn)
        return -1; /* with it: as far as it goes, then turn */
    if (reached)
        d = block_deviation(step, &to, motion, s0, s1, allowed);
    if (!deviation_within(d, allowed) && depth < DEPTH_MAX) {
        double mid = (s0 + s1) / 2;
        if (step->state.why == NC_WHY_PATH)
            step->state.why = NC_WHY_DIVIDED;
        if (straight(step, motion, s0, mid, kind, allowed, depth + 1) != 0)
            return -1;
        return straight(step, motion, mid, s1, kind, allowed, depth + 1);
    }
    if (!deviation_within(d, allowed)) {
        if (go_on_turned(step, motion, s0, s1, kind, &to) != 0)
            return -1;
        d = kind == NC_LINE ? block_deviation(step, &to, motion, s0, s1, allowed) : d;
    }
    take(step, &to, goal, kind, d);
    return 0;
}

int nc_step_rapid(struct nc_step *step, struct pose to)
{
    double chord = step->follow.mode == FOLLOW_JOINT ? rapid_chord / step->wish.unit : HUGE_VAL;
    struct deviation any = {chord, HUGE_VAL};
    struct station station;
    if (step->state.begun) {
        struct motion motion = motion_line(step->state.pose, to);
        return straight(step, &motion, 0, 1, NC_RAPID, any, 0);
    }
    if (nc_reach(step, to, &station) != 0)
        return -1;
    add_move(step, NC_RAPID, &station, 0, 0);
    step->state.pose = to;
    step->state.begun = true;
    return 0;
}

static int arc(struct nc_step *step, const struct motion *motion, double s0, double s1, int depth)
{
    const struct nc_ability *ability = &step->plan->ability;
    struct station to;
    struct nc_arc words;
    struct deviation d;
    double point = 0;
    struct pose goal = motion_at(motion, s1);
    bool fits = nc_reach(step, goal, &to) == 0;
    fits =
        fits && nc_arc_words(&words, ability->arcs, ability->digits.linear, ability->radius_error,
                             &step->follow, &step->state.at, &to, motion, s0, s1, &d, &point);
    if (fits && !deviation_within(d, step->allowed) && point <= step->allowed.point &&
        depth < ARC_DEPTH_MAX) { /* it is the tool axis: it may be right in halves */
        double mid = (s0 + s1) / 2;
        if (arc(step, motion, s0, mid, depth + 1) != 0)
            return -1;
        return arc(step, motion, mid, s1, depth + 1);
    }
    if (!fits || !deviation_within(d, step->allowed)) {
        step->plan->total.chorded++;
        step->state.why = NC_WHY_CHORD;
        return straight(step, motion, s0, s1, NC_LINE, step->allowed, 0);
    }
    *array_push(&step->plan->arc) = words;
    add_move(step, NC_ARC, &to, (s1 - s0) * motion_length(motion), step->plan->arc.n - 1);
    step->plan->total.spent = deviation_worst(step->plan->total.spent, d);
    step->state.pose = goal;
    return 0;
}

/* A whole arc, in as many pieces as the control wants. */
static int arcs(struct nc_step *step, const struct motion *motion)
{
    double most = nc_arc_most(step->plan->ability.arcs);
    int n = (int)ceil(motion->sweep / most - 1e-9);
    for (int i = 0; i < n; i++)
        if (arc(step, motion, (double)i / n, (double)(i + 1) / n, 0) != 0)
            return -1;
    return 0;
}

static int spline(struct nc_step *step, const struct motion *motion)
{
    const struct nc_ability *ability = &step->plan->ability;
    struct nc_spline_digits digits = {ability->digits.linear, ability->digits.angle,
                                      ability->digits.knot};
    struct nc_spline words;
    struct station to, checked;
    struct deviation d;
    if (nc_spline_words(&words, ability->splines, digits, &step->follow, &step->state.at, motion,
                        step->allowed, &to, &d)) {
        *array_push(&step->plan->spline) = words;
        if (step->follow.mode == FOLLOW_VECTOR && nc_reach(step, motion->to, &checked) == 0)
            to.q[0] = checked.q[0], to.q[1] = checked.q[1];
        if (nc_check_linear(step, &to) != 0)
            return -1;
        add_move(step, NC_SPLINE, &to, motion_length(motion), step->plan->spline.n - 1);
        step->plan->total.spent = deviation_worst(step->plan->total.spent, d);
        step->state.pose = motion_at(motion, 1);
        return 0;
    }
    step->plan->total.chorded += motion->curve->degree > 1;
    step->state.why = NC_WHY_CHORD;
    for (double s = 0; s < 1;) {
        double next = motion_next_knot(motion, s);
        if (straight(step, motion, s, next, NC_LINE, step->allowed, 0) != 0)
            return -1;
        s = next;
    }
    return 0;
}

int nc_step_motion(struct nc_step *step, const struct motion *motion)
{
    if (motion->kind == MOTION_SPLINE) {
        struct motion lead = motion_line(step->state.pose, motion_at(motion, 0));
        if (straight(step, &lead, 0, 1, NC_LINE, step->allowed, 0) != 0)
            return -1;
        return spline(step, motion);
    }
    if (motion->kind == MOTION_ARC && step->plan->ability.arcs != NC_ARCS_NONE)
        return arcs(step, motion);
    step->plan->total.chorded += motion->kind == MOTION_ARC;
    if (motion->kind == MOTION_ARC)
        step->state.why = NC_WHY_CHORD;
    return straight(step, motion, 0, 1, NC_LINE, step->allowed, 0);
}
