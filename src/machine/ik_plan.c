/* ik_plan - see ik_plan.h. */
#include "machine/ik_plan.h"

#include <stdint.h>
#include <stdlib.h>

#include "base/array.h"

static const double jump = PI / 2; /* radians between two places that no block makes */
static const double inside = 1e-3; /* radians of travel that a turn inside of a motion counts */

/* A node at one place: the least cost up to it, and the angles there. */
struct state {
    unsigned turns;
    double travel; /* HUGE_VAL: not reached */
    double q[ROTARY_MAX];
};

/* How a state was reached: from the state before, by one of these. */
enum { BY_BLOCK, BY_TURN, BY_CROSSING, BY_BITS = 2 };

struct search {
    const struct ik_plan *plan;
    const struct kinematic_chain *chain;
    double weight[ROTARY_MAX];
    struct ik_branches states; /* of each place */
    struct state *row, *last, *turned,
        *far;     /* of this place, the one before; where a crossing starts */
    int *parent;  /* of each turned state, the one that it turned from */
    bool turns;   /* it may turn back */
    uint16_t *by; /* of each state of each place */
};

static double travel_between(const struct search *s, const double a[], const double b[])
{
    return s->weight[0] * fabs(a[0] - b[0]) + s->weight[1] * fabs(a[1] - b[1]);
}

static bool is_cheaper(unsigned turns, double cost, const struct state *than)
{
    return !(than->travel < HUGE_VAL) || turns < than->turns ||
           (turns == than->turns && cost < than->travel);
}

static bool improve(struct state *state, unsigned turns, double cost, const double q[])
{
    if (!is_cheaper(turns, cost, state))
        return false;
    *state = (struct state){turns, cost, {q[0], q[1]}};
    return true;
}

static void clear_row(struct state row[], int n)
{
    for (int s = 0; s < n; s++)
        row[s].travel = HUGE_VAL;
}

static int best_state(const struct state row[], int n)
{
    int found = -1;
    for (int s = 0; s < n; s++)
        if (row[s].travel < HUGE_VAL &&
            (found < 0 || is_cheaper(row[s].turns, row[s].travel, &row[found])))
            found = s;
    return found;
}

/* Every state in which the tool can stand at a place, from one that cost so much. */
static void improve_all(struct search *s, const struct ik_plan_place *place,
                        const struct state *from, int parent)
{
    struct ik_branch_target target = {.found = place->solutions};
    target.stays = target.found.free;
    int each = s->states.n / 2;
    for (int to = 0; to < target.found.n * each; to++) {
        double q[ROTARY_MAX];
        if (place->shut[to / each] ||
            (s->last[to].travel < HUGE_VAL && s->last[to].turns < from->turns))
            continue; /* it is there with fewer turns back */
        ik_branch_angles(&s->states, &target, to, from->q, q);
        if (ik_branch_within(s->chain, q) &&
            improve(&s->turned[to], from->turns, from->travel + travel_between(s, from->q, q), q))
            s->parent[to] = parent;
    }
}

/* From a state of the place before on to this one in a block. */
static void extend_by_block(struct search *s, const struct ik_plan_place *place,
                            const struct ik_branch_target *target, const struct state *from,
                            uint16_t by, uint16_t into[])
{
    for (int k = 0; k < target->found.n; k++) {
        double q[ROTARY_MAX] = {0}, base[ROTARY_MAX] = {0}, most = 0;
        for (int i = 0; i < s->chain->n; i++) {
            base[i] = target->found.q[k][i];
            q[i] = angle_nearest(base[i], from->q[i]);
            if (i == 0 && target->stays) {
                q[i] = from->q[i];
                base[i] = angle_remainder(q[i]);
            }
            if (i > 0 || !target->loose)
                most = fmax(most, fabs(q[i] - from->q[i]));
        }
        int to = place->shut[k] || !(most < jump) ? -1 : ik_branch_at(&s->states, k, q, base);
        if (to >= 0 &&
            improve(&s->row[to], from->turns, from->travel + travel_between(s, from->q, q), q))
            into[to] = by;
    }
}

static uint16_t origin_of(int state, int how)
{
    return (uint16_t)((unsigned)state << BY_BITS | (unsigned)how);
}

/* The turns back at the place before: from the states with the fewest turns. */
static void turn_back(struct search *s, const struct ik_plan_place place[], size_t j,
                      const struct ik_branch_target *target, uint16_t into[])
{
    const struct ik_plan_place *last = &place[j - 1];
    int start = best_state(s->last, s->states.n);
    if (!s->turns || !last->may_turn || start < 0)
        return;
    clear_row(s->turned, s->states.n);
    for (int k = 0; k < s->states.n; k++) {
        struct state from = s->last[k];
        if (!(from.travel < HUGE_VAL) || from.turns > s->last[start].turns)
            continue;
        from.turns++;
        from.travel += last->inside ? inside : 0;
        improve_all(s, last, &from, k);
    }
    for (int k = 0; k < s->states.n; k++)
        if (s->turned[k].travel < HUGE_VAL)
            extend_by_block(s, &place[j], target, &s->turned[k], origin_of(s->parent[k], BY_TURN),
                            into);
}

/* One block from where a motion starts to where it ends, whatever lies between. */
static void cross_singular(struct search *s, const struct ik_plan_place place[], size_t j,
                           const struct ik_branch_target *target, uint16_t into[])
{
    const struct ik_plan *plan = s->plan;
    int each = s->states.n / 2;
    for (int k = 0; k < s->states.n; k++)
        for (int to = 0; to < target->found.n * each && s->far[k].travel < HUGE_VAL; to++) {
            const struct state *from = &s->far[k];
            double q[ROTARY_MAX];
            ik_branch_angles(&s->states, target, to, from->q, q);
            if (place[j].shut[to / each] || fabs(q[0] - from->q[0]) > PI ||
                fabs(q[1] - from->q[1]) > PI ||
                ik_branch_at(&s->states, to / each, q, target->found.q[to / each]) != to)
                continue;
            if (plan->may_cross &&
                !plan->may_cross(plan->with, j - place[j].crossing, j, from->q, q))
                continue;
            if (improve(&s->row[to], from->turns, from->travel + travel_between(s, from->q, q), q))
                into[to] = origin_of(k, BY_CROSSING);
        }
}

/* The solutions at the next place that is not free; NULL: there is none. */
static const struct chain_solutions *next_tilted(const struct ik_plan_place place[], size_t n,
                                                 size_t j, size_t *tilted)
{
    if (*tilted <= j)
        for (*tilted = j; *tilted < n && place[*tilted].solutions.free;)
            ++*tilted;
    return *tilted < n ? &place[*tilted].solutions : NULL;
}

/* The direction of a place, gone to from the one before. */
static struct ik_branch_target target_at(const struct search *s, const struct ik_plan_place place[],
                                         size_t n, size_t j, size_t *tilted)
{
    const struct chain_solutions *ahead = next_tilted(place, n, j, tilted);
    return ik_branch_target(s->chain, s->plan->cone, place[j - 1].axis, place[j].axis,
                            &place[j].solutions, ahead);
}

static void fill_forward(struct search *s, const struct ik_plan_place place[], size_t n)
{
    size_t tilted = 0, leads = 0; /* the next place where a crossing ends */
    for (size_t j = 0; j < n; j++) {
        uint16_t *into = s->by + j * (size_t)s->states.n;
        if (j > 0) {
            struct ik_branch_target target = target_at(s, place, n, j, &tilted);
            struct state *other = s->last;
            s->last = s->row;
            s->row = other;
            clear_row(s->row, s->states.n);
            for (int k = 0; k < s->states.n; k++)
                if (s->last[k].travel < HUGE_VAL)
                    extend_by_block(s, &place[j], &target, &s->last[k], origin_of(k, BY_BLOCK),
                                    into);
            turn_back(s, place, j, &target, into);
            if (place[j].crossing && !target.found.free)
                cross_singular(s, place, j, &target, into);
        }
        while (leads < n && (leads <= j || place[leads].crossing == 0))
            leads++;
        for (int k = 0; leads < n && leads - place[leads].crossing == j && k < s->states.n; k++)
            s->far[k] = s->row[k];
    }
}

/* Backwards from the best last state: the state at each place that no crossing passes. */
static void trace_back(const struct search *s, struct ik_plan_place place[], size_t n, int state,
                       int at[])
{
    size_t j = n - 1;
    place[j].turn = place[j].passed = false;
    for (at[j] = state; j > 0; at[j] = state) {
        unsigned by = s->by[j * (size_t)s->states.n + (size_t)state], how = by % (1 << BY_BITS);
        size_t back = how == BY_CROSSING ? place[j].crossing : 1;
        for (size_t i = 1; i <= back; i++) {
            place[j - i].turn = how == BY_TURN;
            place[j - i].passed = i < back;
        }
        state = (int)(by >> BY_BITS);
        j -= back;
    }
}

/* The angles of the states that were found. */
static void fill_angles(const struct search *s, struct ik_plan_place place[], size_t n,
                        const int at[], const double from[])
{
    double q[ROTARY_MAX] = {from[0], from[1]};
    size_t tilted = 0;
    for (size_t j = 0; j < n; j++) {
        struct ik_branch_target target = {.found = place[j].solutions,
                                          .stays = place[j].solutions.free};
        if (place[j].passed)
            continue;
        if (j > 0)
            target = target_at(s, place, n, j, &tilted);
        ik_branch_angles(&s->states, &target, at[j], q, place[j].q);
        q[0] = place[j].q[0];
        q[1] = place[j].q[1];
    }
}

static struct search search_of(const struct ik_plan *plan, size_t n)
{
    struct search s = {.plan = plan,
                       .chain = plan->chain,
                       .weight = {ik_weight(plan->chain, 0), ik_weight(plan->chain, 1)},
                       .states = ik_branches(plan->chain)};
    size_t states = (size_t)s.states.n;
    s.row = mem_alloc(4 * states, sizeof *s.row);
    s.last = s.row + states;
    s.turned = s.last + states;
    s.far = s.turned + states;
    s.parent = mem_alloc(states, sizeof *s.parent);
    s.by = mem_alloc(n * states, sizeof *s.by);
    return s;
}

/* The best of the last states, without turns back where that can be; -1: none. */
static int best_last_state(struct search *s, const struct ik_plan_place place[], size_t n,
                           const double from[])
{
    struct state start = {.q = {from[0], from[1]}};
    clear_row(s->turned, s->states.n);
    clear_row(s->far, s->states.n);
    improve_all(s, &place[0], &start, 0);
    for (int k = 0; k < s->states.n; k++)
        s->row[k] = s->turned[k];
    fill_forward(s, place, n);
    int last = best_state(s->row, s->states.n);
    if (last >= 0 || s->turns)
        return last;
    s->turns = true;
    return best_last_state(s, place, n, from);
}

int ik_plan_make(const struct ik_plan *plan, struct ik_plan_place place[], size_t n,
                 const double from[], struct ik_plan_cost *cost)
{
    struct search s = search_of(plan, n);
    for (size_t j = 0; j < n; j++)
        if (!place[j].known)
            place[j].solutions = chain_angles(plan->chain, place[j].axis);
    struct state *rows = s.row;
    int last = best_last_state(&s, place, n, from);
    if (last >= 0) {
        int *at = mem_alloc(n, sizeof *at);
        *cost = (struct ik_plan_cost){s.row[last].turns, s.row[last].travel};
        trace_back(&s, place, n, last, at);
        fill_angles(&s, place, n, at, from);
        free(at);
    }
    free(rows);
    free(s.parent);
    free(s.by);
    return last >= 0 ? 0 : -1;
}
