/* scan_border - see scan_border.h. */
#include "meshing/scan_border.h"

#include <stdlib.h>

#include "delaunay.h"
#include "delaunay_border.h"

bool delaunay_is_surface(const struct delaunay *d, int triangle, double gap)
{
    return triangle != DELAUNAY_NONE && delaunay_is_near(d, triangle) &&
           delaunay_diameter(d, triangle) <= gap;
}

static bool is_border(const struct delaunay *d, const bool *surface, int t, int edge)
{
    int beside = d->t.item[t].beside[edge];

    return surface[t] && (beside == DELAUNAY_NONE || !surface[beside]);
}

/* From a border edge on to the next one, about the point where it ends. */
static void step_on(const struct delaunay *d, const bool *surface, int *t, int *edge)
{
    *edge = (*edge + 1) % 3;
    while (!is_border(d, surface, *t, *edge)) {
        int beside = d->t.item[*t].beside[*edge];
        const int *back = d->t.item[beside].beside;
        *edge = ((back[0] == *t ? 0 : back[1] == *t ? 1 : 2) + 1) % 3;
        *t = beside;
    }
}

static void follow(const struct delaunay *d, const bool *surface, int t, int edge, bool *done,
                   struct ints *loop)
{
    while (!done[3 * t + edge]) {
        done[3 * t + edge] = true;
        *array_push(loop) = d->t.item[t].v[edge];
        step_on(d, surface, &t, &edge);
    }
}

struct scan_border delaunay_border(const struct delaunay *d, double gap)
{
    struct scan_border border = {0};
    bool *surface = mem_alloc(d->t.n, sizeof *surface), *done = mem_alloc(3 * d->t.n, sizeof *done);

    for (size_t t = 0; t < d->t.n; t++)
        surface[t] = delaunay_is_surface(d, (int)t, gap);
    for (int t = 0; t < (int)d->t.n; t++)
        for (int edge = 0; edge < 3; edge++)
            if (is_border(d, surface, t, edge) && !done[3 * t + edge]) {
                struct ints loop = {0};
                follow(d, surface, t, edge, done, &loop);
                *array_push(&border) = loop;
            }
    free(surface);
    free(done);
    return border;
}

struct scan_border scan_border_find(const struct vec3 *point, size_t n, double gap)
{
    struct delaunay d = delaunay_new(point, n);

    delaunay_insert_all(&d);
    struct scan_border border = delaunay_border(&d, gap);
    delaunay_free(&d);
    return border;
}

size_t scan_border_farthest(const struct ints *loop, const struct vec3 *point, size_t from,
                            size_t to, double *distance)
{
    struct vec3 a = point[loop->item[from]], b = point[loop->item[to % loop->n]];
    size_t at = from + 1;

    *distance = -1;
    for (size_t i = from + 1; i < to; i++) {
        double off = vec_segment_distance(a, b, point[loop->item[i]]);
        if (off > *distance) {
            *distance = off;
            at = i;
        }
    }
    return at;
}

static void thin_part(const struct ints *loop, const struct vec3 *point, double tolerance,
                      size_t from, size_t to, bool *keep)
{
    struct sizes todo = {0};

    *array_push(&todo) = from;
    *array_push(&todo) = to;
    while (todo.n > 0) {
        double off;
        size_t b = todo.item[--todo.n], a = todo.item[--todo.n];
        if (b - a < 2)
            continue;
        size_t middle = scan_border_farthest(loop, point, a, b, &off);
        if (off <= tolerance)
            continue;
        keep[middle] = true;
        size_t next[4] = {a, middle, middle, b};
        for (int i = 0; i < 4; i++)
            *array_push(&todo) = next[i];
    }
    array_free(&todo);
}

void scan_border_thin(const struct ints *loop, const struct vec3 *point, double tolerance,
                      bool *keep)
{
    size_t other = 1;
    double reach = -1, off;

    if (loop->n == 0)
        return;
    for (size_t i = 0; i < loop->n; i++) {
        double away = vec_distance(point[loop->item[i]], point[loop->item[0]]);
        keep[i] = false;
        if (away > reach) {
            reach = away;
            other = i;
        }
    }
    keep[0] = keep[other] = true;
    thin_part(loop, point, tolerance, 0, other, keep);
    thin_part(loop, point, tolerance, other, loop->n, keep);
    size_t kept = 0;
    for (size_t i = 0; i < loop->n; i++)
        kept += keep[i];
    if (kept < 3) { /* a loop has an area */
        size_t one = other > 1 ? scan_border_farthest(loop, point, 0, other, &off) : other + 1;
        keep[one % loop->n] = true;
    }
}

void scan_border_free(struct scan_border *border)
{
    for (size_t i = 0; i < border->n; i++)
        array_free(&border->item[i]);
    array_free(border);
}
