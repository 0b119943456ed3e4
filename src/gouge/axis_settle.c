/* axis_settle - see axis_plan_steps.h: the angles of the rotary axes along nodes made smooth. */
#include <stdlib.h>

#include "axis_plan_steps.h"

static const double WIDEST = 16;          /* mm: first half length of averages, halved each time */
static const double NARROWEST = 1.5;      /* mm: and the last */
static const double BESIDE = RADIANS(12); /* so near the pole the turn may be off */

/* True if the node may have the axis. */
static bool may_have(const struct axis_planner *p, const struct node *node, struct vec3 axis,
                     double spare)
{
    int corner[4];

    if (vec_dot(axis, node->rule) < cos(node->allow + spare))
        return false;
    if (node->strict)
        return access_is_open(p->access, node->ball, axis);
    sphere_grid_corners(&p->grid, axis, corner);
    for (int k = 0; k < 4; k++)
        if (node->state[corner[k]] == ACCESS_BLOCKED)
            return false;
    return true;
}

/* How far each axis may be off its rule: `play`, or as far as it was chosen to be or the nodes
 * beside it, less by the way between. */
static void set_allowances(const struct work *w, size_t from, size_t to)
{
    const double ramp = 0.04; /* radians/mm */
    struct node *node = w->nodes.item;

    for (size_t i = from; i < to; i++) {
        double off = vec_angle(node[i].axis, node[i].rule), play = axis_choose_play(w->planner);
        if (vec_length(node[i].normal) == 0 && play > 0)
            play = AXIS_AIR;
        node[i].allow = off > play + 1e-6 ? off + 0.05 : play;
    }
    for (size_t i = from + 1; i < to; i++)
        node[i].allow =
            fmax(node[i].allow, node[i - 1].allow - ramp * (node[i].along - node[i - 1].along));
    for (size_t i = to - 1; i-- > from;)
        node[i].allow =
            fmax(node[i].allow, node[i + 1].allow - ramp * (node[i + 1].along - node[i].along));
}

static void unwrap_angles(const struct work *w, size_t from, size_t to)
{
    struct node *node = w->nodes.item;
    struct rotary_angles last = {0, 0};

    for (size_t i = from; i < to; i++) {
        if (i == from)
            last.turn = rotary_angles_near(&w->planner->frame, node[i].axis, last).turn;
        node[i].angles = last = rotary_angles_near(&w->planner->frame, node[i].axis, last);
    }
}

/* The node's angles towards `to`, as far as it may have them. */
static void move_towards(const struct axis_planner *p, struct node *node, struct rotary_angles to)
{
    struct rotary_angles was = node->angles;

    if (fabs(to.lean - was.lean) + fabs(to.turn - was.turn) < 1e-9)
        return;
    for (double part = 1; part > 0.1; part /= 2) {
        struct rotary_angles a = {was.lean + part * (to.lean - was.lean),
                                  was.turn + part * (to.turn - was.turn)};
        struct vec3 axis = rotary_axis(&p->frame, a);
        if (!may_have(p, node, axis, 0))
            continue;
        node->angles = a;
        node->axis = axis;
        node->by_rule = false;
        return;
    }
}

/* Each node's angles to the mean over `half` mm before and after it, less near the ends. */
static void average_angles(const struct work *w, size_t from, size_t to, double half)
{
    struct node *node = &w->nodes.item[from];
    size_t n = to - from;
    struct rotary_angles *sum = mem_alloc(n + 1, sizeof *sum);

    for (size_t i = 0; i + 1 < n; i++) { /* integrals up to node i */
        double length = node[i + 1].along - node[i].along;
        sum[i + 1].lean =
            sum[i].lean + length * (node[i].angles.lean + node[i + 1].angles.lean) / 2;
        sum[i + 1].turn =
            sum[i].turn + length * (node[i].angles.turn + node[i + 1].angles.turn) / 2;
    }
    for (size_t i = 1, low = 0, high = 0; i + 1 < n; i++) {
        double reach =
            fmin(half, fmin(node[i].along - node[0].along, node[n - 1].along - node[i].along));
        while (low < i && node[i].along - node[low].along > reach + 1e-9)
            low++;
        high = high < i ? i : high;
        while (high + 1 < n && node[high + 1].along - node[i].along <= reach + 1e-9)
            high++;
        while (high > i && node[high].along - node[i].along > reach + 1e-9)
            high--;
        double length = node[high].along - node[low].along;
        if (length <= 0)
            continue;
        move_towards(w->planner, &node[i],
                     (struct rotary_angles){(sum[high].lean - sum[low].lean) / length,
                                            (sum[high].turn - sum[low].turn) / length});
    }
    free(sum);
}

/* The turn of a node between its neighbours', as far as that moves the axis by no more than
 * AXIS_SPARE: beside the pole that is far, and no axis is any nearer to its rule for a turn
 * there. */
static void relax_turn(const struct axis_planner *p, struct node *node, double turn0)
{
    double before = node->along - node[-1].along, after = node[1].along - node->along;
    double sine = fabs(sin(node->angles.lean)), most = sine > 0 ? AXIS_SPARE / sine : HUGE_VAL;
    double to = before + after > 0 ? (node[-1].angles.turn * after + node[1].angles.turn * before) /
                                         (before + after)
                                   : node->angles.turn;
    struct rotary_angles angles = {node->angles.lean, fmin(fmax(to, turn0 - most), turn0 + most)};
    struct vec3 axis = rotary_axis(&p->frame, angles);

    if (fabs(angles.turn - node->angles.turn) < 1e-9 || !may_have(p, node, axis, AXIS_SPARE))
        return;
    node->angles = angles;
    node->axis = axis;
    node->by_rule = false;
}

static void relax_turns(const struct work *w, size_t from, size_t to)
{
    enum { SWEEPS = 60 };
    struct node *node = w->nodes.item;
    double *turn0 = mem_alloc(to - from, sizeof *turn0);

    for (size_t i = from; i < to; i++)
        turn0[i - from] = node[i].angles.turn;
    for (int sweep = 0; sweep < SWEEPS; sweep++)
        for (size_t k = 1; k + 1 < to - from; k++) {
            size_t i = sweep % 2 ? to - 1 - k : from + k;
            if (fabs(node[i].angles.lean) < BESIDE)
                relax_turn(w->planner, &node[i], turn0[i - from]);
        }
    free(turn0);
}

void axis_settle(const struct work *w, size_t from, size_t to)
{
    enum { SWEEPS = 4 };

    unwrap_angles(w, from, to);
    if (to - from < 3)
        return;
    set_allowances(w, from, to);
    for (double half = WIDEST; half > NARROWEST; half /= 2)
        for (int sweep = 0; sweep < SWEEPS; sweep++)
            average_angles(w, from, to, half);
    if (w->planner->options.play > 0)
        relax_turns(w, from, to);
}
