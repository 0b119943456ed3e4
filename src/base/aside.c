/* aside - one thread that waits for work; see aside.h. */
#include "base/aside.h"

#include <pthread.h>
#include <stddef.h>
#include <stdlib.h>

#include "base/array.h"
#include "system.h"
#include "thread.h"

struct piece {
    void (*work)(void *context); /* NULL: none */
    void *context;
};

struct aside {
    struct piece now, next; /* to be done, or in hand; after it */
    bool has_thread, ends;
    pthread_t thread;
    pthread_mutex_t lock; /* on now, next and ends */
    pthread_cond_t changed;
};

static void *run_aside(void *argument)
{
    struct aside *a = argument;
    pthread_mutex_lock(&a->lock);
    while (a->now.work || !a->ends) {
        if (!a->now.work) {
            pthread_cond_wait(&a->changed, &a->lock);
            continue;
        }
        pthread_mutex_unlock(&a->lock);
        a->now.work(a->now.context);
        pthread_mutex_lock(&a->lock);
        a->now = a->next;
        a->next = (struct piece){0};
        pthread_cond_signal(&a->changed);
    }
    pthread_mutex_unlock(&a->lock);
    return NULL;
}

struct aside *aside_begin(int threads)
{
    struct aside *a = mem_alloc(1, sizeof *a);
    long wanted = threads > 0 ? threads : sysconf(_SC_NPROCESSORS_ONLN);
    pthread_mutex_init(&a->lock, NULL);
    pthread_cond_init(&a->changed, NULL);
    a->has_thread = wanted > 1 && thread_begin(&a->thread, run_aside, a) == 0;
    return a;
}

void aside_wait(struct aside *a)
{
    pthread_mutex_lock(&a->lock);
    while (a->now.work)
        pthread_cond_wait(&a->changed, &a->lock);
    pthread_mutex_unlock(&a->lock);
}

bool aside_add(struct aside *a, void (*work)(void *context), void *context)
{
    struct piece piece = {work, context};

    if (!a->has_thread) {
        work(context);
        return true;
    }
    pthread_mutex_lock(&a->lock);
    bool room = !a->next.work;
    if (room)
        *(a->now.work ? &a->next : &a->now) = piece;
    pthread_cond_signal(&a->changed);
    pthread_mutex_unlock(&a->lock);
    return room;
}

bool aside_is_full(struct aside *a)
{
    pthread_mutex_lock(&a->lock);
    bool full = a->next.work != NULL;
    pthread_mutex_unlock(&a->lock);
    return full;
}

void *aside_drop(struct aside *a)
{
    pthread_mutex_lock(&a->lock);
    void *context = a->next.work ? a->next.context : NULL;
    a->next = (struct piece){0};
    pthread_mutex_unlock(&a->lock);
    return context;
}

void aside_do(struct aside *a, void (*work)(void *context), void *context)
{
    if (!a->has_thread) {
        work(context);
        return;
    }
    aside_wait(a);
    aside_add(a, work, context);
}

void aside_end(struct aside *a)
{
    aside_wait(a);
    if (a->has_thread) {
        pthread_mutex_lock(&a->lock);
        a->ends = true;
        pthread_cond_signal(&a->changed);
        pthread_mutex_unlock(&a->lock);
        pthread_join(a->thread, NULL);
    }
    pthread_cond_destroy(&a->changed);
    pthread_mutex_destroy(&a->lock);
    free(a);
}
