/* parallel - threads that take piece after piece from one counter; see parallel.h. */
#include "base/parallel.h"

#include <pthread.h>

#include "base/cli.h"
#include "system.h"
#include "thread.h"

enum { MOST_THREADS = 64, MOST_PIECE = 64, PIECES_EACH = 8 };

struct share {
    void (*work)(void *context, size_t from, size_t to);
    void *context;
    size_t n, next, piece;
    pthread_mutex_t lock; /* on next */
};

/* Piece after piece; the thread that was given `what` to show tells how far all of them are. */
static void take_pieces(struct share *s, const char *what)
{
    for (;;) {
        pthread_mutex_lock(&s->lock);
        size_t from = s->next;
        size_t to = s->n - from > s->piece ? from + s->piece : s->n;
        s->next = to;
        pthread_mutex_unlock(&s->lock);
        if (what)
            progress(what, from, s->n);
        if (from == to)
            return;
        s->work(s->context, from, to);
    }
}

static void *run_worker(void *argument)
{
    take_pieces(argument, NULL);
    return NULL;
}

void parallel_for(int threads, size_t n, void (*work)(void *context, size_t from, size_t to),
                  void *context)
{
    parallel_shown(NULL, threads, n, work, context);
}

void parallel_shown(const char *what, int threads, size_t n,
                    void (*work)(void *context, size_t from, size_t to), void *context)
{
    struct share share = {work, context, n, 0, 1, PTHREAD_MUTEX_INITIALIZER};
    pthread_t thread[MOST_THREADS];
    long wanted = threads > 0 ? threads : sysconf(_SC_NPROCESSORS_ONLN);
    size_t piece = wanted > 0 ? n / (size_t)wanted / PIECES_EACH : MOST_PIECE;
    share.piece = piece < 1 ? 1 : piece > MOST_PIECE ? MOST_PIECE : piece;
    int started = 0;
    /* this thread works too; where no other can be had it does all of it */
    while (started < MOST_THREADS && started + 1 < wanted &&
           (size_t)(started + 1) * share.piece < n &&
           thread_begin(&thread[started], run_worker, &share) == 0)
        started++;
    take_pieces(&share, what);
    for (int i = 0; i < started; i++)
        pthread_join(thread[i], NULL);
    pthread_mutex_destroy(&share.lock);
}
