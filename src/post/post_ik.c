/* post_ik - see post_ik.h. */
#include "post_ik.h"

#include <stdio.h>
#include <string.h>

#include "base/num.h"

/* How far the path leads a linear axis that is over, from here on: the furthest of the ends of its
 * motions that the rotary axes reach one after another.  `tip` and the value are those of here. */
static double furthest_over(const struct nc_planner *planner, int axis, double value,
                            struct vec3 *tip)
{
    const struct machine *m = planner->machine;
    const struct path *path = planner->path;
    double q[ROTARY_MAX] = {planner->state.at.q[0], planner->state.at.q[1]};
    double side = value > m->max[axis] ? 1 : -1;
    int over;
    for (size_t i = planner->next > 0 ? planner->next - 1 : 0; i < path->item.n; i++) {
        const struct pose *to = &path->item.item[i].to;
        if (!path_moves(&path->item.item[i]))
            continue;
        if (ik_choose(&m->chain, to->a, q, true, -1, q, &over) != 0)
            break;
        struct vec3 p = chain_linear(&m->chain, to->p, q);
        double at = vec_coordinate(p, axis);
        if (side * at > side * value)
            value = at, *tip = to->p;
    }
    return value;
}

/* -1, with the error as it was said before "the first such place" and what is said behind it. */
static int tell_first(struct nc_planner *planner, struct vec3 tip, int axis, const char *what,
                      double value, const char *behind)
{
    const struct machine *m = planner->machine;
    double mm = planner->options.unit, scale = axis < 3 ? mm : 1;
    planner->plan->unmet = true;
    return error_at(planner->error, planner->path->name, planner->state.line,
                    "pass %zu: axis %c of %s: found %s %.5f at the point %.3f %.3f %.3f, expected "
                    "its travel %g to %g (the first such place%s)",
                    planner->state.pass, machine_letter(axis), m->name, what, scale * value,
                    mm * tip.x, mm * tip.y, mm * tip.z, scale * m->min[axis], scale * m->max[axis],
                    behind);
}

int post_ik_tell_over(struct nc_planner *planner, struct vec3 tip, int axis, const char *what,
                      double value)
{
    const double more = 1e-3, mm = planner->options.unit; /* mm beyond: worth to be said */
    char behind[120] = "";
    if (axis < 3) {
        struct vec3 at = tip;
        double most = furthest_over(planner, axis, value, &at);
        if (mm * fabs(most - value) > more)
            snprintf(behind, sizeof behind,
                     "; the path goes on to %.3f at the point %.3f %.3f %.3f", mm * most, mm * at.x,
                     mm * at.y, mm * at.z);
    }
    return tell_first(planner, tip, axis, what, value, behind);
}

bool post_ik_chain(const struct machine *machine, int tool, double unit,
                   struct kinematic_chain *chain)
{
    const struct machine_tool *said = machine_tool(machine, tool);
    bool known = said && !isnan(said->length);
    for (int i = 0; i < machine->chain.n; i++) {
        struct rotary *r = &chain->rotary[i];
        r->centre = machine->chain.rotary[i].centre;
        if (known && !r->table)
            r->centre = vec_along(r->centre, said->length / unit, chain->tool);
    }
    return known || !machine_has_lengths(machine);
}

double post_ik_safe_radius(const struct machine *m)
{
    double far = HUGE_VAL;
    for (int axis = 0; axis < 3; axis++)
        far = fmin(far, fmin(m->max[axis], -m->min[axis]));
    for (int i = 0; i < m->chain.n; i++)
        far -= 2 * vec_length(m->chain.rotary[i].centre);
    return fmax(far, 0);
}

int post_ik_out_of_travel(const struct nc_planner *planner, const double at[3])
{
    const struct machine *m = planner->machine;
    double half = 0.5 / num_ten[planner->plan->ability.digits.linear];
    for (int axis = 0; axis < 3; axis++)
        if (!(at[axis] >= m->min[axis] - half && at[axis] <= m->max[axis] + half))
            return axis;
    return -1;
}

int post_ik_linear_over(const struct nc_planner *planner, struct vec3 tip, const double q[])
{
    if (vec_dot(tip, tip) < planner->safe_radius * planner->safe_radius)
        return -1;
    struct vec3 p = chain_linear(&planner->machine->chain, tip, q);
    return post_ik_out_of_travel(planner, (const double[]){p.x, p.y, p.z});
}

int post_ik_check_linear(struct nc_planner *planner, const struct machine_pose *to)
{
    struct vec3 p = to->at.p;
    if (planner->follow.mode != INTERPOLATE_JOINT &&
        vec_dot(p, p) < planner->safe_radius * planner->safe_radius)
        return 0;
    if (planner->follow.mode != INTERPOLATE_JOINT)
        p = chain_linear_of(&planner->machine->chain, p, &to->turned);
    const double at[3] = {p.x, p.y, p.z};
    int axis = post_ik_out_of_travel(planner, at);
    if (axis < 0)
        return 0;
    struct vec3 tip = chain_tip_of(&planner->machine->chain, p, &to->turned);
    return post_ik_tell_over(planner, tip, axis, "a position of", at[axis]);
}

/* How far a tool axis as it is said is off, in each way in which the control may take it. */
static inline double axis_off(const struct nc_planner *planner, struct vec3 said, struct vec3 axis)
{
    double off = vec_distance(said, axis);
    if (planner->follow.mode != INTERPOLATE_VECTOR)
        return off;
    double unit = vec_distance(vec_unit(said), axis);
    return planner->plan->ability.doubtful && off > unit ? off : unit;
}

/* The angle of axis i as printed, degrees, at the end of its travel if it is hardly beyond. */
static double printed_angle(const struct nc_planner *planner, int i, double q, bool *at_end)
{
    const struct machine *m = planner->machine;
    int letter = m->letter[i], digits = planner->plan->ability.digits.angle;
    double at = num_round(DEGREES(q), digits);
    double end = at < m->min[letter] ? m->min[letter] : at;
    end = end > m->max[letter] ? m->max[letter] : end;
    if (i >= m->chain.n || end == at || fabs(DEGREES(q) - end) > POST_IK_AT_END)
        return at;
    *at_end = true;
    return num_round(end, digits);
}

/* The same, where the cosines and sines of q are known; *off: what its rounding does. */
static void words_of_pose(const struct nc_planner *planner, const struct pose *to, const double q[],
                          const struct turned *turned, struct machine_pose *s,
                          struct pose_deviation *off)
{
    const struct machine_digits *digits = &planner->plan->ability.digits;
    const struct kinematic_chain *chain = &planner->machine->chain;
    struct vec3 p = to->p;
    double by[ROTARY_MAX];
    bool at_end = false;
    for (int i = 0; i < ROTARY_MAX; i++) { /* 0 where there is no axis */
        s->at.q[i] = RADIANS(printed_angle(planner, i, q[i], &at_end));
        by[i] = s->at.q[i] - q[i];
    }
    s->turned = ik_turned_on(turned, by);
    if (planner->follow.mode == INTERPOLATE_VECTOR)
        s->at.a = vec_round(at_end ? chain_axis_of(chain, &s->turned) : to->a, digits->vector);
    else
        s->at.a = chain->n == 2   ? ik_near_axis(&planner->near, &s->turned)
                  : chain->n == 1 ? chain_axis_of(chain, &s->turned)
                                  : to->a;
    if (planner->follow.mode == INTERPOLATE_JOINT)
        p = chain_linear_of(chain, p, &s->turned);
    s->at.p = vec_round(p, digits->linear);
    *off = (struct pose_deviation){vec_distance(s->at.p, p), axis_off(planner, s->at.a, to->a)};
}

struct machine_pose post_ik_pose(const struct nc_planner *planner, struct pose to, const double q[])
{
    struct turned turned = chain_turned(&planner->machine->chain, q);
    struct machine_pose s;
    struct pose_deviation off;
    words_of_pose(planner, &to, q, &turned, &s, &off);
    return s;
}

/* The first tool axis after the current item that is not singular, NULL: none. */
static const struct vec3 *next_tilted(struct nc_planner *planner)
{
    const struct path *path = planner->path;
    if (planner->next_tilted < planner->next)
        planner->next_tilted = planner->next;
    for (; planner->next_tilted < path->item.n; planner->next_tilted++) {
        const struct path_item *item = &path->item.item[planner->next_tilted];
        if (path_moves(item) && !chain_free(&planner->machine->chain, item->to.a))
            return &item->to.a;
    }
    return NULL;
}

/*
 * In the singular direction the axis nearest the work is free.  From one such pose to the next it
 * turns to where the path will need it, so that it has the way between them for its turn instead
 * of none when the tool tilts.
 */
static void turn_ahead(struct nc_planner *planner, struct pose to, double q[])
{
    const struct kinematic_chain *chain = &planner->machine->chain;
    double then[ROTARY_MAX];
    int over;
    if (planner->leaves || !chain_free(chain, to.a))
        return;
    if (planner->state.begun && !planner->off_part && !chain_free(chain, planner->state.pose.a))
        return;
    const struct vec3 *ahead = next_tilted(planner);
    if (ahead && ik_choose(chain, *ahead, q, true, -1, then, &over) == 0)
        q[0] = then[0];
}

/* The angles that the look ahead has found at s of the motion.  True: on the way past the singular
 * direction, and so they are, whatever the tool axis. */
static bool aim_at(const struct nc_aim *aim, double s, double q[])
{
    size_t low = 0, high = aim->n - 1;
    while (high > low + 1) {
        size_t mid = (low + high) / 2;
        *(aim->s[mid] < s ? &low : &high) = mid;
    }
    while (low > 0 && aim->place[low].passed)
        low--;
    while (high + 1 < aim->n && aim->place[high].passed)
        high++;
    const struct ik_plan_place *from = &aim->place[low], *to = &aim->place[high];
    double s0 = low ? aim->s[low] : 0, s1 = aim->s[high];
    double t = s1 > s0 && !from->turn ? (s - s0) / (s1 - s0) : 1;
    for (int i = 0; i < ROTARY_MAX; i++)
        q[i] = from->q[i] + t * (to->q[i] - from->q[i]);
    return high > low + 1 && t < 1;
}

/* The angle turned by whole turns to be nearest to the travel. */
static double nearest_to_travel(const struct rotary *r, double q)
{
    return angle_nearest(q, (r->min + r->max) / 2);
}

static double beyond_travel(const struct rotary *r, double q)
{
    return fmax(r->min - q, q - r->max);
}

/* The axis of a solution that is furthest out of its travel, *by radians. */
static int axis_over(const struct kinematic_chain *chain, const struct chain_solutions *found,
                     int k, double *by)
{
    int worst = 0;
    *by = -HUGE_VAL;
    for (int i = found->free ? 1 : 0; i < chain->n; i++) {
        double out =
            beyond_travel(&chain->rotary[i], nearest_to_travel(&chain->rotary[i], found->q[k][i]));
        worst = out > *by ? i : worst;
        *by = fmax(*by, out);
    }
    return worst;
}

/* No angles of the machine, or none within its travel, have the direction: of the solution that is
 * less far out of it, which is the one that has just left it, the axis is named. */
static int not_reached(struct nc_planner *planner, struct pose to, int over)
{
    const struct machine *m = planner->machine;
    struct chain_solutions found = chain_angles(&m->chain, to.a);
    double by[2] = {HUGE_VAL, HUGE_VAL};
    int axis[2] = {0};
    for (int k = 0; k < found.n && over >= 0; k++)
        axis[k] = axis_over(&m->chain, &found, k, &by[k]);
    int k = by[1] < by[0], i = axis[k];
    if (found.n > 0 && over >= 0)
        return post_ik_tell_over(planner, to.p, m->letter[i], "angle",
                                 DEGREES(nearest_to_travel(&m->chain.rotary[i], found.q[k][i])));
    planner->plan->unmet = true;
    return error_at(
        planner->error, planner->path->name, planner->state.line,
        "pass %zu: found tool axis %.6f %.6f %.6f at the point %.3f %.3f %.3f, which no "
        "angles of %s reach",
        planner->state.pass, to.a.x, to.a.y, to.a.z, to.p.x, to.p.y, to.p.z, m->name);
}

/*
 * q is the shortest way to the axis by either solution, were there no end of travel.  Where the
 * axis nearest the work is free, it does not matter when it turns to where it will be needed.
 */
static bool nearest_of_both(const struct nc_planner *planner, struct vec3 axis, const double q[])
{
    const struct kinematic_chain *chain = &planner->machine->chain;
    const double *from = planner->state.at.q;
    struct chain_solutions found = chain_angles(chain, axis);
    for (int k = 0; k < found.n; k++) {
        for (int i = 0; i < chain->n; i++)
            found.q[k][i] = angle_nearest(found.q[k][i], from[i]);
        if (found.free)
            found.q[k][0] = from[0];
        if (ik_travel(chain, from, found.q[k]) < ik_travel(chain, from, q) - 1e-9)
            return false;
    }
    return true;
}

/* So near the singular direction that one block may lead past it (post_lookahead.h): a way to the
 * other solution is shorter than the nearest one by far. */
static bool may_be_crossed(const struct nc_planner *planner, struct vec3 axis)
{
    const struct kinematic_chain *chain = &planner->machine->chain;
    double near = 2 * planner->allowed.axis;
    struct vec3 off = vec_cross(chain->rotary[0].axis, axis);
    return chain->n == 2 && vec_dot(off, off) < near * near && !chain_free(chain, axis);
}

static const double POLE_SHARE = 0.95; /* of what is allowed: how far off the pole is the pole */

/* Where the control does not lead the tip, the axes' own way past the pole has its share, and the
 * pole is no wider than so many of the last digit of an angle: nearer the digits say nothing. */
static const double POLE_SHARE_JOINT = 0.25, POLE_DIGITS = 10;

double post_ik_near_pole(const struct nc_planner *planner)
{
    struct pose_deviation allowed = planner->allowed;
    double ball = fabs(planner->follow.ball);
    double most = fmin(allowed.axis, ball > 0 ? allowed.point / ball : HUGE_VAL);
    if (planner->machine->chain.n != 2 || planner->follow.mode == INTERPOLATE_ROTARY)
        return 0;
    if (planner->follow.mode == INTERPOLATE_VECTOR)
        return POLE_SHARE * most;
    return fmin(POLE_SHARE_JOINT * most,
                RADIANS(POLE_DIGITS / num_ten[planner->plan->ability.digits.angle]));
}

/* The pose, its axis the singular direction where it is near it.  True: it was changed. */
static bool snap_to_pole(const struct nc_planner *planner, struct pose *to)
{
    double near = planner->near_pole;
    struct vec3 pole = planner->machine->chain.rotary[0].axis, off = vec_cross(pole, to->a);
    double off2 = near > 0 ? vec_dot(off, off) : HUGE_VAL;
    if (!(off2 < near * near) || chain_free(&planner->machine->chain, to->a))
        return false;
    to->a = vec_dot(pole, to->a) < 0 ? vec_scale(-1, pole) : pole;
    return true;
}

bool post_ik_says_pole(const struct nc_planner *planner, struct vec3 axis)
{
    struct vec3 pole = planner->machine->chain.rotary[0].axis;
    return vec_length(vec_cross(pole, axis)) < planner->near_pole;
}

double post_ik_pole_between(const struct nc_planner *planner, const struct motion *motion,
                            double s0, double s1)
{
    const double beside = 1e-6; /* of the motion: as good as its end */
    double near = planner->near_pole;
    struct vec3 a = motion->from.a, b = motion->to.a;
    struct vec3 pole = planner->machine->chain.rotary[0].axis;
    if (planner->follow.mode != INTERPOLATE_VECTOR || near == 0 || motion->kind == MOTION_SPLINE ||
        vec_dot(vec_cross(pole, a), vec_cross(pole, b)) >= 0 || /* to one side */
        post_ik_says_pole(planner, motion_at(motion, s0).a) ||
        post_ik_says_pole(planner, motion_at(motion, s1).a)) /* it goes through it anyway */
        return s1;
    double turn = vec_angle(a, b);
    struct vec3 across = vec_unit(vec_reject(b, a));
    if (vec_dot(pole, a) < 0)
        pole = vec_scale(-1, pole);
    double s = atan2(vec_dot(pole, across), vec_dot(pole, a)) / turn;
    bool within =
        fabs(vec_dot(pole, vec_cross(a, across))) < near && s > s0 + beside && s < s1 - beside;
    return within ? s : s1;
}

bool post_ik_reach_near(const struct nc_planner *planner, const struct pose *to,
                        struct machine_pose *target, struct pose_deviation *off)
{
    double q[ROTARY_MAX] = {0};
    struct turned turned;
    struct pose pose = *to;
    bool changed = snap_to_pole(planner, &pose);
    if (planner->off_part || planner->aim.n > 0 ||
        !ik_near(&planner->near, pose.a, planner->state.at.q, &planner->state.turned, q, &turned))
        return false;
    words_of_pose(planner, &pose, q, &turned, target, off);
    if (changed)
        off->point = off->axis = NAN;
    return true;
}

int post_ik_reach(struct nc_planner *planner, struct pose to, double s, struct machine_pose *target)
{
    const struct kinematic_chain *chain = &planner->machine->chain;
    double q[ROTARY_MAX] = {planner->state.at.q[0], planner->state.at.q[1]};
    struct pose_deviation off;
    int over;
    if (post_ik_reach_near(planner, &to, target, &off))
        return post_ik_check_linear(planner, target);
    snap_to_pole(planner, &to);
    if (planner->aim.n && aim_at(&planner->aim, s, q)) {
        *target = post_ik_pose(planner, to, q);
        return post_ik_check_linear(planner, target);
    }
    if (ik_choose(chain, to.a, q, true, -1, q, &over) != 0)
        return not_reached(planner, to, over);
    planner->doubtful = planner->doubtful ||
                        (!planner->off_part &&
                         (!nearest_of_both(planner, to.a, q) || may_be_crossed(planner, to.a)));
    if (planner->aim.n == 0 &&
        (planner->follow.mode != INTERPOLATE_VECTOR || !planner->state.begun))
        turn_ahead(planner, to, q); /* a vector says no angle: there the axis stays */
    *target = post_ik_pose(planner, to, q);
    return post_ik_check_linear(planner, target);
}

/* ---- vectors leave the rotary axes to the control */

bool post_ik_nearest(const struct kinematic_chain *chain, struct vec3 axis, const double from[],
                     double q[])
{
    struct chain_solutions found = chain_angles(chain, axis);
    double least = HUGE_VAL;
    for (int k = 0; k < found.n; k++) {
        double at[ROTARY_MAX] = {0}, most;
        for (int i = 0; i < chain->n; i++)
            at[i] = found.free && i == 0 ? from[0] : angle_nearest(found.q[k][i], from[i]);
        most = ik_most_turn(chain, at, from);
        if (most < least) {
            least = most;
            q[0] = at[0];
            q[1] = at[1];
        }
    }
    return least < HUGE_VAL;
}

struct follow_way {
    const struct kinematic_chain *chain;
    const struct motion *motion;
};

/* From q at s0 on to s1, in steps in which no axis turns far; false: out of the travel. */
static bool follow_on(const struct follow_way *way, double s0, double s1, double q[], int depth)
{
    enum { DEPTH = 16 };
    const double far = RADIANS(15);
    double next[ROTARY_MAX] = {0};
    if (!post_ik_nearest(way->chain, motion_at(way->motion, s1).a, q, next))
        return false;
    if (depth < DEPTH && (depth < 2 || ik_most_turn(way->chain, next, q) > far)) {
        double mid = (s0 + s1) / 2;
        return follow_on(way, s0, mid, q, depth + 1) && follow_on(way, mid, s1, q, depth + 1);
    }
    for (int i = 0; i < way->chain->n; i++) {
        const struct rotary *r = &way->chain->rotary[i];
        if (next[i] < r->min - 1e-6 || next[i] > r->max + 1e-6)
            return false;
        q[i] = next[i];
    }
    return true;
}

/* Does all of a curve or an arc stay so near to 0 that no linear axis can leave its travel? */
static bool stays_near(const struct nc_planner *planner, const struct motion *motion)
{
    double far = planner->safe_radius;
    if (motion->kind != MOTION_SPLINE)
        return vec_length(motion->centre) + vec_distance(motion->centre, motion->from.p) < far;
    for (size_t i = 0; i < motion->curve->poles; i++)
        if (vec_dot(motion->curve->pole[i], motion->curve->pole[i]) >= far * far)
            return false;
    return true;
}

int post_ik_check_between(struct nc_planner *planner, const struct motion *motion, double s0,
                          double s1)
{
    enum { LOOKS = 16 };
    const struct kinematic_chain *chain = &planner->machine->chain;
    double q[ROTARY_MAX] = {planner->state.at.q[0], planner->state.at.q[1]};
    if (stays_near(planner, motion))
        return 0;
    for (double s = s0, next; s < s1; s = next) {
        next = motion->kind == MOTION_SPLINE ? fmin(motion_next_knot(motion, s), s1) : s1;
        for (int i = 1; i <= LOOKS; i++) {
            struct pose at = motion_at(motion, s + (next - s) * i / LOOKS);
            double turned[ROTARY_MAX] = {q[0], q[1]};
            if (post_ik_nearest(chain, at.a, q, turned))
                memcpy(q, turned, sizeof q);
            struct vec3 p = chain_linear(chain, at.p, q);
            const double place[3] = {p.x, p.y, p.z};
            int axis = post_ik_out_of_travel(planner, place);
            if (axis >= 0)
                return post_ik_tell_over(planner, at.p, axis, "a position of", place[axis]);
        }
    }
    return 0;
}

bool post_ik_follow(const struct nc_planner *planner, const struct motion *motion, double s0,
                    double s1, struct machine_pose *to)
{
    const struct kinematic_chain *chain = &planner->machine->chain;
    double q[ROTARY_MAX] = {planner->state.at.q[0], planner->state.at.q[1]};
    if (planner->follow.mode != INTERPOLATE_VECTOR || chain->n != 2)
        return true;
    struct vec3 pole = chain->rotary[0].axis, a = planner->state.pose.a;
    double off = fmin(vec_length(vec_cross(pole, a)), vec_length(vec_cross(pole, to->at.a)));
    if (motion->kind != MOTION_SPLINE && 2 * vec_distance(a, to->at.a) < off &&
        ik_most_turn(chain, to->at.q, q) < PI / 2)
        return true; /* far from the pole nothing else is near */
    if (chain_free(chain, to->at.a))
        return true; /* it leads straight there */
    const struct follow_way way = {chain, motion};
    if (!follow_on(&way, s0, s1, q, 0))
        return false;
    int digits = planner->plan->ability.digits.angle;
    for (int i = 0; i < chain->n; i++)
        to->at.q[i] = RADIANS(num_round(DEGREES(q[i]), digits));
    to->turned = chain_turned(chain, to->at.q);
    return true;
}
