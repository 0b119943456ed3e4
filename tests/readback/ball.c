#include "ball.h"

#include <stdlib.h>

#define STEP 0.2   /* way of the ball between places that are always looked at, mm */
#define LEAST 0.01 /* and as close as it gets where it may be deep, mm */

struct search {
    const struct nc_motion *nc_motion;
    const struct surface *surface;
    double radius;
    struct depth depth;
};

static struct vec3 ball_at(const struct search *search, const struct nc_piece *piece, double s)
{
    struct nc_motion_pose pose = nc_motion_at(search->nc_motion, piece, s);
    double up = search->nc_motion->track == NC_MOTION_TIP ? search->radius : 0;
    return vec_along(pose.p, up, pose.a);
}

static double look(struct search *search, size_t index, struct vec3 ball)
{
    double depth = search->radius - search->surface->distance(search->surface->data, ball);
    if (depth > search->depth.worst)
        search->depth = (struct depth){depth, ball, index};
    return depth;
}

/* No place between two can be deeper than half the sum of their depths and the way between. */
static void between(struct search *search, size_t index, double s0, struct vec3 a, double da,
                    double s1, struct vec3 b, double db, int level)
{
    const struct nc_piece *piece = &search->nc_motion->piece.item[index];
    double s = (s0 + s1) / 2;
    struct vec3 m = ball_at(search, piece, s);
    double way = vec_distance(a, m) + vec_distance(m, b);
    bool curved = level < 3 && piece->shape != SHAPE_LINE;
    if ((way < LEAST || (way < STEP && (da + db + way) / 2 <= search->depth.worst)) && !curved)
        return;
    double dm = look(search, index, m);
    if (level > 20 || (!curved && (da + dm + way) / 2 < search->depth.worst &&
                       (dm + db + way) / 2 < search->depth.worst))
        return;
    between(search, index, s0, a, da, s, m, dm, level + 1);
    between(search, index, s, m, dm, s1, b, db, level + 1);
}

struct depth ball_depth(const struct nc_motion *nc_motion, double radius,
                        const struct surface *surface)
{
    struct search search = {nc_motion, surface, radius, {-HUGE_VAL, {0, 0, 0}, 0}};
    for (size_t i = 0; i < nc_motion->piece.n; i++) {
        const struct nc_piece *piece = &nc_motion->piece.item[i];
        struct vec3 a = ball_at(&search, piece, 0), b = ball_at(&search, piece, 1);
        double da = look(&search, i, a), db = look(&search, i, b);
        between(&search, i, 0, a, da, 1, b, db, 0);
    }
    return search.depth;
}

struct depth ball_nodes(const struct nc_motion *nc_motion, double radius,
                        const struct surface *surface)
{
    struct search search = {nc_motion, surface, radius, {-HUGE_VAL, {0, 0, 0}, 0}};
    for (size_t i = 0; i < nc_motion->piece.n; i++)
        if (nc_motion->piece.item[i].touches)
            look(&search, i, ball_at(&search, &nc_motion->piece.item[i], 1));
    return search.depth;
}
