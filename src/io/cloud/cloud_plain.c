/* cloud_plain - see cloud_plain.h. */
#include "cloud_plain.h"

#include <string.h>

#include "base/num.h"
#include "base/parallel.h"
#include "math/elementary.h"

/* How the columns are written. */
struct manner {
    char delimiter;
    bool even; /* their numbers have as many decimals in nearly each row */
};

static const char *odd_number(const char *p, double *value)
{
    return num_read(&p, value) && fabs(*value) <= CLOUD_TOO_LARGE ? p : NULL;
}

static inline const char *any_number(const char *p, double *value)
{
    const char *after = num_plain(p, value);
    return after ? after : odd_number(p, value);
}

static inline const char *even_number(const char *p, double *value)
{
    const char *after = num_even(p, value);
    return after ? after : odd_number(p, value);
}

/* Over the blanks and the delimiter between two columns; NULL when there is none. */
static inline const char *after_delimiter(const char *p, char delimiter)
{
    if (delimiter == ' ' && !cloud_is_blank(*p))
        return NULL;
    while (cloud_is_blank(*p))
        p++;
    if (delimiter == ' ')
        return p;
    if (*p != delimiter)
        return NULL;
    for (p++; cloud_is_blank(*p); p++)
        ;
    return p;
}

/* From the end of a row's third number to the next line; NULL when something else is there. */
static inline const char *after_row(const char *p, char delimiter)
{
    if (*p == '\n')
        return p + 1;
    const char *third = p;
    while (cloud_is_blank(*p))
        p++;
    if (delimiter == ' ' ? p != third : *p == delimiter)
        while ((unsigned char)*p >= ' ' || *p == '\t')
            p++;
    p += *p == '\r';
    return *p == '\n' ? p + 1 : NULL;
}

typedef const char *number_reader(const char *p, double *value);

/* One row at p: the start of the next, or NULL when it is not plain. */
static inline const char *row_by(number_reader *number, const char *p, char delimiter,
                                 struct vec3 *row)
{
    while (cloud_is_blank(*p))
        p++;
    if (!(p = number(p, &row->x)) || !(p = after_delimiter(p, delimiter)) ||
        !(p = number(p, &row->y)) || !(p = after_delimiter(p, delimiter)) ||
        !(p = number(p, &row->z)))
        return NULL;
    return after_row(p, delimiter);
}

static const char *any_row(const char *p, char delimiter, struct vec3 *row)
{
    return row_by(any_number, p, delimiter, row);
}

static const char *even_row(const char *p, char delimiter, struct vec3 *row)
{
    return row_by(even_number, p, delimiter, row);
}

static inline const char *one_row(const char *p, struct manner how, struct vec3 *row)
{
    return how.even ? even_row(p, how.delimiter, row) : any_row(p, how.delimiter, row);
}

enum { SHORTEST_ROW = 6 }; /* `0 0 0` and its line end */

/* Rows from both places in turn, as long as they are plain and before `middle` and `end`: where a
 * number ends, which the next one waits for, is found for two of them at once. */
static inline size_t rows_in_turn(const char *at[2], const char *middle, const char *end,
                                  struct manner how, struct vec3 *first, struct vec3 *second)
{
    size_t rows = 0;
    while (at[0] != middle && at[1] != end) {
        const char *p = one_row(at[0], how, &first[rows]);
        const char *q = one_row(at[1], how, &second[rows]);
        if (!p || !q)
            break;
        at[0] = p;
        at[1] = q;
        rows++;
    }
    return rows;
}

static inline const char *rows_of(const char *p, const char *end, struct manner how,
                                  struct vec3 *point, size_t most, size_t *rows)
{
    for (*rows = 0; p != end && *rows < most; ++*rows) {
        const char *next = one_row(p, how, &point[*rows]);
        if (!next)
            break;
        p = next;
    }
    return p;
}

static const char *after_line(const char *p, const char *end)
{
    const char *feed = memchr(p, '\n', (size_t)(end - p));
    return feed ? feed + 1 : end;
}

static size_t count_lines(const char *p, const char *end)
{
    enum { AT_ONCE = 128 }; /* so that a byte holds how many */
    size_t lines = 0;
    for (; end - p >= AT_ONCE; p += AT_ONCE) {
        unsigned char some = 0;
        for (int i = 0; i < AT_ONCE; i++)
            some = (unsigned char)(some + (p[i] == '\n'));
        lines += some;
    }
    for (; p < end; p++)
        lines += *p == '\n';
    return lines;
}

/* The same, of much text by halves: the rows of the second stand behind as many as the first has
 * lines, and if one of these is no plain row they are as if they had not been read. */
static inline const char *halves_of(const char *p, const char *end, struct manner how,
                                    struct vec3 *point, size_t most, size_t *rows)
{
    enum { MANY = 4096 }; /* bytes that are worth it */
    if (end - p < MANY || (size_t)(end - p) / SHORTEST_ROW > most)
        return rows_of(p, end, how, point, most, rows);
    const char *middle = after_line(p + (end - p) / 2, end);
    struct vec3 *second = point + count_lines(p, middle);
    const char *at[2] = {p, middle};
    size_t both = rows_in_turn(at, middle, end, how, point, second), left, right;
    p = rows_of(at[0], middle, how, point + both, most, &left);
    *rows = both + left;
    if (p != middle)
        return p;
    p = rows_of(at[1], end, how, second + both, most, &right);
    *rows += both + right;
    return p;
}

/* Text in parts of whole lines, each with a place for the points that it has if all are plain. */
struct parts {
    struct manner how;
    struct vec3 *point;
    size_t lines, n;
    struct part {
        const char *from, *end, *after;
        size_t first, rows;
    } part[CLOUD_PLAIN_PARTS];
};

static size_t most_rows(const char *text, const char *end)
{
    return (size_t)(end - text) / SHORTEST_ROW;
}

static void cut_into_parts(const char *text, const char *end, struct parts *parts)
{
    size_t n = (size_t)(end - text), wanted = n / CLOUD_PLAIN_PART;
    const char *from = text, *to;
    wanted = wanted < CLOUD_PLAIN_PARTS ? wanted : CLOUD_PLAIN_PARTS;
    for (size_t k = 1; from < end; k++, from = to) {
        to = k < wanted ? after_line(text + n / wanted * k, end) : end;
        if (to <= from) { /* in a line that is longer than a part */
            to = from;
            continue;
        }
        parts->part[parts->n++] = (struct part){from, to, from, parts->lines, 0};
        parts->lines += count_lines(from, to);
    }
}

static void read_parts(void *context, size_t from, size_t to)
{
    struct parts *parts = context;
    for (size_t k = from; k < to; k++) {
        struct part *p = &parts->part[k];
        p->after = halves_of(p->from, p->end, parts->how, parts->point + p->first,
                             most_rows(p->from, p->end), &p->rows);
    }
}

/* The same as halves_of by several threads: parts up to the first with a row that is not plain. */
static const char *parts_of(struct parts *parts, int threads, size_t *rows)
{
    const struct part *p = parts->part;
    parallel_for(threads, parts->n, read_parts, parts);
    *rows = p->rows;
    while (p->after == p->end && p + 1 < parts->part + parts->n)
        *rows += (++p)->rows;
    return p->after;
}

/* How many decimals the first three numbers with a point have in the row at *p, which goes to the
 * next one, a byte for each. */
static unsigned decimals_of_row(const char **p)
{
    const char *s = *p;
    unsigned all = 0;
    for (int numbers = 0; *s != '\n'; s++) {
        if (*s != '.' || numbers++ >= 3)
            continue;
        const char *point = s;
        while (s[1] >= '0' && s[1] <= '9')
            s++;
        all = all << 8 | ((unsigned)(s - point) & 0xff);
    }
    *p = s + 1;
    return all;
}

bool cloud_plain_even(const char *text, const char *end)
{
    enum { LOOK = 64, OTHERS = LOOK / 16 };
    unsigned first = decimals_of_row(&text);
    int others = 0;
    for (int row = 1; row < LOOK && text < end; row++)
        others += decimals_of_row(&text) != first;
    return others <= OTHERS;
}

size_t cloud_plain_rows(const struct cloud_options *style, bool even, int threads, const char *text,
                        const char *end, size_t most, struct vec3s *points, size_t *rows)
{
    const size_t *column = style->column;
    *rows = 0;
    if (style->point == ',' || column[0] != 0 || column[1] != 1 || column[2] != 2)
        return 0;
    size_t fit = most_rows(text, end);
    bool several = most >= fit && end - text >= 2 * CLOUD_PLAIN_PART;
    struct parts parts = {.how = {style->delimiter, even}};
    if (most > fit)
        most = fit;
    if (most == 0)
        return 0;
    if (several) {
        cut_into_parts(text, end, &parts);
        most = parts.lines;
    }
    array_reserve(points, points->n + most + 1); /* the last may prove to be no whole row */
    parts.point = points->item + points->n;
    const char *after = several ? parts_of(&parts, threads, rows)
                                : halves_of(text, end, parts.how, parts.point, most, rows);
    points->n += *rows;
    return (size_t)(after - text);
}
