/*
 * path_passes - $$-> PASSES: which passes a fitted path has, in their order, as its head says; see
 * path.h and cloudmill-path(5).
 *
 * Parts of a path (path_part.h) are joined by cat, and nothing stands between them.  A pass's own
 * number does not tell whether one is missing: the makers of paths leave out numbers, go back and
 * cut a row in several pieces.  So the head, which is in the first part, lists what all parts hold.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "math/elementary.h"
#include "path_parse.h"

enum { LINE_MOST = 72 }; /* characters */

static void add(struct path_passes *passes, unsigned number)
{
    struct path_pass_range *last = passes->n > 0 ? &passes->item[passes->n - 1] : NULL;

    if (last && last->to >= last->from && number == last->to + 1)
        last->to = number;
    else if (last && last->to <= last->from && number + 1 == last->to)
        last->to = number;
    else
        *array_push(passes) = (struct path_pass_range){number, number};
}

struct path_passes path_passes_of(const struct path *path)
{
    struct path_passes passes = {0};

    for (size_t i = 0; i < path->item.n; i++)
        if (path->item.item[i].kind == PATH_PASS)
            add(&passes, path->item.item[i].index);
    return passes;
}

/* ---- in the head */

/* PASSES/1,3,THRU,18,36,THRU,21: over several lines, since other readers of CL know no continued
 * comments. */
void path_write_passes(struct out *out, const struct path_passes *passes)
{
    static const char word[] = "$$-> PASSES/";
    int column = 0;

    for (size_t i = 0; i < passes->n; i++) {
        struct path_pass_range r = passes->item[i];
        char text[40];
        int n = r.from == r.to ? snprintf(text, sizeof text, "%u", r.from)
                               : snprintf(text, sizeof text, "%u,THRU,%u", r.from, r.to);
        bool starts = column == 0 || column + 1 + n > LINE_MOST;
        out_printf(out, "%s%s%s", starts && column > 0 ? "\n" : "", starts ? word : ",", text);
        column = starts ? (int)strlen(word) + n : column + 1 + n;
    }
    out_text(out, column > 0 ? "\n" : "");
}

static int read_number(struct path_parse *p, size_t k, unsigned *number)
{
    double n;

    if (path_numbers(p, k, 1, &n, "number of a pass") < 0)
        return -1;
    if (n < 0 || n > PATH_PASS_MOST || n != floor(n))
        return error_at(p->error, p->path->name, p->apt.line,
                        "found PASSES/%g, expected whole numbers", n);
    *number = (unsigned)n;
    return 0;
}

int path_read_passes(struct path_parse *p)
{
    for (size_t k = 0; k < p->apt.argument.n || k == 0; k++) {
        struct path_pass_range r;
        if (read_number(p, k, &r.from) < 0)
            return -1;
        r.to = r.from;
        if (apt_is(&p->apt, k + 1, "THRU")) {
            k += 2;
            if (read_number(p, k, &r.to) < 0)
                return -1;
        }
        *array_push(&p->path->head.passes) = r;
    }
    return 0;
}

/* ---- held against the passes that there are */

/* Goes through the numbers of a list. */
struct walk {
    const struct path_passes *list;
    size_t range;
    unsigned done; /* of this range */
};

/* The next number; false: there is none left. */
static bool next_of(struct walk *w, unsigned *number)
{
    if (w->range == w->list->n)
        return false;
    struct path_pass_range r = w->list->item[w->range];
    *number = r.to >= r.from ? r.from + w->done : r.from - w->done;
    if (*number == r.to) {
        w->range++;
        w->done = 0;
    } else {
        w->done++;
    }
    return true;
}

/* The first place where the two differ, as text; false: they are the same. */
static bool differ(const struct path_passes *have, const struct path_passes *want, char *text,
                   size_t size)
{
    struct walk h = {.list = have}, w = {.list = want};
    unsigned found = 0, expected = 0, last = 0;
    bool one, other, first = true;

    for (;; first = false, last = found) {
        one = next_of(&h, &found);
        other = next_of(&w, &expected);
        if (!one && !other)
            return false;
        if (one != other || found != expected)
            break;
    }
    char after[40] = "", a[40] = "the end", b[40] = "the end";
    if (!first)
        snprintf(after, sizeof after, " after pass %u", last);
    if (one)
        snprintf(a, sizeof a, "pass %u", found);
    if (other)
        snprintf(b, sizeof b, "pass %u", expected);
    snprintf(text, size,
             "found %s%s, expected %s, as PASSES of its head says: parts of the path are not in "
             "their order, one is missing, or there twice",
             a, after, b);
    return true;
}

/* The stage that wrote what it spent in each pass: a fitter; NULL: none did. */
static const char *fitter_of(const struct path *path)
{
    for (size_t i = 0; i < path->head.ledger.n; i++)
        if (path->head.ledger.item[i].by_pass)
            return path->head.ledger.item[i].stage;
    return NULL;
}

void path_check_passes(struct path_parse *p)
{
    struct path_head *head = &p->path->head;
    struct path_passes have = {0};
    const char *fitter = fitter_of(p->path);
    char text[240] = "";

    if (fitter && !p->own)
        snprintf(text, sizeof text,
                 "found passes of %.40s without the head that it writes (CLOUDMILL/1), expected "
                 "it: the first part of the path is missing",
                 fitter);
    if (head->passes.n > 0) /* else nobody asks for them */
        have = path_passes_of(p->path);
    if (*text || (head->passes.n > 0 && differ(&have, &head->passes, text, sizeof text)))
        unmets_add(&head->unmet, "path", text);
    array_free(&have);
}
