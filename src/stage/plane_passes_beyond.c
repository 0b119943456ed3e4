/* plane_passes_beyond - the strips of planes run out to the border of the scan; see plane_passes.h.
 */
#include <stdlib.h>

#include "base/cli.h"
#include "stage/path_options.h"
#include "base/parallel.h"
#include "stage/plane_passes.h"
#include "toolpath/pass_extend.h"

/* Of the tolerance and the noise: how far the ball may be off on the surface near a border. */
static const double SURE = 0.5;

/* Of the distance of two planes: shorter pieces between them are not worth their links. */
static const double LONG = 1.5;

/* What the threads share. */
struct ends {
    const struct plane_passes *path;
    struct plane_cuts *cuts;
    double *length;
    size_t *beyond;
};

static struct border_surface_plane plane_at(const struct plane_passes *p, double height)
{
    return (struct border_surface_plane){p->rule.normal, p->rule.along, height};
}

static void lengthen(void *context, size_t from, size_t to)
{
    struct ends *e = context;

    for (size_t i = from; i < to; i++) {
        struct plane_cut *cut = &e->cuts->item[i];
        struct border_surface_plane plane = plane_at(e->path, cut->height);
        e->beyond[i] =
            e->path->extended ? 0 : pass_extend_within(e->path->border_surface, &cut->strips);
        e->length[i] = pass_extend_ends(e->path->border_surface, &plane, &cut->strips);
    }
}

static double lengthen_all(const struct plane_passes *p, struct plane_cuts *cuts)
{
    struct ends e = {p, cuts, mem_alloc(cuts->n + 1, sizeof(double)),
                     mem_alloc(cuts->n + 1, sizeof(size_t))};
    double length = 0;
    size_t beyond = 0;

    parallel_for(p->threads, cuts->n, lengthen, &e);
    for (size_t i = 0; i < cuts->n; i++)
        length += e.length[i];
    for (size_t i = 0; i < cuts->n; i++)
        beyond += e.beyond[i];
    if (beyond > 0)
        note("%zu points of the mesh lie beyond the border of the scan and are left out", beyond);
    free(e.length);
    free(e.beyond);
    return length;
}

/* What the plane has beside the strips of a neighbouring one and not beside those on its other side
 * (NULL: none). */
static double widen(const struct plane_passes *p, const struct plane_cut *from,
                    const struct plane_cut *beyond, double shortest, struct plane_cut *cut)
{
    struct border_surface_plane plane = plane_at(p, cut->height);
    struct pass_extend_neighbours beside = {&from->strips, beyond ? &beyond->strips : NULL};

    return pass_extend_beside(p->border_surface, &plane, &beside, shortest, &cut->strips);
}

static double widen_all(const struct plane_passes *p, struct plane_cuts *cuts)
{
    double length = 0;

    for (size_t i = 1; i < cuts->n; i++) {
        struct plane_cut *low = &cuts->item[i - 1], *high = &cuts->item[i];
        length += widen(p, low, NULL, (high->height - low->height) / 2, high);
    }
    for (size_t i = cuts->n - 1; i-- > 0;) {
        struct plane_cut *low = &cuts->item[i], *high = &cuts->item[i + 1];
        length += widen(p, high, NULL, (high->height - low->height) / 2, low);
    }
    return length;
}

/* Planes from the end on (`way` 1: beyond the last, -1: before the first), as long as the scan has
 * something for them. */
static double go_on(const struct plane_passes *p, const struct plane_cut *end, double way,
                    double step, struct plane_cuts *more)
{
    double length = 0;

    for (struct plane_cut last = *end;; last = more->item[more->n - 1]) {
        struct plane_cut next = {last.height + way * step, {{0}, {0}}};
        double added = widen(p, &last, NULL, step / 2, &next);
        if (added == 0)
            return length;
        length += added;
        *array_push(more) = next;
    }
}

/* Two planes, of which one ends well before the other where the border runs nearly along them: what
 * goes between. */
static double go_between(const struct plane_passes *p, const struct plane_cut *low,
                         const struct plane_cut *high, struct plane_cuts *to)
{
    double step = high->height - low->height;
    struct plane_cut between = {low->height + step / 2, {{0}, {0}}};
    double length =
        widen(p, low, high, LONG * step, &between) + widen(p, high, low, LONG * step, &between);

    if (length > 0)
        *array_push(to) = between;
    return length;
}

/* Half the distance of the planes at an end; the one at the border may have come nearer. */
static double end_step(const struct plane_passes *p, bool last)
{
    const double *h = p->height.item;
    size_t n = p->height.n;

    if (n < 4)
        return p->widest / 2;
    return (last ? h[n - 2] - h[n - 3] : h[2] - h[1]) / 2;
}

void plane_passes_go_beyond(const struct plane_passes *p, struct plane_cuts *cuts)
{
    struct plane_cuts before = {0}, behind = {0}, all = {0};
    double length = lengthen_all(p, cuts);

    if (cuts->n == 0)
        return;
    length += widen_all(p, cuts);
    length += go_on(p, &cuts->item[0], -1, end_step(p, false), &before);
    length += go_on(p, &cuts->item[cuts->n - 1], 1, end_step(p, true), &behind);
    for (size_t i = before.n; i-- > 0;)
        *array_push(&all) = before.item[i];
    for (size_t i = 0; i < cuts->n; i++) {
        if (i > 0)
            length += go_between(p, &cuts->item[i - 1], &cuts->item[i], &all);
        *array_push(&all) = cuts->item[i];
    }
    for (size_t i = 0; i < behind.n; i++)
        *array_push(&all) = behind.item[i];
    note("rows run out to the border of the scan: %.1f mm more, %zu planes more", length,
         all.n - cuts->n);
    array_free(&before);
    array_free(&behind);
    array_free(cuts);
    *cuts = all;
}

void plane_passes_run_out(struct plane_passes *p, const struct mesh *mesh)
{
    struct border_surface_options rule = {.scan = &cutting.certain,
                                          .doubtful = &cutting.doubtful,
                                          .spacing = mesh->origin.spacing,
                                          .radius = cutting.radius,
                                          .sure =
                                              SURE * (cutting.tolerance + fmax(cutting.noise, 0))};

    if (rule.scan->n > 0 && rule.spacing > 0 && mesh->origin.part.n == 0 && p->rule.normal.z == 0)
        p->border_surface = border_surface_new(&rule, mesh);
    p->extended = mesh->origin.extended > 0;
    array_free(&cutting.certain);
    array_free(&cutting.doubtful);
}
