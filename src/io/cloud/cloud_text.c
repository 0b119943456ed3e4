/*
 * cloud_text - see cloud_text.h.
 *
 * Lines before the first row are looked at in every way that a row may be written; the first one
 * that is a row in one of them settles the style, and from there on each line must be a row in it.
 */
#include "cloud_text.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "cloud_run.h"

struct text {
    struct cloud_source *source;
    struct cloud_options style;
    bool begun;         /* the first row was there */
    bool doubtful;      /* it had words behind its numbers: a heading, unless the next has too */
    bool reserved;      /* room was made for all points of the file */
    char *heading;      /* the heading line last seen, or NULL */
    size_t rows;        /* of this block */
    size_t promised;    /* how many its count says, 0: there was no count */
    size_t promised_at; /* line of the count */
    size_t columns;     /* fewest of a row that was looked at */
};

/* A whole number alone on its line may be a count of rows. */
static bool is_count(const struct cloud_row *row)
{
    return row->columns == 1 && row->numbers == 1 && !row->point && row->p.x >= 1 &&
           row->p.x <= 1e15;
}

static void begin_block(struct text *t, const struct cloud_row *count)
{
    t->rows = 0;
    t->promised = (size_t)count->p.x;
    t->promised_at = t->source->reader->line;
    t->source->count->heads++;
}

static int take_row(struct text *t, const struct cloud_row *row, struct error *error)
{
    if (t->promised && t->rows == t->promised)
        return cloud_error(t->source, error,
                           "a row more than the %zu that line %zu says, expected the end or a "
                           "count",
                           t->promised, t->promised_at);
    if (!t->source->reader->ended && row->columns < t->columns)
        return cloud_error(t->source, error,
                           "%zu columns in the last row, expected %zu: the file is cut short",
                           row->columns, t->columns);
    if (cloud_take(t->source, row, error) < 0)
        return -1;
    t->rows++;
    if (!t->style.point)
        t->style.point = row->point;
    if (t->rows == 1 || row->columns < t->columns)
        t->columns = row->columns;
    return 0;
}

/* Control characters that no text has. */
static bool is_binary(const char *line)
{
    for (const char *p = line; *p; p++)
        if ((unsigned char)*p < ' ' && *p != '\t' && *p != '\v' && *p != '\f')
            return true;
    return false;
}

/* A line before the first row that is no row. */
static int heading_line(struct text *t, const char *line, size_t n, const struct cloud_row *closest,
                        struct error *error)
{
    struct cloud_count *count = t->source->count;
    if (is_binary(line))
        return cloud_error(t->source, error,
                           "control characters, expected text and no binary data");
    if (is_count(closest) && count->heads == 0) {
        begin_block(t, closest);
        return 0;
    }
    if (closest->numbers >= 2 || (closest->numbers == 1 && closest->columns == 1))
        return cloud_take(t->source, closest, error);
    free(t->heading);
    t->heading = mem_string(line, n);
    t->promised = 0; /* a number with words behind it on the next line was no count of rows */
    count->heads++;
    return 0;
}

static int first_line(struct text *t, char *line, size_t n, struct error *error)
{
    struct cloud_row row;
    if (cloud_row_sniff(t->heading, line, n, &t->style, &row)) {
        t->begun = true;
        t->doubtful = row.numbers < row.columns;
        return take_row(t, &row, error);
    }
    if (row.kind == CLOUD_COMMENT)
        t->source->count->comments++;
    if (row.kind == CLOUD_COMMENT || row.kind == CLOUD_EMPTY)
        return 0;
    return heading_line(t, line, n, &row, error);
}

/* Line two settles what line one was: `12 3 2019 scan of a panel` before rows of numbers alone. */
static void settle_doubt(struct text *t, char *line, size_t n)
{
    struct cloud_options style;
    struct cloud_row row;
    t->doubtful = false;
    if (!cloud_row_sniff(NULL, line, n, &style, &row) || row.numbers < row.columns)
        return;
    struct cloud_count *count = t->source->count;
    if (count->not_finite > 0)
        count->not_finite = 0;
    else
        count->points--, t->source->points->n--;
    count->columns = t->rows = t->promised = 0;
    count->heads++;
    t->begun = false;
}

static int next_line(struct text *t, char *line, size_t n, struct error *error)
{
    if (t->doubtful)
        settle_doubt(t, line, n);
    if (!t->begun)
        return first_line(t, line, n, error);
    struct cloud_row row = cloud_row_read(&t->style, line, n);
    if (row.kind == CLOUD_EMPTY)
        return 0;
    if (row.kind == CLOUD_COMMENT) {
        t->source->count->comments++;
        return 0;
    }
    if (t->promised && t->rows == t->promised && is_count(&row)) {
        begin_block(t, &row);
        return 0;
    }
    return take_row(t, &row, error);
}

/* Room for the rest of the file, if it goes on as it began: so many rows in so many bytes, and some
 * more, for scans begin in a corner, where coordinates have a sign more and a digit.  Room that is
 * not used costs nothing. */
static void reserve(struct text *t, size_t rows, size_t bytes)
{
    enum { SURE = 256, MOST = 1 << 25 };
    const double more = 1.15;
    if (t->reserved || rows < SURE)
        return;
    t->reserved = true;
    double expected = more * (double)t->source->reader->size * (double)rows / (double)bytes;
    array_reserve(t->source->points,
                  t->source->points->n + (expected < MOST ? (size_t)expected : MOST));
}

/* Rows straight from the reader's buffer, as many as there are whole and plain. */
static void run(struct text *t)
{
    const char *ahead;
    size_t rows, n = reader_ahead(t->source->reader, &ahead);
    size_t most = t->promised ? t->promised - t->rows : n;
    size_t taken = cloud_run(&t->style, ahead, ahead + n, most, t->source->points, &rows);
    if (!t->style.point && memchr(ahead, '.', taken))
        t->style.point = '.';
    reader_take(t->source->reader, taken, rows);
    reserve(t, rows, taken);
    t->rows += rows;
    t->source->count->points += rows;
}

static int at_end(const struct text *t, struct error *error)
{
    const char *name = t->source->reader->name;
    if (t->promised && t->rows < t->promised)
        return error_at(error, name, 0, "%zu rows, expected the %zu that line %zu says", t->rows,
                        t->promised, t->promised_at);
    if (!t->begun)
        return error_at(error, name, 0, "no points, expected rows of x y z");
    return 0;
}

int cloud_text_read(struct cloud_source *source, struct error *error)
{
    struct text t = {.source = source};
    char *line;
    size_t n;
    int got;
    while ((got = cloud_line(source, &line, &n, error)) > 0) {
        if (next_line(&t, line, n, error) < 0) {
            got = -1;
            break;
        }
        if (t.begun && !t.doubtful)
            run(&t);
    }
    free(t.heading);
    return got < 0 ? -1 : at_end(&t, error);
}
