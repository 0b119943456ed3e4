/* tiles - see tiles.h. */
#include "simulate/tiles.h"

#include <stdlib.h>

#include "base/array.h"

enum { MOST_BOXES = 64 };

struct tiles tiles_new(double x, double y, double dx, double dy, int nx, int ny)
{
    struct tiles t = {.x = x, .y = y, .dx = dx, .dy = dy};
    for (int k = 0; k < TILES_LEVELS; k++) {
        size_t n = (size_t)nx * (size_t)ny;
        t.nx[k] = nx;
        t.ny[k] = ny;
        t.levels = k + 1;
        t.level[k] = mem_alloc(n, sizeof *t.level[k]);
        for (size_t i = 0; i < n; i++)
            t.level[k][i] = (struct tile){HUGE_VAL, -HUGE_VAL};
        if (n == 1)
            break;
        nx = (nx + 1) / 2;
        ny = (ny + 1) / 2;
    }
    return t;
}

void tiles_free(struct tiles *tiles)
{
    for (int k = 0; k < tiles->levels; k++)
        free(tiles->level[k]);
}

static struct tile *tile_at(const struct tiles *t, int level, int i, int j)
{
    return &t->level[level][(size_t)j * (size_t)t->nx[level] + (size_t)i];
}

void tiles_set(struct tiles *t, int i, int j, struct tile tile)
{
    *tile_at(t, 0, i, j) = tile;
    for (int k = 1; k < t->levels; k++) {
        struct tile sum = {HUGE_VAL, -HUGE_VAL};
        i /= 2;
        j /= 2;
        for (int c = 0; c < 4; c++) {
            int ci = 2 * i + c % 2, cj = 2 * j + c / 2;
            if (ci >= t->nx[k - 1] || cj >= t->ny[k - 1])
                continue;
            const struct tile *child = tile_at(t, k - 1, ci, cj);
            sum.low = fmin(sum.low, child->low);
            sum.high = fmax(sum.high, child->high);
        }
        *tile_at(t, k, i, j) = sum;
    }
}

double tiles_look(struct tiles_search *search, struct vec3 place)
{
    double distance = holder_distance(search->holder, search->centre, search->axis, place);
    if (distance < search->distance) {
        search->distance = distance;
        search->at = place;
    }
    return distance;
}

struct job {
    const struct tiles *tiles;
    tiles_visit *visit;
    void *what;
    struct tiles_search *search;
};

/* No place in the box is nearer than this; a tall box is taken as several, one on the other. */
static double bound(const struct job *job, int level, int i, int j)
{
    const struct tiles *t = job->tiles;
    const struct tiles_search *s = job->search;
    const struct tile *tile = tile_at(t, level, i, j);
    double dx = ldexp(t->dx, level), dy = ldexp(t->dy, level), tall = tile->high - tile->low;
    if (tall < 0)
        return HUGE_VAL;
    double boxes = fmin(fmax(1, ceil(tall / (dx + dy))), MOST_BOXES), least = HUGE_VAL;
    struct vec3 half = vec(dx / 2, dy / 2, tall / boxes / 2);
    for (int k = 0; k < (int)boxes; k++) {
        double z = tile->low + (k + 0.5) * tall / boxes;
        struct vec3 middle = vec(t->x + (i + 0.5) * dx, t->y + (j + 0.5) * dy, z);
        least = fmin(least, holder_bound(s->holder, s->centre, s->axis, middle, half));
    }
    return least;
}

static void descend(const struct job *job, int level, int i, int j)
{
    struct child {
        double bound;
        int i, j;
    } child[4];
    int n = 0;
    if (level == 0) {
        job->visit(job->what, i, j, job->search);
        return;
    }
    for (int c = 0; c < 4; c++) {
        struct child next = {0, 2 * i + c % 2, 2 * j + c / 2};
        if (next.i >= job->tiles->nx[level - 1] || next.j >= job->tiles->ny[level - 1])
            continue;
        next.bound = bound(job, level - 1, next.i, next.j);
        int k = n++;
        for (; k > 0 && child[k - 1].bound > next.bound; k--)
            child[k] = child[k - 1];
        child[k] = next;
    }
    const struct tiles_search *found = job->search;
    for (int k = 0; k < n && child[k].bound < found->distance && found->distance >= found->enough;
         k++)
        descend(job, level - 1, child[k].i, child[k].j);
}

void tiles_nearest(const struct tiles *tiles, tiles_visit *visit, void *what,
                   struct tiles_search *search)
{
    const struct job job = {tiles, visit, what, search};
    int top = tiles->levels - 1;
    if (bound(&job, top, 0, 0) < search->distance)
        descend(&job, top, 0, 0);
}
