/* ncread_word - see ncread_word.h. */
#include "ncread_word.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/num.h"

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

static bool is_capital(char c)
{
    return c >= 'A' && c <= 'Z';
}

int ncread_word_number(const char **s, double *value, bool *pointed, struct error *error)
{
    const char *p = *s;
    int before = 0, behind = 0;
    if (*p == '-' || *p == '+')
        p++;
    while (is_digit(*p))
        p++, before++;
    *pointed = *p == '.';
    if (*pointed)
        p++;
    while (*pointed && is_digit(*p))
        p++, behind++;
    int shown = (int)(p - *s) < 24 ? (int)(p - *s) : 24;
    if (before + behind == 0)
        return error_set(error, "found `%.10s`, expected a number", *s);
    if (before > 9 || behind > 9)
        return error_set(error, "too many digits in `%.*s`", shown, *s);
    if (isalpha((unsigned char)*p) && (*p == 'E' || *p == 'e' || *p == 'D' || *p == 'd') &&
        (is_digit(p[1]) || p[1] == '-' || p[1] == '+'))
        return error_set(error, "an exponent in `%.20s`", *s);
    const char *q = *s;
    char text[32];
    memcpy(text, q, (size_t)(p - q));
    text[p - q] = '\0';
    q = text;
    if (!num_read(&q, value))
        return error_set(error, "found `%s`, expected a number", text);
    if (*text == '-' && *value == 0)
        return error_set(error, "minus zero in `%s`", text);
    *s = p;
    return 0;
}

static struct ncread_word *new_word(struct ncread_words *words, enum word_kind kind,
                                    const char *name, size_t n)
{
    struct ncread_word *w = array_push(words);
    *w = (struct ncread_word){.kind = kind};
    memcpy(w->name, name, n < WORD_TEXT ? n : WORD_TEXT - 1);
    return w;
}

int ncread_word_fanuc(const char *line, struct ncread_words *words, struct error *error)
{
    words->n = 0;
    const char *s = line + (*line == '/'); /* a block that may be skipped is run */
    while (*s && *s != ';') {
        if (*s == ' ' || *s == '\t') {
            s++;
        } else if (*s == '(') {
            size_t n = strcspn(s + 1, "()");
            if (s[n + 1] != ')')
                return error_set(error, "a comment that does not end, or one inside another");
            s += n + 2;
        } else if (isalpha((unsigned char)*s)) {
            char letter = (char)toupper((unsigned char)*s++);
            struct ncread_word *w = new_word(words, WORD_ADDRESS, &letter, 1);
            w->values = 1;
            s += strspn(s, " ");
            if (*s == '#' || *s == '[')
                return error_set(error,
                                 "found `%.10s`, a variable, which this reader does not read", s);
            if (ncread_word_number(&s, &w->value[0], &w->pointed, error) < 0)
                return -1;
        } else if (*s == '#' || *s == '[') {
            return error_set(
                error, "found `%.20s`, a variable or macro, which this reader does not read", s);
        } else {
            return error_set(error, "found `%.10s`, expected a word", s);
        }
    }
    return 0;
}

/* A value after `=`: a number, AC(number), a list in brackets or a text. */
static int siemens_value(const char **s, struct ncread_word *w, struct error *error)
{
    bool pointed;
    if (**s == '"') {
        size_t n = strcspn(*s + 1, "\"");
        if ((*s)[n + 1] != '"')
            return error_set(error, "a text that does not end");
        *s += n + 2;
        return 0;
    }
    if (strncmp(*s, "AC(", 3) == 0) {
        w->absolute = true;
        *s += 2;
    } else if (strncmp(*s, "IC(", 3) == 0) {
        w->by = true;
        *s += 2;
    } else if (strncmp(*s, "DC(", 3) == 0) {
        w->shortest = true;
        *s += 2;
    }
    if (**s != '(') {
        w->values = 1;
        return ncread_word_number(s, &w->value[0], &w->pointed, error);
    }
    do {
        ++*s;
        if (w->values == WORD_VALUES)
            return error_set(error, "more than %d numbers in a bracket", WORD_VALUES);
        if (ncread_word_number(s, &w->value[w->values++], &pointed, error) < 0)
            return -1;
    } while (**s == ',');
    if (**s != ')')
        return error_set(error, "found `%.10s`, expected `)`", *s);
    ++*s;
    return 0;
}

/* A call's arguments are skipped, but its brackets must close. */
static int siemens_call(const char **s, struct error *error)
{
    size_t n = strcspn(*s, ")");
    if ((*s)[n] != ')')
        return error_set(error, "a call that does not end: `%.20s`", *s);
    *s += n + 1;
    return 0;
}

static int siemens_word(const char **at, struct ncread_words *words, struct error *error)
{
    const char *s = *at;
    size_t n = strspn(s, "ABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789");
    size_t letters = strspn(s, "ABCDEFGHIJKLMNOPQRSTUVWXYZ_");
    size_t index = s[n] == '[' ? strcspn(s + n, "]") + 1 : 0;
    struct ncread_word *w;
    if (s[n + index] == '=') {
        w = new_word(words, WORD_SET, s, n + index);
        *at = s + n + index + 1;
        return siemens_value(at, w, error);
    }
    if (letters == 1 && (is_digit(s[1]) || s[1] == '-' || s[1] == '+' || s[1] == '.')) {
        w = new_word(words, WORD_ADDRESS, s, 1);
        w->values = 1;
        *at = s + 1;
        return ncread_word_number(at, &w->value[0], &w->pointed, error);
    }
    w = new_word(words, s[n] == '(' ? WORD_CALL : WORD_NAME, s, n);
    *at = s + n;
    return w->kind == WORD_CALL ? siemens_call(at, error) : 0;
}

int ncread_word_siemens(const char *line, struct ncread_words *words, struct error *error)
{
    words->n = 0;
    const char *first = line + (*line == '/'); /* a block that may be skipped is run */
    for (const char *s = first; *s && *s != ';';) {
        if (*s == ' ')
            s++;
        else if (!is_capital(*s))
            return error_set(error, "found `%.10s`, expected a word", s);
        else if (siemens_word(&s, words, error) < 0)
            return -1;
        else if (*s && *s != ' ' && *s != ';' && !is_capital(*s))
            return error_set(error, "found `%.10s` after a word", s);
    }
    return 0;
}

const struct ncread_word *ncread_word_find(const struct ncread_words *words, const char *name)
{
    for (size_t i = 0; i < words->n; i++)
        if (strcmp(words->item[i].name, name) == 0)
            return &words->item[i];
    return NULL;
}
