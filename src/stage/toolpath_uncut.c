/* toolpath_uncut - what a path leaves standing; see toolpath.h. */
#include <stdlib.h>

#include "math/kdtree.h"
#include "base/parallel.h"
#include "stage/toolpath.h"

struct job {
    const struct toolpath *t;
    struct kdtree *ball; /* where its centre is at the points of the path */
    bool *stays;         /* at each place: more than may */
};

/* No ball comes nearer to the place than this above it. */
static bool stays(const struct job *job, const struct toolpath_stand *s, double height)
{
    struct vec3 at = s->stand.contact;

    return s->stand.height > height && !kdtree_any_beside(job->ball, at, at, s->offset + height);
}

static void look(void *context, size_t from, size_t to)
{
    struct job *job = context;

    for (size_t i = from; i < to; i++)
        job->stays[i] = stays(job, &job->t->stand.item[i], job->t->lift.stands);
}

/* The highest of what stays. */
static void find_highest(struct toolpath *t, const struct job *job)
{
    for (size_t i = 0; i < t->stand.n; i++) {
        const struct toolpath_stand *s = &t->stand.item[i];
        struct vec3 at = s->stand.contact;
        size_t nearest;
        t->standing += job->stays[i];
        if (!job->stays[i] || !stays(job, s, t->stands))
            continue;
        double far = s->offset + s->stand.height;
        t->stands = kdtree_nearest_segment(job->ball, at, at, far, &nearest) - s->offset;
        t->stands_at = at;
        t->stands_pass = s->pass;
    }
}

void toolpath_stand(struct toolpath *t)
{
    struct job job = {.t = t};

    if (t->stand.n == 0)
        return;
    job.ball = kdtree_new_by(t->ball.item, t->ball.n, t->threads);
    array_free(&t->ball);
    job.stays = mem_alloc(t->stand.n, sizeof *job.stays);
    parallel_for(t->threads, t->stand.n, look, &job);
    find_highest(t, &job);
    free(job.stays);
    kdtree_free(job.ball);
    array_free(&t->stand);
}
