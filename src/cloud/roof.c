/* roof - see roof.h. */
#include "cloud/roof.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "base/parallel.h"
#include "math/box.h"

/* Steep: 68 degrees. */
static const double STEEP = 2.5;
/* In mean spacings: neighbours so near tell whether the roof ends, and how many make one. */
static const double RIM = ROOF_JUDGE;
/* Of the width of the scan: points of the curtain of who asks are no nearer to one another. */
static const double ASKED = 0.005;
/* A sheet has so many points within reach, at least. */
enum { FEWEST = 3, EIGHTHS = 8 };

struct roof_work {
    const struct point_grid *grid;
    double reach;             /* mm */
    unsigned char *roof;      /* what is found */
    const unsigned char *all; /* what was found before; NULL: nothing yet */
    double *foot;             /* z down to which material shows below a point; it: none */
    double bottom;            /* z, mm: that of one at the rim */
};

/* What is about a point. */
struct about {
    size_t level, off; /* points about as high, nearer than RIM, and others, within reach */
    unsigned eighths;  /* of the turn, in which there is roof nearer than RIM */
    double lowest;     /* z of that roof, and of the point */
};

/* The eighth of a turn that a direction is in, counted round. */
static unsigned eighth_of(struct vec3 d)
{
    unsigned quarter = d.y >= 0 ? (d.x > 0 ? 0 : 1) : (d.x < 0 ? 2 : 3);
    bool late = quarter % 2 == 0 ? fabs(d.y) > fabs(d.x) : fabs(d.x) > fabs(d.y);

    return 2 * quarter + late;
}

static void add_cell(const struct roof_work *w, size_t i, size_t cell, struct about *about)
{
    const struct point_grid *g = w->grid;
    double spacing = point_grid_spacing(g), least = ROOF_GUARD * spacing;
    double near = w->reach, rim = RIM * spacing, most = fmax(near, rim);

    for (size_t k = g->first[cell]; k < g->first[cell + 1]; k++) {
        struct vec3 d = vec_sub(g->point[k], g->point[i]);
        double away2 = d.x * d.x + d.y * d.y;
        if (k == i || away2 > most * most)
            continue;
        bool level = fabs(d.z) <= STEEP * fmax(sqrt(away2), least);
        about->level += level && away2 <= rim * rim;
        about->off += !level && away2 <= near * near;
        if (w->all && w->all[k] && level && away2 <= rim * rim) {
            about->eighths |= 1u << eighth_of(d);
            about->lowest = fmin(about->lowest, g->point[k].z);
        }
    }
}

static struct about look_about(const struct roof_work *w, size_t i)
{
    const struct point_grid *g = w->grid;
    size_t column = point_grid_column(g, g->point[i].x), row = point_grid_row(g, g->point[i].y);
    struct about about = {.lowest = g->point[i].z};

    for (size_t r = row > 0 ? row - 1 : 0; r <= row + 1 && r < g->rows; r++)
        for (size_t c = column > 0 ? column - 1 : 0; c <= column + 1 && c < g->columns; c++)
            add_cell(w, i, r * g->columns + c, &about);
    return about;
}

static void find_roof(void *context, size_t from, size_t to)
{
    const struct roof_work *w = context;

    for (size_t i = from; i < to; i++) {
        struct about about = look_about(w, i);
        w->roof[i] = about.level >= FEWEST && about.off == 0;
    }
}

size_t roof_find(const struct point_grid *point_grid, double reach, int threads,
                 unsigned char *roof)
{
    struct roof_work work = {
        .grid = point_grid, .reach = reach * point_grid_spacing(point_grid), .roof = roof};
    size_t found = 0;

    parallel_for(threads, point_grid->n, find_roof, &work);
    for (size_t i = 0; i < point_grid->n; i++)
        found += roof[i] == 1;
    return found;
}

/* No roof in two eighths of a turn that are beside each other. */
static bool is_at_rim(unsigned eighths)
{
    for (unsigned k = 0; k < EIGHTHS; k++)
        if (!(eighths & 1u << k) && !(eighths & 1u << (k + 1) % EIGHTHS))
            return true;
    return false;
}

static void find_feet(void *context, size_t from, size_t to)
{
    const struct roof_work *w = context;

    for (size_t i = from; i < to; i++) {
        w->foot[i] = w->grid->point[i].z;
        if (!w->all[i])
            continue;
        struct about about = look_about(w, i);
        w->foot[i] = is_at_rim(about.eighths) ? w->bottom : about.lowest;
    }
}

/* A point that something hangs below, by the square that it is in. */
struct hook {
    double column, row;
    size_t index;
};

static struct hook hook_of(const struct point_grid *g, size_t i, double width)
{
    return (struct hook){floor((g->point[i].x - g->x) / width),
                         floor((g->point[i].y - g->y) / width), i};
}

static int compare_squares(const void *pa, const void *pb)
{
    const struct hook *a = pa, *b = pb;

    if (a->row != b->row)
        return a->row < b->row ? -1 : 1;
    if (a->column != b->column)
        return a->column < b->column ? -1 : 1;
    return (a->index > b->index) - (a->index < b->index);
}

/* One line of each square of half the gap, below the highest.  The last of it is at the foot: a
 * scan that is flatter than the gap would have none. */
static void hang(const struct roof_work *w, struct hook *hook, size_t n, double gap,
                 struct vec3s *to)
{
    qsort(hook, n, sizeof *hook, compare_squares);
    for (size_t i = 0, end; i < n; i = end) {
        struct vec3 top = w->grid->point[hook[i].index];
        double foot = w->foot[hook[i].index];
        for (end = i + 1;
             end < n && hook[end].row == hook[i].row && hook[end].column == hook[i].column; end++) {
            foot = fmin(foot, w->foot[hook[end].index]);
            if (w->grid->point[hook[end].index].z > top.z)
                top = w->grid->point[hook[end].index];
        }
        for (double k = 1; top.z - k * gap > foot; k++)
            *array_push(to) = vec(top.x, top.y, top.z - k * gap);
        if (top.z > foot)
            *array_push(to) = vec(top.x, top.y, foot);
    }
}

/* A floor inside of the rim, which keeps out what passes below that and comes up within: in each
 * square of `pitch` one point at the bottom, under one of the roof. */
static void floor_under(const struct roof_work *w, struct hook *hook, double pitch,
                        struct vec3s *to)
{
    const struct point_grid *g = w->grid;
    size_t n = 0;

    for (size_t i = 0; i < g->n; i++)
        if (w->all[i] && g->point[i].z > w->bottom && w->foot[i] > w->bottom)
            hook[n++] = hook_of(g, i, pitch);
    qsort(hook, n, sizeof *hook, compare_squares);
    for (size_t i = 0; i < n; i++) {
        struct vec3 p = g->point[hook[i].index];
        if (i == 0 || hook[i].row != hook[i - 1].row || hook[i].column != hook[i - 1].column)
            *array_push(to) = vec(p.x, p.y, w->bottom);
    }
}

void roof_curtain(const struct point_grid *point_grid, const unsigned char *roof, double gap,
                  double bottom, int threads, struct vec3s *to)
{
    size_t n = point_grid->n, hooks = 0;
    struct roof_work work = {.grid = point_grid,
                             .reach = RIM * point_grid_spacing(point_grid),
                             .all = roof,
                             .foot = mem_alloc(n + 1, sizeof *work.foot),
                             .bottom = bottom};
    struct hook *hook = mem_alloc(n + 1, sizeof *hook);

    parallel_for(threads, n, find_feet, &work);
    for (size_t i = 0; i < n; i++)
        if (point_grid->point[i].z - work.foot[i] > (work.foot[i] > bottom ? gap : 0))
            hook[hooks++] = hook_of(point_grid, i, gap / 2);
    hang(&work, hook, hooks, gap, to);
    floor_under(&work, hook, fmax(gap, 2 * point_grid_spacing(point_grid)), to);
    free(hook);
    free(work.foot);
}

void roof_curtain_asked(const struct point_grid *point_grid, int threads, struct vec3s *to)
{
    struct box box = box_around(point_grid->point, point_grid->n);
    double wide = fmax(box.high.x - box.low.x, box.high.y - box.low.y);
    double gap = fmax(2 * point_grid_spacing(point_grid), ASKED * wide);
    unsigned char *roof = mem_alloc(point_grid->n, 1);

    if (roof_find(point_grid, ROOF_GUARD, threads, roof) > 0 && gap > 0)
        roof_curtain(point_grid, roof, gap, box.low.z, threads, to);
    free(roof);
}
