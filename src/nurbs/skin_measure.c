/* skin_measure - see skin_measure.h. */
#include "nurbs/skin_measure.h"

#include <stdlib.h>

#include "math/elementary.h"
#include "base/parallel.h"
#include "patch_measure.h"

/* By the triangles' area: how far they may be off. */
static const double MOST_OFF = 0.2;

struct measuring {
    const struct patches *patches;
    const int *body;    /* [sheet] */
    const double *area; /* [sheet] of its triangles */
    struct vec3 origin;
    struct patch_measure *result;
};

static void measure_some(void *context, size_t from, size_t to)
{
    struct measuring *m = context;
    for (size_t i = from; i < to; i++)
        if (m->body[i] >= 0)
            m->result[i] = patch_measure(&m->patches->item[i], sqrt(m->area[i]), m->origin);
}

static double *areas_of(const struct patch_mesh *q)
{
    double *area = mem_alloc(q->sheets + 1, sizeof *area);
    for (size_t i = 0; i < q->face.n; i++) {
        const struct patch_mesh_vertex *v = q->vertex.item;
        const int *c = q->face.item[i].v;
        struct vec3 a = vec_sub(v[c[1]].point, v[c[0]].point);
        area[q->sheet.item[i]] +=
            vec_length(vec_cross(a, vec_sub(v[c[2]].point, v[c[0]].point))) / 2;
    }
    return area;
}

/* Sums up the surfaces of each body; `exact` stays where all of them are sound. */
static void sum_up(const struct patch_mesh *q, const struct measuring *m, struct skin *skin,
                   struct patch_measure *sum)
{
    for (size_t i = 0; i < skin->body.n; i++)
        skin->body.item[i].exact = !skin->body.item[i].shared;
    for (size_t i = 0; i < q->sheets; i++) {
        if (m->body[i] < 0)
            continue;
        struct skin_body *b = &skin->body.item[m->body[i]];
        b->exact = b->exact && m->result[i].sound;
        sum[m->body[i]].area += m->result[i].area;
        sum[m->body[i]].volume += (q->flipped[i] ? -1 : 1) * m->result[i].volume;
    }
}

void skin_measure(struct skin *skin, const struct patch_mesh *q, const struct patches *patches,
                  int threads)
{
    double *area = areas_of(q);
    struct measuring m = {.patches = patches, .body = skin->body_of, .area = area};
    struct patch_measure *sum = mem_alloc(skin->body.n + 1, sizeof *sum);
    m.result = mem_alloc(q->sheets + 1, sizeof *m.result);
    m.origin = q->vertex.n > 0 ? q->vertex.item[0].point : vec(0, 0, 0);
    parallel_for(threads, q->sheets, measure_some, &m);
    sum_up(q, &m, skin, sum);
    for (size_t i = 0; i < skin->body.n; i++) {
        struct skin_body *b = &skin->body.item[i];
        b->exact = b->exact && fabs(sum[i].area - b->area) <= MOST_OFF * b->area;
        if (!b->exact)
            continue;
        b->area = sum[i].area;
        b->volume = sum[i].volume;
    }
    free(area);
    free(sum);
    free(m.result);
}
