/* axis_limits - see axis_limits.h. */
#include "simulate/axis_limits.h"

/* Pieces whose tool axis turns are looked at in so many steps, what stands still in one. */
enum { STEPS = 6 };

#define REACH 0.01  /* degrees that a tool axis may be off what the machine reaches */
#define SHORT 0.001 /* mm: swings are told of longer ways */
#define OVER 1.01   /* speeds are printed rounded, and so are ways */
#define TRAVEL 1e-6

struct state {
    double axis[LOAD_AXES];
    double turn[VERIFY_KINEMATICS_AXES];
    struct vec3 tip;
};

struct run {
    const struct nc_motion *nc_motion;
    const struct axis_limits_limits *limits;
    struct axis_limits *load;
    double turn[VERIFY_KINEMATICS_AXES]; /* where the rotary axes stand */
};

/* Where all axes stand at s of a piece. */
static struct state state_at(struct run *run, size_t index, double s)
{
    const struct verify_kinematics *verify_kinematics = &run->nc_motion->verify_kinematics;
    const struct nc_piece *piece = &run->nc_motion->piece.item[index];
    struct nc_motion_pose pose = nc_motion_at(run->nc_motion, piece, s);
    struct state state = {.tip = pose.p};
    if (piece->swing == SWING_ROTARY && piece->shape != SHAPE_SPLINE) {
        struct vec3 q = vec_mix(piece->q[0], piece->q[1], s);
        state.turn[0] = q.x;
        state.turn[1] = q.y;
    } else if (!verify_kinematics_angles(verify_kinematics, pose.a, run->turn, REACH, state.turn)) {
        if (run->load->unreachable++ == 0)
            run->load->unreachable_at = index;
    }
    struct vec3 linear = verify_kinematics_linear(verify_kinematics, pose.p, state.turn);
    state.axis[0] = linear.x;
    state.axis[1] = linear.y;
    state.axis[2] = linear.z;
    for (int i = 0; i < verify_kinematics->n; i++) {
        state.axis[3 + verify_kinematics->axis[i].letter - 'A'] = state.turn[i];
        run->turn[i] = state.turn[i];
    }
    return state;
}

/* Travel; true when an axis is beyond it. */
static bool travel(struct run *run, const struct state *state, size_t index)
{
    struct axis_limits *load = run->load;
    bool beyond = false;
    for (int k = 0; k < LOAD_AXES; k++) {
        double at = state->axis[k];
        load->low[k] = fmin(load->low[k], at);
        load->high[k] = fmax(load->high[k], at);
        if (at >= run->limits->min[k] - TRAVEL && at <= run->limits->max[k] + TRAVEL)
            continue;
        if (load->beyond == 0 && !beyond)
            load->travel = (struct axis_limits_peak){at, k, index};
        beyond = true;
    }
    return beyond;
}

/* Minutes from one state to the next as programmed; rapid: as fast as the axes can. */
static double programmed(const struct run *run, const struct nc_piece *piece, const struct state *a,
                         const struct state *b, double share)
{
    double sum = 0, way = vec_distance(a->tip, b->tip);
    if (piece->rapid || !(piece->feed > 0))
        return 0;
    if (piece->inverse)
        return share / piece->feed;
    if (!run->limits->combined && way > 0)
        return way / piece->feed;
    for (int k = run->limits->combined ? 0 : 3; k < LOAD_AXES; k++) /* the tip stays: degrees */
        sum += (b->axis[k] - a->axis[k]) * (b->axis[k] - a->axis[k]);
    return sqrt(sum) / piece->feed;
}

/* Minutes that the slowest axis needs at least. */
static double needed(const struct run *run, const struct state *a, const struct state *b, int *axis)
{
    double most = 0;
    for (int k = 0; k < LOAD_AXES; k++) {
        double time = fabs(b->axis[k] - a->axis[k]) / run->limits->rapid[k];
        if (time > most) {
            most = time;
            *axis = k;
        }
    }
    return most;
}

static void raise(struct axis_limits_peak *peak, double value, int axis, size_t piece)
{
    if (value > peak->value)
        *peak = (struct axis_limits_peak){value, axis, piece};
}

static void turns(struct run *run, size_t index, const struct state *a, const struct state *b,
                  double way)
{
    for (int k = 3; k < LOAD_AXES; k++) {
        double turn = fabs(b->axis[k] - a->axis[k]);
        raise(&run->load->jump, turn, k, index);
        if (way > SHORT)
            raise(&run->load->swing, turn / way, k, index);
    }
}

static void one_piece(struct run *run, size_t index)
{
    const struct nc_piece *piece = &run->nc_motion->piece.item[index];
    struct axis_limits *load = run->load;
    bool still = piece->shape == SHAPE_LINE && piece->swing != SWING_HEAD &&
                 vec_distance(piece->q[0], piece->q[1]) == 0;
    int steps = still ? 1 : STEPS;
    struct state first = state_at(run, index, 0), a = first;
    bool beyond = travel(run, &a, index), fast = false;
    double way = 0;
    for (int i = 1; i <= steps; i++) {
        int axis = 0;
        struct state b = state_at(run, index, (double)i / steps);
        double time = programmed(run, piece, &a, &b, 1.0 / steps);
        double least = needed(run, &a, &b, &axis);
        beyond = travel(run, &b, index) || beyond;
        way += vec_distance(a.tip, b.tip);
        if (!piece->rapid && time > 0 && least > OVER * time) {
            fast = true;
            raise(&load->speed, least / time, axis, index);
        }
        *(piece->rapid ? &load->rapid_time : &load->cut_time) += fmax(time, least);
        a = b;
    }
    *(piece->rapid ? &load->rapid_length : &load->cut_length) += way;
    load->beyond += beyond;
    load->fast += fast;
    load->no_feed += !piece->rapid && !(piece->feed > 0);
    if (!piece->rapid)
        turns(run, index, &first, &a, way);
}

struct axis_limits axis_limits_run(const struct nc_motion *nc_motion,
                                   const struct axis_limits_limits *limits)
{
    struct axis_limits load = {0};
    struct run run = {nc_motion, limits, &load, {0, 0}};
    for (int k = 0; k < LOAD_AXES; k++) {
        load.low[k] = HUGE_VAL;
        load.high[k] = -HUGE_VAL;
    }
    for (size_t i = 0; i < nc_motion->piece.n; i++)
        one_piece(&run, i);
    return load;
}
