#include "cl_text.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"

/* The words whose text is theirs, whatever it holds. */
static const char *const raw_words[] = {"PARTNO", "PPRINT", "INSERT", "TPRINT", "REMARK"};

struct text {
    size_t n, cap;
    char *item;
};

static int read_file(const char *file, struct text *text, struct error *error)
{
    FILE *f = strcmp(file, "-") == 0 ? stdin : fopen(file, "rb");
    int c;
    if (!f)
        return error_set(error, "%s: cannot be opened", file);
    while ((c = getc(f)) != EOF)
        *array_push(text) = (char)c;
    *array_push(text) = '\n';
    *array_push(text) = '\0';
    if (f != stdin)
        fclose(f);
    return 0;
}

/* The next line, its end cut off; NULL after the last. */
static char *next_line(char **at, size_t *number)
{
    char *line = *at;
    if (!*line)
        return NULL;
    size_t n = strcspn(line, "\r\n");
    *at = line + n + (line[n] == '\r' && line[n + 1] == '\n' ? 2 : 1);
    line[n] = '\0';
    ++*number;
    while (n > 0 && isspace((unsigned char)line[n - 1]))
        line[--n] = '\0';
    return line + strspn(line, " \t");
}

static bool begins_with(const char *s, const char *word)
{
    size_t i = 0;
    for (; word[i]; i++)
        if (toupper((unsigned char)s[i]) != word[i])
            return false;
    return !isalnum((unsigned char)s[i]);
}

/* Behind a label: `N30 ,` or `30)`. */
static const char *behind_label(const char *s)
{
    size_t n = *s == 'N' || *s == 'n' ? 1 : 0, digits = strspn(s + n, "0123456789");
    const char *t = s + n + digits;
    t += strspn(t, " \t");
    if (digits > 0 && (n == 0 ? *t == ')' : *t == ',' || *t == ')'))
        return t + 1 + strspn(t + 1, " \t");
    return s;
}

/* A sign, digits with or without a point, an exponent: and nothing after it. */
static bool to_number(const char *s, double *value)
{
    char *end;
    size_t n = strspn(s, "0123456789+-.eE");
    if (*s == '\0' || s[n] != '\0' || !strpbrk(s, "0123456789"))
        return false;
    *value = strtod(s, &end);
    return *end == '\0' && isfinite(*value);
}

/* What stands before `end`, without blanks around it, in capitals. */
static void copy_word(char word[CL_WORD], const char *s, const char *end)
{
    size_t n = 0;
    while (s < end && isspace((unsigned char)*s))
        s++;
    while (end > s && isspace((unsigned char)end[-1]))
        end--;
    for (; s < end && n + 1 < CL_WORD; s++)
        word[n++] = (char)toupper((unsigned char)*s);
    word[n] = '\0';
}

static void split_arguments(struct cl_statement *s, const char *from)
{
    while (*from) {
        const char *to = from + strcspn(from, ",");
        struct cl_argument *a = array_push(&s->argument);
        *a = (struct cl_argument){.text = ""};
        copy_word(a->text, from, to);
        a->is_number = to_number(a->text, &a->number);
        from = *to ? to + 1 : to;
    }
}

/* The statement's text as a word and its arguments. */
static void split(struct cl_statement *s)
{
    const char *text = s->text;
    if (strncmp(text, "$$->", 4) == 0) {
        s->data = true;
        text += 4;
    } else if (strncmp(text, "$$", 2) == 0) {
        return;
    }
    text = behind_label(text + strspn(text, " \t"));
    s->bare = !s->data && *text && strchr("+-.0123456789", *text);
    if (s->bare) {
        split_arguments(s, text);
        return;
    }
    const char *slash = text + strcspn(text, "/");
    copy_word(s->word, text, slash);
    if (*slash)
        split_arguments(s, slash + 1);
}

static bool is_raw(const char *line)
{
    const char *s = behind_label(line);
    for (size_t i = 0; i < sizeof raw_words / sizeof *raw_words; i++)
        if (begins_with(s, raw_words[i]))
            return true;
    return false;
}

/* Adds a line; true when the statement goes on in the next one. */
static bool add_line(struct text *text, const char *line, bool first)
{
    bool data = first ? strncmp(line, "$$->", 4) == 0 : strncmp(text->item, "$$->", 4) == 0;
    const char *s = first && data ? line + 4 : line;
    if (first && !data && (strncmp(line, "$$", 2) == 0 || is_raw(line)))
        s = line + strlen(line);
    const char *end = s + strcspn(s, "$");
    bool goes_on = end[0] == '$' && end[1] != '$';
    for (; line < end; line++)
        *array_push(text) = *line;
    return goes_on;
}

int cl_text_read(const char *file, struct cl_text *text, struct error *error)
{
    struct text all = {0};
    size_t number = 0;
    char *line;
    if (read_file(file, &all, error) < 0)
        return -1;
    for (char *at = all.item; (line = next_line(&at, &number));) {
        struct text one = {0};
        struct cl_statement s = {.line = number};
        if (!*line)
            continue;
        bool goes_on = add_line(&one, line, true);
        while (goes_on && (line = next_line(&at, &number)))
            goes_on = add_line(&one, line, false);
        *array_push(&one) = '\0';
        s.text = one.item;
        split(&s);
        *array_push(text) = s;
    }
    array_free(&all);
    return 0;
}

void cl_text_free(struct cl_text *text)
{
    for (size_t i = 0; i < text->n; i++) {
        free(text->item[i].text);
        array_free(&text->item[i].argument);
    }
    array_free(text);
}

size_t cl_numbers(const struct cl_statement *s, size_t i, size_t most, double *value)
{
    size_t n = 0;
    for (; n < most && i + n < s->argument.n && s->argument.item[i + n].is_number; n++)
        value[n] = s->argument.item[i + n].number;
    return n;
}

size_t cl_find(const struct cl_statement *s, const char *word)
{
    size_t i = 0;
    while (i < s->argument.n && strcmp(s->argument.item[i].text, word) != 0)
        i++;
    return i;
}
