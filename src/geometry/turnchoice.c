/* turnchoice - see turnchoice.h. */
#include "turnchoice.h"

/* q turned by whole turns to be nearest to `from` within the travel; false: there is none. */
static bool within_travel(const struct rotary *rotary, double from, double *q)
{
    const double slack = 1e-9;
    double turned = *q + 2 * PI * round((from - *q) / (2 * PI));
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
static bool better(const double a[3], const double b[3])
{
    for (int i = 0; i < 3; i++)
        if (fabs(a[i] - b[i]) > 1e-9)
            return a[i] < b[i];
    return false;
}

double chain_weight(const struct chain *chain, int i)
{
    double slowest = HUGE_VAL;
    for (int k = 0; k < chain->n; k++)
        slowest = fmin(slowest, chain->rotary[k].rapid);
    return i < chain->n && slowest > 0 ? slowest / chain->rotary[i].rapid : 1;
}

double chain_way(const struct chain *chain, const double a[], const double b[])
{
    double sum = 0;
    for (int i = 0; i < chain->n; i++)
        sum += chain_weight(chain, i) * fabs(a[i] - b[i]);
    return sum;
}

static void merit(const struct chain *chain, const double from[], const double q[], bool smooth,
                  double m[3])
{
    double sum = 0, away = 0, master = 0;
    for (int i = 0; i < chain->n; i++) {
        sum += fabs(q[i] - from[i]);
        away += fabs(q[i]);
        if (i == chain->master)
            master = fabs(q[i] - from[i]);
    }
    m[0] = smooth ? chain_way(chain, from, q) : master;
    m[1] = smooth ? master : sum - master;
    m[2] = away;
}

/* The angle of that cosine and sine nearest to `from`, whose own are in `was`: by the sine's
 * inverse series where it is near. */
static inline double angle_near(double from, const struct turned *was, int i, double cosine,
                                double sine)
{
    double s = sine * was->cosine[i] - cosine * was->sine[i], s2 = s * s;
    if (s2 < 1e-4 && cosine * was->cosine[i] + sine * was->sine[i] > 0)
        return from + s * (1 + s2 * (1.0 / 6 + s2 * (3.0 / 40)));
    double q = atan2(sine, cosine);
    return q + 2 * PI * round((from - q) / (2 * PI));
}

struct chain_ways chain_ways(const struct chain *chain)
{
    struct chain_ways w = {.chain = chain};
    if (chain->n != 2)
        return w;
    struct vec3 u1 = chain->rotary[1].axis, across = vec_cross(u1, chain->tool);
    struct vec3 along = vec_scale(vec_dot(u1, chain->tool), u1);
    w.up = chain->rotary[0].axis;
    w.side = vec_perpendicular(w.up);
    w.front = vec_cross(w.up, w.side);
    const struct vec3 frame[] = {w.up, w.side, w.front};
    for (int i = 0; i < 3; i++) {
        w.still[i] = vec_dot(frame[i], along);
        w.cosine[i] = vec_dot(frame[i], chain->tool) - w.still[i];
        w.sine[i] = vec_dot(frame[i], across);
    }
    w.h = hypot(w.cosine[0], w.sine[0]);
    return w;
}

/* Component i of the tool in the frame of the ways, when the second axis is turned. */
static inline double component(const struct chain_ways *w, int i, double c1, double s1)
{
    return w->still[i] + w->cosine[i] * c1 + w->sine[i] * s1;
}

struct vec3 chain_ways_axis(const struct chain_ways *w, const struct turned *at)
{
    double c0 = at->cosine[0], s0 = at->sine[0], c1 = at->cosine[1], s1 = at->sine[1];
    double side = component(w, 1, c1, s1), front = component(w, 2, c1, s1);
    struct vec3 a = vec_scale(component(w, 0, c1, s1), w->up);
    return vec_along(vec_along(a, c0 * side - s0 * front, w->side), s0 * side + c0 * front,
                     w->front);
}

/* 1 / |a|, for unit vectors without a root. */
static inline double inverse_length(struct vec3 a)
{
    double l2 = vec_dot(a, a);
    return fabs(l2 - 1) < 1e-8 ? 1.5 - 0.5 * l2 : 1 / sqrt(l2);
}

/*
 * The component of a along u0 is k0 + b cos q1 + c sin q1, so with root^2 = b^2 + c^2 - k^2 the
 * cosine and sine of both q1 are known without an angle.  Turned by q1, t is as far from u0 as a
 * is: the lengths of what is across u0 need no root either, but one step of Newton's.
 */
bool chain_beside(const struct chain_ways *w, struct vec3 axis, const double from[], double q[],
                  struct turned *turned)
{
    const double steep = 1e-4; /* of h^2: half a degree from the singular direction */
    const struct chain *chain = w->chain;
    const struct rotary *r0 = &chain->rotary[0], *r1 = &chain->rotary[1];
    if (chain->n != 2)
        return false;
    double unit = inverse_length(axis), up = unit * vec_dot(w->up, axis);
    double b = w->cosine[0], c = w->sine[0], k = up - w->still[0];
    double h2 = w->h * w->h, root2 = h2 - k * k, flat = 1 - up * up;
    if (!(root2 > steep * h2 && flat > steep))
        return false;
    double root = sqrt(root2), per = 1 / h2;
    double sign = c * turned->cosine[1] - b * turned->sine[1] > 0 ? -root : root;
    double c1 = (b * k - c * sign) * per, s1 = (c * k + b * sign) * per;
    double x = unit * vec_dot(w->side, axis), y = unit * vec_dot(w->front, axis);
    double side = component(w, 1, c1, s1), front = component(w, 2, c1, s1);
    double c0 = side * x + front * y, s0 = side * y - front * x;
    double scale = 1 / flat, far2 = (c0 * c0 + s0 * s0) * scale * scale;
    scale *= 1.5 - 0.5 * far2;
    c0 *= scale;
    s0 *= scale;
    double q0 = angle_near(from[0], turned, 0, c0, s0), q1 = angle_near(from[1], turned, 1, c1, s1);
    if (q0 > r0->max || q0 < r0->min || q1 > r1->max || q1 < r1->min)
        return false;
    double move0 = fabs(q0 - from[0]), move1 = fabs(q1 - from[1]);
    if (!(2 * root > w->h * (2 * move1 + move0 + 1e-6))) /* twice the sine: the other's way */
        return false;
    q[0] = q0; /* last, for q may be where `from` stands */
    q[1] = q1;
    *turned = (struct turned){{c0, c1}, {s0, s1}};
    return true;
}

int chain_choose(const struct chain *chain, struct vec3 axis, const double from[], bool smooth,
                 int only, double q[], int *over)
{
    if (smooth && only < 0 && chain_weight(chain, 0) <= chain_weight(chain, 1)) {
        struct turned turned = chain_turned(chain, from);
        struct chain_ways ways = chain_ways(chain);
        if (chain_beside(&ways, axis, from, q, &turned))
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
        merit(chain, from, s.q[k], smooth, m);
        if (!inside || (found >= 0 && !better(m, best)))
            continue;
        found = k;
        for (int i = 0; i < 3; i++)
            best[i] = m[i];
    }
    for (int i = 0; found >= 0 && i < chain->n; i++)
        q[i] = s.q[found][i];
    return found >= 0 ? 0 : -1;
}
