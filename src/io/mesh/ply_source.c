/* ply_source - see ply_source.h. */
#include "ply_source.h"

#include <math.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "base/num.h"

static const char blanks[] = " \t";

int ply_error(const struct ply_source *s, struct error *error, const char *format, ...)
{
    char text[200];
    va_list args;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    return error_at(error, s->reader->name, s->format == PLY_ASCII ? s->reader->line : 0, "%s",
                    text);
}

/* Letters of the word at s that a message shows. */
static int shown(const char *s)
{
    size_t n = strcspn(s, blanks);
    return n < 40 ? (int)n : 40;
}

static int ends_early(const struct ply_source *s, struct error *error)
{
    return ply_error(s, error, "the file ends behind %zu rows of element %s, expected %zu", s->row,
                     s->element->name, s->element->count);
}

/* The next line that is not empty: 1, 0 at the end, -1. */
static int next_line(struct ply_source *s, struct error *error)
{
    char *line;
    size_t n;
    int got;
    while ((got = reader_line(s->reader, &line, &n, error)) > 0) {
        s->at = line;
        s->end = line + n;
        if (line + strspn(line, blanks) != s->end)
            break;
    }
    return got;
}

int ply_row_begin(struct ply_source *s, struct error *error)
{
    if (s->format != PLY_ASCII)
        return 0;
    int got = next_line(s, error);
    return got > 0 ? 0 : got < 0 ? -1 : ends_early(s, error);
}

int ply_row_end(struct ply_source *s, struct error *error)
{
    if (s->format != PLY_ASCII)
        return 0;
    s->at += strspn(s->at, blanks);
    if (s->at == s->end)
        return 0;
    return ply_error(s, error, "'%.*s' behind the last property of element %s, expected a line end",
                     shown(s->at), s->at, s->element->name);
}

static int ascii_value(struct ply_source *s, double *value, struct error *error)
{
    s->at += strspn(s->at, blanks);
    if (s->at == s->end)
        return ply_error(s, error, "too few numbers in a row of element %s, expected %zu or more",
                         s->element->name, s->element->property.n);
    const char *p = s->at;
    bool finite = num_read(&p, value);
    if (!finite && num_not_finite(&p))
        *value = NAN;
    if (p == s->at || (p != s->end && *p != ' ' && *p != '\t'))
        return ply_error(s, error, "'%.*s' is no number, expected one", shown(s->at), s->at);
    s->at = p;
    return 0;
}

/* The value that the bits of a type stand for. */
static double from_bits(uint64_t bits, enum ply_type type)
{
    uint32_t low = (uint32_t)bits;
    float f;
    double d;
    switch (type) {
    case PLY_INT8:
        return (int)(low & 0xFF) - (low & 0x80 ? 0x100 : 0);
    case PLY_INT16:
        return (int)(low & 0xFFFF) - (low & 0x8000 ? 0x10000 : 0);
    case PLY_INT32:
        return (double)low - (low & 0x80000000u ? 4294967296.0 : 0.0);
    case PLY_FLOAT32:
        memcpy(&f, &low, sizeof f);
        return (double)f;
    case PLY_FLOAT64:
        memcpy(&d, &bits, sizeof d);
        return d;
    default:
        return (double)low;
    }
}

static int binary_value(struct ply_source *s, enum ply_type type, double *value,
                        struct error *error)
{
    static const size_t sizes[] = {
        [PLY_INT8] = 1,  [PLY_UINT8] = 1,  [PLY_INT16] = 2,   [PLY_UINT16] = 2,
        [PLY_INT32] = 4, [PLY_UINT32] = 4, [PLY_FLOAT32] = 4, [PLY_FLOAT64] = 8,
    };
    unsigned char byte[8];
    size_t size = sizes[type];
    long got = reader_bytes(s->reader, byte, size, error);
    if (got < 0)
        return -1;
    if ((size_t)got < size)
        return ends_early(s, error);
    uint64_t bits = 0;
    for (size_t i = 0; i < size; i++)
        bits = bits << 8 | byte[s->format == PLY_BIG_ENDIAN ? i : size - 1 - i];
    *value = from_bits(bits, type);
    return 0;
}

int ply_value(struct ply_source *s, enum ply_type type, double *value, struct error *error)
{
    return s->format == PLY_ASCII ? ascii_value(s, value, error)
                                  : binary_value(s, type, value, error);
}

int ply_length(struct ply_source *s, enum ply_type type, size_t *length, struct error *error)
{
    double value;
    if (ply_value(s, type, &value, error) < 0)
        return -1;
    if (!(value >= 0 && value <= UINT32_MAX && value == floor(value)))
        return ply_error(s, error, "a list of length %g, expected a whole number", value);
    *length = (size_t)value;
    return 0;
}

int ply_skip(struct ply_source *s, const struct ply_property *property, struct error *error)
{
    double value;
    size_t n = 1;
    if (property->list && ply_length(s, property->length_type, &n, error) < 0)
        return -1;
    for (size_t i = 0; i < n; i++)
        if (ply_value(s, property->type, &value, error) < 0)
            return -1;
    return 0;
}

int ply_finish(struct ply_source *s, struct error *error)
{
    int got = next_line(s, error);
    if (got <= 0)
        return got;
    return ply_error(s, error, "more than the %zu rows of element %s, expected the end of the file",
                     s->element->count, s->element->name);
}
