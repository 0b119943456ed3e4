/* array - see array.h. */
#include "array.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "cli.h"

void *mem_alloc(size_t n, size_t size)
{
    void *p = calloc(n ? n : 1, size ? size : 1);
    if (!p)
        die("out of memory: no room for %zu elements of %zu bytes", n, size);
    return p;
}

char *mem_string(const char *s, size_t n)
{
    char *copy = mem_alloc(n + 1, 1);
    memcpy(copy, s, n);
    return copy;
}

void *mem_grow(void *item, size_t *cap, size_t n, size_t size)
{
    if (n <= *cap)
        return item;
    size_t want = *cap + *cap / 2 + 16;
    if (want < n)
        want = n;
    void *p = want > SIZE_MAX / size ? NULL : realloc(item, want * size);
    if (!p)
        die("out of memory: no room for %zu elements of %zu bytes", want, size);
    *cap = want;
    return p;
}
