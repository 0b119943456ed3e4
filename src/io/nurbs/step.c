/* step - see step.h. */
#include "step.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "math/elementary.h"
#include "base/array.h"
#include "base/num.h"

enum { BLOCK = 65536, DEPTH_MAX = 50, WORD_MAX = 80 };
static const long ID_MAX = 2000000000;

/* A place in the text. */
struct cursor {
    const struct step *step;
    size_t at, line;
};

static char char_here(const struct cursor *c)
{
    return c->at < c->step->text.n ? c->step->text.item[c->at] : '\0';
}

static char char_ahead(const struct cursor *c)
{
    return c->at + 1 < c->step->text.n ? c->step->text.item[c->at + 1] : '\0';
}

static char take_char(struct cursor *c)
{
    char ch = char_here(c);
    c->line += ch == '\n';
    c->at += c->at < c->step->text.n;
    return ch;
}

static bool at_end(const struct cursor *c)
{
    return c->at >= c->step->text.n;
}

static int unexpected(const struct cursor *c, const char *expected, struct error *error)
{
    char ch = char_here(c);
    if (at_end(c))
        return error_at(error, c->step->name, c->line,
                        "the file ends, expected %s: it is cut short", expected);
    return error_at(error, c->step->name, c->line, "'%c', expected %s",
                    isprint((unsigned char)ch) ? ch : '?', expected);
}

/* A blank, a tab or what ends a line or page. */
static bool is_blank(char ch)
{
    return ch == ' ' || (ch >= '\t' && ch <= '\r');
}

/* Over blanks, line ends and comments. */
static int skip_blanks(struct cursor *c, struct error *error)
{
    for (;;) {
        while (is_blank(char_here(c)))
            take_char(c);
        if (char_here(c) != '/' || char_ahead(c) != '*')
            return 0;
        while (!at_end(c) && !(char_here(c) == '*' && char_ahead(c) == '/'))
            take_char(c);
        if (at_end(c))
            return unexpected(c, "the end of a comment", error);
        take_char(c);
        take_char(c);
    }
}

/* From the quote on; a quote inside is doubled. */
static int skip_text(struct cursor *c, struct error *error)
{
    char quote = take_char(c);
    for (;;) {
        if (at_end(c))
            return unexpected(c, "the quote that ends a text", error);
        if (take_char(c) == quote) {
            if (char_here(c) != quote)
                return 0;
            take_char(c);
        }
    }
}

static int read_id(struct cursor *c, double *id, struct error *error)
{
    *id = 0;
    if (!isdigit((unsigned char)char_here(c)))
        return unexpected(c, "the number of an instance after #", error);
    while (isdigit((unsigned char)char_here(c)) && *id <= (double)ID_MAX)
        *id = 10 * *id + (take_char(c) - '0');
    if (!(*id > 0 && *id <= (double)ID_MAX))
        return error_at(error, c->step->name, c->line,
                        "an instance number of %.0f, expected 1 to %ld", *id, ID_MAX);
    return 0;
}

/* To the `;` that ends a statement. */
static int skip_statement(struct cursor *c, struct error *error)
{
    for (;;) {
        char ch = char_here(c);
        if (ch == '\'' || ch == '"') {
            if (skip_text(c, error) < 0)
                return -1;
        } else if (ch == '/' && char_ahead(c) == '*') {
            if (skip_blanks(c, error) < 0)
                return -1;
        } else if (at_end(c)) {
            return unexpected(c, "';'", error);
        } else if (take_char(c) == ';') {
            return 0;
        }
    }
}

static bool word_begins(const struct cursor *c, const char *word)
{
    size_t n = strlen(word);
    return c->step->text.n - c->at >= n && memcmp(c->step->text.item + c->at, word, n) == 0;
}

static int compare_instances(const void *p, const void *q)
{
    const struct step_instance *a = p, *b = q;
    return (a->id > b->id) - (a->id < b->id);
}

static int index_instances(struct step *step, struct error *error)
{
    struct cursor c = {step, 0, 1};
    bool header = false, data = false, end = false;
    while (!end) {
        if (skip_blanks(&c, error) < 0)
            return -1;
        if (at_end(&c))
            return unexpected(&c, "END-ISO-10303-21", error);
        if (!data && word_begins(&c, "HEADER")) {
            header = true;
        } else if (data && char_here(&c) == '#') {
            double id;
            size_t line = c.line;
            take_char(&c);
            if (read_id(&c, &id, error) < 0 || skip_blanks(&c, error) < 0)
                return -1;
            if (char_here(&c) != '=')
                return unexpected(&c, "'=' after the number of an instance", error);
            take_char(&c);
            *array_push(&step->instance) = (struct step_instance){(long)id, c.at, line};
        } else if (!data && word_begins(&c, "DATA")) {
            if (!header)
                return unexpected(&c, "a HEADER section before the DATA", error);
            data = true;
        } else if (word_begins(&c, "ENDSEC")) {
            data = false;
        } else if (!data && word_begins(&c, "END-ISO-10303-21")) {
            end = true;
        } else if (data) {
            return unexpected(&c, "'#' and the number of an instance, or ENDSEC", error);
        }
        if (skip_statement(&c, error) < 0)
            return -1;
    }
    step->lines = c.line;
    return 0;
}

/* Sorts the instances; none may have the number of another. */
static int sort_instances(struct step *step, struct error *error)
{
    size_t n = step->instance.n;
    struct step_instance *item = step->instance.item;
    if (n == 0)
        return error_at(error, step->name, step->lines,
                        "no instances in the DATA section, expected a model");
    qsort(item, n, sizeof *item, compare_instances);
    for (size_t i = 1; i < n; i++)
        if (item[i].id == item[i - 1].id)
            return error_at(error, step->name, item[i].line,
                            "instance #%ld a second time, expected it once (line %zu)", item[i].id,
                            item[i - 1].line);
    return 0;
}

int step_read(struct reader *r, struct step *step, struct error *error)
{
    long got;
    *step = (struct step){.name = mem_string(r->name, strlen(r->name))};
    do {
        array_reserve(&step->text, step->text.n + BLOCK);
        got = reader_bytes(r, step->text.item + step->text.n, BLOCK, error);
        step->text.n += got > 0 ? (size_t)got : 0;
    } while (got == BLOCK);
    int status = got < 0 ? -1 : 0;
    if (status == 0)
        status = index_instances(step, error);
    if (status == 0)
        status = sort_instances(step, error);
    if (status < 0)
        step_free(step);
    return status;
}

const struct step_instance *step_find(const struct step *step, long id)
{
    struct step_instance key = {.id = id};
    return step->instance.n > 0
               ? bsearch(&key, step->instance.item, step->instance.n, sizeof key, compare_instances)
               : NULL;
}

static int read_value(struct cursor *c, struct step_values *v, int depth, struct error *error);

/* The values between parentheses; the list or record itself was pushed before. */
static int read_items(struct cursor *c, struct step_values *v, int depth, struct error *error)
{
    take_char(c);
    if (skip_blanks(c, error) < 0)
        return -1;
    for (bool first = true; char_here(c) != ')'; first = false) {
        if (!first && char_here(c) != ',')
            return unexpected(c, "',' or ')'", error);
        if (!first)
            take_char(c);
        if (read_value(c, v, depth + 1, error) < 0 || skip_blanks(c, error) < 0)
            return -1;
    }
    take_char(c);
    return 0;
}

static bool is_of_number(char ch)
{
    return (ch >= '0' && ch <= '9') || ch == '.' || ch == '-' || ch == '+' || ch == 'e' ||
           ch == 'E';
}

static int read_number(struct cursor *c, struct step_value *value, struct error *error)
{
    char word[WORD_MAX + 1];
    size_t n = 0;
    while (n < WORD_MAX && is_of_number(char_here(c)))
        word[n++] = take_char(c);
    word[n] = '\0';
    const char *p = word;
    if (!num_read(&p, &value->number) || *p != '\0' || !isfinite(value->number))
        return error_at(error, c->step->name, c->line, "'%.40s', expected a number", word);
    value->kind = STEP_NUMBER;
    return 0;
}

static bool is_name(char ch)
{
    return isalnum((unsigned char)ch) || ch == '_' || ch == '-';
}

/* NAME and its attributes. */
static int read_record(struct cursor *c, struct step_values *v, int depth, struct error *error)
{
    size_t at = v->n, from = c->at;
    while (is_name(char_here(c)) || char_here(c) == '!')
        take_char(c);
    *array_push(v) = (struct step_value){
        .kind = STEP_RECORD, .text = c->step->text.item + from, .length = c->at - from};
    if (skip_blanks(c, error) < 0)
        return -1;
    if (char_here(c) != '(')
        return unexpected(c, "'(' after the name of an entity", error);
    if (read_items(c, v, depth, error) < 0)
        return -1;
    v->item[at].size = v->n - at;
    return 0;
}

static int read_value(struct cursor *c, struct step_values *v, int depth, struct error *error)
{
    if (depth > DEPTH_MAX)
        return error_at(error, c->step->name, c->line,
                        "lists within lists more than %d deep, expected fewer", DEPTH_MAX);
    if (skip_blanks(c, error) < 0)
        return -1;
    char ch = char_here(c);
    if (isalpha((unsigned char)ch) || ch == '!')
        return read_record(c, v, depth, error);
    size_t at = v->n, from = c->at + 1;
    struct step_value value = {.kind = STEP_UNSET, .size = 1};
    int status = 0;
    if (ch == '(') {
        value.kind = STEP_LIST;
        *array_push(v) = value;
        status = read_items(c, v, depth, error);
        v->item[at].size = v->n - at;
        return status;
    }
    if (ch == '#') {
        value.kind = STEP_REFERENCE;
        take_char(c);
        status = read_id(c, &value.number, error);
    } else if (ch == '\'' || ch == '"') {
        value.kind = STEP_TEXT;
        status = skip_text(c, error);
        value.length = c->at - from - 1;
    } else if (ch == '.' && isalpha((unsigned char)char_ahead(c))) {
        value.kind = STEP_ENUM;
        take_char(c);
        while (is_name(char_here(c)))
            take_char(c);
        value.length = c->at - from;
        if (char_here(c) != '.')
            return unexpected(c, "'.' at the end of an enumeration", error);
        take_char(c);
    } else if (ch == '$' || ch == '*') {
        take_char(c);
    } else if (ch == '+' || ch == '-' || ch == '.' || isdigit((unsigned char)ch)) {
        status = read_number(c, &value, error);
    } else {
        return unexpected(c, "a value", error);
    }
    value.text = c->step->text.item + from;
    *array_push(v) = value;
    return status;
}

int step_values(const struct step *step, const struct step_instance *instance,
                struct step_values *v, struct error *error)
{
    struct cursor c = {step, instance->at, instance->line};
    *v = (struct step_values){.instance = instance};
    *array_push(v) = (struct step_value){.kind = STEP_LIST};
    int status = skip_blanks(&c, error);
    bool complex = status == 0 && char_here(&c) == '(';
    if (complex)
        take_char(&c);
    do {
        status = status < 0 ? -1 : skip_blanks(&c, error);
        if (status == 0 && !isalpha((unsigned char)char_here(&c)) && char_here(&c) != '!')
            status = unexpected(&c, "the name of an entity", error);
        if (status == 0)
            status = read_record(&c, v, 1, error);
        if (status == 0)
            status = skip_blanks(&c, error);
    } while (complex && status == 0 && char_here(&c) != ')');
    if (complex && status == 0)
        take_char(&c);
    if (status == 0)
        status = skip_blanks(&c, error);
    if (status == 0 && char_here(&c) != ';')
        status = unexpected(&c, "';' after an instance", error);
    if (status < 0) {
        array_free(v);
        return -1;
    }
    v->item[0].size = v->n;
    return 0;
}

bool step_is(const struct step_value *value, const char *name)
{
    return value && value->length == strlen(name) && memcmp(value->text, name, value->length) == 0;
}

const struct step_value *step_next(const struct step_value *list, const struct step_value *item)
{
    const struct step_value *next = item + item->size;
    return next < list + list->size ? next : NULL;
}

const struct step_value *step_item(const struct step_value *list, size_t index)
{
    if (!list || (list->kind != STEP_LIST && list->kind != STEP_RECORD) || list->size < 2)
        return NULL;
    const struct step_value *item = list + 1;
    while (item && index-- > 0)
        item = step_next(list, item);
    return item;
}

const struct step_value *step_record(const struct step_values *values, const char *name)
{
    const struct step_value *r = step_item(values->item, 0);
    while (r && !step_is(r, name))
        r = step_next(values->item, r);
    return r;
}

const struct step_value *step_own(const struct step_values *values, const struct step_value *record,
                                  size_t index)
{
    bool complex = step_item(values->item, 1) != NULL;
    return complex && index == 0 ? NULL : step_item(record, index - complex);
}

void step_free(struct step *step)
{
    free(step->name);
    array_free(&step->text);
    array_free(&step->instance);
    *step = (struct step){0};
}
