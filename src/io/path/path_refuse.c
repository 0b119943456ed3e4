/*
 * path_refuse - statements that no row reads but that may move the tool: a motion word without its
 * slash, one that is misspelt, one with coordinates.  See path_parse.h.
 */
#include <ctype.h>
#include <string.h>

#include "path_parse.h"

/* Words that move the tool, of this reader and of others. */
static const char *const motion[] = {"GOTO",   "GODLTA", "CIRCLE", "MOVARC", "MOVNRB", "FROM",
                                     "GOHOME", "CYCLE",  "RAPID",  "MOVETO", "GOLFT",  "GORGT",
                                     "GOFWD",  "GOBACK", "ARCMOV", "MOVLIN"};

/* Words with numbers that say where something is, and move nothing. */
static const char *const still[] = {
    "STOCK",  "BLOCK",  "WPIECE", "PAINT",  "DISPLY", "COLOR",  "LIMIT",  "CLAMP",  "FIXTUR",
    "BOX",    "VIEW",   "SCALE",  "AUXFUN", "PREFUN", "SAFPOS", "SAFETY", "TOOLCH", "HOLDER",
    "TPARAM", "PITCH",  "PBS",    "CHECK",  "AIR",    "RETRCT", "GOHOME", "COPYIN", "INTOL",
    "OUTTOL", "TOLER",  "THICK",  "MAXVEL", "ORIGIN", "SETOOL", "DEFSUB", "OFSTNO", "CSYS",
    "SYN",    "ADJUST", "SEQNO",  "CUTCOM", "TLDATA", "MSYS"};

static bool is_among(const char *word, size_t n, const char *const *words, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (strlen(words[i]) == n && strncmp(words[i], word, n) == 0)
            return true;
    return false;
}

/* One letter is another, missing, or too many. */
static bool is_nearly(const char *a, size_t n, const char *b)
{
    size_t m = strlen(b), same = 0, tail = 0;
    if (n + 1 < m || m + 1 < n || n < 3)
        return false;
    while (same < n && same < m && a[same] == b[same])
        same++;
    while (tail < n - same && tail < m - same && a[n - 1 - tail] == b[m - 1 - tail])
        tail++;
    return n - same - tail <= 1 && m - same - tail <= 1;
}

static size_t count_numbers(const struct apt *apt)
{
    size_t n = 0;
    for (size_t i = 0; i < apt->argument.n; i++)
        n += apt->argument.item[i].is_number;
    return n;
}

int path_refuse_motion(struct path_parse *p)
{
    const char *word = p->apt.word;
    size_t n = 0, numbers = count_numbers(&p->apt);
    while (isalnum((unsigned char)word[n]))
        n++;
    bool bare = word[n] && strcspn(word + n, "0123456789") < strlen(word + n);
    bool moves = (bare && is_among(word, n, motion, sizeof motion / sizeof *motion)) ||
                 (numbers >= 3 && !is_among(word, n, still, sizeof still / sizeof *still));
    for (size_t i = 0; i < sizeof motion / sizeof *motion && !moves; i++)
        moves = (bare || numbers >= 2) && is_nearly(word, n, motion[i]) &&
                !is_among(word, n, still, sizeof still / sizeof *still);
    if (!moves && !((strncmp(word, "MOV", 3) == 0 || strncmp(word, "GO", 2) == 0) && numbers > 0))
        return 0;
    return error_at(p->error, p->path->name, p->apt.line,
                    "found `%.40s`, which may move the tool, expected a word like GOTO/x,y,z: "
                    "ignoring it would lose the motion",
                    p->apt.raw);
}
