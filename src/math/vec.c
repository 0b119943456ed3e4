/* vec - see vec.h. */
#include "math/vec.h"

#include "base/array.h"

void vec3s_add(struct vec3s *to, const struct vec3 *point, size_t n)
{
    array_reserve(to, to->n + n);
    for (size_t i = 0; i < n; i++)
        to->item[to->n++] = point[i];
}

struct vec3 vec_turn(struct vec3 a, struct vec3 axis, double angle)
{
    struct sine_cosine turn = elementary_sine_cosine(angle);

    return vec_turn_by(a, axis, turn.cosine, turn.sine);
}

struct great_circle great_circle_of(struct vec3 a, struct vec3 b)
{
    double angle = vec_angle(a, b);

    return (struct great_circle){a, b, angle, sin(angle)};
}

struct vec3 great_circle_at(const struct great_circle *c, double s)
{
    if (c->angle < 1e-6) /* the chord: off the circle by less than 1e-13 */
        return vec_unit(vec_mix(c->a, c->b, s));
    if (c->sine < 1e-9) /* opposite: any great circle will do, but the same one always */
        return vec_turn(c->a, vec_perpendicular(c->a), s * c->angle);
    double wa = sin((1 - s) * c->angle) / c->sine, wb = sin(s * c->angle) / c->sine;
    return vec_along(vec_scale(wa, c->a), wb, c->b);
}

struct vec3 vec_slerp(struct vec3 a, struct vec3 b, double s)
{
    struct great_circle circle = great_circle_of(a, b);

    return great_circle_at(&circle, s);
}

struct vec3 vec_perpendicular(struct vec3 a)
{
    double x = fabs(a.x), y = fabs(a.y), z = fabs(a.z);
    struct vec3 other = x <= y && x <= z ? vec(1, 0, 0) : y <= z ? vec(0, 1, 0) : vec(0, 0, 1);
    return vec_unit(vec_cross(a, other));
}

int vec_compare(const void *a, const void *b)
{
    const struct vec3 *p = a, *q = b;

    if (p->x != q->x)
        return p->x < q->x ? -1 : 1;
    if (p->y != q->y)
        return p->y < q->y ? -1 : 1;
    return (p->z > q->z) - (p->z < q->z);
}
