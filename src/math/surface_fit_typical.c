/* surface_fit_typical - how many points most surfaces take; see surface_fit.h. */
#include <stdlib.h>

#include "base/array.h"
#include "base/parallel.h"
#include "math/surface_fit.h"

enum { SAMPLE = 200, FEWEST = 32 };

struct sample {
    const struct surface_fit_options *rule;
    const struct vec3 *place, *guess;
    size_t places, n; /* of them, looked at */
    size_t *widest;
};

static void choose(void *context, size_t from, size_t to)
{
    const struct sample *sample = context;
    struct surface_fit_hood *hood = surface_fit_hood_new();
    for (size_t i = from; i < to; i++) {
        size_t at = i * sample->places / sample->n;
        sample->widest[i] =
            surface_fit_widest(sample->rule, sample->place[at], sample->guess[at], hood);
    }
    surface_fit_hood_free(hood);
}

static int by_size(const void *a, const void *b)
{
    size_t x = *(const size_t *)a, y = *(const size_t *)b;
    return (x > y) - (x < y);
}

size_t surface_fit_typical(const struct surface_fit_options *rule, const struct vec3 *place,
                           const struct vec3 *guess, size_t n, int threads)
{
    size_t some = n < SAMPLE ? n : SAMPLE;
    struct sample sample = {rule, place, guess, n, some, mem_alloc(some, sizeof(size_t))};
    parallel_for(threads, some, choose, &sample);
    qsort(sample.widest, some, sizeof *sample.widest, by_size);
    size_t typical = some > 0 ? sample.widest[some / 2] : FEWEST;
    free(sample.widest);
    return typical;
}
