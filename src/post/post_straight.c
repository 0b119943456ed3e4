/* post_straight - see post_straight.h. */
#include "post_straight.h"

#include "machine/rotary_cost.h"
#include "math/elementary.h"
#include "post_block.h"
#include "post_ik.h"

enum {
    DEPTH_MAX = 22, /* halvings of a straight motion: beside the singular direction */
    PARTS_MAX = 512 /* equal parts of one, before they are halved */
};

static const double BESIDE_POLE = 0.002; /* radians */

/*
 * The block is surely no further off than what blocks before it have spent: so much by the digits
 * at its ends, and so much more between them.  False says nothing.
 */
static bool within_spent(const struct nc_planner *planner, const struct machine_pose *to,
                         const struct pose *goal, struct pose_deviation off)
{
    const struct nc_state *state = &planner->state;
    struct pose_deviation spent = planner->plan->total.spent, d = state->off, bend = {0, 0};
    if (!(d.point >= 0 && off.point >= 0)) /* not known */
        return false;
    if (planner->follow.mode != INTERPOLATE_VECTOR || planner->plan->ability.doubtful)
        bend = interpolation_bend(&planner->follow, &state->at, &to->at);
    d.axis = bend.axis + larger(d.axis, off.axis);
    d.point = bend.point + larger(d.point, off.point) + fabs(planner->follow.ball) * d.axis;
    if (planner->follow.mode ==
        INTERPOLATE_JOINT) { /* the tip runs ahead of the axis by so much at most */
        double length = vec_distance(state->pose.p, goal->p);
        double other = d.point / length * (1.05 * vec_distance(state->pose.a, goal->a) + bend.axis);
        d.axis += other;
        d.point += fabs(planner->follow.ball) * other;
    }
    return pose_deviation_within(d, spent) && pose_deviation_within(d, planner->allowed);
}

/* A bound from a closer look, for each way in which the control may turn the axis. */
static struct pose_deviation deviation_bound(const struct nc_planner *planner,
                                             const struct machine_pose *to, const struct pose *goal)
{
    const struct nc_state *state = &planner->state;
    const struct machine_pose from = {state->at, state->turned};
    struct interpolation f = planner->follow;
    struct pose_deviation d =
        interpolation_line(&f, &from, to, state->pose, *goal, planner->allowed);
    f.mode = INTERPOLATE_ROTARY;
    if (planner->plan->ability.doubtful && pose_deviation_within(d, planner->allowed))
        d = pose_deviation_worst(
            d, interpolation_line(&f, &from, to, state->pose, *goal, planner->allowed));
    return d;
}

/* With vectors the control may be led to turn back: see turns_back. */
static bool turns_far(const struct nc_planner *planner, const struct machine_pose *to)
{
    const double *q = planner->state.at.q;
    return fabs(to->at.q[0] - q[0]) >= PI / 2 || fabs(to->at.q[1] - q[1]) >= PI / 2;
}

/* |a x b| squared. */
static inline double cross2(struct vec3 a, struct vec3 b)
{
    struct vec3 cross = vec_cross(a, b);
    return vec_dot(cross, cross);
}

/*
 * Vectors far from the singular direction that turn little, and slowly: they pass no pole
 * (post_ik_pole_between), need no block that is slow alone (post_feed_divide_even), and the rotary
 * axes follow them (post_ik_follow).  Told by squares, with room to spare; false says nothing.
 */
static bool vectors_turn_little(const struct nc_planner *planner, const struct machine_pose *target,
                                const struct pose *to)
{
    const double far = 0.05; /* the sine of the angle to the singular direction */
    const struct nc_state *state = &planner->state;
    const struct machine *m = planner->machine;
    if (m->chain.n != 2)
        return false;
    struct vec3 pole = m->chain.rotary[0].axis, way = vec_sub(to->p, state->pose.p);
    double off2 = smaller(cross2(pole, state->pose.a),
                          smaller(cross2(pole, to->a), cross2(pole, target->at.a)));
    struct vec3 turn = vec_sub(to->a, state->pose.a), said = vec_sub(target->at.a, state->pose.a);
    double turn2 = vec_dot(turn, turn), feed = state->feed * state->faster;
    double slowest = smaller(m->rapid[m->letter[0]], m->rapid[m->letter[1]]);
    return off2 > far * far && 16 * larger(turn2, vec_dot(said, said)) < off2 &&
           DEGREES(16 * DEGREES(turn2)) * feed * feed <=
               off2 * vec_dot(way, way) * slowest * slowest;
}

/* One block with vectors may lead there: *target is where its rotary axes do. */
static bool vectors_lead_to(const struct nc_planner *planner, struct machine_pose *target,
                            const struct pose *to)
{
    if (turns_far(planner, target))
        return false;
    if (vectors_turn_little(planner, target, to))
        return true;
    struct motion line = motion_line(planner->state.pose, *to);
    return post_ik_pole_between(planner, &line, 0, 1) >= 1 &&
           post_feed_divide_even(planner, &line, 0, 1) >= 1 &&
           post_ik_follow(planner, &line, 0, 1, target);
}

int post_straight_one(struct nc_planner *planner, const struct pose *to)
{
    struct machine_pose target;
    struct pose_deviation off = {NAN, NAN};
    if (post_ik_reach_near(planner, to, &target, &off)
            ? post_ik_check_linear(planner, &target) != 0
            : post_ik_reach(planner, *to, 1, &target) != 0)
        return 1;
    if (planner->follow.mode == INTERPOLATE_VECTOR && !vectors_lead_to(planner, &target, to))
        return 1;
    if (!within_spent(planner, &target, to, off)) {
        struct pose_deviation d = deviation_bound(planner, &target, to);
        if (!pose_deviation_within(d, planner->allowed))
            return 1;
        planner->plan->total.spent = pose_deviation_worst(planner->plan->total.spent, d);
    }
    post_block_straight(planner, NC_LINE, &target, to);
    planner->state.off = off;
    return 0;
}

/* How far the block to a target is off the motion. */
static struct pose_deviation deviation_in_mode(const struct nc_planner *planner,
                                               const struct interpolation *f,
                                               const struct machine_pose *to,
                                               const struct motion *motion, double s0, double s1,
                                               struct pose_deviation allowed)
{
    const struct nc_state *state = &planner->state;
    if (motion->kind == MOTION_LINE) {
        struct machine_pose from = {state->at, state->turned};
        struct pose goal = motion_at(motion, s1);
        struct pose_deviation most = interpolation_line(f, &from, to, state->pose, goal, allowed);
        if (pose_deviation_within(most, allowed))
            return most;
    }
    return interpolation_block(f, &state->at, &to->at, motion, s0, s1);
}

/*
 * Vectors leave the rotary axes to the control, which goes on with them as they stand: where they
 * could only follow by way of another solution or whole turns back, the block cannot be.  Beside
 * the singular direction they may turn far while the tool hardly does.
 */
static bool turns_back(const struct nc_planner *planner, const struct machine_pose *to,
                       const struct motion *motion, double s0, double s1)
{
    const struct block_pose *at = &planner->state.at;
    struct interpolation rotary = planner->follow;
    double most = 0;
    for (int i = 0; i < rotary.chain->n; i++)
        most = fmax(most, fabs(to->at.q[i] - at->q[i]));
    if (planner->follow.mode != INTERPOLATE_VECTOR || most < PI / 2)
        return false;
    rotary.mode = INTERPOLATE_ROTARY;
    double great = vec_angle(motion_at(motion, s0).a, motion_at(motion, s1).a);
    return interpolation_block(&rotary, at, &to->at, motion, s0, s1).axis > great + RADIANS(1);
}

/* The same for every way in which the control may turn the axis. */
static struct pose_deviation deviation_of(const struct nc_planner *planner,
                                          const struct machine_pose *to,
                                          const struct motion *motion, double s0, double s1,
                                          struct pose_deviation allowed)
{
    struct interpolation other = planner->follow;
    if (allowed.axis < HUGE_VAL && turns_back(planner, to, motion, s0, s1))
        return (struct pose_deviation){HUGE_VAL, HUGE_VAL};
    struct pose_deviation d = deviation_in_mode(planner, &other, to, motion, s0, s1, allowed);
    if (planner->plan->ability.doubtful && pose_deviation_within(d, allowed)) {
        other.mode = INTERPOLATE_ROTARY;
        d = pose_deviation_worst(d,
                                 deviation_in_mode(planner, &other, to, motion, s0, s1, allowed));
    }
    return d;
}

/* The axis that would have to turn furthest is to blame. */
int post_straight_no_way(struct nc_planner *planner, struct pose goal,
                         const struct machine_pose *to)
{
    const struct machine *m = planner->machine;
    const double *from = planner->state.at.q;
    int i = m->chain.n > 1 && fabs(to->at.q[1] - from[1]) > fabs(to->at.q[0] - from[0]);
    int axis = m->letter[i];
    planner->plan->unmet = true;
    return error_at(planner->error, planner->path->name, planner->state.line,
                    "pass %zu: axis %c of %s: cannot continue from %.3f at the point %.3f %.3f "
                    "%.3f, expected one within its travel %g to %g and the tolerance "
                    "(meshnorm and planecut plan a path for a machine: -m)",
                    planner->state.pass, machine_letter(axis), m->name, DEGREES(from[i]), goal.p.x,
                    goal.p.y, goal.p.z, m->min[axis], m->max[axis]);
}

/* So far does the axis nearest the work turn in one block at the pole: the linear axes go straight
 * where the tip, this far from it, would be led on an arc. */
static double pole_step(const struct nc_planner *planner)
{
    const struct rotary *r = &planner->machine->chain.rotary[0];
    double far = vec_distance(planner->state.pose.p, r->centre);
    double arc = planner->allowed.point / 2;
    if (planner->follow.mode != INTERPOLATE_JOINT || far <= arc)
        return PI;
    return fmin(sqrt(8 * arc / far), RADIANS(POST_BLOCK_TURN));
}

/* How far the tool axis is off the singular direction, radians; below 0: too far to be said as it.
 */
static double off_pole(const struct nc_planner *planner)
{
    double off =
        vec_length(vec_cross(planner->machine->chain.rotary[0].axis, planner->state.pose.a));
    bool at =
        chain_free(&planner->machine->chain, planner->state.pose.a) || off < planner->near_pole;
    return at ? off : -1;
}

/*
 * In the singular direction the axis nearest the work turns about the tool itself: to where the
 * motion that follows needs it, at feed, with the tip at rest.  False: the tool is tilted, or the
 * axis stands there already.
 */
static bool turn_at_pole(struct nc_planner *planner, const struct machine_pose *to)
{
    struct nc_state *state = &planner->state;
    const double q[ROTARY_MAX] = {to->at.q[0], state->at.q[1]};
    double step = pole_step(planner), turn = q[0] - state->at.q[0];
    if (planner->machine->chain.n != 2 || planner->follow.mode == INTERPOLATE_VECTOR || turn == 0)
        return false;
    double off = off_pole(planner);
    if (off < 0)
        return false;
    int n = (int)ceil(fabs(turn) / step);
    post_block_stand(planner, NC_LINE, q, n);
    struct pose_deviation spent = {planner->allowed.point / 2, 2 * off};
    if (n > 1 || step < PI || off > 0)
        planner->plan->total.spent = pose_deviation_worst(planner->plan->total.spent, spent);
    return true;
}

/* The same for a motion that is too far off as one block, to where it leaves the pole: an axis that
 * stands askew turns further with the tilt. */
static bool turn_out_of_pole(struct nc_planner *planner, const struct motion *motion, double s0,
                             double s1)
{
    double turn = vec_angle(motion_at(motion, s0).a, motion_at(motion, s1).a);
    struct machine_pose beside;
    if (!(turn > 0))
        return false;
    double s = s0 + (s1 - s0) * fmin(1, BESIDE_POLE / turn);
    return post_ik_reach(planner, motion_at(motion, s), s, &beside) == 0 &&
           turn_at_pole(planner, &beside);
}

/*
 * The rotary axes cannot go on as they stand: the next pose is out of their travel, or it takes a
 * turn that no block in the cut can make.  Off the part they turn where they are.
 */
static int go_on_turned(struct nc_planner *planner, const struct motion *motion, double s0,
                        double s1, enum nc_kind kind, struct machine_pose *to)
{
    struct pose goal = motion_at(motion, s1);
    if (kind == NC_RAPID) {
        if (post_ik_reach(planner, goal, s1, to) != 0)
            return -1;
        post_block_turn(planner, to->at.q);
        return 0;
    }
    bool turned = planner->rewind && planner->rewind(planner, goal) == 0;
    if (turned && post_ik_reach(planner, goal, s1, to) == 0 &&
        pose_deviation_within(deviation_of(planner, to, motion, s0, s1, planner->allowed),
                              planner->allowed))
        return 0;
    if (planner->plan->unmet)
        return -1;
    return post_straight_no_way(planner, goal, to);
}

static void add_block(struct nc_planner *planner, const struct machine_pose *to, struct pose goal,
                      enum nc_kind kind, struct pose_deviation d)
{
    struct nc_total *total = &planner->plan->total;
    post_block_straight(planner, kind, to, &goal);
    if (kind == NC_LINE)
        total->spent = pose_deviation_worst(total->spent, d);
}

/* Into how many equal parts to divide what is so far off: a chord's error falls with the square of
 * its length. */
static int parts_for(struct pose_deviation d, struct pose_deviation allowed)
{
    const double spare = 1.02;
    double off = larger(d.point / allowed.point, d.axis / allowed.axis);
    double parts = ceil(spare * sqrt(off));

    return parts >= 2 && parts <= PARTS_MAX ? (int)parts
                                            : 2; /* 2: it may be infinite, or no number */
}

/* The part of a motion at feed from s0 to s1 in n equal blocks.  False: one of them is not within
 * what is allowed, and nothing is done. */
static bool divide_evenly(struct nc_planner *planner, const struct motion *motion, double s0,
                          double s1, int n)
{
    struct nc_plan *plan = planner->plan;
    const struct nc_state state = planner->state;
    const struct nc_total total = plan->total;
    const size_t moves = plan->move.n, vectors = plan->vector.n;
    const bool off_part = planner->off_part, doubtful = planner->doubtful, unmet = plan->unmet;
    double from = s0;

    for (int i = 1; i <= n; i++) {
        double end = i < n ? s0 + (s1 - s0) * i / n : s1;
        struct pose goal = motion_at(motion, end);
        struct pose_deviation d = {HUGE_VAL, HUGE_VAL};
        struct machine_pose to;
        if (post_ik_reach(planner, goal, end, &to) == 0 &&
            post_ik_follow(planner, motion, from, end, &to))
            d = deviation_of(planner, &to, motion, from, end, planner->allowed);
        if (!pose_deviation_within(d, planner->allowed)) {
            planner->state = state;
            plan->total = total;
            plan->move.n = moves;
            plan->vector.n = vectors;
            planner->off_part = off_part;
            planner->doubtful = doubtful;
            plan->unmet = unmet;
            return false;
        }
        add_block(planner, &to, goal, NC_LINE, d);
        from = end;
    }
    return true;
}

/* The same in as few equal blocks as may be, from `least` on to less than twice as many: halves of
 * so many would be more. */
static bool divide_in_few(struct nc_planner *planner, const struct motion *motion, double s0,
                          double s1, int least)
{
    enum { STEPS = 8 };
    int step = least < STEPS ? 1 : least / STEPS;
    bool found = false;

    for (int n = least; n < 2 * least && !found; n += step)
        found = divide_evenly(planner, motion, s0, s1, n);
    return found;
}

static int divide(struct nc_planner *planner, const struct motion *motion, double s0, double s1,
                  enum nc_kind kind, struct pose_deviation allowed, int depth)
{
    struct pose goal = motion_at(motion, s1);
    struct machine_pose to;
    struct pose_deviation d = {HUGE_VAL, HUGE_VAL};
    bool reached = post_ik_reach(planner, goal, s1, &to) == 0;
    if (!reached && !planner->rewind)
        return -1; /* with it: as far as it goes, then turn */
    if (reached && (kind != NC_LINE || post_ik_follow(planner, motion, s0, s1, &to)))
        d = deviation_of(planner, &to, motion, s0, s1, allowed);
    bool first = reached && kind == NC_LINE && depth == 0;
    if (first && !pose_deviation_within(d, allowed) && turn_out_of_pole(planner, motion, s0, s1)) {
        if (post_ik_reach(planner, goal, s1, &to) != 0)
            return -1;
        d = deviation_of(planner, &to, motion, s0, s1, allowed);
    }
    if (!pose_deviation_within(d, allowed) && depth < DEPTH_MAX) {
        int parts = depth == 0 ? parts_for(d, allowed) : 2;
        if (planner->state.why == NC_WHY_PATH)
            planner->state.why = NC_WHY_DIVIDED;
        if (first && divide_in_few(planner, motion, s0, s1, parts))
            return 0;
        for (int i = 0; i < parts; i++) {
            double from = s0 + (s1 - s0) * i / parts,
                   to_s = i + 1 < parts ? s0 + (s1 - s0) * (i + 1) / parts : s1;
            if (divide(planner, motion, from, to_s, kind, allowed, depth + 1) != 0)
                return -1;
        }
        return 0;
    }
    if (!pose_deviation_within(d, allowed)) {
        if (go_on_turned(planner, motion, s0, s1, kind, &to) != 0)
            return -1;
        d = kind == NC_LINE ? deviation_of(planner, &to, motion, s0, s1, allowed) : d;
    }
    add_block(planner, &to, goal, kind, d);
    return 0;
}

/* The first end, between s0 and s1, of a block past the singular direction that was planned. */
static double crossing_end(const struct nc_aim *aim, double s0, double s1)
{
    for (size_t i = 1; i + 1 < aim->n; i++)
        if (!aim->place[i].passed && (aim->place[i - 1].passed || aim->place[i + 1].passed) &&
            aim->s[i] > s0 && aim->s[i] < s1)
            return aim->s[i];
    return s1;
}

int post_straight_blocks(struct nc_planner *planner, const struct motion *motion, double s0,
                         double s1, enum nc_kind kind, struct pose_deviation allowed)
{
    for (double s = s0, next; s < s1; s = next) {
        next = crossing_end(&planner->aim, s, s1);
        if (divide(planner, motion, s, next, kind, allowed, 0) != 0)
            return -1;
    }
    return 0;
}
