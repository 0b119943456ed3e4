/* cloud_source - see cloud_source.h. */
#include "cloud_source.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "base/array.h"

int cloud_error(const struct cloud_source *s, struct error *error, const char *format, ...)
{
    char text[200];
    va_list args;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    return error_at(error, s->reader->name, s->reader->line, "%s", text);
}

int cloud_line(struct cloud_source *s, char **line, size_t *n, struct error *error)
{
    int got = reader_line(s->reader, line, n, error);
    if (got > 0 && memchr(*line, '\0', *n))
        return cloud_error(s, error, "a NUL byte, expected text and no binary data");
    return got;
}

int cloud_take(struct cloud_source *s, const struct cloud_row *row, struct error *error)
{
    if (row->kind == CLOUD_WORD)
        return cloud_error(s, error, "'%.*s' is no number, expected a row of x y z", row->word_n,
                           row->word);
    if (row->kind != CLOUD_POINT && row->kind != CLOUD_NOT_FINITE)
        return cloud_error(s, error, "%zu column%s in the row, expected the three of x y z",
                           row->columns, row->columns == 1 ? "" : "s");
    if (row->columns > s->count->columns)
        s->count->columns = row->columns;
    if (row->kind == CLOUD_POINT) {
        *array_push(s->points) = row->p;
        s->count->points++;
    } else if (s->count->not_finite++ == 0) {
        s->count->first_not_finite = s->reader->line;
    }
    return 0;
}
