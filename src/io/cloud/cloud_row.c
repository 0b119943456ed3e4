/* cloud_row - see cloud_row.h. */
#include "cloud_row.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/num.h"

struct field {
    char *from, *to; /* without the blanks around it */
};

static bool is_blank(char c)
{
    return c == ' ' || c == '\t';
}

/* A comment begins at p: `//`, `;` where it parts no columns, `#` but not that of 1.#IND. */
static bool is_comment(const struct cloud_options *style, const char *p, const char *line)
{
    return (*p == '#' && (p == line || p[-1] != '.')) || (*p == '/' && p[1] == '/') ||
           (*p == ';' && style->parting != ';');
}

/* The next column at *s; false when there is none before a comment or the end. */
static bool next_field(const struct cloud_options *style, char **s, const char *line,
                       const char *end, struct field *field)
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

bool cloud_row_sniff(const char *heading, char *line, size_t n, struct cloud_options *style,
                     struct cloud_row *row)
{
    struct cloud_row closest = {0};
    for (const char *parting = ";, "; *parting; parting++) {
        size_t columns = 0;
        *style = (struct cloud_options){.parting = *parting};
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
