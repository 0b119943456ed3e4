/*
 * cloud_run - see cloud_run.h.
 *
 * Most of the time that a cloud takes is spent here, so that this walks over the text but once,
 * copies nothing, and tests no more than it must to know that a row is plain.
 */
#include "cloud_run.h"

#include <math.h>
#include <stdbool.h>

#include "base/array.h"
#include "base/num.h"

static inline bool is_blank(char c)
{
    return c == ' ' || c == '\t';
}

static inline const char *any_number(const char *p, double *value)
{
    const char *behind = num_plain(p, value);
    if (behind)
        return behind;
    return num_read(&p, value) && fabs(*value) <= CLOUD_TOO_LARGE ? p : NULL;
}

/* From the blanks and, where that is none, the parting between two columns; NULL: there is none. */
static inline const char *behind_parting(const char *p, char parting)
{
    if (parting == ' ' && !is_blank(*p))
        return NULL;
    while (is_blank(*p))
        p++;
    if (parting == ' ')
        return p;
    if (*p != parting)
        return NULL;
    for (p++; is_blank(*p); p++)
        ;
    return p;
}

/* From behind a row's third number to behind its line end; NULL when something else is there. */
static inline const char *behind_row(const char *p, char parting)
{
    if (*p == '\n')
        return p + 1;
    const char *third = p;
    while (is_blank(*p))
        p++;
    if (parting == ' ' ? p != third : *p == parting)
        while ((unsigned char)*p >= ' ' || *p == '\t')
            p++;
    p += *p == '\r';
    return *p == '\n' ? p + 1 : NULL;
}

/* One row at p: what stands behind it, or NULL when it is not plain. */
static inline const char *one_row(const char *p, char parting, struct vec3 *row)
{
    while (is_blank(*p))
        p++;
    if (!(p = any_number(p, &row->x)) || !(p = behind_parting(p, parting)) ||
        !(p = any_number(p, &row->y)) || !(p = behind_parting(p, parting)) ||
        !(p = any_number(p, &row->z)))
        return NULL;
    return behind_row(p, parting);
}

/* Written out for one parting each, so that the compiler knows it. */
static inline const char *rows_of(const char *p, const char *end, char parting, struct vec3 *point,
                                  size_t most, size_t *rows)
{
    for (*rows = 0; p != end && *rows < most; ++*rows) {
        const char *next = one_row(p, parting, &point[*rows]);
        if (!next)
            break;
        p = next;
    }
    return p;
}

size_t cloud_run(const struct cloud_options *style, const char *text, const char *end, size_t most,
                 struct vec3s *points, size_t *rows)
{
    enum { SHORTEST_ROW = 6 }; /* `0 0 0` and its line end */
    const size_t *column = style->column;
    *rows = 0;
    if (style->point == ',' || column[0] != 0 || column[1] != 1 || column[2] != 2)
        return 0;
    size_t fit = (size_t)(end - text) / SHORTEST_ROW;
    if (most > fit)
        most = fit;
    if (most == 0)
        return 0;
    array_reserve(points, points->n + most);
    struct vec3 *point = points->item + points->n;
    const char *behind = style->parting == ','   ? rows_of(text, end, ',', point, most, rows)
                         : style->parting == ';' ? rows_of(text, end, ';', point, most, rows)
                                                 : rows_of(text, end, ' ', point, most, rows);
    points->n += *rows;
    return (size_t)(behind - text);
}
