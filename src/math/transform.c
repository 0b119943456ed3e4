/* transform - see transform.h. */
#include "math/transform.h"

struct transform transform_identity(void)
{
    return transform_scale(1);
}

struct transform transform_scale(double s)
{
    return (struct transform){{{s, 0, 0, 0}, {0, s, 0, 0}, {0, 0, s, 0}, {0, 0, 0, 1}}};
}

struct transform transform_shift(struct vec3 d)
{
    return (struct transform){{{1, 0, 0, d.x}, {0, 1, 0, d.y}, {0, 0, 1, d.z}, {0, 0, 0, 1}}};
}

struct transform transform_product(struct transform a, struct transform b)
{
    struct transform c;
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++) {
            c.m[i][j] = 0;
            for (int k = 0; k < 4; k++)
                c.m[i][j] += a.m[i][k] * b.m[k][j];
        }
    return c;
}

struct vec3 transform_point(const struct transform *t, struct vec3 p)
{
    double c[3];
    for (int i = 0; i < 3; i++)
        c[i] = t->m[i][0] * p.x + t->m[i][1] * p.y + t->m[i][2] * p.z + t->m[i][3];
    return vec(c[0], c[1], c[2]);
}

void transform_points(const struct transform *t, struct vec3 *point, size_t n)
{
    for (size_t i = 0; i < n; i++)
        point[i] = transform_point(t, point[i]);
}

bool transform_is_identity(const struct transform *t)
{
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            if (t->m[i][j] != (i == j ? 1 : 0))
                return false;
    return true;
}

double transform_determinant(const struct transform *t)
{
    struct vec3 row[3];
    for (int i = 0; i < 3; i++)
        row[i] = vec(t->m[i][0], t->m[i][1], t->m[i][2]);
    return vec_dot(row[0], vec_cross(row[1], row[2]));
}
