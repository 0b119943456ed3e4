/* iges - see iges.h. */
#include "iges.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "iges_global.h"
#include "iges_text.h"

enum { COLUMNS = 80, LETTER = 72, POINTER = 64 };

static const char section_letter[] = "SGDPT";

/* What is known while the lines go by. */
struct scan {
    struct iges *iges;
    size_t count[5]; /* lines of each section */
    int section;     /* index in section_letter */
    struct iges_records directory;
    struct iges_record terminate;
};

static int bad_line(const struct scan *s, size_t line, struct error *error, size_t n)
{
    return error_at(error, s->iges->name, line, "a line of %zu columns, expected 80 as in IGES", n);
}

/* The number in columns from..to (from 0); blank is 0. */
static int field(const char *text, size_t from, size_t to, long *number)
{
    char word[24] = {0};
    memcpy(word, text + from, to - from);
    char *end;
    *number = strtol(word, &end, 10);
    return end[strspn(end, " ")] == '\0' ? 0 : -1;
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
                        "a line of section %c behind section %c, expected S, G, D, P, T in order",
                        *letter, section_letter[s->section]);
    s->section = section;
    s->count[section]++;
    if (field(record.text, LETTER + 1, COLUMNS, &number) < 0 || (size_t)number != s->count[section])
        return error_at(error, s->iges->name, line,
                        "sequence number '%.7s' in section %c, expected %zu",
                        record.text + LETTER + 1, *letter, s->count[section]);
    if (*letter == 'G')
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
        return error_at(error, s->iges->name, 0,
                        "no T section at the end, expected one: the file is cut short");
    for (size_t i = 0; i < 4; i++) {
        const char *text = s->terminate.text + 8 * i;
        long number;
        if (text[0] == section_letter[i] &&
            (field(text, 1, 8, &number) < 0 || (size_t)number != s->count[i]))
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
        if (field(r->text, at, at + 8, &v[i]) < 0 || labs(v[i]) > 99999999)
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
        status = iges_global(iges, error);
    if (status == 0)
        status = take_directory(&s, error);
    array_free(&s.directory);
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
        if (field(r->text, POINTER + 1, LETTER, &back) == 0 && back != 0 && back != entity->number)
            return error_at(error, iges->name, r->line,
                            "a parameter line of directory entry %ld, expected one of %d", back,
                            entity->number);
    }
    for (int got = 1; got == 1;) {
        got = iges_next(&c, array_push(values), text, sizeof text, error);
        if (got < 0) {
            array_free(values);
            return -1;
        }
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
    *iges = (struct iges){0};
}
