/* ncread_meaning - see ncread_meaning.h. */
#include "ncread_meaning.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "math/elementary.h"
#include "base/cli.h"
#include "ncread_state.h"

static const char *const meanings[MEANS_NOTHING_KNOWN] = {[MEANS_IDLE] = "idle",
                                                          [MEANS_OFFSET] = "offset",
                                                          [MEANS_TCP] = "tcp",
                                                          [MEANS_TCP_VECTORS] = "tcp.vectors",
                                                          [MEANS_TCP_OFF] = "tcp.off",
                                                          [MEANS_LENGTH] = "length",
                                                          [MEANS_LENGTH_OFF] = "length.off",
                                                          [MEANS_NEVER] = "never",
                                                          [MEANS_HOME] = "home",
                                                          [MEANS_MACHINE_ON] = "machine",
                                                          [MEANS_MACHINE_OFF] = "machine.off",
                                                          [MEANS_MM] = "mm",
                                                          [MEANS_INCH] = "inch",
                                                          [MEANS_END] = "end",
                                                          [MEANS_READ] = "read",
                                                          [MEANS_UNREAD] = "unread"};

/* One entry `WORD: meaning` of the list; the rest of it, NULL: there is no more. */
static const char *next_entry(const char *words, char word[WORD_TEXT], char meaning[WORD_TEXT])
{
    *word = *meaning = '\0';
    words += strspn(words, " |");
    if (!*words)
        return NULL;
    size_t all = strcspn(words, "|"), n = 0;
    const char *colon = memchr(words, ':', all);
    for (const char *s = words; s < (colon ? colon : words + all) && n + 1 < WORD_TEXT;) {
        bool hash = strncmp(s, "{hash}", 6) == 0;
        word[n++] = hash ? '#' : *s;
        s += hash ? 6 : 1;
    }
    while (n && word[n - 1] == ' ')
        n--;
    word[n] = '\0';
    if (colon) {
        const char *s = colon + 1 + strspn(colon + 1, " ");
        int length = (int)strcspn(s, " |");
        snprintf(meaning, WORD_TEXT, "%.*s", length < WORD_TEXT ? length : WORD_TEXT - 1, s);
    }
    return words + all;
}

static enum ncread_meaning find_meaning(const char *text)
{
    int i = 0;
    while (i < MEANS_NOTHING_KNOWN && strcmp(meanings[i], text) != 0)
        i++;
    return (enum ncread_meaning)i;
}

int ncread_meaning_check(const char *words, struct error *error)
{
    char word[WORD_TEXT], meaning[WORD_TEXT];
    for (const char *s = words; (s = next_entry(s, word, meaning)) != NULL;)
        if (!*word || find_meaning(meaning) == MEANS_NOTHING_KNOWN)
            return error_set(
                error,
                "words: found `%s: %s`, expected WORD: idle, offset, tcp, tcp.vectors, "
                "tcp.off, length, length.off, never, home, machine, machine.off, "
                "mm, inch, end, read or unread",
                word, meaning);
    return 0;
}

/* The number is a whole one of a range: entry is G17-G19 from its `-` on. */
static bool within(double from, const char *entry, char letter, double number)
{
    char *end;
    if (entry[0] != '-' || entry[1] != letter)
        return false;
    double to = strtod(entry + 2, &end);
    return end > entry + 2 && !*end && number >= from && number <= to && number == floor(number);
}

/* The same letter and number as an entry, or one of its range, or the same text. */
static bool same_word(const char *entry, const char *b)
{
    char *end, *end_b;
    if (strcmp(entry, b) == 0)
        return true;
    if (*entry != *b || !isupper((unsigned char)*entry))
        return false;
    double x = strtod(entry + 1, &end), y = strtod(b + 1, &end_b);
    if (end == entry + 1 || end_b == b + 1 || *end_b)
        return false;
    return (!*end && fabs(x - y) < 1e-6) || within(x, end, *entry, y);
}

/* The entry is the letter alone of a word with a number. */
static bool same_letter(const char *entry, const char *word)
{
    return entry[0] == word[0] && !entry[1] && strspn(word + 1, "0123456789.") > 0;
}

enum ncread_meaning ncread_meaning_of(const struct ncread *c, const char *text)
{
    char word[WORD_TEXT], meaning[WORD_TEXT];
    const char *s = c->options->words ? c->options->words : "";
    enum ncread_meaning found = MEANS_NOTHING_KNOWN;
    while ((s = next_entry(s, word, meaning)) != NULL) {
        if (same_word(word, text)) {
            found = find_meaning(meaning);
            break;
        }
        if (same_letter(word, text))
            found = find_meaning(meaning);
    }
    return found == MEANS_READ ? MEANS_NOTHING_KNOWN : found;
}

enum ncread_meaning ncread_meaning_of_word(const struct ncread *c, const struct ncread_word *w)
{
    char text[WORD_TEXT + 32];
    if (!c->options->words || !*c->options->words)
        return MEANS_NOTHING_KNOWN;
    if (w->kind == WORD_ADDRESS)
        snprintf(text, sizeof text, "%s%.10g", w->name, w->value[0]);
    else
        snprintf(text, sizeof text, "%s", w->name);
    return ncread_meaning_of(c, text);
}

int ncread_meaning_apply(struct ncread *c, enum ncread_meaning meaning, struct error *error)
{
    switch (meaning) {
    case MEANS_TCP:
    case MEANS_TCP_VECTORS:
        if (!ncread_upright(c)) /* upright the frame is the work's before and after */
            memset(c->here.known, 0, sizeof c->here.known);
        c->tcp = c->length = true;
        c->vectors = meaning == MEANS_TCP_VECTORS;
        break;
    case MEANS_TCP_OFF:
    case MEANS_LENGTH_OFF:
        c->tcp = c->vectors = false;
        c->length = ncread_meaning_of(c, "G43") == MEANS_NEVER;
        break;
    case MEANS_LENGTH:
        c->length = true;
        break;
    case MEANS_HOME:
        memset(c->here.known, 0, sizeof c->here.known);
        break;
    case MEANS_MACHINE_ON:
    case MEANS_MACHINE_OFF:
        c->machine_frame = meaning == MEANS_MACHINE_ON;
        break;
    case MEANS_MM:
    case MEANS_INCH:
        return ncread_unit(c, meaning == MEANS_MM ? 1 : INCH, error);
    case MEANS_END:
        c->ended = true;
        break;
    case MEANS_UNREAD:
        return ncread_error(c, error, "found a word of the control that this reader does not read");
    default:
        break;
    }
    return 0;
}

/* ---- words that nothing is known of */

void ncread_meaning_note(struct ncread *c, const char *word)
{
    for (size_t i = 0; i < c->unknown_n; i++)
        if (strcmp(c->unknown[i].word, word) == 0) {
            c->unknown[i].times++;
            return;
        }
    if (c->unknown_n == NCREAD_UNKNOWN)
        return;
    struct ncread_unknown_word *u = &c->unknown[c->unknown_n++];
    *u = (struct ncread_unknown_word){.line = c->line, .times = 1};
    snprintf(u->word, sizeof u->word, "%.39s", word);
}

void ncread_meaning_tell(struct ncread *c)
{
    if (c->length_assumed)
        say("%s:%zu: cuts without the tool's length (G43): took Z for the tip's height as it "
            "stands, the zero set with this tool",
            c->name, c->length_assumed);
    for (size_t i = 0; i < c->unknown_n; i++)
        say("%s:%zu: found %s, which is not known here: taken to have no effect (%zu times)",
            c->name, c->unknown[i].line, c->unknown[i].word, c->unknown[i].times);
}

/* Tenths of G from..to. */
static const struct {
    int from, to;
    const char *what;
} moving[] = {
    {21, 23, "an interpolation"},
    {31, 33, "an interpolation"},
    {52, 53, "a spline"},
    {60, 69, "a spline"},
    {70, 71, "an interpolation on a cylinder"},
    {100, 109, "a change of offsets or a retract"},
    {120, 139, "a circle of its own or an interpolation"},
    {160, 160, "polar coordinates"},
    {171, 179, "a plane of other axes"},
    {181, 189, "a plane of other axes"},
    {191, 199, "a plane of other axes"},
    {270, 290, "a way to a reference point"}, /* G28.1 of Mach3 and G30.1 of Fanuc go there, too */
    {300, 309, "a way to a reference point"},
    {310, 389, "a skip, a thread or a measurement"},
    {410, 429, "radius compensation"},
    {431, 439, "a tool's length more, or along its axis"},
    {440, 449, "a tool's length against Z"},
    {450, 489, "an offset of the tool"},
    {500, 529, "scaling, mirroring or a shift"},
    {531, 539, "a turn of the rotary axes or a frame"},
    {600, 601, "a way from one side"},
    {650, 669, "a macro"},
    {680, 689, "a turned frame"},
    {700, 890, "a cycle"},
    {920, 929, "a shift"},
    {950, 950, "a feed per revolution"},
    {960, 969, "a surface speed"},
    {1000, 1079, "mirroring, a frame or an interpolation"},
    {1120, 1139, "an interpolation"},
    {1360, 1369, "a measurement"},
    {1410, 1439, "compensation in space"},
    {1500, 1509, "a pocket"},
    {1740, 1849, "a cycle"},
    {2540, 2540, "a frame that turns with the table"},
    {2680, 2680, "a tilted plane"},
};

bool ncread_meaning_shapes(const char *name)
{
    static const char *const shaping[] = {"AR",  "AP",   "RP",  "TURN", "RND",
                                          "CHF", "RNDM", "CHR", "ANG",  "OFFN"};
    static const char *const of_axis[] = {"POS[", "POSA[", "POSP[", "AX[", "R["};
    bool axis = strchr("ABCUVWXYZIJKR", *name) != NULL;
    if (axis && strspn(name + 1, "0123456789") == strlen(name + 1))
        return true;
    for (size_t i = 0; i < sizeof shaping / sizeof *shaping; i++)
        if (strcmp(name, shaping[i]) == 0)
            return true;
    for (size_t i = 0; i < sizeof of_axis / sizeof *of_axis; i++)
        if (strncmp(name, of_axis[i], strlen(of_axis[i])) == 0)
            return true;
    return false;
}

const char *ncread_meaning_moves(char letter, int tenths)
{
    if (letter == 'M')
        return (tenths >= 960 && tenths <= 999) || tenths == 1980 ? "a subprogram or a jump"
               : tenths == 1400                                   ? "a retract"
                                                                  : NULL;
    for (size_t i = 0; letter == 'G' && i < sizeof moving / sizeof *moving; i++)
        if (tenths >= moving[i].from && tenths <= moving[i].to)
            return moving[i].what;
    return NULL;
}
