/* side_fit - see side_fit.h. */
#include "math/side_fit.h"

#include <stdlib.h>

#include "base/array.h"

enum { PLANE = 3, QUADRIC = 6, SOME = 400 };

/* Spread across a neighbourhood by its length, below which its points are on a line. */
static const double NARROW = 0.05;

/* What a quadric may leave of what a plane leaves, to be worth its freedom. */
static const double BETTER = 0.6;

/* What the fit leaves to each of the points, in its frame, that it does not fix. */
static double left_over(const struct quadric *q, const struct vec3 *local, size_t n, size_t fixed)
{
    return n > fixed ? quadric_rms_local(q, local, n) * sqrt((double)n / (double)(n - fixed)) : 0;
}

int side_fit_plane_of(const struct side_sums *sum, struct side_fit *fit)
{
    double count = sum->n, *c = fit->q.c;
    double mu = sum->u / count, mv = sum->v / count, mh = sum->h / count;

    if (count <= PLANE)
        return -1;
    double uu = sum->uu - count * mu * mu, uv = sum->uv - count * mu * mv;
    double vv = sum->vv - count * mv * mv;
    double uh = sum->uh - count * mu * mh, vh = sum->vh - count * mv * mh;
    /* the smaller eigenvalue by the larger one is the square of width by length */
    double mean = (uu + vv) / 2, skew = (uu - vv) / 2, half = sqrt(skew * skew + uv * uv);
    double det = uu * vv - uv * uv;
    if (!(mean - half > NARROW * NARROW * (mean + half)) || !(det > 0))
        return -1;
    c[1] = (uh * vv - vh * uv) / det;
    c[2] = (vh * uu - uh * uv) / det;
    c[0] = mh - c[1] * mu - c[2] * mv;
    return 0;
}

int side_fit_plane_local(const struct vec3 *local, size_t n, struct vec3 origin, struct vec3 w,
                         struct side_fit *fit)
{
    struct side_fit plane = {.q = quadric_frame(origin, w)};
    struct side_sums sum = {.n = 0};

    for (size_t i = 0; i < n; i++)
        side_sums_add(&sum, 1, local[i]);
    if (side_fit_plane_of(&sum, &plane) < 0)
        return -1;
    plane.rms = left_over(&plane.q, local, n, PLANE);
    *fit = plane;
    return 0;
}

int side_fit_plane(const struct vec3 *point, size_t n, struct vec3 origin, struct vec3 w,
                   struct side_fit *fit)
{
    struct quadric frame = quadric_frame(origin, w);
    struct vec3 few[SOME], *local = n > SOME ? mem_alloc(n, sizeof *local) : few;

    quadric_local_all(&frame, point, n, local);
    int status = side_fit_plane_local(local, n, origin, w, fit);
    if (local != few)
        free(local);
    return status;
}

struct side_fit side_fit_through(struct vec3 place, struct vec3 normal, struct vec3 origin,
                                 struct vec3 w)
{
    struct side_fit f = {.q = quadric_frame(origin, w)};
    double upright = vec_dot(normal, w);

    f.q.c[1] = -vec_dot(normal, f.q.u) / upright;
    f.q.c[2] = -vec_dot(normal, f.q.v) / upright;
    f.q.c[0] = vec_dot(normal, vec_sub(place, origin)) / upright;
    return f;
}

void side_fit_bend_local(const struct vec3 *local, size_t n, struct side_fit *fit)
{
    struct side_fit bent;

    if (n < 3 * QUADRIC || quadric_fit_local(local, n, &fit->q, &bent.q) < 0)
        return;
    bent.rms = left_over(&bent.q, local, n, QUADRIC);
    if (bent.rms < BETTER * fit->rms)
        *fit = bent;
}

void side_fit_bend(const struct vec3 *point, size_t n, struct side_fit *fit)
{
    struct vec3 few[SOME], *local = n > SOME ? mem_alloc(n, sizeof *local) : few;

    quadric_local_all(&fit->q, point, n, local);
    side_fit_bend_local(local, n, fit);
    if (local != few)
        free(local);
}

double side_fit_height(const struct side_fit *fit, struct vec3 p)
{
    return side_fit_height_local(fit, quadric_local(&fit->q, p));
}

double side_fit_above(const struct side_fit *fit, struct vec3 p)
{
    return vec_dot(vec_sub(p, fit->q.origin), fit->q.w) - side_fit_height(fit, p);
}

struct vec3 side_fit_point(const struct side_fit *fit, struct vec3 p)
{
    return vec_along(p, -side_fit_above(fit, p), fit->q.w);
}

struct vec3 side_fit_normal(const struct side_fit *fit, struct vec3 p)
{
    const struct quadric *q = &fit->q;
    struct vec3 at = quadric_local(q, p);
    double du = q->c[1] + 2 * q->c[3] * at.x + q->c[4] * at.y;
    double dv = q->c[2] + 2 * q->c[5] * at.y + q->c[4] * at.x;
    return vec_unit(vec_along(vec_along(q->w, -du, q->u), -dv, q->v));
}
