/*
 * array - growing arrays, and memory that either is there or ends the process.
 *
 * An array is any struct with the members  size_t n, cap;  T *item;  and starts as all zero.
 * Running out of memory ends the process with exit status 1 (it is `base` that does it), so
 * that no caller has a path for it.
 */
#ifndef CLOUDMILL_ARRAY_H
#define CLOUDMILL_ARRAY_H

#include <stddef.h>

/* n * size bytes, all zero; never NULL.  Free with free(). */
void *mem_alloc(size_t n, size_t size);

/* A copy of the n bytes at s with a '\0' behind them; never NULL. */
char *mem_string(const char *s, size_t n);

/* Makes room for n elements of `size` bytes in `item`, which now holds *cap; returns it, moved. */
void *mem_grow(void *item, size_t *cap, size_t n, size_t size);

/* Makes room for n elements in all. */
#define array_reserve(a, want) \
    ((a)->item = mem_grow((a)->item, &(a)->cap, (want), sizeof *(a)->item))

/* A pointer to one more element at the end, not yet filled. */
#define array_push(a) (array_reserve((a), (a)->n + 1), &(a)->item[(a)->n++])

/* Gives the memory back; the array is empty and may be used again. */
#define array_free(a) (free((a)->item), (a)->item = NULL, (a)->n = (a)->cap = 0)

struct doubles {
    size_t n, cap;
    double *item;
};

/* The n values in rising order; no NAN among them. */
void doubles_sort(double *value, size_t n);

struct ints {
    size_t n, cap;
    int *item;
};

struct sizes {
    size_t n, cap;
    size_t *item;
};

#endif
