/* uv_polygon - see uv_polygon.h. */
#include "uv_polygon.h"

#include <stdlib.h>

#include "math/elementary.h"
#include "base/array.h"
#include "trim_crossings.h"

/* Does the ray from the place to the right cross the side? */
static bool is_passed(struct uv a, struct uv b, struct uv p)
{
    return (a.v > p.v) != (b.v > p.v) && p.u < a.u + (p.v - a.v) / (b.v - a.v) * (b.u - a.u);
}

/* Does the loop go round the place? */
static bool goes_round(const struct uvs *loop, struct uv p)
{
    bool inside = false;
    for (size_t i = 0, k = loop->n - 1; i < loop->n; k = i++)
        inside = inside != is_passed(loop->item[k], loop->item[i], p);
    return inside;
}

bool uv_polygon_inside(const struct uv_polygon *loops, bool open, struct uv at)
{
    bool inside = open;
    for (size_t i = 0; i < loops->n; i++)
        if (goes_round(&loops->item[i], at))
            inside = !inside;
    return inside;
}

/* ---- rows */

/* The row of v; what lies beyond the rows is counted to the first and the last. */
static size_t row_of(const struct uv_rows *rows, double v)
{
    double row = rows->height > 0 ? floor((v - rows->from) / rows->height) : 0;
    return !(row >= 1) ? 0 : row >= (double)rows->n ? rows->n - 1 : (size_t)row;
}

/* Counts the sides of each row into first[row + 1], or, once these are sums, puts them there. */
static void fill_rows(const struct uv_polygon *loops, struct uv_rows *rows, size_t *next)
{
    for (size_t l = 0; l < loops->n; l++) {
        const struct uvs *loop = &loops->item[l];
        for (size_t i = 0, k = loop->n - 1; i < loop->n; k = i++) {
            struct uv a = loop->item[k], b = loop->item[i];
            size_t row = row_of(rows, fmin(a.v, b.v)), last = row_of(rows, fmax(a.v, b.v));
            for (; row <= last; row++) {
                if (!next) {
                    rows->first[row + 1]++;
                    continue;
                }
                rows->side[next[row]][0] = a;
                rows->side[next[row]++][1] = b;
            }
        }
    }
}

void uv_rows_make(const struct uv_polygon *loops, struct uv_rows *rows)
{
    double low = HUGE_VAL, high = -HUGE_VAL, rise = 0;
    size_t n = 0;
    for (size_t l = 0; l < loops->n; l++)
        for (size_t i = 0; i < loops->item[l].n; i++, n++) {
            double v = loops->item[l].item[i].v;
            rise += i > 0 ? fabs(v - loops->item[l].item[i - 1].v) : 0;
            low = fmin(low, v);
            high = fmax(high, v);
        }
    /* a side lies in all rows that it rises through: about eight of them, however long they are */
    double most = rise > 0 ? fmin((double)n / 2, 8 * (double)n * (high - low) / rise) : 0;
    *rows = (struct uv_rows){.from = n ? low : 0, .n = (size_t)most + 1};
    rows->height = n ? (high - low) / (double)rows->n : 0;
    rows->first = mem_alloc(rows->n + 1, sizeof *rows->first);
    fill_rows(loops, rows, NULL);
    for (size_t i = 0; i < rows->n; i++)
        rows->first[i + 1] += rows->first[i];
    size_t *next = mem_alloc(rows->n + 1, sizeof *next);
    for (size_t i = 0; i < rows->n; i++)
        next[i] = rows->first[i];
    rows->side = mem_alloc(rows->first[rows->n] + 1, sizeof *rows->side);
    fill_rows(loops, rows, next);
    free(next);
}

bool uv_rows_inside(const struct uv_rows *rows, bool open, struct uv at)
{
    size_t row = row_of(rows, at.v);
    bool inside = open;
    for (size_t i = rows->first[row]; i < rows->first[row + 1]; i++)
        inside = inside != is_passed(rows->side[i][0], rows->side[i][1], at);
    return inside;
}

void uv_rows_free(struct uv_rows *rows)
{
    free(rows->first);
    free(rows->side);
    *rows = (struct uv_rows){0};
}

double uv_loop_area(const struct uvs *loop)
{
    double area = 0;
    struct uv o = loop->item[0];
    for (size_t i = 0, k = loop->n - 1; i < loop->n; k = i++) {
        struct uv a = loop->item[k], b = loop->item[i];
        area += (a.u - o.u) * (b.v - o.v) - (b.u - o.u) * (a.v - o.v);
    }
    return area / 2;
}

/* Corners of a loop that say whether it lies in another: one alone may be on the border of that. */
enum { ASKED = 7 };

bool uv_polygon_backwards(const struct uv_polygon *loops, size_t index, bool open)
{
    const struct uvs *loop = &loops->item[index];
    bool hole = open;
    for (size_t i = 0; i < loops->n; i++) {
        int inside = 0;
        for (size_t k = 0; k < ASKED && i != index; k++)
            inside += goes_round(&loops->item[i], loop->item[k * loop->n / ASKED]);
        hole = hole != (inside > ASKED / 2);
    }
    return (uv_loop_area(loop) > 0) == hole;
}

size_t uv_polygon_crossings(const struct uv_polygon *loops, const struct nurbs *s, double tolerance)
{
    size_t count = 0;
    for (size_t k = 0; k < loops->n; k++)
        count += trim_crossings(&loops->item[k], s, tolerance);
    return count;
}

void uv_polygon_free(struct uv_polygon *loops)
{
    for (size_t i = 0; i < loops->n; i++)
        array_free(&loops->item[i]);
    array_free(loops);
    loops->off = loops->gap = 0;
    loops->lost = 0;
}
