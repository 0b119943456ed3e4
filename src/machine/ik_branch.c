/* ik_branch - see ik_branch.h. */
#include "machine/ik_branch.h"

static const int turns_max[ROTARY_MAX] = {IK_BRANCH_TURNS_FIRST, IK_BRANCH_TURNS_SECOND};
static const double slack = 1e-9;  /* radians beyond the travel that are rounding */
static const double jump = PI / 2; /* radians between two near directions that are none */

/* The i-th axis has an end. */
static bool has_end(const struct kinematic_chain *chain, int i)
{
    return chain->rotary[i].max - chain->rotary[i].min < (turns_max[i] - 1) * 2 * PI;
}

static struct turn_range turn_range_of(const struct kinematic_chain *chain, int i)
{
    const struct rotary *r = &chain->rotary[i];
    if (i >= chain->n || !has_end(chain, i))
        return (struct turn_range){1, 0, true};
    int least = (int)ceil((r->min - PI) / (2 * PI) - slack);
    int most = (int)floor((r->max + PI) / (2 * PI) + slack);
    return (struct turn_range){most - least + 1, least, false};
}

struct ik_branches ik_branches(const struct kinematic_chain *chain)
{
    struct ik_branches s = {chain, {turn_range_of(chain, 0), turn_range_of(chain, 1)}, 0};
    s.n = 2 * s.range[0].many * s.range[1].many;
    return s;
}

bool ik_branch_within(const struct kinematic_chain *chain, const double q[])
{
    for (int i = 0; i < chain->n; i++)
        if (!(q[i] >= chain->rotary[i].min - slack && q[i] <= chain->rotary[i].max + slack))
            return false;
    return true;
}

int ik_branch_at(const struct ik_branches *s, int k, const double q[], const double base[])
{
    int at = k;
    if (!ik_branch_within(s->chain, q))
        return -1;
    for (int i = 0; i < ROTARY_MAX; i++) {
        const struct turn_range *w = &s->range[i];
        int turns = w->endless ? 0 : (int)round((q[i] - base[i]) / (2 * PI)) - w->least;
        if (turns < 0 || turns >= w->many)
            return -1;
        at = at * w->many + turns;
    }
    return at;
}

void ik_branch_angles(const struct ik_branches *s, const struct ik_branch_target *target, int state,
                      const double from[], double q[])
{
    int turns[ROTARY_MAX], k = state;
    for (int i = ROTARY_MAX; i-- > 0; k /= s->range[i].many)
        turns[i] = k % s->range[i].many;
    for (int i = 0; i < ROTARY_MAX; i++) {
        double base = target->found.q[k][i];
        if (i == 0 && target->stays)
            base = angle_remainder(from[0]);
        double whole =
            s->range[i].endless ? round((from[i] - base) / (2 * PI)) : turns[i] + s->range[i].least;
        q[i] = i < s->chain->n ? base + 2 * PI * whole : 0;
    }
}

bool ik_branch_end(const struct kinematic_chain *chain, const struct chain_solutions *from,
                   const struct chain_solutions *to, int solution, double *share)
{
    *share = 1;
    if (from->free || to->free || solution >= from->n || solution >= to->n)
        return false;
    for (int i = 0; i < 2 * chain->n; i++) {
        const struct rotary *r = &chain->rotary[i / 2];
        if (!has_end(chain, i / 2))
            continue;
        double here = from->q[solution][i / 2];
        double turn = angle_remainder(to->q[solution][i / 2] - here);
        double far = angle_remainder((i % 2 ? r->max : r->min) - here);
        if (fabs(turn) < jump && far / turn > 0 && far / turn < *share)
            *share = far / turn;
    }
    return *share < 1;
}

double ik_branch_step(const struct kinematic_chain *chain, struct vec3 axis)
{
    const double tilted = 0.12, most = 0.035; /* sine: beyond it the step is the largest */
    struct vec3 across = vec_cross(chain->rotary[0].axis, axis);
    if (chain->n && vec_dot(across, across) > tilted * tilted)
        return most;
    double off = chain->n ? vec_angle(chain->rotary[0].axis, axis) : 1;
    return fmax(5e-4, fmin(most, 0.3 * fmin(off, PI - off)));
}

struct ik_branch_target ik_branch_target(const struct kinematic_chain *chain, double cone,
                                         struct vec3 near, struct vec3 axis,
                                         const struct chain_solutions *found,
                                         const struct chain_solutions *ahead)
{
    struct ik_branch_target g = {.found = *found};
    bool free = g.found.free, was = chain->n == 2 && chain_free(chain, near);
    if (free && was && ahead) {
        for (int k = 0; k < ahead->n && k < g.found.n; k++)
            g.found.q[k][0] = ahead->q[k][0];
    }
    g.stays = free && !(was && ahead);
    double most = sin(fmin(cone, PI / 2));
    struct vec3 here = vec_cross(chain->rotary[0].axis, axis);
    struct vec3 before = vec_cross(chain->rotary[0].axis, near);
    g.loose = (free && was) || (chain->n == 2 && vec_dot(here, here) <= most * most &&
                                vec_dot(before, before) <= most * most);
    return g;
}
