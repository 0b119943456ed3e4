#include "shapes.h"

struct vec3 shape_sphere(double x, double y, struct vec3 *normal)
{
    struct vec3 p = vec(x, y, sqrt(2500 - x * x - y * y));

    *normal = vec_scale(1 / 50.0, p);
    return p;
}

struct vec3 shape_cylinder(double x, double y, struct vec3 *normal)
{
    double z = sqrt(900 - y * y);

    *normal = vec(0, y / 30, z / 30);
    return vec(x, y, z);
}

/* z = f(x / 44) g(y / 51) with cubics f and g. */
struct vec3 shape_wave(double x, double y, struct vec3 *normal)
{
    double u = x / 44, v = y / 51;
    double f = 1 + 2 * u - 7 * u * u + 5 * u * u * u, df = (2 - 14 * u + 15 * u * u) / 44;
    double g = 10 - 12 * v + 20 * v * v - 8 * v * v * v, dg = (-12 + 40 * v - 24 * v * v) / 51;

    *normal = vec_unit(vec(-df * g, -f * dg, 1));
    return vec(x, y, f * g);
}

struct mesh shape_grid(shape_point *at, double x0, double y0, double x1, double y1, int columns,
                       int rows)
{
    struct mesh mesh = {0};

    for (int j = 0; j <= rows; j++) {
        for (int i = 0; i <= columns; i++) {
            struct vec3 normal;
            struct vec3 p = at(x0 + (x1 - x0) * i / columns, y0 + (y1 - y0) * j / rows, &normal);
            *array_push(&mesh.vertex) = p;
            *array_push(&mesh.normal) = normal;
        }
    }
    for (int j = 0; j < rows; j++) {
        for (int i = 0; i < columns; i++) {
            int a = j * (columns + 1) + i, b = a + columns + 1;
            *array_push(&mesh.face) = (struct face){{a, a + 1, b + 1}};
            *array_push(&mesh.face) = (struct face){{a, b + 1, b}};
        }
    }
    return mesh;
}

struct mesh shape_cube(double size)
{
    static const int side[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                   {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    struct mesh mesh = {0};

    for (int i = 0; i < 8; i++)
        *array_push(&mesh.vertex) = vec(size * (i & 1), size * (i >> 1 & 1), size * (i >> 2));
    for (int i = 0; i < 6; i++) {
        const int *s = side[i];
        *array_push(&mesh.face) = (struct face){{s[0], s[1], s[2]}};
        *array_push(&mesh.face) = (struct face){{s[0], s[2], s[3]}};
    }
    return mesh;
}

struct mesh shape_ball(double radius, int parallels, int meridians)
{
    struct mesh mesh = {0};

    *array_push(&mesh.normal) = vec(0, 0, 1);
    for (int i = 1; i < parallels; i++) {
        for (int k = 0; k < meridians; k++) {
            double a = PI * i / parallels, b = 2 * PI * k / meridians;
            *array_push(&mesh.normal) = vec(sin(a) * cos(b), sin(a) * sin(b), cos(a));
        }
    }
    *array_push(&mesh.normal) = vec(0, 0, -1);
    for (size_t i = 0; i < mesh.normal.n; i++)
        *array_push(&mesh.vertex) = vec_scale(radius, mesh.normal.item[i]);
    int last = (int)mesh.vertex.n - 1;
    for (int k = 0; k < meridians; k++) {
        int next = (k + 1) % meridians;
        *array_push(&mesh.face) = (struct face){{0, 1 + k, 1 + next}};
        for (int i = 0; i + 2 < parallels; i++) {
            int a = 1 + i * meridians, b = a + meridians;
            *array_push(&mesh.face) = (struct face){{a + k, b + k, b + next}};
            *array_push(&mesh.face) = (struct face){{a + k, b + next, a + next}};
        }
        *array_push(&mesh.face) =
            (struct face){{last, last - meridians + next, last - meridians + k}};
    }
    return mesh;
}
