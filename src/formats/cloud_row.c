/*
 * cloud_row - see cloud_row.h.
 *
 * Two readers of the same rows: cloud_row_read takes a line apart column by column and can say what
 * is wrong with it; cloud_row_run walks over the text itself and leaves what is not plain to the
 * other.
 */
#include "cloud_row.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "array.h"
#include "num.h"

static const double TOO_LARGE = 1e30; /* its fourth power, in a quadric's sums, is still finite */

struct field {
    char *from, *to; /* without the blanks around it */
};

static bool is_blank(char c)
{
    return c == ' ' || c == '\t';
}

/* A comment begins at p: `//`, `;` where it parts no columns, `#` but not that of 1.#IND. */
static bool is_comment(const struct cloud_style *style, const char *p, const char *line)
{
    return (*p == '#' && (p == line || p[-1] != '.')) || (*p == '/' && p[1] == '/') ||
           (*p == ';' && style->parting != ';');
}

/* The next column at *s; false when there is none before a comment or the end. */
static bool next_field(const struct cloud_style *style, char **s, const char *line, const char *end,
                       struct field *field)
{
    char *p = *s;
    while (is_blank(*p))
        p++;
    if (p == end || is_comment(style, p, line))
        return false;
    field->from = p;
    while (p != end && !(style->parting == ' ' ? is_blank(*p) : *p == style->parting) &&
           !is_comment(style, p, line))
        p++;
    field->to = p;
    while (field->to > field->from && is_blank(field->to[-1]))
        field->to--;
    *s = p != end && *p == style->parting ? p + 1 : p;
    return true;
}

enum number { NO_NUMBER, NUMBER, NO_FINITE_NUMBER };

/* The whole field as a number.  A comma in it is a decimal comma where the style has no point. */
static enum number read_number(const struct cloud_style *style, struct field f, double *value,
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
    if (found == NUMBER && !(fabs(*value) <= TOO_LARGE))
        found = NO_FINITE_NUMBER;
    if (found == NUMBER && (comma || has_point))
        *point = comma ? ',' : '.';
    return found;
}

struct cloud_row cloud_row_read(const struct cloud_style *style, char *line, size_t n)
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
static bool named_columns(const char *heading, struct cloud_style *style, size_t *columns)
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

bool cloud_row_sniff(const char *heading, char *line, size_t n, struct cloud_style *style,
                     struct cloud_row *row)
{
    struct cloud_row closest = {0};
    for (const char *parting = ";, "; *parting; parting++) {
        size_t columns = 0;
        *style = (struct cloud_style){.parting = *parting};
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

/* A number of at most 15 digits and no exponent at p; returns what stands behind it, or NULL. */
static inline const char *short_number(const char *p, double *value)
{
    static const double ten[] = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
    bool negative = *p == '-';
    p += negative;
    uint64_t mantissa = 0;
    size_t digits, decimals = 0;
    const char *first = p;
    for (; *p >= '0' && *p <= '9'; p++)
        mantissa = mantissa * 10 + (uint64_t)(*p - '0');
    digits = (size_t)(p - first);
    if (*p == '.') {
        for (first = ++p; *p >= '0' && *p <= '9'; p++)
            mantissa = mantissa * 10 + (uint64_t)(*p - '0');
        decimals = (size_t)(p - first);
        digits += decimals;
    }
    if (digits - 1 >= 15 || *p >= 'A') /* none or too many; an exponent */
        return NULL;
    /* both are exact, so that one division rounds once: the nearest double */
    double magnitude = (double)(int64_t)mantissa / ten[decimals];
    *value = negative ? -magnitude : magnitude;
    return p;
}

static inline const char *run_number(const char *p, double *value)
{
    const char *behind = short_number(p, value);
    if (behind)
        return behind;
    return num_read(&p, value) && fabs(*value) <= TOO_LARGE ? p : NULL;
}

/* From the blanks and, where that is none, the parting between two columns; NULL: there is none. */
static inline const char *run_parting(const char *p, char parting)
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
static inline const char *run_rest(const char *p, char parting)
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
static inline const char *run_row(const char *p, char parting, struct vec3 *row)
{
    while (is_blank(*p))
        p++;
    if (!(p = run_number(p, &row->x)) || !(p = run_parting(p, parting)) ||
        !(p = run_number(p, &row->y)) || !(p = run_parting(p, parting)) ||
        !(p = run_number(p, &row->z)))
        return NULL;
    return run_rest(p, parting);
}

/* Written out for one parting each, so that the compiler knows it. */
static inline const char *run(const char *p, const char *end, char parting, struct vec3 *point,
                              size_t most, size_t *rows)
{
    for (*rows = 0; p != end && *rows < most; ++*rows) {
        const char *next = run_row(p, parting, &point[*rows]);
        if (!next)
            break;
        p = next;
    }
    return p;
}

size_t cloud_row_run(const struct cloud_style *style, const char *text, const char *end,
                     size_t most, struct vec3s *points, size_t *rows)
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
    const char *behind = style->parting == ','   ? run(text, end, ',', point, most, rows)
                         : style->parting == ';' ? run(text, end, ';', point, most, rows)
                                                 : run(text, end, ' ', point, most, rows);
    points->n += *rows;
    return (size_t)(behind - text);
}
