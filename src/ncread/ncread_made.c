/* ncread_made - see ncread/ncread_made.h. */
#include "ncread/ncread_made.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

static const char *const kept[] = {"offset",       "offset.1",    "coolant.on",  "coolant.mist",
                                   "coolant.thru", "coolant.air", "coolant.off", "home"};

/* The value behind `key =` at this place, NULL: another key stands there. */
static const char *value_at(const char *s, const char *key)
{
    size_t n = strlen(key);
    if (strncasecmp(s, key, n) != 0)
        return NULL;
    s += n + strspn(s + n, " ");
    return *s == '=' ? s + 1 + strspn(s + 1, " ") : NULL;
}

/* A key of a machine with its `=` begins here: a name with a dot or of letters, not Q339=. */
static bool begins_key(const char *s)
{
    size_t n = 0, letters = 0, dots = 0;
    for (; isalnum((unsigned char)s[n]) || s[n] == '.'; n++) {
        letters += isalpha((unsigned char)s[n]) != 0;
        dots += s[n] == '.';
    }
    bool named = isalpha((unsigned char)*s) && (dots > 0 || letters > 2);
    return named && s[n + strspn(s + n, " ")] == '=';
}

/* The last value of the key among settings with blanks between. */
static bool find_set(const char *set, const char *key, char value[NCREAD_MADE_TEXT])
{
    bool found = false;
    for (const char *s = set; *s; s++) {
        const char *v = s == set || s[-1] == ' ' ? value_at(s, key) : NULL;
        size_t n = 0;
        if (!v)
            continue;
        while (v[n] && !(v[n] == ' ' && begins_key(v + n + 1)))
            n++;
        found = n < NCREAD_MADE_TEXT;
        snprintf(value, NCREAD_MADE_TEXT, "%.*s", found ? (int)n : 0, v);
    }
    return found;
}

/* The user's own settings have it; of offsets any of them. */
static bool is_own(const struct cli_list *own, const char *key)
{
    char stem[20];
    snprintf(stem, sizeof stem, "%.*s", (int)strcspn(key, "."), key);
    bool offset = strcmp(stem, "offset") == 0;
    for (size_t i = 0; i < own->n; i++) {
        const char *s = own->item[i] + strspn(own->item[i], " ");
        if (value_at(s, key) || (offset && strncasecmp(s, stem, strlen(stem)) == 0))
            return true;
    }
    return false;
}

void ncread_made_set(struct machine *machine, const struct ncread_head *head,
                     const struct cli_list *own)
{
    char value[NCREAD_MADE_TEXT], text[NCREAD_MADE_TEXT + 20];
    struct error error;
    for (size_t i = 0; i < sizeof kept / sizeof *kept; i++) {
        if (is_own(own, kept[i]) || !find_set(head->set, kept[i], value))
            continue;
        snprintf(text, sizeof text, "%s=%s", kept[i], value);
        machine_set(machine, text, &error); /* what it does not take is none of ncpost's */
    }
}

static bool same_file(const char *a, const char *b)
{
    return *a && strcasecmp(a, b) == 0;
}

bool ncread_made_for(const struct ncread_head *head, const char *control)
{
    return head->numbered && control && same_file(control, head->control_file);
}

/* G54, G54.1 P3, a preset of Klartext, or none: what the readers know. */
static bool is_offset(const char *work)
{
    return !*work || (*work == 'G' && isdigit((unsigned char)work[1])) ||
           strncmp(work, "CYCL DEF 247", 12) == 0;
}

bool ncread_made_work(const struct machine *machine, const struct ncread_head *head,
                      const struct cli_list *own, char work[NCREAD_MADE_TEXT])
{
    bool said = ncread_made_for(head, machine->used) &&
                same_file(machine->file, head->machine_file) &&
                strlen(head->set) < sizeof head->set / 2; /* longer ones are not all there */
    const char *first = machine->tool_offset[0];
    snprintf(work, NCREAD_MADE_TEXT, "%s", *first ? first : machine->offset);
    for (int i = 1; i < MACHINE_OFFSETS && head->of_whole; i++)
        said = said && !*machine->tool_offset[i]; /* which of them a part has it does not say */
    return (said || is_own(own, "offset")) && is_offset(work) &&
           control_text_has(&machine->text, "{work}");
}

/* The letters and the number behind them that stand at *s, which moves on; false: the end. */
static bool next_word(const char **s, char name[8], double *value)
{
    const char *p = *s + strspn(*s, " =");
    char *end;
    int n = 0;
    for (; isalpha((unsigned char)*p); p++)
        if (n < 7)
            name[n++] = (char)toupper((unsigned char)*p);
    name[n] = '\0';
    *value = strtod(p, &end);
    *s = end;
    return n > 0 || end > p;
}

bool ncread_made_same(const char *a, const char *b)
{
    char of_a[8], of_b[8];
    double x, y;
    bool same = !*a == !*b, more = true;
    int words = 0;
    while (more && same) {
        bool more_a = next_word(&a, of_a, &x), more_b = next_word(&b, of_b, &y);
        bool number = words++ == 1 && more_a != more_b; /* G15 and G15 H1 */
        more = more_a && more_b;
        same = !number && (!more || (strcmp(of_a, of_b) == 0 && x == y));
    }
    return same;
}
