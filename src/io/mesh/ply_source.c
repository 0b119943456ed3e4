/* ply_source - see ply_source.h. */
#include "ply_source.h"

#include <limits.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "math/elementary.h"
#include "base/num.h"
#include "ply_origin.h"

enum { WORDS = 6 };

/* Cuts a line into its words in place; those beyond WORDS stay in the last one. */
static int split_words(char *line, char *word[WORDS])
{
    int n = 0;
    for (char *p = line; n < WORDS; n++) {
        p += strspn(p, " \t");
        if (!*p)
            break;
        word[n] = p;
        p += strcspn(p, " \t");
        if (*p && n + 1 < WORDS)
            *p++ = '\0';
    }
    return n;
}

static bool type_read(const char *word, enum ply_type *type)
{
    static const char *const name[][2] = {
        [PLY_INT8] = {"char", "int8"},        [PLY_UINT8] = {"uchar", "uint8"},
        [PLY_INT16] = {"short", "int16"},     [PLY_UINT16] = {"ushort", "uint16"},
        [PLY_INT32] = {"int", "int32"},       [PLY_UINT32] = {"uint", "uint32"},
        [PLY_FLOAT32] = {"float", "float32"}, [PLY_FLOAT64] = {"double", "float64"},
    };
    for (int i = PLY_INT8; i <= PLY_FLOAT64; i++)
        if (strcmp(word, name[i][0]) == 0 || strcmp(word, name[i][1]) == 0) {
            *type = (enum ply_type)i;
            return true;
        }
    return false;
}

/* A count of rows: digits alone, and no more than memory could ever hold. */
static bool count_read(const char *word, size_t *count)
{
    size_t value = 0;
    if (!*word)
        return false;
    for (const char *p = word; *p; p++) {
        if (*p < '0' || *p > '9' || value > LLONG_MAX / 100)
            return false;
        value = value * 10 + (size_t)(*p - '0');
    }
    *count = value;
    return true;
}

static int read_format(struct ply_head *head, int n, char *word[], const struct reader *r,
                       struct error *error)
{
    static const char *const name[] = {
        [PLY_ASCII] = "ascii",
        [PLY_LITTLE_ENDIAN] = "binary_little_endian",
        [PLY_BIG_ENDIAN] = "binary_big_endian",
    };
    for (int i = PLY_ASCII; n >= 2 && i <= PLY_BIG_ENDIAN; i++)
        if (strcmp(word[1], name[i]) == 0) {
            head->format = (enum ply_format)i;
            return 0;
        }
    return error_at(error, r->name, r->line,
                    "PLY format '%.40s', expected ascii, binary_little_endian or binary_big_endian",
                    n >= 2 ? word[1] : "");
}

static int read_element(struct ply_head *head, int n, char *word[], const struct reader *r,
                        struct error *error)
{
    size_t count;
    if (n != 3 || !count_read(word[2], &count))
        return error_at(error, r->name, r->line,
                        "PLY element with the count '%.40s', expected a name and how many there "
                        "are",
                        n >= 3 ? word[2] : "");
    if (ply_head_element(head, word[1]))
        return error_at(error, r->name, r->line, "element %.40s a second time, expected it once",
                        word[1]);
    struct ply_element *e = array_push(&head->element);
    *e = (struct ply_element){.count = count};
    snprintf(e->name, sizeof e->name, "%s", word[1]);
    return 0;
}

static int read_property(struct ply_head *head, int n, char *word[], const struct reader *r,
                         struct error *error)
{
    if (head->element.n == 0)
        return error_at(error, r->name, r->line, "a property, expected an element first");
    struct ply_property p = {.list = n >= 2 && strcmp(word[1], "list") == 0};
    if (n != (p.list ? 5 : 3))
        return error_at(error, r->name, r->line,
                        "a property of %d words, expected its type and its name", n - 1);
    if (p.list && !type_read(word[2], &p.length_type))
        return error_at(error, r->name, r->line, "unknown type '%.40s', expected uchar, int, ...",
                        word[2]);
    if (!type_read(word[n - 2], &p.type))
        return error_at(error, r->name, r->line,
                        "property of unknown type '%.40s', expected float, double, int, ...",
                        word[n - 2]);
    snprintf(p.name, sizeof p.name, "%s", word[n - 1]);
    *array_push(&head->element.item[head->element.n - 1].property) = p;
    return 0;
}

/* A comment line's text goes to the origin, which gives no place to its errors. */
static int read_comment(struct mesh_origin *origin, const char *text, const struct reader *r,
                        struct error *error)
{
    struct error what;
    if (ply_origin_read(origin, text + strspn(text, " \t"), &what) < 0)
        return error_at(error, r->name, r->line, "%s", what.text);
    return 0;
}

/* One line of the head; 1 when it was the last. */
static int read_statement(struct ply_head *head, char *line, struct mesh_origin *origin,
                          bool *has_format, const struct reader *r, struct error *error)
{
    char *word[WORDS];
    if (strncmp(line, "comment", 7) == 0 && (line[7] == ' ' || line[7] == '\t' || !line[7]))
        return read_comment(origin, line + 7, r, error);
    int n = split_words(line, word);
    if (n == 0 || strcmp(word[0], "obj_info") == 0)
        return 0;
    if (strcmp(word[0], "end_header") == 0)
        return *has_format ? 1 : error_at(error, r->name, r->line, "no format in the PLY head");
    if (strcmp(word[0], "format") == 0) {
        *has_format = true;
        return read_format(head, n, word, r, error);
    }
    if (strcmp(word[0], "element") == 0)
        return read_element(head, n, word, r, error);
    if (strcmp(word[0], "property") == 0)
        return read_property(head, n, word, r, error);
    return error_at(error, r->name, r->line,
                    "'%.40s' in the PLY head, expected element, property or end_header", word[0]);
}

int ply_head_read(struct reader *r, struct ply_head *head, struct mesh_origin *origin,
                  struct error *error)
{
    char *line;
    size_t n;
    memset(head, 0, sizeof *head);
    int got = reader_line(r, &line, &n, error);
    if (got < 0)
        return -1;
    if (got == 0)
        return error_at(error, r->name, 0, "is empty, expected a PLY file");
    if (n < 3 || memcmp(line, "ply", 3) != 0 || line[3 + strspn(line + 3, " \t")] != '\0')
        return error_at(error, r->name, r->line,
                        "no PLY file, expected the line 'ply' first (planecut reads STL and OFF)");

    bool has_format = false;
    while ((got = reader_line(r, &line, &n, error)) > 0) {
        int done = read_statement(head, line, origin, &has_format, r, error);
        if (done)
            return done < 0 ? -1 : 0;
    }
    return got < 0 ? -1
                   : error_at(error, r->name, r->line,
                              "the file ends in its PLY head, expected "
                              "end_header");
}

void ply_head_free(struct ply_head *head)
{
    for (size_t i = 0; i < head->element.n; i++)
        array_free(&head->element.item[i].property);
    array_free(&head->element);
}

const struct ply_element *ply_head_element(const struct ply_head *head, const char *name)
{
    for (size_t i = 0; i < head->element.n; i++)
        if (strcmp(head->element.item[i].name, name) == 0)
            return &head->element.item[i];
    return NULL;
}

int ply_element_property(const struct ply_element *element, const char *name)
{
    for (size_t i = 0; i < element->property.n; i++) {
        const struct ply_property *p = &element->property.item[i];
        if (!p->list && strcmp(p->name, name) == 0)
            return (int)i;
    }
    return -1;
}

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
static int shown_length(const char *s)
{
    size_t n = strcspn(s, blanks);
    return n < 40 ? (int)n : 40;
}

static int ends_early(const struct ply_source *s, struct error *error)
{
    return ply_error(s, error, "the file ends after %zu rows of element %s, expected %zu", s->row,
                     s->element->name, s->element->count);
}

/* The next line that is not empty: 1, 0 at the end, -1. */
static int next_row_line(struct ply_source *s, struct error *error)
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

static const char *over_blanks(const char *p)
{
    while (*p == ' ' || *p == '\t')
        p++;
    return p;
}

size_t ply_row_numbers(const struct ply_source *s, size_t n, double *value)
{
    const char *text, *p;
    if (s->format != PLY_ASCII || reader_ahead(s->reader, &text) == 0)
        return 0;
    p = text;
    for (size_t i = 0; i < n; i++) {
        p = num_even(over_blanks(p), &value[i]);
        if (!p || (*p != ' ' && *p != '\t' && *p != '\n'))
            return 0;
    }
    p = over_blanks(p);
    return *p == '\n' ? (size_t)(p + 1 - text) : 0;
}

void ply_row_take(struct ply_source *s, size_t length)
{
    reader_take(s->reader, length, 1);
}

int ply_row_begin(struct ply_source *s, struct error *error)
{
    if (s->format != PLY_ASCII)
        return 0;
    int got = next_row_line(s, error);
    return got > 0 ? 0 : got < 0 ? -1 : ends_early(s, error);
}

int ply_row_end(struct ply_source *s, struct error *error)
{
    if (s->format != PLY_ASCII)
        return 0;
    s->at += strspn(s->at, blanks);
    if (s->at == s->end)
        return 0;
    return ply_error(s, error, "'%.*s' after the last property of element %s, expected a line end",
                     shown_length(s->at), s->at, s->element->name);
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
        return ply_error(s, error, "'%.*s' is no number, expected one", shown_length(s->at), s->at);
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
    double value = 0;
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
    int got = next_row_line(s, error);
    if (got <= 0)
        return got;
    return ply_error(s, error, "more than the %zu rows of element %s, expected the end of the file",
                     s->element->count, s->element->name);
}
