/*
 * array - growing arrays, and memory without failure.
 *
 * An array is any struct with the members  size_t n, cap;  T *item;  and starts as all zero.
 * Running out of memory ends the process with exit status 1, so that callers need not check.
 */
#ifndef CLOUDMILL_ARRAY_H
#define CLOUDMILL_ARRAY_H

#include <stddef.h>

/* n * size bytes, all zero; never NULL.  Free with free(). */
void *mem_alloc(size_t n, size_t size);

/* A copy of the n bytes at s, followed by '\0'; never NULL. */
char *mem_string(const char *s, size_t n);

/* Makes room for n elements of `size` bytes in `item`, which has room for *cap; returns its new
 * place. */
void *mem_grow(void *item, size_t *cap, size_t n, size_t size);

/* Makes room for n elements in all. */
#define array_reserve(a, want) \
    ((a)->item = mem_grow((a)->item, &(a)->cap, (want), sizeof *(a)->item))

/* Appends one element and returns a pointer to it, not yet filled. */
#define array_push(a) (array_reserve((a), (a)->n + 1), &(a)->item[(a)->n++])

/* The same without a call where there is room, for loops over millions.  Behind a fence (array.c)
 * each element is asked for. */
#ifdef ARRAY_FENCE
#define array_push_inline array_push
#else
#define array_push_inline(a) ((a)->n < (a)->cap ? &(a)->item[(a)->n++] : array_push(a))
#endif

/* Frees the memory; the array is empty and may be used again. */
#define array_free(a) (free((a)->item), (a)->item = NULL, (a)->n = (a)->cap = 0)

struct doubles {
    size_t n, cap;
    double *item;
};

/* Sorts n values in increasing order; none may be NAN. */
void doubles_sort(double *value, size_t n);

/* The one of n values (k < n) that would stand at k if they were sorted; changes their order. */
double doubles_select(double *value, size_t n, size_t k);

struct ints {
    size_t n, cap;
    int *item;
};

struct sizes {
    size_t n, cap;
    size_t *item;
};

#endif
