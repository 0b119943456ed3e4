/*
 * cloud_text - see cloud_text.h.
 *
 * Lines before the first row are tried in every style that a row may be written in; the first line
 * that is a row in one of them settles the style, and from there on each line must be a row in it.
 */
#include "cloud_plain.h"
#include "cloud_source.h"

#include <stdlib.h>
#include <string.h>

#include "math/elementary.h"
#include "base/array.h"
#include "base/num.h"

struct field {
    char *from, *to; /* without the blanks around it */
};

/* A comment begins at p: `//`, `;` where it separates no columns, `#` but not that of 1.#IND. */
static bool is_comment(const struct cloud_options *style, const char *p, const char *line)
{
    return (*p == '#' && (p == line || p[-1] != '.')) || (*p == '/' && p[1] == '/') ||
           (*p == ';' && style->delimiter != ';');
}

/* The next column at *s; false when there is none before a comment or the end. */
static bool next_field(const struct cloud_options *style, char **s, const char *line,
                       const char *end, struct field *field)
{
    char *p = *s;
    while (cloud_is_blank(*p))
        p++;
    if (p == end || is_comment(style, p, line))
        return false;
    field->from = p;
    while (p != end && !(style->delimiter == ' ' ? cloud_is_blank(*p) : *p == style->delimiter) &&
           !is_comment(style, p, line))
        p++;
    field->to = p;
    while (field->to > field->from && cloud_is_blank(field->to[-1]))
        field->to--;
    *s = p != end && *p == style->delimiter ? p + 1 : p;
    return true;
}

enum number { NO_NUMBER, NUMBER, NO_FINITE_NUMBER };

/* The whole field as a number.  A comma in it is a decimal comma where the style has no point. */
static enum number read_number(const struct cloud_options *style, struct field f, double *value,
                               char *point)
{
    size_t n = (size_t)(f.to - f.from);
    char *comma = memchr(f.from, ',', n);
    bool has_point = memchr(f.from, '.', n) != NULL;
    if (comma && (has_point || style->point == '.'))
        return NO_NUMBER;
    if (has_point && style->point == ',')
        return NO_NUMBER;
    if (comma)
        *comma = '.';
    const char *p = f.from;
    enum number found = num_read(&p, value) ? NUMBER : NO_NUMBER;
    if (p != f.to) {
        p = f.from;
        found = num_not_finite(&p) ? NO_FINITE_NUMBER : NO_NUMBER;
    }
    if (comma)
        *comma = ',';
    if (p != f.to)
        return NO_NUMBER;
    if (found == NUMBER && !(fabs(*value) <= CLOUD_TOO_LARGE))
        found = NO_FINITE_NUMBER;
    if (found == NUMBER && (comma || has_point))
        *point = comma ? ',' : '.';
    return found;
}

struct cloud_row cloud_row_read(const struct cloud_options *style, char *line, size_t n)
{
    struct cloud_row row = {.kind = CLOUD_POINT};
    const char *end = line + n;
    double coordinate[3] = {0, 0, 0};
    size_t last = 0;
    struct field field;
    char *s = line;
    while (next_field(style, &s, line, end, &field)) {
        double value = 0;
        char point = 0;
        enum number found = read_number(style, field, &value, &point);
        if (found != NO_NUMBER && row.numbers == row.columns)
            row.numbers++;
        for (int i = 0; i < 3; i++) {
            if (style->column[i] != row.columns)
                continue;
            coordinate[i] = value;
            if (row.point && point && row.point != point)
                found = NO_NUMBER;
            if (point)
                row.point = point;
            if (found == NO_FINITE_NUMBER && row.kind == CLOUD_POINT)
                row.kind = CLOUD_NOT_FINITE;
            if (found == NO_NUMBER && row.kind != CLOUD_WORD) {
                row.kind = CLOUD_WORD;
                row.word = field.from;
                row.word_n = field.to - field.from < 40 ? (int)(field.to - field.from) : 40;
            }
        }
        row.columns++;
    }
    for (int i = 0; i < 3; i++)
        last = style->column[i] > last ? style->column[i] : last;
    if (row.columns == 0)
        row.kind = s + strspn(s, " \t") == end ? CLOUD_EMPTY : CLOUD_COMMENT;
    else if (row.columns <= last && row.kind != CLOUD_WORD)
        row.kind = CLOUD_SHORT;
    row.p = vec(coordinate[0], coordinate[1], coordinate[2]);
    return row;
}

/* 0, 1 or 2 when a heading's column is called x, y or z (`"X [mm]"`, `y`), else -1. */
static int axis_of(struct field f)
{
    while (f.from < f.to && (*f.from == '"' || *f.from == '\''))
        f.from++;
    if (f.from == f.to || !strchr("xyzXYZ", *f.from))
        return -1;
    char next = f.from + 1 < f.to ? f.from[1] : ' ';
    if (next == '\0' || !strchr(" \t\"'_([", next))
        return -1;
    return (*f.from | 0x20) - 'x';
}

/* The columns that a heading calls x, y and z, each once; *columns: how many it has in all. */
static bool named_columns(const char *heading, struct cloud_options *style, size_t *columns)
{
    size_t n = strlen(heading);
    char *copy = mem_string(heading, n), *s = copy;
    int times[3] = {0, 0, 0};
    struct field field;
    for (*columns = 0; next_field(style, &s, copy, copy + n, &field); ++*columns) {
        int axis = axis_of(field);
        if (axis >= 0) {
            style->column[axis] = *columns;
            times[axis]++;
        }
    }
    free(copy);
    return times[0] == 1 && times[1] == 1 && times[2] == 1;
}

/*
 * Finds the style in which a line is a row with a point; `heading`, where not NULL, is the line
 * before it: when it names columns x, y and z, and as many columns as the row has, it says which
 * they are; else they are the first three.  False when there is no such style; *row is then what
 * comes closest.
 */
static bool sniff_row(const char *heading, char *line, size_t n, struct cloud_options *style,
                      struct cloud_row *row)
{
    struct cloud_row closest = {0};
    for (const char *delimiter = ";, "; *delimiter; delimiter++) {
        size_t columns = 0;
        *style = (struct cloud_options){.delimiter = *delimiter};
        bool named = heading && named_columns(heading, style, &columns);
        for (int given = named ? 0 : 1; given < 2; given++) {
            if (given)
                for (size_t i = 0; i < 3; i++)
                    style->column[i] = i;
            *row = cloud_row_read(style, line, n);
            if ((row->kind == CLOUD_POINT || row->kind == CLOUD_NOT_FINITE) &&
                (given || row->columns == columns)) {
                style->point = row->point;
                return true;
            }
            if (given && row->numbers >= closest.numbers)
                closest = *row;
        }
    }
    *row = closest;
    return false;
}

/* A row whose first column may be its number and no coordinate. */
struct numbered {
    struct cloud_row row; /* as x y z in the columns after it */
    size_t line;
};

enum {
    SURELY = 4096, /* so many rows that count up from the first are numbers of rows, ... */
    PERHAPS = 4    /* ... and so many, if there are no more */
};

struct text {
    struct cloud_source *source;
    struct { /* rows so far, all of whose first columns count up; see numbered_row */
        size_t n, cap;
        struct numbered *item;
    } numbered;
    double number; /* the first of those */
    size_t first;  /* point of the first of them */
    bool counting; /* the next row may be one of them */
    struct cloud_options style;
    bool looked, even;  /* whether decimals are even was looked at; they are */
    bool begun;         /* the first row was there */
    bool doubtful;      /* it had words after its numbers: a heading, unless the next has too */
    bool reserved;      /* room was made for all points of the file */
    char *heading;      /* the heading line last seen, or NULL */
    size_t rows;        /* of this block */
    size_t promised;    /* how many its count says, 0: there was no count */
    size_t promised_at; /* line of the count */
    size_t columns;     /* fewest of a row that was read one by one */
    bool smooth;        /* what was looked at ahead last was all plain: more may be looked at */
};

/* The first column as a whole number without decimal point, or -1. */
static double row_number(const struct cloud_options *style, char *line, size_t n)
{
    struct cloud_options first = *style;
    for (int i = 0; i < 3; i++)
        first.column[i] = 0;
    struct cloud_row row = cloud_row_read(&first, line, n);
    bool whole = row.kind == CLOUD_POINT && !row.point && row.p.x >= 0 && row.p.x <= 1e15;
    return whole && row.p.x == floor(row.p.x) ? row.p.x : -1;
}

/*
 * Files of points with their numbers, `1 x y z`, would be read as x = 1, 2, 3 ...  No surface has
 * one point at each of so many x, so rows of four columns or more that count up from the first to
 * the last, or SURELY of them, are such.  Until that is known each row stands among the points as
 * x y z in its first columns, and here as numbered.
 */
static void numbered_row(struct text *t, char *line, size_t n)
{
    struct cloud_options style = t->style;
    for (size_t i = 0; i < 3; i++)
        style.column[i] = i + 1;
    double number = row_number(&style, line, n);
    struct cloud_row row = cloud_row_read(&style, line, n);
    if (t->numbered.n == 0)
        t->number = number;
    t->counting = number >= 0 && number == t->number + (double)t->numbered.n &&
                  (row.kind == CLOUD_POINT || row.kind == CLOUD_NOT_FINITE);
    if (t->counting)
        *array_push(&t->numbered) = (struct numbered){.row = row, .line = t->source->reader->line};
}

/* The first column does number the rows: they are taken anew. */
static int take_numbered(struct text *t, struct error *error)
{
    struct cloud_count *count = t->source->count;
    size_t line = t->source->reader->line;
    int status = 0;

    t->source->points->n = t->first;
    count->points = count->not_finite = count->first_not_finite = 0;
    for (size_t i = 0; i < t->numbered.n && status == 0; i++) {
        t->source->reader->line = t->numbered.item[i].line;
        status = cloud_take(t->source, &t->numbered.item[i].row, error);
    }
    t->source->reader->line = line;
    for (size_t i = 0; i < 3; i++)
        t->style.column[i] = i + 1;
    t->counting = false;
    count->indexed = true;
    return status;
}

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
                           "a row more than the %zu of line %zu, expected the end or a "
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
    t->promised = 0; /* a number before a line of words was no count of rows */
    count->heads++;
    return 0;
}

static int first_line(struct text *t, char *line, size_t n, struct error *error)
{
    struct cloud_row row;
    if (sniff_row(t->heading, line, n, &t->style, &row)) {
        const size_t *column = t->style.column;
        t->begun = true;
        t->doubtful = row.numbers < row.columns;
        t->numbered.n = 0;
        t->counting = false;
        t->first = t->source->points->n;
        t->source->count->placed = column[0] != 0 || column[1] != 1 || column[2] != 2;
        if (row.columns > 3 && !t->source->count->placed)
            numbered_row(t, line, n);
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
    if (!sniff_row(NULL, line, n, &style, &row) || row.numbers < row.columns)
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
    if (t->counting)
        numbered_row(t, line, n);
    if (take_row(t, &row, error) < 0)
        return -1;
    return t->counting && t->numbered.n == SURELY ? take_numbered(t, error) : 0;
}

/* Room for the rest of the file, if it goes on as it began: so many rows in so many bytes, and some
 * more, for scans begin in a corner, where coordinates have a sign more and a digit.  Room that is
 * not used costs nothing. */
static void reserve(struct text *t, size_t rows, size_t bytes)
{
    enum { SURE = 256, MOST = 1 << 25 };
    const double more = 1.15;
    if (t->reserved || rows < SURE || t->source->take)
        return;
    t->reserved = true;
    double expected = more * (double)t->source->reader->size * (double)rows / (double)bytes;
    array_reserve(t->source->points,
                  t->source->points->n + (expected < MOST ? (size_t)expected : MOST));
}

/* Rows straight from the reader's buffer, as many as there are whole and plain. */
static void read_plain_rows(struct text *t)
{
    const char *ahead;
    size_t rows, n = reader_ahead(t->source->reader, &ahead);
    size_t most = t->promised ? t->promised - t->rows : n;
    if (!t->looked && n > 0) {
        t->even = cloud_plain_even(ahead, ahead + n);
        t->looked = true;
    }
    if (!t->smooth && n > CLOUD_PLAIN_PART) { /* less of it would be read for nothing */
        const char *feed = memchr(ahead + CLOUD_PLAIN_PART, '\n', n - CLOUD_PLAIN_PART);
        n = (size_t)(feed - ahead) + 1;
    }
    size_t taken = cloud_plain_rows(&t->style, t->even, t->source->threads, ahead, ahead + n, most,
                                    t->source->points, &rows);
    t->smooth = taken == n && n > 0;
    if (!t->style.point && memchr(ahead, '.', taken))
        t->style.point = '.';
    reader_take(t->source->reader, taken, rows);
    reserve(t, rows, taken);
    t->rows += rows;
    t->source->count->points += rows;
    const size_t many = 4096;
    if (rows > 0 || t->source->points->n > many)
        cloud_hand_on(t->source);
}

static int at_end(const struct text *t, struct error *error)
{
    const char *name = t->source->reader->name;
    if (t->promised && t->rows < t->promised)
        return error_at(error, name, 0, "%zu rows, expected the %zu of line %zu", t->rows,
                        t->promised, t->promised_at);
    if (!t->begun)
        return error_at(error, name, 0, "no points, expected rows of x y z");
    return 0;
}

int cloud_text_read(struct cloud_source *source, struct error *error)
{
    enum { AT_ONCE = 1 << 20 };
    struct text t = {.source = source};
    char *line;
    size_t n;
    int got;
    /* for any number of threads, so that the rows that are read one by one are the same */
    if (!source->take && source->reader->size > AT_ONCE)
        source->reader->at_once = AT_ONCE;
    while ((got = cloud_line(source, &line, &n, error)) > 0) {
        if (next_line(&t, line, n, error) < 0) {
            got = -1;
            break;
        }
        if (t.begun && !t.doubtful && !t.counting)
            read_plain_rows(&t);
    }
    if (got == 0 && t.counting && t.numbered.n >= PERHAPS)
        got = take_numbered(&t, error);
    array_free(&t.numbered);
    free(t.heading);
    return got < 0 ? -1 : at_end(&t, error);
}
