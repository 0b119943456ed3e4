/* apt - see apt.h. */
#include "apt.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "math/elementary.h"
#include "base/num.h"

static bool is_blank(char c)
{
    return c == ' ' || c == '\t';
}

/* Trims the text in place. */
static char *trim(char *s)
{
    while (is_blank(*s))
        s++;
    size_t n = strlen(s);
    while (n && is_blank(s[n - 1]))
        n--;
    s[n] = '\0';
    return s;
}

/* Drops the blanks beside commas, in place: `TLON, GOFWD` is the word TLON,GOFWD. */
static void close_commas(char *s)
{
    char *to = s;
    for (const char *from = s; *from; from++) {
        size_t blanks = strspn(from, " \t");
        if (blanks && (from[blanks] == ',' || (to > s && to[-1] == ',')))
            from += blanks;
        *to++ = *from;
    }
    *to = '\0';
}

/* True if the line starts with one of the words whose text is raw. */
static bool is_raw(const char *s)
{
    static const char *const words[] = {"PARTNO", "PPRINT", "INSERT", "TPRINT", "REMARK"};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        size_t k = 0;
        while (words[i][k] && toupper((unsigned char)s[k]) == words[i][k])
            k++;
        if (!words[i][k] && !isalnum((unsigned char)s[k]))
            return true;
    }
    return false;
}

/* The text after a label: `N30 ,GOTO/...` of NCL, `100) GOTO/...` of APT. */
static char *skip_label(char *s)
{
    char *p = s + (toupper((unsigned char)*s) == 'N');
    size_t digits = strspn(p, "0123456789");
    p += digits;
    if (digits && p == s + digits && *p == ')')
        return p + 1 + strspn(p + 1, " \t");
    p += strspn(p, " \t");
    if (!digits || s == p || toupper((unsigned char)*s) != 'N' || *p != ',')
        return s;
    return p + 1 + strspn(p + 1, " \t");
}

/* Numbers alone, without a word. */
static bool is_bare(const char *s)
{
    bool digit = false;
    for (; *s; s++) {
        digit = digit || isdigit((unsigned char)*s);
        if (!strchr("0123456789+-.,EDed \t", *s))
            return false;
    }
    return digit;
}

static int expect_text(const struct reader *r, const char *line, size_t n, struct error *error)
{
    for (size_t i = 0; i < n; i++) {
        unsigned char c = (unsigned char)line[i];
        if ((c < ' ' && c != '\t' && c != '\f') || c == 127)
            return error_at(error, r->name, r->line,
                            "found a binary character (code %d), expected APT text", c);
    }
    return 0;
}

static void append_text(struct apt *apt, const char *s, size_t n)
{
    array_reserve(&apt->joined, apt->joined.n + n + 1);
    memcpy(apt->joined.item + apt->joined.n, s, n);
    apt->joined.n += n;
    apt->joined.item[apt->joined.n] = '\0';
}

/* The length of the line without its comment, or up to the $ that continues it (*more). */
static size_t text_end(const char *s, bool *more)
{
    const char *dollar = strchr(s, '$');
    *more = dollar && dollar[1] != '$';
    return dollar ? (size_t)(dollar - s) : strlen(s);
}

/* The same of a line that starts with $$: its last character continues it when it is a single $. */
static size_t comment_end(const char *s, bool *more)
{
    size_t n = strlen(s);
    while (n > 2 && is_blank(s[n - 1]))
        n--;
    *more = n > 2 && s[n - 1] == '$' && s[n - 2] != '$';
    return *more ? n - 1 : n;
}

/* Joins the lines of one statement; 1, 0 at the end, -1. */
static int join_lines(struct reader *r, struct apt *apt, struct error *error)
{
    bool more = true, first = true;
    apt->joined.n = 0;
    while (more) {
        char *line;
        size_t n;
        int got = reader_line(r, &line, &n, error);
        if (got < 0)
            return -1;
        if (got == 0)
            return first ? 0
                         : error_at(error, r->name, r->line,
                                    "the input ends in a statement continued by $, expected the "
                                    "rest of it and FINI");
        if (expect_text(r, line, n, error) < 0)
            return -1;
        char *s = line;
        while (is_blank(*s))
            s++;
        if (first) {
            apt->line = (unsigned)r->line;
            s = skip_label(s);
            apt->comment = s[0] == '$' && s[1] == '$';
            first = false;
        }
        size_t end = 0;
        more = false;
        if (apt->comment && apt->joined.n == 0)
            end = comment_end(s, &more);
        else if (apt->joined.n == 0 && is_raw(s))
            end = strlen(s);
        else
            end = text_end(s, &more);
        append_text(apt, s, end);
    }
    return 1;
}

/* Finds the word and the arguments of `s`, which is changed in place. */
static void split_arguments(struct apt *apt, char *s)
{
    char *slash = strchr(s, '/');
    bool bare = !slash && is_bare(s);
    apt->slash = slash != NULL;
    if (slash)
        *slash = '\0';
    if (!bare) {
        char *word = trim(s);
        close_commas(word);
        apt->word = word;
    }
    if (!slash && !bare)
        return;
    char *p = trim(bare ? s : slash + 1);
    while (*p) {
        char *comma = strchr(p, ',');
        if (comma)
            *comma = '\0';
        struct apt_argument *a = array_push(&apt->argument);
        a->text = trim(p);
        a->number = NAN;
        a->is_number = num_whole(a->text, &a->number);
        if (!comma)
            break;
        p = comma + 1;
    }
}

int apt_read(struct reader *r, struct apt *apt, struct error *error)
{
    for (;;) {
        int got = join_lines(r, apt, error);
        if (got <= 0)
            return got;
        apt->raw = trim(apt->joined.item);
        if (*apt->raw)
            break;
    }
    apt->argument.n = 0;
    apt->word = "";
    apt->slash = false;
    const char *text = apt->raw;
    if (apt->comment && strncmp(text, "$$->", 4) != 0)
        return 1;
    if (apt->comment)
        text += 4;
    apt->upper.n = 0;
    array_reserve(&apt->upper, strlen(text) + 1);
    char *u = apt->upper.item;
    for (; *text; text++)
        *u++ = (char)toupper((unsigned char)*text);
    *u = '\0';
    if (!apt->comment && is_raw(apt->upper.item)) {
        apt->upper.item[6] = '\0';
        apt->word = apt->upper.item;
        return 1;
    }
    split_arguments(apt, apt->upper.item);
    return 1;
}

void apt_free(struct apt *apt)
{
    array_free(&apt->argument);
    array_free(&apt->joined);
    array_free(&apt->upper);
}

bool apt_is(const struct apt *apt, size_t i, const char *word)
{
    return i < apt->argument.n && strcmp(apt->argument.item[i].text, word) == 0;
}

int apt_numbers(const struct apt *apt, const char *name, size_t from, size_t n, double *value,
                const char *what, struct error *error)
{
    for (size_t i = 0; i < n; i++) {
        if (from + i >= apt->argument.n)
            return error_at(error, name, apt->line, "found %zu numbers in %s, expected %zu (%s)", i,
                            apt->word, n, what);
        const struct apt_argument *a = &apt->argument.item[from + i];
        if (!a->is_number)
            return error_at(error, name, apt->line,
                            "found `%.40s` in %s, expected a finite number (%s)", a->text,
                            apt->word, what);
        value[i] = a->number;
    }
    return 0;
}
