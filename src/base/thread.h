/*
 * thread - threads that have as much stack as the usual first one.
 *
 * Some libraries give a thread little: musl 128 kB, of which the fits of a neighbourhood take 100.
 */
#ifndef CLOUDMILL_THREAD_H
#define CLOUDMILL_THREAD_H

#include <pthread.h>

/* As pthread_create. */
static inline int thread_begin(pthread_t *thread, void *(*work)(void *), void *context)
{
    enum { STACK = 1 << 23 };
    pthread_attr_t how;
    int result = pthread_attr_init(&how);

    if (result != 0)
        return result;
    result = pthread_attr_setstacksize(&how, STACK);
    if (result == 0)
        result = pthread_create(thread, &how, work, context);
    pthread_attr_destroy(&how);
    return result;
}

#endif
