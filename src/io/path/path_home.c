/* path_home - see path_home.h. */
#include "path_home.h"

#include <math.h>

#define AT(p) (p)->error, (p)->path->name, (p)->apt.line

static int go_at_rapid(struct path_parse *p, struct pose to)
{
    if (p->cycling)
        return error_at(AT(p), "found %.20s among the holes of a CYCLE, expected CYCLE/OFF first",
                        p->apt.word);
    p->rapid = true;
    p->axis = to.a;
    return path_move_to(p, to);
}

int path_read_gohome(struct path_parse *p)
{
    size_t n = p->apt.argument.n;
    double v[6];
    if (n == 0 && p->home.known)
        return go_at_rapid(p, p->home.from);
    if (n == 0) {
        path_count_unknown(p, "GOHOME");
        return 0;
    }
    if (n != 3 && n != 6)
        return error_at(AT(p), "found %zu numbers in GOHOME, expected three or six, or none", n);
    if (path_numbers(p, 0, n, v, n == 3 ? "x, y, z" : "x, y, z, i, j, k") < 0)
        return -1;
    struct vec3 axis = p->axis;
    if (n == 6 && path_direction(p, v + 3, "a tool axis", &axis) < 0)
        return -1;
    return go_at_rapid(p, (struct pose){path_point_of(p, v), axis});
}

int path_read_retrct(struct path_parse *p)
{
    const struct home_parse *h = &p->home;
    double along = vec_dot(h->normal, p->at.a);
    if (!h->cleared || !p->moved || along < 1e-3) {
        path_count_unknown(p, "RETRCT");
        return 0;
    }
    double way = (h->height - vec_dot(h->normal, p->at.p)) / along;
    if (way <= 0)
        return 0;
    return go_at_rapid(p, (struct pose){vec_along(p->at.p, way, p->at.a), p->at.a});
}

int path_read_clearp(struct path_parse *p)
{
    struct home_parse *h = &p->home;
    size_t n = p->apt.argument.n, first = apt_is(&p->apt, 0, "XYPLAN");
    double v[4] = {0, 0, 1};
    h->cleared = false;
    if (n - first != 1 && n != 4) {
        path_count_unknown(p, p->apt.word);
        return 0;
    }
    if (n == 4 ? path_numbers(p, 0, 4, v, "a, b, c, d of a plane") < 0
               : path_numbers(p, first, 1, v + 3, "z of the clearance plane") < 0)
        return -1;
    double length = vec_length(vec(v[0], v[1], v[2]));
    if (path_direction(p, v, "a plane's normal", &h->normal) < 0)
        return -1;
    double foot[3]; /* a point of the plane, in the coordinates of the stream */
    for (int i = 0; i < 3; i++)
        foot[i] = v[i] * v[3] / (length * length);
    h->height = vec_dot(h->normal, path_point_of(p, foot));
    h->cleared = true;
    return 0;
}

int path_read_rotabl(struct path_parse *p)
{
    bool any = false, turns = false;
    for (size_t i = 0; i < p->apt.argument.n; i++) {
        any = any || p->apt.argument.item[i].is_number;
        turns = turns || (p->apt.argument.item[i].is_number && p->apt.argument.item[i].number != 0);
    }
    if (any && !turns)
        return 0;
    return error_at(AT(p),
                    "found %.20s, which turns the table by itself, expected the tool axis in GOTO: "
                    "passing over it would send the tool elsewhere",
                    p->apt.word);
}
