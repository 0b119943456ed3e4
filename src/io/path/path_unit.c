/* path_unit - the unit of a stream that does not say it; see path_parse.h. */
#include <ctype.h>
#include <string.h>

#include "path_parse.h"

enum { PEEK_FIRST = 1 << 9, PEEK = 1 << 16, PEEK_MOST = 1 << 22 };

static bool is_letter(char c)
{
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
}

/* The n letters and digits are this word, in capitals or not. */
static bool is_word(const char *text, size_t n, const char *word)
{
    size_t k = 0;
    while (k < n && toupper((unsigned char)text[k]) == word[k])
        k++;
    return k == n && word[k] == '\0';
}

/* What the lines say of units; each is set where it is found. */
struct unit_signs {
    bool units, inch, mm;
};

static void look_at_line(const char *line, size_t n, struct unit_signs *found)
{
    bool feed = false, inch = false, mm = false;
    for (size_t i = 0; i < n; i++) {
        const char *word = line + i;
        while (i < n && is_letter(line[i]))
            i++;
        size_t m = (size_t)(line + i - word);
        if (m < 3 || m > 6)
            continue;
        feed = feed || is_word(word, m, "FEDRAT") || is_word(word, m, "CYCLE");
        inch = inch || is_word(word, m, "IPM") || is_word(word, m, "IPR");
        mm = mm || is_word(word, m, "MMPM") || is_word(word, m, "MMPR");
        found->units = found->units || is_word(word, m, "UNITS") || is_word(word, m, "UNIT");
    }
    found->inch = found->inch || (feed && inch);
    found->mm = found->mm || (feed && mm);
}

static void look_for_units(const char *text, size_t n, struct unit_signs *found)
{
    const char *end = text + n;
    while (text < end && !found->units) {
        const char *stop = memchr(text, '\n', (size_t)(end - text));
        size_t length = (size_t)((stop ? stop : end) - text);
        look_at_line(text, length, found);
        text += length + 1;
    }
}

/* The text without a last line that is not whole. */
static size_t whole_lines(const char *text, size_t n)
{
    while (n > 0 && text[n - 1] != '\n')
        n--;
    return n;
}

/* Most streams say it at once, and what comes slowly is not waited for. */
int path_guess_unit(struct path_parse *p)
{
    struct unit_signs found = {0};
    size_t all = p->reader.size > 0 ? p->reader.size : PEEK_MOST;
    const char *text;
    for (size_t want = PEEK_FIRST;; want = want < PEEK ? 2 * want : all) {
        long got = reader_peek(&p->reader, &text, want, p->error);
        if (got < 0)
            return -1;
        bool last = want >= all || (size_t)got < want;
        found = (struct unit_signs){0};
        look_for_units(text, last ? (size_t)got : whole_lines(text, (size_t)got), &found);
        if (found.units || last)
            break;
    }
    if (found.units || !found.inch)
        return 0;
    if (found.mm)
        return error_set(p->error,
                         "%s: found feeds in inches and in mm and no UNITS, expected UNITS/MM, "
                         "UNITS/INCHES or option -u",
                         p->path->name);
    p->unit = 25.4;
    p->path->inches_taken = true;
    return 0;
}
