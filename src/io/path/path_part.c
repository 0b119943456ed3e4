/* path_part - see path_part.h. */
#include "io/path/path_part.h"

#include <stdlib.h>

int path_part_read(const char *text, struct path_part *part, struct error *error)
{
    char *slash = NULL, *end = NULL;

    part->k = strtol(text, &slash, 10);
    part->n = *slash == '/' ? strtol(slash + 1, &end, 10) : 0;
    if (*text < '0' || *text > '9' || !end || end == slash + 1 || *end || part->k < 1 ||
        part->n < part->k || part->n > PATH_PART_MOST)
        return error_set(error,
                         "option --part: found '%.40s', expected K/N, part K of N, N at most %d",
                         text, PATH_PART_MOST);
    return 0;
}

void path_part_share(struct path_part part, size_t n, size_t *from, size_t *to)
{
    size_t k = (size_t)part.k, parts = (size_t)part.n;

    *from = parts ? n / parts * (k - 1) + n % parts * (k - 1) / parts : 0;
    *to = parts ? n / parts * k + n % parts * k / parts : n;
}

/* The first pass that begins at `at` or after it. */
static size_t next_pass(const struct path *path, size_t at)
{
    while (at < path->item.n && path->item.item[at].kind != PATH_PASS)
        at++;
    return at;
}

void path_part_items(struct path_part part, const struct path *path, size_t *from, size_t *to)
{
    path_part_share(part, path->item.n, from, to);
    *from = path_part_first(part) ? 0 : next_pass(path, *from);
    *to = part.n == 0 || path_part_last(part) ? path->item.n : next_pass(path, *to);
}
