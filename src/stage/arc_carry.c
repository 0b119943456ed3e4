/* arc_carry - see arc_carry.h. */
#include "arc_carry.h"

#include "math/elementary.h"
#include <stdlib.h>

static const double ENDS_MOVED = 0.1; /* mm: by no more, or it is another part */

static bool vec_same(struct vec3 a, struct vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

bool arc_carry_same(const struct run_point *a, const struct run_point *b)
{
    return vec_same(a->tip, b->tip) && vec_same(a->ball, b->ball) && vec_same(a->axis, b->axis) &&
           vec_same(a->contact, b->contact) && vec_same(a->normal, b->normal) &&
           a->given == b->given;
}

/* The given points, and the last one. */
static struct sizes given_points(const struct run *run)
{
    struct sizes given = {0};

    for (size_t i = 0; i < run->n; i++)
        if (run->item[i].given || i == 0 || i + 1 == run->n)
            *array_push(&given) = i;
    return given;
}

/* The same end, as it is or lifted. */
static bool is_near(const struct run_point *a, const struct run_point *b)
{
    return vec_distance(a->ball, b->ball) <= ENDS_MOVED;
}

bool arc_carry_alike(const struct run *old, const struct run *now)
{
    if (old->n < 2 || now->n < 2 || !is_near(&old->item[0], &now->item[0]) ||
        !is_near(&old->item[old->n - 1], &now->item[now->n - 1]))
        return false;
    struct sizes a = given_points(old), b = given_points(now);
    bool alike = a.n == b.n;
    array_free(&a);
    array_free(&b);
    return alike;
}

/* Interval g of the old and the new points holds the same. */
static bool has_stayed(const struct run *old, const struct run *now, const size_t *a,
                       const size_t *b)
{
    if (a[1] - a[0] != b[1] - b[0])
        return false;
    for (size_t i = 0; i <= a[1] - a[0]; i++)
        if (!arc_carry_same(&old->item[a[0] + i], &now->item[b[0] + i]))
            return false;
    return true;
}

/* The interval, from `g` on, that holds an old place. */
static size_t interval_of(const struct sizes *given, double place, size_t g)
{
    while (g + 2 < given->n && (double)given->item[g + 1] <= place)
        g++;
    return g;
}

static double new_place(const size_t *a, const size_t *b, double place)
{
    double part = (place - (double)a[0]) / (double)(a[1] - a[0]);

    return a[1] - a[0] == b[1] - b[0] ? place - (double)a[0] + (double)b[0]
                                      : (double)b[0] + part * (double)(b[1] - b[0]);
}

static void add_window(struct arc_moves *windows, size_t at, size_t beside, size_t n)
{
    size_t from = at > beside ? at - beside : 0, to = at + beside < n ? at + beside + 1 : n;

    if (windows->n > 0 && windows->item[windows->n - 1].to >= from)
        windows->item[windows->n - 1].to = to;
    else
        *array_push(windows) = (struct arc_moved){from, to};
}

void arc_carry(const struct run *old, const struct run *now, const struct pieces *pieces,
               size_t beside, struct pieces *carried, struct arc_moves *windows)
{
    struct sizes a = given_points(old), b = given_points(now);
    bool *stayed = mem_alloc(a.n, sizeof *stayed);
    size_t g = 0;

    for (size_t k = 0; k + 1 < a.n; k++)
        stayed[k] = has_stayed(old, now, &a.item[k], &b.item[k]);
    for (size_t i = 0; i < pieces->n; i++) {
        struct arc_piece piece = pieces->item[i];
        size_t first = interval_of(&a, piece.from, g), last = interval_of(&a, piece.to, first);
        bool moved = false;
        for (size_t k = first; k <= last; k++)
            moved = moved || !stayed[k];
        piece.from = new_place(&a.item[first], &b.item[first], piece.from);
        piece.to = new_place(&a.item[last], &b.item[last], piece.to);
        *array_push(carried) = piece;
        if (moved)
            add_window(windows, i, beside, pieces->n);
        g = first;
    }
    free(stayed);
    array_free(&a);
    array_free(&b);
}
