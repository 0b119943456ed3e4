/* toolpath_stand - what a path leaves standing; see toolpath.h. */
#include <stdlib.h>

#include "kdtree.h"
#include "parallel.h"
#include "toolpath.h"

/* Where the ball's centre is at the points of the path, and what is looked for there. */
struct job {
    const struct toolpath *t;
    struct kdtree *ball;
    double *height; /* of what is left at each place, mm */
};

static struct vec3s balls_of(const struct toolpath *t)
{
    struct vec3s ball = {0};

    for (size_t i = 0; i < t->path->item.n; i++) {
        const struct path_item *item = &t->path->item.item[i];
        if (item->kind == PATH_POINT && !item->rapid)
            *array_push(&ball) = vec_along(item->to.p, t->rule.radius, item->to.a);
    }
    return ball;
}

static void measure(void *context, size_t from, size_t to)
{
    struct job *job = context;

    for (size_t i = from; i < to; i++) {
        const struct toolpath_stand *s = &job->t->stand.item[i];
        struct vec3 at = s->stand.contact;
        size_t nearest;
        double far = s->offset + s->stand.height;
        job->height[i] = kdtree_nearest_segment(job->ball, at, at, far, &nearest) - s->offset;
    }
}

void toolpath_stand(struct toolpath *t)
{
    struct job job = {.t = t};

    if (t->stand.n == 0)
        return;
    struct vec3s ball = balls_of(t);
    job.ball = kdtree_new_by(ball.item, ball.n, t->threads);
    array_free(&ball);
    job.height = mem_alloc(t->stand.n, sizeof *job.height);
    parallel_for(t->threads, t->stand.n, measure, &job);
    for (size_t i = 0; i < t->stand.n; i++) {
        t->standing += job.height[i] > t->lift.stands;
        if (job.height[i] > fmax(t->lift.stands, t->stands)) {
            t->stands = job.height[i];
            t->stands_at = t->stand.item[i].stand.contact;
            t->stands_pass = t->stand.item[i].pass;
        }
    }
    free(job.height);
    kdtree_free(job.ball);
    array_free(&t->stand);
}
