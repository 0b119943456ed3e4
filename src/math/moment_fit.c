/* moment_fit - see moment_fit.h. */
#include "math/moment_fit.h"

#include <stdbool.h>

enum { QUADRIC = 6, CUBIC = 10, POWERS = 28, FRAMES = 2 };

/* Part of a term that the terms before it must leave over. */
static const double INDEPENDENT = 1e-3;

/* Slope of a surface against its frame from which on it gets one of its own. */
static const double SKEW = 0.2;

static const double HIGHEST = 20; /* so many times the points that fit are looked at, at most */

/* The points in the ball, from the place. */
struct ball {
    size_t n;
    struct vec3 d[MOMENT_FIT_MOST];
};

/* Sums of u^i v^j, by degree and from u^degree to v^degree; of u^i v^j w; and of w^2. */
struct sums {
    double power[POWERS], w[CUBIC], ww;
};

double moment_fit_radius(double k, double spacing, struct vec3 normal)
{
    const double least = 0.25;

    return spacing * sqrt(k / (PI * fmax(fabs(normal.z), least)));
}

/* False: there are too many. */
static bool gather(const struct point_grid *b, struct vec3 place, double radius, struct ball *ball)
{
    size_t left = point_grid_column(b, place.x - radius);
    size_t right = point_grid_column(b, place.x + radius);
    size_t low = point_grid_row(b, place.y - radius), high = point_grid_row(b, place.y + radius);
    double radius2 = radius * radius;
    size_t looked = 0;

    ball->n = 0;
    for (size_t row = low; row <= high; row++) {
        uint32_t from = b->first[row * b->columns + left];
        uint32_t to = b->first[row * b->columns + right + 1];
        looked += to - from;
        if (looked > (size_t)(HIGHEST * MOMENT_FIT_MOST))
            return false;
        for (uint32_t i = from; i < to; i++) {
            struct vec3 d = vec_sub(b->point[i], place);
            if (vec_dot(d, d) > radius2)
                continue;
            if (ball->n == MOMENT_FIT_MOST)
                return false;
            ball->d[ball->n++] = d;
        }
    }
    return ball->n >= MOMENT_FIT_LEAST;
}

/* Of u and v in units of the radius, and w in mm. */
static struct sums add_up(const struct quadric *frame, double radius, const struct ball *ball)
{
    struct sums s = {.ww = 0};
    struct vec3 along_u = vec_scale(1 / radius, frame->u),
                along_v = vec_scale(1 / radius, frame->v);
    double *p = s.power;

    for (size_t i = 0; i < ball->n; i++) {
        double u = vec_dot(ball->d[i], along_u), v = vec_dot(ball->d[i], along_v);
        double w = vec_dot(ball->d[i], frame->w);
        double uu = u * u, uv = u * v, vv = v * v;
        double u3 = uu * u, uuv = uu * v, uvv = u * vv, v3 = vv * v;
        p[1] += u, p[2] += v;
        p[3] += uu, p[4] += uv, p[5] += vv;
        p[6] += u3, p[7] += uuv, p[8] += uvv, p[9] += v3;
        p[10] += uu * uu, p[11] += u3 * v, p[12] += uu * vv, p[13] += u * v3, p[14] += vv * vv;
        p[15] += u3 * uu, p[16] += u3 * uv, p[17] += u3 * vv;
        p[18] += uu * v3, p[19] += uv * v3, p[20] += vv * v3;
        p[21] += u3 * u3, p[22] += u3 * uuv, p[23] += u3 * uvv, p[24] += u3 * v3;
        p[25] += uuv * v3, p[26] += uvv * v3, p[27] += v3 * v3;
        s.w[0] += w, s.w[1] += u * w, s.w[2] += v * w;
        s.w[3] += uu * w, s.w[4] += uv * w, s.w[5] += vv * w;
        s.w[6] += u3 * w, s.w[7] += uuv * w, s.w[8] += uvv * w, s.w[9] += v3 * w;
        s.ww += w * w;
    }
    p[0] = (double)ball->n;
    return s;
}

/* Powers of u and v in each term, in the order of quadric.c and cubic.c. */
static const int U[CUBIC] = {0, 1, 0, 2, 1, 0, 3, 2, 1, 0};
static const int V[CUBIC] = {0, 0, 1, 0, 1, 2, 0, 1, 2, 3};

static double power_of(const struct sums *s, int i, int j)
{
    int degree = U[i] + V[i] + U[j] + V[j];

    return s->power[degree * (degree + 1) / 2 + V[i] + V[j]];
}

/* a' a = the sums of products, a upper triangular, with 1 / a[i][i] in inverse[]; -1 when a term
 * depends on those before it. */
static int factor(const struct sums *s, double a[CUBIC][CUBIC], double inverse[CUBIC])
{
    for (int i = 0; i < CUBIC; i++)
        for (int j = i; j < CUBIC; j++)
            a[i][j] = power_of(s, i, j);
    for (int k = 0; k < CUBIC; k++) {
        if (!(a[k][k] > INDEPENDENT * power_of(s, k, k)))
            return -1;
        inverse[k] = 1 / sqrt(a[k][k]);
        for (int j = k; j < CUBIC; j++)
            a[k][j] *= inverse[k];
        for (int i = k + 1; i < CUBIC; i++)
            for (int j = i; j < CUBIC; j++)
                a[i][j] -= a[k][i] * a[k][j];
    }
    return 0;
}

/* a' y = b */
static void solve_forward(double a[CUBIC][CUBIC], const double inverse[CUBIC],
                          const double b[CUBIC], double y[CUBIC])
{
    for (int i = 0; i < CUBIC; i++)
        y[i] = b[i];
    for (int k = 0; k < CUBIC; k++) {
        y[k] *= inverse[k];
        for (int i = k + 1; i < CUBIC; i++)
            y[i] -= a[k][i] * y[k];
    }
}

/* The coefficients of the surface with the first so many terms, in mm. */
static void solve_back(double a[CUBIC][CUBIC], const double inverse[CUBIC], const double y[CUBIC],
                       int terms, double radius, double c[CUBIC])
{
    double scale[4] = {1, 1 / radius, 0, 0};

    scale[2] = scale[1] * scale[1];
    scale[3] = scale[2] * scale[1];
    for (int i = 0; i < CUBIC; i++)
        c[i] = 0;
    for (int i = terms - 1; i >= 0; i--) {
        c[i] = y[i];
        for (int j = i + 1; j < terms; j++)
            c[i] -= a[i][j] * c[j];
        c[i] *= inverse[i];
    }
    for (int i = 0; i < terms; i++)
        c[i] *= scale[U[i] + V[i]];
}

/* Of c0, and of c1 and c2 together, by the squares of the first so many terms. */
static void find_variances(double a[CUBIC][CUBIC], const double inverse[CUBIC], double radius,
                           struct moment_fit *fit)
{
    double variance[3][2] = {{0}};

    for (int term = 0; term < 3; term++) {
        double pick[CUBIC] = {0}, y[CUBIC];
        pick[term] = 1;
        solve_forward(a, inverse, pick, y);
        for (int i = 0; i < CUBIC; i++)
            variance[term][i >= QUADRIC] += y[i] * y[i];
    }
    double radius2 = radius * radius, tilt = variance[1][0] + variance[2][0];
    fit->quadric.variance = variance[0][0];
    fit->quadric.tilt = tilt / radius2;
    fit->cubic.variance = variance[0][0] + variance[0][1];
    fit->cubic.tilt = (tilt + variance[1][1] + variance[2][1]) / radius2;
}

/* Spread of what a surface with so many terms leaves. */
static double spread_of(const struct sums *s, const double y[CUBIC], int terms)
{
    double left = s->ww;

    for (int i = 0; i < terms; i++)
        left -= y[i] * y[i];
    return sqrt(fmax(left, 0) / fmax(s->power[0] - terms, 1));
}

static int fit_in_frame(struct vec3 place, struct vec3 w, double radius, const struct ball *ball,
                        struct moment_fit *fit)
{
    double a[CUBIC][CUBIC], inverse[CUBIC], y[CUBIC];

    fit->cubic = fit->quadric = quadric_frame(place, w);
    struct sums s = add_up(&fit->cubic, radius, ball);
    if (factor(&s, a, inverse) < 0)
        return -1;
    solve_forward(a, inverse, s.w, y);
    solve_back(a, inverse, y, CUBIC, radius, fit->cubic.c);
    solve_back(a, inverse, y, QUADRIC, radius, fit->quadric.c);
    find_variances(a, inverse, radius, fit);
    fit->quadric_spread = spread_of(&s, y, QUADRIC);
    fit->cubic_spread = spread_of(&s, y, CUBIC);
    fit->lean = sqrt(s.power[1] * s.power[1] + s.power[2] * s.power[2]) / s.power[0];
    fit->n = ball->n;
    return 0;
}

int moment_fit_ball(const struct point_grid *scan, struct vec3 place, struct vec3 guess,
                    double radius, struct moment_fit *fit)
{
    struct ball ball;

    if (!gather(scan, place, radius, &ball))
        return -1;
    for (int frame = 0; frame < FRAMES; frame++) {
        if (fit_in_frame(place, guess, radius, &ball, fit) < 0)
            return -1;
        const double *c = fit->cubic.c;
        if (c[1] * c[1] + c[2] * c[2] < SKEW * SKEW)
            break;
        guess = quadric_normal(&fit->cubic);
    }
    return 0;
}

/* The quadric's slopes are off by a bias and less uncertain: the cubic's are nearer to the truth
 * where the squared difference is more than four times its variance (Hausman 1978: that of the
 * cubic's less that of the quadric's). */
static bool cubic_is_nearer(const struct moment_fit *fit)
{
    double du = fit->cubic.c[1] - fit->quadric.c[1], dv = fit->cubic.c[2] - fit->quadric.c[2];
    double sigma = fit->cubic_spread;

    return du * du + dv * dv > 4 * sigma * sigma * (fit->cubic.tilt - fit->quadric.tilt);
}

const struct quadric *moment_fit_better(const struct moment_fit *fit)
{
    return cubic_is_nearer(fit) ? &fit->cubic : &fit->quadric;
}

double moment_fit_spread(const struct moment_fit *fit)
{
    return cubic_is_nearer(fit) ? fit->cubic_spread : fit->quadric_spread;
}
