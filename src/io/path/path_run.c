/* path_run - see path_run.h. */
#include "io/path/path_run.h"

static const double SAME = 1e-5; /* mm: points that are nearer are in one place */

struct run path_run_read(const struct path *path, size_t from, size_t to)
{
    double ball = path->head.track == TRACK_CONTACT ? 0 : path_ball(path);
    double up = path->head.track == TRACK_CENTRE ? 0 : 1; /* radii from the tracked point */
    struct run run = {.radius = ball > 0 ? ball : 0};

    for (size_t i = from; i < to; i++) {
        const struct path_item *item = &path->item.item[i];
        struct run_point p = {.axis = item->to.a, .given = true};

        p.ball = vec_along(item->to.p, up * run.radius, item->to.a);
        p.tip = vec_along(item->to.p, (up - 1) * run.radius, item->to.a);
        if (item->touches) {
            p.contact = path->contact.item[item->contact].p;
            p.normal = path->contact.item[item->contact].n;
        }
        *array_push(&run) = p;
    }
    return run;
}

/* The next point at feed from an item on, either way, that is somewhere else; the item itself where
 * there is none. */
static size_t next_point(const struct path *path, size_t at, bool before)
{
    const struct path_item *item = path->item.item;
    size_t i = at;

    while (before ? i > 0 && !item[i].rapid : i + 1 < path->item.n) {
        i = before ? i - 1 : i + 1;
        if (item[i].kind == PATH_PASS)
            continue;
        if (item[i].kind != PATH_POINT || (item[i].rapid && !before))
            break;
        if (vec_distance(item[i].to.p, item[at].to.p) > SAME)
            return i;
    }
    return at;
}

struct vec3 path_run_direction(const struct path *path, size_t at, bool before)
{
    const struct path_item *item = path->item.item;
    size_t next = next_point(path, at, before), after = next_point(path, next, before);
    struct vec3 a = vec_sub(item[next].to.p, item[at].to.p);
    struct vec3 b = vec_sub(item[after].to.p, item[next].to.p);
    double la = vec_length(a), lb = vec_length(b);

    if (next == at)
        return vec(0, 0, 0);
    struct vec3 t = vec_scale(1 / la, a); /* at the end of a parabola */
    if (after != next && vec_dot(a, b) > 0)
        t = vec_along(t, la / (la + lb), vec_sub(t, vec_scale(1 / lb, b)));
    return vec_scale(before ? -1 : 1, vec_unit(t));
}

struct vec3 path_run_normal(const struct path *path, size_t at)
{
    const struct path_item *item = path->item.item;
    size_t next = at + 1;

    while (next < path->item.n && item[next].kind == PATH_PASS)
        next++;
    if (item[at].touches)
        return path->contact.item[item[at].contact].n;
    if (next < path->item.n && item[next].kind == PATH_POINT && item[next].touches &&
        vec_distance(item[next].to.p, item[at].to.p) < SAME)
        return path->contact.item[item[next].contact].n;
    return vec(0, 0, 0);
}
