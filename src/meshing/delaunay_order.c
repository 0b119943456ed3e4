/* delaunay_order - see delaunay_order.h. */
#include "delaunay_order.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "math/elementary.h"
#include "base/array.h"

enum { CURVE_BITS = 16, DIGIT = 11, ROUNDS = 9 };

struct place {
    uint64_t key; /* round, then the length of the curve */
    int i;
};

/* How far along a Hilbert curve over 2^16 x 2^16 cells a cell lies. */
static uint32_t along_curve(uint32_t x, uint32_t y)
{
    uint32_t along = 0;

    for (uint32_t s = 1u << (CURVE_BITS - 1); s > 0; s >>= 1) {
        uint32_t right = (x & s) > 0, up = (y & s) > 0;
        along += s * s * ((3 * right) ^ up);
        if (!up) {
            if (right) {
                x = ~x;
                y = ~y;
            }
            uint32_t swap = x;
            x = y;
            y = swap;
        }
    }
    return along;
}

/* The round of point i: the last has seven eighths of all, the one before of the rest ... */
static uint64_t round_of(uint64_t i)
{
    uint64_t h = (i + 1) * UINT64_C(0x9E3779B97F4A7C15), round = ROUNDS;

    h = (h ^ h >> 30) * UINT64_C(0xBF58476D1CE4E5B9);
    h = (h ^ h >> 27) * UINT64_C(0x94D049BB133111EB);
    for (h ^= h >> 31; (h & 7) == 0 && round > 0; h >>= 3)
        round--;
    return round;
}

/* Sorts by the keys, DIGIT bits at a time, and keeps the order of equal ones. */
static void sort_places(struct place **place, size_t n)
{
    struct place *other = mem_alloc(n, sizeof *other);
    size_t *start = mem_alloc((1 << DIGIT) + 1, sizeof *start);

    for (int shift = 0; shift < 2 * CURVE_BITS + 4; shift += DIGIT) {
        memset(start, 0, ((1 << DIGIT) + 1) * sizeof *start);
        for (size_t i = 0; i < n; i++)
            start[((*place)[i].key >> shift & ((1 << DIGIT) - 1)) + 1]++;
        for (size_t k = 1; k < 1 << DIGIT; k++)
            start[k] += start[k - 1];
        for (size_t i = 0; i < n; i++)
            other[start[(*place)[i].key >> shift & ((1 << DIGIT) - 1)]++] = (*place)[i];
        struct place *swap = *place;
        *place = other;
        other = swap;
    }
    free(start);
    free(other);
}

int *delaunay_order(const struct uv *at, size_t n)
{
    struct place *place = mem_alloc(n, sizeof *place);
    int *order = mem_alloc(n, sizeof *order);
    double x = HUGE_VAL, y = HUGE_VAL, wide = 1e-300;

    for (size_t i = 0; i < n; i++) {
        x = fmin(x, at[i].u);
        y = fmin(y, at[i].v);
    }
    for (size_t i = 0; i < n; i++)
        wide = fmax(wide, fmax(at[i].u - x, at[i].v - y));
    double cells = ((1 << CURVE_BITS) - 1) / wide;
    for (size_t i = 0; i < n; i++) {
        uint64_t along =
            along_curve((uint32_t)((at[i].u - x) * cells), (uint32_t)((at[i].v - y) * cells));
        place[i] = (struct place){round_of(i) << 2 * CURVE_BITS | along, (int)i};
    }
    sort_places(&place, n);
    for (size_t i = 0; i < n; i++)
        order[i] = place[i].i;
    free(place);
    return order;
}
