/* toolpath_stand - what a path leaves standing; see toolpath.h. */
#include <stdlib.h>

#include "buckets.h"
#include "parallel.h"
#include "toolpath.h"

/* Where the ball's centre is at the points of the path, and what is looked for there. */
struct job {
    const struct toolpath *t;
    struct buckets ball;
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

/* How far apart they are in the mean, seen from above. */
static double spacing_of(const struct vec3s *ball)
{
    struct vec3 low = ball->item[0], high = low;

    for (size_t i = 0; i < ball->n; i++) {
        struct vec3 p = ball->item[i];
        low = vec(fmin(low.x, p.x), fmin(low.y, p.y), 0);
        high = vec(fmax(high.x, p.x), fmax(high.y, p.y), 0);
    }
    double wide = high.x - low.x, deep = high.y - low.y, n = (double)ball->n;
    return fmax(1e-3, fmax(sqrt(wide * deep / n), fmax(wide, deep) / n));
}

static void measure(void *context, size_t from, size_t to)
{
    struct job *job = context;

    for (size_t i = from; i < to; i++) {
        const struct toolpath_stand *s = &job->t->stand.item[i];
        uint32_t nearest;
        double distance2;
        buckets_nearest(&job->ball, s->stand.contact, 1, &nearest, &distance2);
        job->height[i] = fmin(s->stand.height, sqrt(distance2) - s->offset);
    }
}

void toolpath_stand(struct toolpath *t)
{
    struct job job = {.t = t};
    struct vec3s ball = balls_of(t);
    struct error error;

    if (t->stand.n > 0 && buckets_make(ball.item, ball.n, spacing_of(&ball), t->threads, &job.ball,
                                       &error) == 0) {
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
        buckets_free(&job.ball);
    }
    array_free(&ball);
    array_free(&t->stand);
}
