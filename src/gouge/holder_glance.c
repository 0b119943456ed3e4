/* holder_glance - see holder_glance.h. */
#include "holder_glance.h"

static const double OFF = 0.5; /* of how far the middle of a part is off its ends' straight way, and
                                  twice what an even curve is on half of it */

enum { MIDDLE = GLANCE_PARTS };

void holder_glance_measure(struct holder_glance *g)
{
    const struct pose *at = g->pose;
    double lever = holder_reach(g->holder), step = 0, turn = 0, off = 0, off_axis = 0;

    g->moved = g->part_moved = 0;
    for (int i = 0; i < GLANCE_POSES; i++)
        g->moved = fmax(g->moved, vec_distance(at[i].p, at[MIDDLE].p) +
                                      lever * vec_distance(at[i].a, at[MIDDLE].a));
    for (int i = 0; i + 1 < GLANCE_POSES; i++) {
        double along = vec_distance(at[i].p, at[i + 1].p), by = vec_distance(at[i].a, at[i + 1].a);
        g->part_moved = fmax(g->part_moved, along + lever * by);
        step = fmax(step, along);
        turn = fmax(turn, by);
    }
    for (int i = 0; i + 2 < GLANCE_POSES; i += 2) {
        off = fmax(off, OFF * vec_distance(at[i + 1].p, vec_mix(at[i].p, at[i + 2].p, 0.5)));
        off_axis =
            fmax(off_axis, OFF * vec_distance(at[i + 1].a, vec_mix(at[i].a, at[i + 2].a, 0.5)));
    }
    g->moved += off + lever * off_axis;
    g->part_moved += off + lever * off_axis;
    /* h = (p - c).a and r >= (p - c).w - h (w.a), which are bilinear in centre and axis */
    lever += 2 * g->part_moved;
    double along = step * turn / 4 + off + lever * off_axis;
    g->bent = along + off + (step + lever * turn) * turn / 4 + turn * along + lever * off_axis;
}

/* Beside the axis: how far out, and how high. */
struct place {
    double r, h;
};

static struct place nearest_on(struct place a, struct place b, struct place p)
{
    double dr = b.r - a.r, dh = b.h - a.h, l2 = dr * dr + dh * dh;
    double s = l2 > 0 ? (dr * (p.r - a.r) + dh * (p.h - a.h)) / l2 : 0;

    s = s < 0 ? 0 : s > 1 ? 1 : s;
    return (struct place){a.r + s * dr, a.h + s * dh};
}

static double apart(struct place a, struct place b)
{
    double r = a.r - b.r, h = a.h - b.h;

    return sqrt(r * r + h * h);
}

/* The place of a part of the holder that is nearest to one outside it; false: that is inside. */
static bool nearest_of_part(const struct holder_part *part, double height, struct place p,
                            struct place *nearest)
{
    const struct place low = {part->low, height}, high = {part->high, height + part->length};
    double share = (p.h - height) / part->length;
    struct place axis = {0, share < 0 ? low.h : high.h}, rim = share < 0 ? low : high;
    struct place end = nearest_on(axis, rim, p);

    if (share >= 0 && share <= 1 && p.r <= part->low + share * (part->high - part->low))
        return false;
    *nearest = nearest_on(low, high, p);
    if (apart(p, end) < apart(p, *nearest))
        *nearest = end;
    return true;
}

/* How much less g.(r, h) of a point is in a pose than at `from`, at most; w: the way from the axis
 * to it there. */
static double change_at(const struct pose *pose, struct place from, struct place g, struct vec3 w,
                        struct vec3 p)
{
    struct vec3 d = vec_sub(p, pose->p);
    double h = vec_dot(d, pose->a), r = vec_dot(d, w) - h * vec_dot(w, pose->a);

    return g.r * (r - from.r) + g.h * (h - from.h);
}

/* The point may come near between the pose before this one and the next. */
static bool may_come_by(const struct holder_glance *glance, const struct pose *pose, struct vec3 p)
{
    struct vec3 d = vec_sub(p, pose->p);
    double h = vec_dot(d, pose->a), height = 0;
    struct vec3 out = vec_along(d, -h, pose->a), w = vec_unit(out);
    const struct place at = {vec_length(out), h};

    for (int k = 0; k < glance->holder->n; k++) {
        const struct holder_part *part = &glance->holder->part[k];
        struct place near;
        if (!nearest_of_part(part, height, at, &near))
            return true;
        double away = apart(at, near);
        if (!(away > 0))
            return true;
        struct place g = {(at.r - near.r) / away, (at.h - near.h) / away};
        double change = fmin(change_at(pose - 1, at, g, w, p), change_at(pose + 1, at, g, w, p));
        if (away + fmin(change, 0) - glance->bent < glance->least)
            return true;
        height += part->length;
    }
    return false;
}

static bool may_come_near(const struct holder_glance *g, struct vec3 p)
{
    const struct pose *middle = &g->pose[MIDDLE];
    double far = g->least + g->moved, part_far = g->least + g->part_moved;

    if (holder_distance_below(g->holder, middle->p, middle->a, p, far) >= far)
        return false;
    for (int i = 1; i < GLANCE_POSES; i += 2) {
        const struct pose *pose = &g->pose[i];
        if (holder_distance_below(g->holder, pose->p, pose->a, p, part_far) < part_far &&
            may_come_by(g, pose, p))
            return true;
    }
    return false;
}

/* A glance over all guard points. */
struct gathering {
    const struct holder_glance *glance;
    struct vec3s *near;
};

static bool is_box_near(const struct holder_glance *g, const struct pose *pose, struct vec3 middle,
                        struct vec3 half, double far)
{
    return holder_bound_below(g->holder, pose->p, pose->a, middle, half, far) < far;
}

static bool look_into(void *context, int depth, struct vec3 middle, struct vec3 half)
{
    const struct holder_glance *g = ((struct gathering *)context)->glance;

    (void)depth;
    if (!is_box_near(g, &g->pose[MIDDLE], middle, half, g->least + g->moved))
        return false;
    for (int i = 1; i < GLANCE_POSES; i += 2)
        if (is_box_near(g, &g->pose[i], middle, half, g->least + g->part_moved))
            return true;
    return false;
}

static void look_at(void *context, int depth, struct vec3 p, size_t index)
{
    struct gathering *g = context;

    (void)depth;
    (void)index;
    if (may_come_near(g->glance, p))
        *array_push(g->near) = p;
}

void holder_glance_gather(const struct gouge_check *guard, const struct holder_glance *glance,
                          struct vec3s *near)
{
    struct gathering gathering = {glance, near};
    const struct kdtree_visitor visitor = {look_into, look_at, &gathering};

    gouge_visit(guard, glance->pose[MIDDLE].p, &visitor);
}

void holder_glance_choose(const struct holder_glance *glance, size_t from, size_t to,
                          struct vec3s *near)
{
    for (size_t i = from; i < to; i++) {
        struct vec3 p = near->item[i];
        if (may_come_near(glance, p))
            *array_push(near) = p;
    }
}
