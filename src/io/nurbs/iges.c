/* iges - see iges.h. */
#include "iges.h"

#include <ctype.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "math/elementary.h"
#include "base/array.h"
#include "base/num.h"
#include "io/nurbs/surfaces_scan.h"

/* A place in the text of some records. */
struct iges_cursor {
    const char *name; /* of the file */
    const struct iges_record *record;
    size_t records;
    size_t width;  /* columns that hold text: 72 in the global section, 64 for parameters */
    int entity;    /* whose parameters they are, 0: the global section */
    size_t column; /* of the next character, from 0 */
    char comma, semicolon;
};

enum { WORD_MAX = 80 };

/* Parameters end in column 64; some writers run on into column 65, in front of the pointer back to
 * the directory, which is right-justified in 66 to 72 but may begin with a nought in 65. */
static size_t width_of(const struct iges_cursor *c)
{
    if (c->entity == 0 || c->record->text[c->width] == ' ')
        return c->width;
    char pointer[9] = {0};
    memcpy(pointer, c->record->text + c->width, 8);
    bool later =
        strtol(pointer, NULL, 10) != c->entity && strtol(pointer + 1, NULL, 10) == c->entity;
    return later ? c->width + 1 : c->width;
}

static size_t cursor_line(const struct iges_cursor *c)
{
    return c->records > 0 ? c->record->line : c->record[-1].line;
}

/* The next character without taking it, '\0' at the end of the records. */
static char peek_char(struct iges_cursor *c)
{
    while (c->records > 0 && c->column >= width_of(c)) {
        c->record++;
        c->records--;
        c->column = 0;
    }
    return c->records > 0 ? c->record->text[c->column] : '\0';
}

static char take_char(struct iges_cursor *c)
{
    char ch = peek_char(c);
    if (ch != '\0')
        c->column++;
    return ch;
}

static int copy_text(struct iges_cursor *c, long length, char *text, size_t size,
                     struct error *error)
{
    for (long i = 0; i < length; i++) {
        char ch = take_char(c);
        if (ch == '\0')
            return error_at(error, c->name, cursor_line(c),
                            "a text of %ld characters that the file does not hold, expected them",
                            length);
        if ((size_t)i + 1 < size)
            text[i] = ch;
    }
    text[(size_t)length < size ? (size_t)length : size - 1] = '\0';
    return 0;
}

static int word_value(struct iges_cursor *c, const char *word, struct iges_value *value,
                      struct error *error)
{
    const char *end = word;
    value->kind = IGES_NUMBER;
    if (!num_read(&end, &value->number) || *end != '\0')
        return error_at(error, c->name, value->line, "'%.40s', expected a number", word);
    if (!isfinite(value->number))
        return error_at(error, c->name, value->line, "'%.40s', expected a finite number", word);
    return 0;
}

/*
 * The next parameter: 1, or 2 when it is the last one before the record delimiter, or -1.  A text
 * is copied to `text`, cut to its size.  Numbers may have exponents by E or D.
 */
static int next_value(struct iges_cursor *c, struct iges_value *value, char *text, size_t size,
                      struct error *error)
{
    char word[WORD_MAX + 1];
    size_t n = 0;
    *value = (struct iges_value){.kind = IGES_DEFAULT};
    text[0] = '\0';
    for (;;) {
        char ch = take_char(c);
        if (n == 0 && value->kind == IGES_DEFAULT)
            value->line = cursor_line(c);
        if (ch == '\0')
            return error_at(error, c->name, cursor_line(c),
                            "parameters that end without '%c', expected it: the file is cut short",
                            c->semicolon);
        word[n] = '\0';
        if (ch == c->comma || ch == c->semicolon) {
            if (n > 0 && value->kind != IGES_TEXT && word_value(c, word, value, error) < 0)
                return -1;
            return ch == c->comma ? 1 : 2;
        }
        if (c->entity == 0 && value->kind == IGES_TEXT && ch != ' ')
            return error_at(error, c->name, cursor_line(c),
                            "'%c' after a text in the global section, expected '%c': its count of "
                            "characters is wrong",
                            isprint((unsigned char)ch) ? ch : '?', c->comma);
        if (ch == ' ' || value->kind == IGES_TEXT)
            continue;
        if (ch == 'H' && n > 0 && strspn(word, "0123456789") == n && n < 7) {
            value->kind = IGES_TEXT;
            if (copy_text(c, strtol(word, NULL, 10), text, size, error) < 0)
                return -1;
            continue;
        }
        if (n == WORD_MAX || iscntrl((unsigned char)ch))
            return error_at(error, c->name, value->line,
                            "a parameter of more than %d characters, or with control characters, "
                            "expected a number",
                            WORD_MAX);
        word[n++] = ch;
    }
}

/* Columns of the global section, and the numbers of its parameters that are used. */
enum { GLOBAL_COLUMNS = 72, SCALE = 13, UNIT_FLAG = 14, UNIT_NAME = 15 };

struct unit {
    int flag;
    const char *name, *other;
    double mm;
};

static const struct unit unit_table[] = {
    {1, "INCH", "IN", 25.4},           {2, "MM", "MILLIMETER", 1}, {4, "FT", "FOOT", 304.8},
    {5, "MI", "MILE", 1609344},        {6, "M", "METER", 1000},    {7, "KM", "KILOMETER", 1e6},
    {8, "MIL", "MIL", 0.0254},         {9, "UM", "MICRON", 0.001}, {10, "CM", "CENTIMETER", 10},
    {11, "UIN", "MICROINCH", 2.54e-5},
};

/* Flag 3 means the unit by name. */
static const struct unit *unit_of(long flag, const char *name)
{
    for (size_t i = 0; i < sizeof unit_table / sizeof *unit_table; i++) {
        const struct unit *u = &unit_table[i];
        if (flag == 3 ? strcmp(u->name, name) == 0 || strcmp(u->other, name) == 0 : u->flag == flag)
            return u;
    }
    return NULL;
}

static int take_unit(struct iges *iges, double flag, const char *name, struct error *error)
{
    size_t line = iges->global.item[0].line;
    const struct unit *unit = flag >= 1 && flag <= 11 ? unit_of((long)flag, name) : NULL;
    if (!unit)
        return error_at(error, iges->name, line,
                        "unit flag %g with unit '%.12s', expected one that IGES knows", flag, name);
    if (!(iges->scale > 0))
        return error_at(error, iges->name, line, "model space scale %g, expected a positive one",
                        iges->scale);
    iges->unit = unit->mm / iges->scale;
    snprintf(iges->unit_name, sizeof iges->unit_name, "%s", unit->name);
    snprintf(iges->unit_text, sizeof iges->unit_text, "%s", name);
    return 0;
}

static char peek_text(struct iges_cursor *c)
{
    while (peek_char(c) == ' ')
        take_char(c);
    return peek_char(c);
}

/* One of the two delimiters, as 1Hx or as nothing, which means the default; then the one of
 * parameters, or, where the section ends there, the one of records, which is left standing. */
static int take_delimiter(struct iges_cursor *c, char *delimiter, struct error *error)
{
    char next = peek_text(c);
    if (next == ';' || next == c->comma) {
        if (next == c->comma)
            take_char(c);
        return 0;
    }
    char one = take_char(c), h = take_char(c), ch = take_char(c);
    if (one != '1' || h != 'H' || ch <= ' ' || strchr("+-.0123456789DEH", ch))
        return error_at(error, c->name, cursor_line(c),
                        "a global section that begins '%c%c', expected 1H and a delimiter",
                        one > ' ' ? one : '?', h > ' ' ? h : '?');
    *delimiter = ch;
    next = peek_text(c);
    if (next == c->comma)
        take_char(c);
    else if (next != c->semicolon)
        return error_at(error, c->name, cursor_line(c),
                        "'%c' after a delimiter in the global section, expected '%c'",
                        next > ' ' ? next : '?', c->comma);
    return 0;
}

/* What the parameters of the global section are: t a text, n a number. */
static const char global_kind[] = "ttttttnnnnntnntnntnnttnntt";

/* A text where a number belongs, or a number for a text: one of the counts of characters in front
 * of it is wrong, and all that follows is shifted. */
static int check_kind(const struct iges_cursor *c, int number, const struct iges_value *value,
                      struct error *error)
{
    char want = number <= (int)sizeof global_kind - 1 ? global_kind[number - 1] : '\0';
    bool wrong =
        (want == 't' && value->kind == IGES_NUMBER) || (want == 'n' && value->kind == IGES_TEXT);
    if (!wrong)
        return 0;
    return error_at(error, c->name, value->line,
                    "%s as parameter %d of the global section, expected %s: a count of characters "
                    "before it is wrong",
                    want == 't' ? "a number" : "a text", number,
                    want == 't' ? "a text" : "a number");
}

/* The parameters after the delimiters. */
static int read_rest(struct iges *iges, struct iges_cursor *c, double *flag, char *unit,
                     size_t size, struct error *error)
{
    struct iges_value value;
    char text[32];
    for (int number = 3, got = 1; got == 1; number++) {
        got = next_value(c, &value, text, sizeof text, error);
        if (got < 0 || check_kind(c, number, &value, error) < 0)
            return -1;
        if (number == SCALE && value.kind == IGES_NUMBER)
            iges->scale = value.number;
        if (number == UNIT_FLAG && value.kind == IGES_NUMBER)
            *flag = value.number;
        if (number == UNIT_NAME)
            snprintf(unit, size, "%s", text);
    }
    return 0;
}

static int read_global(struct iges *iges, struct error *error)
{
    if (iges->global.n == 0)
        return error_at(error, iges->name, 1, "no G section, expected one as in IGES");
    struct iges_cursor c = {.name = iges->name,
                            .record = iges->global.item,
                            .records = iges->global.n,
                            .width = GLOBAL_COLUMNS,
                            .comma = ',',
                            .semicolon = ';'};
    double flag = 1;
    char unit[32] = "";
    if (take_delimiter(&c, &c.comma, error) < 0 || take_delimiter(&c, &c.semicolon, error) < 0)
        return -1;
    iges->comma = c.comma;
    iges->semicolon = c.semicolon;
    iges->scale = 1;
    if (read_rest(iges, &c, &flag, unit, sizeof unit, error) < 0)
        return -1;
    return take_unit(iges, flag, unit, error);
}

enum { COLUMNS = 80, LETTER = 72, POINTER = 64 };

static const char section_letter[] = "SGDPT";

/* What is known while the lines go by. */
struct scan {
    struct iges *iges;
    size_t count[5]; /* lines of each section */
    int section;     /* index in section_letter */
    struct {
        size_t n, cap;
        char *item;
    } start; /* a line of the start section so far */
    struct iges_records directory;
    struct iges_record terminate;
};

static int bad_line(const struct scan *s, size_t line, struct error *error, size_t n)
{
    return error_at(error, s->iges->name, line, "a line of %zu columns, expected 80 as in IGES", n);
}

/* The number in columns from..to (from 0); blank is 0. */
static int read_field(const char *text, size_t from, size_t to, long *number)
{
    char word[24] = {0};
    memcpy(word, text + from, to - from);
    char *end;
    *number = strtol(word, &end, 10);
    return end[strspn(end, " ")] == '\0' ? 0 : -1;
}

/* A line of the start section; one that ends in a backslash goes on in the next. */
static void take_start(struct scan *s, const char text[COLUMNS])
{
    size_t n = LETTER;
    while (n > 0 && text[n - 1] == ' ')
        n--;
    bool more = n > 0 && text[n - 1] == '\\';
    for (size_t i = 0; i < n - more; i++)
        *array_push(&s->start) = text[i];
    if (more)
        return;
    *array_push(&s->start) = '\0';
    surfaces_scan_line(s->start.item, &s->iges->scan);
    s->start.n = 0;
}

static int take_record(struct scan *s, const char *text, size_t line, struct error *error)
{
    struct iges_record record = {.line = line};
    long number;
    memcpy(record.text, text, COLUMNS);
    const char *letter = record.text[LETTER] ? strchr(section_letter, record.text[LETTER]) : NULL;
    if (!letter)
        return error_at(error, s->iges->name, line,
                        "'%c' in column 73, expected the letter of an IGES section (S, G, D, P, T)",
                        record.text[LETTER] >= ' ' ? record.text[LETTER] : '?');
    int section = (int)(letter - section_letter);
    if (section < s->section)
        return error_at(error, s->iges->name, line,
                        "a line of section %c after section %c, expected S, G, D, P, T in order",
                        *letter, section_letter[s->section]);
    s->section = section;
    s->count[section]++;
    if (read_field(record.text, LETTER + 1, COLUMNS, &number) < 0 ||
        (size_t)number != s->count[section])
        return error_at(error, s->iges->name, line,
                        "sequence number '%.7s' in section %c, expected %zu",
                        record.text + LETTER + 1, *letter, s->count[section]);
    if (*letter == 'S')
        take_start(s, record.text);
    else if (*letter == 'G')
        *array_push(&s->iges->global) = record;
    else if (*letter == 'D')
        *array_push(&s->directory) = record;
    else if (*letter == 'P')
        *array_push(&s->iges->parameter) = record;
    else if (*letter == 'T')
        s->terminate = record;
    return 0;
}

/* One line of the file: one record, or many where the records have no line ends. */
static int take_line(struct scan *s, const char *line, size_t n, size_t at, struct error *error)
{
    while (n > COLUMNS && line[n - 1] == ' ')
        n--;
    if (strspn(line, " \t\x1a") == n)
        return 0;
    if (n % COLUMNS != 0)
        return bad_line(s, at, error, n);
    for (size_t i = 0; i < n; i += COLUMNS)
        if (take_record(s, line + i, at, error) < 0)
            return -1;
    return 0;
}

static int read_lines(struct reader *r, struct scan *s, struct error *error)
{
    char *line;
    size_t n;
    int got;
    while (s->count[4] == 0 && (got = reader_line(r, &line, &n, error)) > 0) {
        if (r->line == 1 && n > LETTER && (line[LETTER] == 'C' || line[LETTER] == 'B'))
            return error_at(error, r->name, 1, "%s IGES, expected fixed-width ASCII",
                            line[LETTER] == 'C' ? "compressed" : "binary");
        if (take_line(s, line, n, r->line, error) < 0)
            return -1;
    }
    return s->count[4] > 0 ? 0 : got;
}

/* S, G, D, P and how many lines each has. */
static int check_terminate(const struct scan *s, struct error *error)
{
    if (s->count[4] == 0)
        return error_at(error, s->iges->name,
                        s->count[0] + s->count[1] + s->count[2] + s->count[3] + 1,
                        "no T section at the end, expected one: the file is cut short");
    for (size_t i = 0; i < 4; i++) {
        const char *text = s->terminate.text + 8 * i;
        long number;
        if (text[0] == section_letter[i] &&
            (read_field(text, 1, 8, &number) < 0 || (size_t)number != s->count[i]))
            return error_at(error, s->iges->name, s->terminate.line,
                            "%zu lines of section %c, expected the %.7s of the T section",
                            s->count[i], section_letter[i], text + 1);
    }
    return 0;
}

static int take_entity(struct iges *iges, const struct iges_record *a, const struct iges_record *b,
                       int number, struct error *error)
{
    static const size_t column[] = {0, 8, 48}, second[] = {24, 32};
    static const char *const what[] = {"entity type", "parameter pointer", "matrix pointer",
                                       "count of parameter lines", "form number"};
    long v[5];
    for (size_t i = 0; i < 5; i++) {
        const struct iges_record *r = i < 3 ? a : b;
        size_t at = i < 3 ? column[i] : second[i - 3];
        if (read_field(r->text, at, at + 8, &v[i]) < 0 || labs(v[i]) > 99999999)
            return error_at(error, iges->name, r->line, "'%.8s' as %s, expected a whole number",
                            r->text + at, what[i]);
    }
    if (v[3] == 0)
        v[3] = 1;
    size_t lines = iges->parameter.n;
    if (v[1] < 1 || (size_t)v[1] > lines || v[3] < 0 || (size_t)v[3] > lines - (size_t)v[1] + 1)
        return error_at(
            error, iges->name, a->line,
            "a pointer to %ld parameter lines from P %ld on, expected lines within the %zu "
            "that there are",
            v[3], v[1], lines);
    struct iges_entity e = {.type = (int)v[0],
                            .form = (int)v[4],
                            .number = number,
                            .first = (size_t)v[1],
                            .lines = (size_t)v[3],
                            .matrix = (int)v[2],
                            .at = a->line};
    *array_push(&iges->entity) = e;
    return 0;
}

static int take_directory(struct scan *s, struct error *error)
{
    const struct iges_records *d = &s->directory;
    if (d->n % 2 != 0)
        return error_at(error, s->iges->name, d->item[d->n - 1].line,
                        "%zu lines of section D, expected two for each entity", d->n);
    for (size_t i = 0; i < d->n; i += 2)
        if (take_entity(s->iges, &d->item[i], &d->item[i + 1], (int)i + 1, error) < 0)
            return -1;
    return 0;
}

int iges_read(struct reader *r, struct iges *iges, struct error *error)
{
    struct scan s = {.iges = iges};
    *iges = (struct iges){.name = mem_string(r->name, strlen(r->name))};
    int status = read_lines(r, &s, error);
    if (status == 0)
        status = check_terminate(&s, error);
    if (status == 0)
        status = read_global(iges, error);
    if (status == 0)
        status = take_directory(&s, error);
    array_free(&s.directory);
    array_free(&s.start);
    if (status < 0)
        iges_free(iges);
    return status;
}

const struct iges_entity *iges_entity(const struct iges *iges, int number)
{
    size_t index = (size_t)(number - 1) / 2;
    bool there = number > 0 && number % 2 == 1 && index < iges->entity.n;
    return there ? &iges->entity.item[index] : NULL;
}

int iges_values(const struct iges *iges, const struct iges_entity *entity,
                struct iges_values *values, struct error *error)
{
    struct iges_cursor c = {.name = iges->name,
                            .record = iges->parameter.item + entity->first - 1,
                            .records = entity->lines,
                            .width = POINTER,
                            .entity = entity->number,
                            .comma = iges->comma,
                            .semicolon = iges->semicolon};
    char text[2];
    *values = (struct iges_values){.line = c.record->line};
    for (size_t i = 0; i < entity->lines; i++) {
        const struct iges_record *r = &c.record[i];
        long back;
        if (read_field(r->text, POINTER + 1, LETTER, &back) == 0 && back != 0 &&
            back != entity->number)
            return error_at(error, iges->name, r->line,
                            "a parameter line of directory entry %ld, expected one of %d", back,
                            entity->number);
    }
    for (int got = 1; got == 1;) {
        got = next_value(&c, array_push(values), text, sizeof text, error);
        if (got < 0) {
            array_free(values);
            return -1;
        }
    }
    struct iges_value type = values->item[0];
    if (!(type.number >= entity->type && type.number <= entity->type)) {
        array_free(values);
        return error_at(error, iges->name, type.line,
                        "parameters of entity type %.12g, expected %d as in its directory entry %d",
                        type.number, entity->type, entity->number);
    }
    return 0;
}

int iges_whole(const struct iges *iges, const struct iges_values *values, size_t index, long min,
               long max, const char *what, long *number, struct error *error)
{
    double x = index < values->n ? values->item[index].number : 0;
    size_t line = index < values->n ? values->item[index].line : values->line;
    if (!(x >= (double)min && x <= (double)max) || x > floor(x))
        return error_at(error, iges->name, line,
                        "%.12g as %s, expected a whole number from %ld to %ld", x, what, min, max);
    *number = (long)x;
    return 0;
}

int iges_numbers(const struct iges *iges, const struct iges_values *values, size_t from, size_t to,
                 double most, struct error *error)
{
    for (size_t i = from; i < to && i < values->n; i++) {
        const struct iges_value *v = &values->item[i];
        if (v->kind == IGES_TEXT)
            return error_at(error, iges->name, v->line, "a text, expected a number (parameter %zu)",
                            i);
        if (!(fabs(v->number) <= most))
            return error_at(error, iges->name, v->line, "%g, expected a number within %g",
                            v->number, most);
    }
    return 0;
}

int iges_pointer(const struct iges *iges, const struct iges_values *values, size_t index,
                 const struct iges_entity **entity, struct error *error)
{
    double x = index < values->n ? values->item[index].number : 0;
    *entity = x > 0 && x < 1e8 && x <= floor(x) ? iges_entity(iges, (int)x) : NULL;
    if (!*entity)
        return error_at(error, iges->name,
                        index < values->n ? values->item[index].line : values->line,
                        "a pointer to directory entry %.12g, expected one that there is", x);
    return 0;
}

void iges_free(struct iges *iges)
{
    free(iges->name);
    array_free(&iges->global);
    array_free(&iges->parameter);
    array_free(&iges->entity);
    scan_sources_free(&iges->scan);
    *iges = (struct iges){0};
}
