/* plane_fit - see plane_fit.h. */
#include "math/plane_fit.h"

enum { SWEEPS = 30 };

static struct vec3 mean_of(const struct vec3 *point, size_t n)
{
    struct vec3 sum = vec(0, 0, 0);

    for (size_t i = 0; i < n; i++)
        sum = vec_add(sum, vec_sub(point[i], point[0]));
    return vec_along(point[0], 1 / (double)n, sum);
}

static void covariance(const struct vec3 *point, size_t n, struct vec3 centre, double a[3][3])
{
    double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;

    for (size_t k = 0; k < n; k++) {
        struct vec3 d = vec_sub(point[k], centre);
        xx += d.x * d.x;
        xy += d.x * d.y;
        xz += d.x * d.z;
        yy += d.y * d.y;
        yz += d.y * d.z;
        zz += d.z * d.z;
    }
    const double sum[3][3] = {{xx, xy, xz}, {xy, yy, yz}, {xz, yz, zz}};
    for (int i = 0; i < 9; i++)
        a[i / 3][i % 3] = sum[i / 3][i % 3] / (double)n;
}

/* Turns rows and columns p and q of `a` so that a[p][q] becomes 0; the axes v with them. */
static void rotate(double a[3][3], double v[3][3], int p, int q)
{
    if (fabs(a[p][q]) <= 1e-18 * (fabs(a[p][p]) + fabs(a[q][q])))
        return;
    double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
    double t = (theta < 0 ? -1 : 1) / (fabs(theta) + sqrt(theta * theta + 1));
    double c = 1 / sqrt(t * t + 1), s = t * c;

    for (int k = 0; k < 3; k++) {
        double kp = a[k][p], kq = a[k][q];
        a[k][p] = c * kp - s * kq;
        a[k][q] = s * kp + c * kq;
    }
    for (int k = 0; k < 3; k++) {
        double pk = a[p][k], qk = a[q][k];
        a[p][k] = c * pk - s * qk;
        a[q][k] = s * pk + c * qk;
        double vp = v[p][k], vq = v[q][k];
        v[p][k] = c * vp - s * vq;
        v[q][k] = s * vp + c * vq;
    }
}

int plane_fit(const struct vec3 *point, size_t n, struct plane_fit *plane)
{
    double a[3][3], v[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    int least = 0, most = 0;

    if (n < 3)
        return -1;
    plane->centre = mean_of(point, n);
    covariance(point, n, plane->centre, a);
    for (int i = 0; i < SWEEPS && a[0][1] * a[0][1] + a[0][2] * a[0][2] + a[1][2] * a[1][2] > 0;
         i++) {
        rotate(a, v, 0, 1);
        rotate(a, v, 0, 2);
        rotate(a, v, 1, 2);
    }
    for (int i = 1; i < 3; i++) {
        least = a[i][i] < a[least][least] ? i : least;
        most = a[i][i] >= a[most][most] ? i : most;
    }
    if (least == most)
        return -1;
    int middle = 3 - least - most;
    plane->normal = vec_unit(vec(v[least][0], v[least][1], v[least][2]));
    plane->rms = sqrt(fmax(a[least][least], 0));
    plane->width = sqrt(fmax(a[middle][middle], 0));
    plane->length = sqrt(fmax(a[most][most], 0));
    return plane->width > 1e-9 * plane->length ? 0 : -1;
}
