/* array - see array.h. */
#define _DEFAULT_SOURCE /* madvise */
#include "base/array.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/cli.h"
#include "system.h"

#ifdef ARRAY_FENCE /* by tests/house/mutate.sh, with the address sanitizer */
#include <sanitizer/asan_interface.h>
#endif

enum { HUGE_PAGE = 1 << 21, LARGE = 4 * HUGE_PAGE };

/* A wish that the whole pages of a block be huge ones; without it all is well too: a fault for each
 * page of 4 KiB costs half as much as parsing the text that fills it. */
static void wish_huge(void *block, size_t bytes)
{
#ifdef MADV_HUGEPAGE
    size_t before = (HUGE_PAGE - (uintptr_t)block % HUGE_PAGE) % HUGE_PAGE;

    if (bytes >= LARGE)
        madvise((char *)block + before, (bytes - before) / HUGE_PAGE * HUGE_PAGE, MADV_HUGEPAGE);
#else
    (void)block, (void)bytes;
#endif
}

void *mem_alloc(size_t n, size_t size)
{
    void *p = calloc(n ? n : 1, size ? size : 1);
    if (!p)
        die("out of memory: no room for %zu elements of %zu bytes", n, size);
    wish_huge(p, n * size);
    return p;
}

char *mem_string(const char *s, size_t n)
{
    char *copy = mem_alloc(n + 1, 1);
    memcpy(copy, s, n);
    return copy;
}

/* A large block lies on huge pages where the system has them: to move such a block is dearer than
 * to copy it. */
static void *grow_large(void *item, size_t old, size_t bytes)
{
    bytes = bytes > SIZE_MAX - HUGE_PAGE ? 0 : (bytes + HUGE_PAGE - 1) / HUGE_PAGE * HUGE_PAGE;
    void *p = bytes ? aligned_alloc(HUGE_PAGE, bytes) : NULL;
    if (!p)
        return NULL;
    wish_huge(p, bytes);
    if (old)
        memcpy(p, item, old);
    free(item);
    return p;
}

/* Behind a fence what nobody asked for yet is beyond the array, though there is room. */
static void *fence(void *item, size_t cap, size_t n, size_t size)
{
#ifdef ARRAY_FENCE
    __asan_unpoison_memory_region(item, n * size);
    __asan_poison_memory_region((char *)item + n * size, (cap - n) * size);
#else
    (void)cap, (void)n, (void)size;
#endif
    return item;
}

void *mem_grow(void *item, size_t *cap, size_t n, size_t size)
{
    if (n <= *cap)
        return fence(item, *cap, n, size);
    size_t want = *cap + *cap / 2 + 16;
    if (want < n)
        want = n;
    void *p = want > SIZE_MAX / size ? NULL
              : want * size >= LARGE ? grow_large(item, *cap * size, want * size)
                                     : realloc(item, want * size);
    if (!p)
        die("out of memory: no room for %zu elements of %zu bytes", want, size);
    *cap = want;
    return fence(p, want, n, size);
}

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

void doubles_sort(double *value, size_t n)
{
    qsort(value, n, sizeof *value, by_size);
}

/* Hoare's selection. */
double doubles_select(double *value, size_t n, size_t k)
{
    for (size_t from = 0, to = n; to - from > 1;) {
        double pivot = value[from + (to - from) / 2];
        size_t i = from, j = to - 1;
        for (;; i++, j--) {
            while (value[i] < pivot)
                i++;
            while (value[j] > pivot)
                j--;
            if (i >= j)
                break;
            double swap = value[i];
            value[i] = value[j];
            value[j] = swap;
        }
        size_t cut = i > from ? i : from + 1;
        if (k < cut)
            to = cut;
        else
            from = cut;
    }
    return value[k];
}
