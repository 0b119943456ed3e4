/* ik_choose - see ik_choose.h. */
#include "machine/ik_choose.h"

#include "machine/ik_near.h"

/* q turned by whole turns to be nearest to `from` within the travel; false: there is none. */
static bool within_travel(const struct rotary *rotary, double from, double *q)
{
    const double slack = 1e-9;
    double turned = angle_nearest(*q, from);
    if (turned > rotary->max + slack)
        turned -= 2 * PI * ceil((turned - rotary->max - slack) / (2 * PI));
    if (turned < rotary->min - slack)
        turned += 2 * PI * ceil((rotary->min - slack - turned) / (2 * PI));
    if (turned > rotary->max + slack)
        return false;
    *q = turned;
    return true;
}

/* a and b in order of merit, the first that differs: true when a is the better. */
static bool is_better(const double a[3], const double b[3])
{
    for (int i = 0; i < 3; i++)
        if (fabs(a[i] - b[i]) > 1e-9)
            return a[i] < b[i];
    return false;
}

double ik_weight(const struct kinematic_chain *chain, int i)
{
    double slowest = HUGE_VAL;
    for (int k = 0; k < chain->n; k++)
        slowest = fmin(slowest, chain->rotary[k].rapid);
    return i < chain->n && slowest > 0 ? slowest / chain->rotary[i].rapid : 1;
}

double ik_travel(const struct kinematic_chain *chain, const double a[], const double b[])
{
    double sum = 0;
    for (int i = 0; i < chain->n; i++)
        sum += ik_weight(chain, i) * fabs(a[i] - b[i]);
    return sum;
}

double ik_most_turn(const struct kinematic_chain *chain, const double a[], const double b[])
{
    double most = 0;
    for (int i = 0; i < chain->n; i++)
        most = fmax(most, fabs(a[i] - b[i]));
    return most;
}

static void rank_solution(const struct kinematic_chain *chain, const double from[],
                          const double q[], bool smooth, double m[3])
{
    double sum = 0, away = 0, master = 0;
    for (int i = 0; i < chain->n; i++) {
        sum += fabs(q[i] - from[i]);
        away += fabs(q[i]);
        if (i == chain->master)
            master = fabs(q[i] - from[i]);
    }
    m[0] = smooth ? ik_travel(chain, from, q) : master;
    m[1] = smooth ? master : sum - master;
    m[2] = away;
}

int ik_choose(const struct kinematic_chain *chain, struct vec3 axis, const double from[],
              bool smooth, int only, double q[], int *over)
{
    if (smooth && only < 0 && ik_weight(chain, 0) <= ik_weight(chain, 1)) {
        struct turned turned = chain_turned(chain, from);
        struct ik_near_table ways = ik_near_table(chain);
        if (ik_near(&ways, axis, from, &turned, q, &turned))
            return 0;
    }
    struct chain_solutions s = chain_angles(chain, axis);
    double best[3];
    int found = -1;
    *over = -1;
    for (int k = 0; k < s.n; k++) {
        double m[3];
        bool inside = true;
        if (only >= 0 && k != only && s.n == 2)
            continue;
        if (s.free)
            s.q[k][0] = from[0];
        for (int i = 0; i < chain->n; i++)
            if (!within_travel(&chain->rotary[i], from[i], &s.q[k][i])) {
                inside = false;
                *over = i;
            }
        rank_solution(chain, from, s.q[k], smooth, m);
        if (!inside || (found >= 0 && !is_better(m, best)))
            continue;
        found = k;
        for (int i = 0; i < 3; i++)
            best[i] = m[i];
    }
    for (int i = 0; found >= 0 && i < chain->n; i++)
        q[i] = s.q[found][i];
    return found >= 0 ? 0 : -1;
}
