/* kdtree_ball - see kdtree.h: a ball that leaves the points. */
#include "math/kdtree.h"

#include "kdtree_parts.h"

/* What may be left of a gouge: far below any tolerance, far above rounding. */
static const double SLACK = 1e-6;

/* A ball on its way up from c, `h` so far. */
struct leaving {
    const struct kdtree *tree;
    struct vec3 c, up;
    double radius, inside2; /* of its centre: what is nearer has to be left */
    double h, limit;
    double at[3];             /* its centre */
    struct kdtree_touch last; /* the point left last */
};

/*
 * A point p keeps the centre c + h * up out of an interval of h: those with |c + h up - p| < R. Its
 * upper end, a root of a quadratic.
 */
static double height_of_leaving(const double p[3], struct vec3 c, struct vec3 up, double radius)
{
    struct vec3 d = vec_sub(vec(p[0], p[1], p[2]), c);
    double along = vec_dot(d, up);
    double across2 = vec_dot(d, d) - along * along, under2 = radius * radius - across2;

    return along + sqrt(under2 > 0 ? under2 : 0);
}

static void rise_to(struct leaving *l, double h)
{
    struct vec3 at = vec_along(l->c, h, l->up);

    l->h = h;
    l->at[0] = at.x;
    l->at[1] = at.y;
    l->at[2] = at.z;
}

static void meet_point(struct leaving *l, const struct kd_point *p)
{
    if (kd_distance2(p->c, l->at) < l->inside2) {
        rise_to(l, fmax(l->h, height_of_leaving(p->c, l->c, l->up, l->radius)));
        l->last = (struct kdtree_touch){1, {{p->c[0], p->c[1], p->c[2]}}};
    }
}

static void leave(struct leaving *l, size_t from, size_t to, size_t number)
{
    if (to - from <= KD_LEAF) {
        for (size_t i = from; i < to; i++)
            if (kd_distance2(l->tree->point[i].c, l->at) < l->inside2)
                meet_point(l, &l->tree->point[i]);
        return;
    }
    size_t middle = from + (to - from) / 2;
    const struct kd_box *half = &l->tree->box[2 * number];
    double first = kd_gap2(&half[0], l->at), second = kd_gap2(&half[1], l->at);
    bool left = first <= second;

    if ((left ? first : second) < l->inside2) {
        if (left)
            leave(l, from, middle, 2 * number);
        else
            leave(l, middle + 1, to, 2 * number + 1);
    }
    meet_point(l, &l->tree->point[middle]);
    /* It may have risen since. */
    if (l->h > l->limit || kd_gap2(&half[left], l->at) >= l->inside2)
        return;
    if (left)
        leave(l, middle + 1, to, 2 * number + 1);
    else
        leave(l, from, middle, 2 * number);
}

static struct leaving leaving_from(const struct kdtree *tree, struct vec3 c, struct vec3 up,
                                   double radius, double limit)
{
    double inside = radius - SLACK;

    return (struct leaving){
        tree, c, up, radius, inside > 0 ? inside * inside : 0, 0, limit, {c.x, c.y, c.z}, {.n = 0}};
}

/* One after the other, and the first again: it may be in the way once more. */
static void leave_these(struct leaving *l, const struct kdtree_touch *these)
{
    for (size_t i = 0; these->n > 0 && i <= these->n; i++) {
        struct vec3 p = these->p[i < these->n ? i : 0];
        meet_point(l, &(struct kd_point){{p.x, p.y, p.z}, 0});
    }
}

double kdtree_leave_these(const struct kdtree_touch *these, struct vec3 c, struct vec3 up,
                          double radius)
{
    struct leaving l = leaving_from(NULL, c, up, radius, HUGE_VAL);

    leave_these(&l, these);
    return l.h;
}

double kdtree_leave(const struct kdtree *tree, struct vec3 c, struct vec3 up, double radius,
                    double limit, struct kdtree_touch *touch)
{
    struct leaving l = leaving_from(tree, c, up, radius, limit);
    double before;

    if (tree->n == 0)
        return 0;
    if (touch)
        leave_these(&l, touch);
    /* What is left by one point may lie in another's interval again. */
    do {
        before = l.h;
        leave(&l, 0, tree->n, 1);
    } while (l.h > before && l.h <= limit);
    if (touch)
        *touch = l.last;
    return l.h;
}

/* How far an upright line through c passes by a box, squared. */
static double beside2(const struct kd_box *box, struct vec3 c)
{
    double left = box->low[0] - c.x, right = c.x - box->high[0];
    double front = box->low[1] - c.y, back = c.y - box->high[1];
    double x = left > right ? left : right, y = front > back ? front : back;

    return (x > 0 ? x * x : 0) + (y > 0 ? y * y : 0);
}

/* The last point that a ball leaves on its way up from c. */
struct last {
    const struct kdtree *tree;
    struct vec3 c, up;
    double radius, inside;
    bool upright;
    double h;
};

/* How far the line up through c passes by a box, at least. */
static double line_distance(const struct last *l, const struct kd_box *box)
{
    struct vec3 half =
        vec(box->high[0] - box->low[0], box->high[1] - box->low[1], box->high[2] - box->low[2]);
    struct vec3 middle = vec_along(vec(box->low[0], box->low[1], box->low[2]), 0.5, half);

    if (l->upright)
        return sqrt(beside2(box, l->c));
    return vec_length(vec_reject(vec_sub(middle, l->c), l->up)) - vec_length(half) / 2;
}

/* No point in the box is left later than this. */
static double latest_leaving(const struct last *l, const struct kd_box *box)
{
    struct vec3 far =
        vec(l->up.x > 0 ? box->high[0] : box->low[0], l->up.y > 0 ? box->high[1] : box->low[1],
            l->up.z > 0 ? box->high[2] : box->low[2]);
    double across = fmax(0, line_distance(l, box));

    if (across * (1 - 1e-12) >= l->inside)
        return -INFINITY;
    return vec_dot(vec_sub(far, l->c), l->up) + sqrt(l->radius * l->radius - across * across) +
           1e-12 * l->radius;
}

static void meet_last(struct last *l, const struct kd_point *p)
{
    struct vec3 d = vec_sub(vec(p->c[0], p->c[1], p->c[2]), l->c);

    if (vec_length(vec_reject(d, l->up)) < l->inside)
        l->h = fmax(l->h, height_of_leaving(p->c, l->c, l->up, l->radius));
}

static void find_last(struct last *l, size_t from, size_t to, size_t number)
{
    if (to - from <= KD_LEAF) {
        for (size_t i = from; i < to; i++)
            meet_last(l, &l->tree->point[i]);
        return;
    }
    size_t middle = from + (to - from) / 2;
    const struct kd_box *half = &l->tree->box[2 * number];
    double first = latest_leaving(l, &half[0]), second = latest_leaving(l, &half[1]);
    bool left = first >= second;

    meet_last(l, &l->tree->point[middle]);
    for (int turn = 0; turn < 2; turn++, left = !left) {
        if ((left ? first : second) <= l->h)
            continue;
        if (left)
            find_last(l, from, middle, 2 * number);
        else
            find_last(l, middle + 1, to, 2 * number + 1);
    }
}

double kdtree_rise(const struct kdtree *tree, struct vec3 c, struct vec3 up, double radius)
{
    struct last l = {tree, c, up, radius, radius - SLACK, up.x == 0 && up.y == 0, 0};

    if (tree->n > 0 && l.inside > 0)
        find_last(&l, 0, tree->n, 1);
    return l.h;
}

/* A column with its foot at c, upright. */
struct column {
    const struct kdtree *tree;
    struct vec3 c;
    double radius2;
};

static bool stands_in(const struct column *l, const struct kd_box *box)
{
    return box->high[2] > l->c.z && beside2(box, l->c) < l->radius2;
}

static bool is_above(const struct column *l, const struct kd_point *p)
{
    double x = p->c[0] - l->c.x, y = p->c[1] - l->c.y;

    return p->c[2] > l->c.z && x * x + y * y < l->radius2;
}

static bool any_above(const struct column *l, size_t from, size_t to, size_t number)
{
    if (to - from <= KD_LEAF) {
        for (size_t i = from; i < to; i++)
            if (is_above(l, &l->tree->point[i]))
                return true;
        return false;
    }
    size_t middle = from + (to - from) / 2;
    const struct kd_box *half = &l->tree->box[2 * number];

    return is_above(l, &l->tree->point[middle]) ||
           (stands_in(l, &half[0]) && any_above(l, from, middle, 2 * number)) ||
           (stands_in(l, &half[1]) && any_above(l, middle + 1, to, 2 * number + 1));
}

bool kdtree_any_above(const struct kdtree *tree, struct vec3 c, double radius)
{
    struct column column = {tree, c, radius * radius};

    return radius > 0 && tree->n > 0 && any_above(&column, 0, tree->n, 1);
}
