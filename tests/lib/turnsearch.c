/* turnsearch - see turnsearch.h. */
#include "turnsearch.h"

#include <stdbool.h>

struct angles angles_all(const struct kinematic_chain *chain, struct vec3 axis)
{
    struct angles all = {0};
    for (int start = 0; start < 144; start++) {
        double q[2] = {2 * PI * (start % 12) / 12, 2 * PI * (double)(start / 12) / 12};
        double miss = 9;
        for (int i = 0; i < 30 && miss > 1e-13; i++) {
            const double h = 1e-6;
            const double q0[2] = {q[0] + h, q[1]}, q1[2] = {q[0], q[1] + h};
            struct vec3 at = chain_axis(chain, q), off = vec_sub(axis, at);
            struct vec3 d0 = vec_scale(1 / h, vec_sub(chain_axis(chain, q0), at));
            struct vec3 d1 = vec_scale(1 / h, vec_sub(chain_axis(chain, q1), at));
            double a = vec_dot(d0, d0), b = vec_dot(d0, d1), c = vec_dot(d1, d1);
            double u = vec_dot(d0, off), v = vec_dot(d1, off), det = a * c - b * b;
            miss = vec_length(off);
            if (det < 1e-12)
                break;
            q[0] += (c * u - b * v) / det;
            q[1] += (a * v - b * u) / det;
        }
        for (int k = 0; k < 25 && miss < 1e-9; k++) {
            double r[2] = {remainder(q[0], 2 * PI) + 2 * PI * (k % 5 - 2),
                           remainder(q[1], 2 * PI) + 2 * PI * (double)(k / 5 - 2)};
            bool new = true;
            for (int i = 0; i < 2; i++)
                new = new &&r[i] >= chain->rotary[i].min &&r[i] <= chain->rotary[i].max;
            for (int i = 0; i < all.n; i++)
                new = new &&fabs(all.q[i][0] - r[0]) + fabs(all.q[i][1] - r[1]) > 1e-6;
            if (new &&all.n < ANGLES) {
                all.q[all.n][0] = r[0];
                all.q[all.n++][1] = r[1];
            }
        }
    }
    return all;
}

double angles_way(const struct kinematic_chain *chain, const double a[], const double b[])
{
    double slow = fmin(chain->rotary[0].rapid, chain->rotary[1].rapid), sum = 0;
    for (int i = 0; i < 2; i++)
        sum += fabs(a[i] - b[i]) * (slow > 0 ? slow / chain->rotary[i].rapid : 1);
    return sum;
}

/* A better way to q comes from `from`. */
static bool better(const int turns[], const double way[], int k, int t, double w)
{
    return turns[k] < 0 || t < turns[k] || (t == turns[k] && w < way[k]);
}

int angles_least(const struct kinematic_chain *chain, const struct vec3 axis[], int n,
                 const double from[], double *way)
{
    struct angles at = angles_all(chain, axis[0]);
    int turns[ANGLES], least = -1;
    double ways[ANGLES];
    for (int k = 0; k < at.n; k++) {
        turns[k] = 0;
        ways[k] = angles_way(chain, from, at.q[k]);
    }
    for (int j = 1; j < n; j++) {
        struct angles to = angles_all(chain, axis[j]);
        int turns_to[ANGLES];
        double ways_to[ANGLES];
        for (int k = 0; k < to.n; k++) {
            turns_to[k] = -1;
            for (int i = 0; i < at.n; i++)
                for (int v = -1; v < at.n && turns[i] >= 0; v++) {
                    const double *start = v < 0 ? at.q[i] : at.q[v];
                    int t = turns[i] + (v >= 0);
                    double w = ways[i] + angles_way(chain, at.q[i], start) +
                               angles_way(chain, start, to.q[k]);
                    if (fabs(start[0] - to.q[k][0]) < PI / 2 &&
                        fabs(start[1] - to.q[k][1]) < PI / 2 &&
                        better(turns_to, ways_to, k, t, w)) {
                        turns_to[k] = t;
                        ways_to[k] = w;
                    }
                }
        }
        at = to;
        for (int k = 0; k < to.n; k++) {
            turns[k] = turns_to[k];
            ways[k] = ways_to[k];
        }
    }
    for (int k = 0; k < at.n; k++)
        if (turns[k] >= 0 &&
            (least < 0 || turns[k] < least || (turns[k] == least && ways[k] < *way))) {
            least = turns[k];
            *way = ways[k];
        }
    return least;
}
