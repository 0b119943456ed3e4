/* turnplan - see turnplan.h. */
#include "turnplan.h"

#include <stdlib.h>

#include "array.h"

enum { WINDINGS_MAX = 11, STATES_MAX = 2 * WINDINGS_MAX * WINDINGS_MAX };
static const double jump = PI / 2;   /* radians between two places that no block makes */
static const double turn_cost = 1e7; /* more than the way of any axis, radians */

bool turnplan_end(const struct chain *chain, struct vec3 from, struct vec3 to, int solution,
                  double *share)
{
    const struct rotary *r = &chain->rotary[0];
    if (chain->n == 0 || r->max - r->min > (WINDINGS_MAX - 1) * 2 * PI)
        return false;
    struct chain_solutions a = chain_angles(chain, from), b = chain_angles(chain, to);
    if (a.free || b.free || solution >= a.n || solution >= b.n)
        return false;
    double turn = remainder(b.q[solution][0] - a.q[solution][0], 2 * PI);
    for (int i = 0; i < 2; i++) {
        double end = i ? r->max : r->min, far = remainder(end - a.q[solution][0], 2 * PI);
        *share = far / turn;
        if (fabs(turn) < jump && *share > 0 && *share < 1)
            return true;
    }
    return false;
}

/* The whole turns that an axis may have: `many` of them from `least`; one that has no end is
 * always turned the nearest way. */
struct winding {
    int many, least;
    bool endless;
};

struct state {
    double cost; /* HUGE_VAL: not to be had */
    double q[ROTARY_MAX];
    int before; /* state of the place before */
    bool turn;  /* by turning there */
};

struct plan {
    const struct chain *chain;
    struct winding winding[ROTARY_MAX];
    int states; /* of a place */
    struct state *state;
};

double turnplan_step(const struct chain *chain, struct vec3 axis)
{
    double off = chain->n ? vec_angle(chain->rotary[0].axis, axis) : 1;
    return fmax(5e-4, fmin(0.035, 0.3 * fmin(off, PI - off)));
}

static struct winding windings(const struct chain *chain, int i)
{
    if (i >= chain->n || chain->rotary[i].max - chain->rotary[i].min > (WINDINGS_MAX - 1) * 2 * PI)
        return (struct winding){1, 0, true};
    int least = (int)ceil((chain->rotary[i].min - PI) / (2 * PI) - 1e-9);
    int most = (int)floor((chain->rotary[i].max + PI) / (2 * PI) + 1e-9);
    return (struct winding){most - least + 1, least, false};
}

/* The state of these angles, whole turns away from the k-th solution `base`; -1: outside of the
 * travel. */
static int state_of(const struct plan *plan, int k, const double q[], const double base[])
{
    int at = k;
    for (int i = 0; i < ROTARY_MAX; i++) {
        const struct rotary *r = &plan->chain->rotary[i];
        int turns = 0;
        if (i < plan->chain->n && (q[i] < r->min - 1e-9 || q[i] > r->max + 1e-9))
            return -1;
        if (!plan->winding[i].endless)
            turns = (int)round((q[i] - base[i]) / (2 * PI)) - plan->winding[i].least;
        if (turns < 0 || turns >= plan->winding[i].many)
            return -1;
        at = at * plan->winding[i].many + turns;
    }
    return at;
}

static double way(const struct chain *chain, const double a[], const double b[])
{
    double sum = 0;
    for (int i = 0; i < chain->n && i < ROTARY_MAX; i++)
        sum += fabs(a[i] - b[i]);
    return sum;
}

static void offer(struct state *state, double cost, const double q[], int before, bool turn)
{
    if (cost < state->cost)
        *state = (struct state){cost, {q[0], q[1]}, before, turn};
}

static void clear(struct state row[], int n)
{
    for (int s = 0; s < n; s++)
        row[s] = (struct state){.cost = HUGE_VAL, .before = -1};
}

/* Every state in which the tool can stand in this direction, at a cost from `from` on. */
static void offer_all(const struct plan *plan, struct vec3 axis, const double from[], double cost,
                      int before, bool turn, struct state row[])
{
    struct chain_solutions found = chain_angles(plan->chain, axis);
    for (int k = 0; k < found.n; k++)
        for (int a = 0; a < plan->winding[0].many; a++)
            for (int b = 0; b < plan->winding[1].many; b++) {
                double base[ROTARY_MAX] = {found.free ? remainder(from[0], 2 * PI) : found.q[k][0],
                                           found.q[k][1]};
                double q[ROTARY_MAX] = {base[0] + 2 * PI * (plan->winding[0].least + a),
                                        base[1] + 2 * PI * (plan->winding[1].least + b)};
                for (int i = 0; i < ROTARY_MAX; i++)
                    if (plan->winding[i].endless)
                        q[i] += 2 * PI * round((from[i] - q[i]) / (2 * PI));
                int s = state_of(plan, k, q, base);
                if (s >= 0)
                    offer(&row[s], cost + way(plan->chain, from, q), q, before, turn);
            }
}

/* From a state of one place on to the next one without a turn. */
static void go_on(const struct plan *plan, const struct chain_solutions *found, bool stays,
                  bool loose, const struct state *from, int before, bool turn, struct state row[])
{
    for (int k = 0; k < found->n; k++) {
        double q[ROTARY_MAX] = {0}, base[ROTARY_MAX] = {found->q[k][0], found->q[k][1]}, most = 0;
        for (int i = 0; i < plan->chain->n; i++) {
            q[i] = found->q[k][i] + 2 * PI * round((from->q[i] - found->q[k][i]) / (2 * PI));
            if (i == 0 && stays) {
                q[i] = from->q[i];
                base[i] = 0;
            }
            if (i > 0 || !loose)
                most = fmax(most, fabs(q[i] - from->q[i]));
        }
        int s = state_of(plan, k, q, base);
        if (s >= 0 && most < jump)
            offer(&row[s], from->cost + way(plan->chain, from->q, q), q, before, turn);
    }
}

static int best(const struct state row[], int n)
{
    int found = -1;
    for (int s = 0; s < n; s++)
        if (row[s].cost < HUGE_VAL && (found < 0 || row[s].cost < row[found].cost))
            found = s;
    return found;
}

/*
 * The states of place j from those of the one before.  Where the first axis is free it stays as it
 * is, and along a way that stays so it turns to where it will be needed (`ahead`).
 */
static void advance(const struct plan *plan, const struct turnplan_place place[], size_t j,
                    const struct vec3 *ahead)
{
    struct state *from = plan->state + (j - 1) * (size_t)plan->states, *row = from + plan->states;
    struct state turned[STATES_MAX];
    struct chain_solutions found = chain_angles(plan->chain, place[j].axis);
    bool free = found.free, was = chain_angles(plan->chain, place[j - 1].axis).free;
    clear(row, plan->states);
    if (free && was && ahead) {
        struct chain_solutions then = chain_angles(plan->chain, *ahead);
        for (int k = 0; k < then.n && k < found.n; k++)
            found.q[k][0] = then.q[k][0];
    }
    bool stays = free && !(was && ahead);
    for (int s = 0; s < plan->states; s++)
        if (from[s].cost < HUGE_VAL)
            go_on(plan, &found, stays, free && was, &from[s], s, false, row);
    int start = best(from, plan->states);
    if (!place[j - 1].may_turn || start < 0)
        return;
    clear(turned, plan->states);
    offer_all(plan, place[j - 1].axis, from[start].q,
              from[start].cost + turn_cost + place[j - 1].dear, start, true, turned);
    for (int s = 0; s < plan->states; s++)
        if (turned[s].cost < HUGE_VAL)
            go_on(plan, &found, stays, free && was, &turned[s], start, true, row);
}

/* Backwards from the best last state. */
static int trace_back(const struct plan *plan, struct turnplan_place place[], size_t n)
{
    int s = best(plan->state + (n - 1) * (size_t)plan->states, plan->states), turns = 0;
    if (s < 0)
        return -1;
    place[n - 1].turn = false;
    for (size_t j = n; j-- > 0;) {
        const struct state *state = &plan->state[j * (size_t)plan->states + (size_t)s];
        for (int i = 0; i < ROTARY_MAX; i++)
            place[j].q[i] = state->q[i];
        if (j > 0)
            place[j - 1].turn = state->turn;
        turns += state->turn;
        s = state->before;
    }
    return turns;
}

int turnplan_make(const struct chain *chain, struct turnplan_place place[], size_t n,
                  const double from[])
{
    struct plan plan = {.chain = chain, .winding = {windings(chain, 0), windings(chain, 1)}};
    plan.states = 2 * plan.winding[0].many * plan.winding[1].many;
    plan.state = mem_alloc(n * (size_t)plan.states, sizeof *plan.state);
    clear(plan.state, plan.states);
    offer_all(&plan, place[0].axis, from, 0, -1, false, plan.state);
    size_t tilted = 0;
    for (size_t j = 1; j < n; j++) {
        if (tilted <= j)
            for (tilted = j; tilted < n && chain_angles(chain, place[tilted].axis).free;)
                tilted++;
        advance(&plan, place, j, tilted < n ? &place[tilted].axis : NULL);
    }
    int turns = trace_back(&plan, place, n);
    free(plan.state);
    return turns;
}
