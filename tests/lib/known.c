#include "known.h"

#include <stdlib.h>

#include "base/array.h"

static void set_axis(struct nurbs_axis *a, int degree, size_t poles, const double *knot)
{
    size_t n = poles + (size_t)degree + 1;
    *a = (struct nurbs_axis){.degree = degree, .poles = poles, .from = knot[0], .to = knot[n - 1]};
    a->knot = mem_alloc(n, sizeof *a->knot);
    for (size_t i = 0; i < n; i++)
        a->knot[i] = knot[i];
}

struct patch known_flat(struct vec3 a, struct vec3 b, struct vec3 c, struct vec3 d)
{
    static const double knot[] = {0, 0, 1, 1};
    const struct vec3 corner[] = {a, b, c, d};
    struct patch p = {0};
    set_axis(&p.surface.u, 1, 2, knot);
    set_axis(&p.surface.v, 1, 2, knot);
    p.surface.pole = mem_alloc(4, sizeof *p.surface.pole);
    for (int i = 0; i < 4; i++)
        p.surface.pole[i] = (struct nurbs_pole){corner[i].x, corner[i].y, corner[i].z, 1};
    return p;
}

struct patch known_turned(int degree, size_t n, const double *knot_v, const double (*profile)[3])
{
    static const double knot_u[] = {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4};
    static const double x[] = {1, 1, 0, -1, -1, -1, 0, 1, 1}, y[] = {0, 1, 1, 1, 0, -1, -1, -1, 0};
    struct patch p = {0};
    set_axis(&p.surface.u, 2, 9, knot_u);
    set_axis(&p.surface.v, degree, n, knot_v);
    p.surface.pole = mem_alloc(9 * n, sizeof *p.surface.pole);
    for (size_t j = 0; j < n; j++)
        for (size_t i = 0; i < 9; i++) {
            double w = profile[j][2] * (i % 2 ? sqrt(0.5) : 1), r = profile[j][0];
            p.surface.pole[9 * j + i] =
                (struct nurbs_pole){w * r * x[i], w * r * y[i], w * profile[j][1], w};
        }
    return p;
}

struct patch known_cylinder(double radius, double height)
{
    static const double knot[] = {0, 0, 1, 1};
    const double profile[][3] = {{radius, 0, 1}, {radius, height, 1}};
    return known_turned(1, 2, knot, profile);
}

struct patch known_sphere(double r)
{
    static const double knot[] = {0, 0, 0, 1, 1, 2, 2, 2};
    const double h = sqrt(0.5);
    const double profile[][3] = {{0, -r, 1}, {r, -r, h}, {r, 0, 1}, {r, r, h}, {0, r, 1}};
    return known_turned(2, 5, knot, profile);
}

struct patch known_torus(double radius, double r)
{
    static const double knot[] = {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4};
    static const double x[] = {1, 1, 0, -1, -1, -1, 0, 1, 1}, y[] = {0, 1, 1, 1, 0, -1, -1, -1, 0};
    double profile[9][3];
    for (int i = 0; i < 9; i++) {
        profile[i][0] = radius + r * x[i];
        profile[i][1] = r * y[i];
        profile[i][2] = i % 2 ? sqrt(0.5) : 1;
    }
    return known_turned(2, 9, knot, profile);
}
