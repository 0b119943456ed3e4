/* axis_limits - see axis_limits.h. */
#include "simulate/axis_limits.h"

/* Pieces whose tool axis turns are looked at in so many steps, what stands still in one. */
enum { STEPS = 6, CURVE_STEPS = 24 };

#define ARC_STEP 0.35 /* radians, and no longer on an arc: its chords add up to 0.995 of it */
#define REACH 0.01    /* degrees that a tool axis may be off what the machine reaches */
#define SHORT 0.001   /* mm: a turn rate is measured over longer moves */
#define NARROW 0.02   /* mm: what an axis does over less is none of a control that slows down */
#define OVER 1.01     /* times as fast as it can: speeds and lengths are printed rounded */

struct state {
    double axis[NC_AXES];
    double turn[VERIFY_KINEMATICS_AXES];
    struct vec3 tip;
};

/* A part of the way, the time that it is given and what the slowest axes need, minutes. */
struct stretch {
    double way, time, least;
};

struct axis_check {
    const struct nc_motion *motion;
    const struct axis_limits *limits;
    struct axis_use *use;
    double turn[VERIFY_KINEMATICS_AXES]; /* where the rotary axes stand */
    struct stretch stretch, before;      /* not yet looked at; looked at last */
};

/* Where all axes stand at s of a piece. */
static struct state state_at(struct axis_check *check, size_t index, double s)
{
    const struct verify_kinematics *kinematics = &check->motion->kinematics;
    const struct nc_piece *piece = &check->motion->piece.item[index];
    struct nc_motion_pose pose = nc_motion_at(check->motion, piece, s);
    struct state state = {.tip = pose.p};
    if (!nc_motion_angles(check->motion, piece, s, state.turn) &&
        !verify_kinematics_angles(kinematics, pose.a, check->turn, REACH, state.turn) &&
        check->use->unreachable++ == 0)
        check->use->unreachable_at = index;
    const struct verify_kinematics with_tool = nc_motion_kinematics(check->motion, piece);
    struct vec3 linear = verify_kinematics_linear(&with_tool, pose.p, state.turn);
    state.axis[0] = linear.x;
    state.axis[1] = linear.y;
    state.axis[2] = linear.z;
    for (int i = 0; i < kinematics->n; i++) {
        state.axis[3 + kinematics->axis[i].letter - 'A'] = state.turn[i];
        check->turn[i] = state.turn[i];
    }
    return state;
}

/* Travel; true when an axis is beyond it. */
static bool note_travel(struct axis_check *check, const struct state *state, size_t index)
{
    struct axis_use *use = check->use;
    bool beyond = false;
    for (int k = 0; k < NC_AXES; k++) {
        double at = state->axis[k];
        use->low[k] = fmin(use->low[k], at);
        use->high[k] = fmax(use->high[k], at);
        double slack = check->limits->slack;
        if (at >= check->limits->min[k] - slack && at <= check->limits->max[k] + slack)
            continue;
        if (use->beyond == 0 && !beyond)
            use->travel = (struct axis_peak){at, k, index};
        beyond = true;
    }
    return beyond;
}

/* Minutes from one state to the next as programmed; rapid: as fast as the axes can. */
static double programmed_time(const struct axis_check *check, const struct nc_piece *piece,
                              const struct state *a, const struct state *b, double share)
{
    double sum = 0, length = vec_distance(a->tip, b->tip);
    if (piece->rapid || !(piece->feed > 0))
        return 0;
    if (piece->inverse)
        return share / piece->feed;
    if (!check->limits->combined && length > 0)
        return length / piece->feed;
    for (int k = check->limits->combined ? 0 : 3; k < NC_AXES; k++) { /* the tip stays: degrees */
        double way = (k < 3 ? 1 : nc_motion_degree(check->motion)) * (b->axis[k] - a->axis[k]);
        sum += way * way;
    }
    return sqrt(sum) / piece->feed;
}

/* Minutes that the slowest axis needs at least. */
static double least_time(const struct axis_check *check, const struct state *a,
                         const struct state *b, int *axis)
{
    double most = 0;
    for (int k = 0; k < NC_AXES; k++) {
        double time = fabs(b->axis[k] - a->axis[k]) / check->limits->rapid[k];
        if (time > most) {
            most = time;
            *axis = k;
        }
    }
    return most;
}

static void note_peak(struct axis_peak *peak, double value, int axis, size_t piece)
{
    if (value > peak->value)
        *peak = (struct axis_peak){value, axis, piece};
}

static void note_turns(struct axis_check *check, size_t index, const struct state *a,
                       const struct state *b, double way)
{
    for (int k = 3; k < NC_AXES; k++) {
        double turn = fabs(b->axis[k] - a->axis[k]);
        note_peak(&check->use->jump, turn, k, index);
        if (way > SHORT)
            note_peak(&check->use->turn_rate, turn / way, k, index);
    }
}

static int steps_of(const struct nc_motion *motion, const struct nc_piece *piece)
{
    bool still = piece->shape == SHAPE_LINE && piece->interpolation != AXIS_BY_HEAD &&
                 vec_distance(piece->q[0], piece->q[1]) == 0;
    if (piece->shape == SHAPE_ARC)
        return (int)fmax(STEPS, ceil(motion->arc.item[piece->index].angle / ARC_STEP));
    bool curve = piece->shape == SHAPE_POLYNOMIAL || piece->shape == SHAPE_SPLINE;
    return still ? 1 : curve ? CURVE_STEPS : STEPS;
}

/* A next piece of the same curve, at the same feed. */
static bool goes_on(const struct nc_motion *motion, size_t index)
{
    const struct nc_piece *a = &motion->piece.item[index], *b = a + 1;
    return index + 1 < motion->piece.n && a->shape == b->shape && a->feed == b->feed &&
           ((a->shape == SHAPE_SPLINE && a->index == b->index) || a->shape == SHAPE_POLYNOMIAL);
}

static struct stretch stretch_add(struct stretch a, struct stretch b)
{
    return (struct stretch){a.way + b.way, a.time + b.time, a.least + b.least};
}

/*
 * Takes a step at feed; true where an axis is too fast.  A control that slows down by itself is
 * asked for too much by no less than NARROW of the way, or by all of a curve that is shorter: what
 * is left at its end goes with the stretch before.
 */
static bool take_step(struct axis_check *check, struct stretch step, int axis, bool last,
                      size_t index)
{
    double narrow = check->limits->strict ? 0 : NARROW;
    struct stretch s = stretch_add(check->stretch, step);
    check->stretch = s;
    if (s.way < narrow && !last)
        return false;
    if (s.way < narrow)
        s = stretch_add(s, check->before);
    const struct stretch none = {0};
    check->before = last ? none : s;
    check->stretch = none;
    bool fast = s.time > 0 && s.least > OVER * s.time;
    if (fast)
        note_peak(&check->use->speed, s.least / s.time, axis, index);
    return fast;
}

static void check_piece(struct axis_check *check, size_t index)
{
    const struct nc_piece *piece = &check->motion->piece.item[index];
    struct axis_use *use = check->use;
    int steps = steps_of(check->motion, piece);
    struct state first = state_at(check, index, 0), a = first;
    bool beyond = note_travel(check, &a, index), fast = false;
    double way = 0;
    for (int i = 1; i <= steps; i++) {
        int axis = 0;
        struct state b = state_at(check, index, (double)i / steps);
        double time = programmed_time(check, piece, &a, &b, 1.0 / steps);
        double least = least_time(check, &a, &b, &axis);
        beyond = note_travel(check, &b, index) || beyond;
        way += vec_distance(a.tip, b.tip);
        if (!piece->rapid) {
            struct stretch step = {vec_distance(a.tip, b.tip), time, least};
            bool last = i == steps && !goes_on(check->motion, index);
            fast = take_step(check, step, axis, last, index) || fast;
        }
        *(piece->rapid ? &use->rapid_time : &use->cut_time) += fmax(time, least);
        a = b;
    }
    *(piece->rapid ? &use->rapid_length : &use->cut_length) += way;
    use->beyond += beyond;
    use->fast += fast;
    use->no_feed += !piece->rapid && !(piece->feed > 0);
    if (!piece->rapid)
        note_turns(check, index, &first, &a, way);
}

struct axis_place axis_limits_place(struct axis_follow *follow, size_t piece, double s)
{
    struct axis_use use = {0};
    struct axis_check check = {
        .motion = follow->motion, .use = &use, .turn = {follow->turn[0], follow->turn[1]}};
    struct state state = state_at(&check, piece, s);
    struct axis_place place = {.tip = state.tip};
    for (int k = 0; k < NC_AXES; k++)
        place.axis[k] = state.axis[k];
    follow->turn[0] = check.turn[0];
    follow->turn[1] = check.turn[1];
    return place;
}

struct axis_use axis_limits_check(const struct nc_motion *motion, const struct axis_limits *limits)
{
    struct axis_use use = {0};
    struct axis_check check = {.motion = motion, .limits = limits, .use = &use};
    for (int k = 0; k < NC_AXES; k++) {
        use.low[k] = HUGE_VAL;
        use.high[k] = -HUGE_VAL;
    }
    for (size_t i = 0; i < motion->piece.n; i++)
        check_piece(&check, i);
    return use;
}
