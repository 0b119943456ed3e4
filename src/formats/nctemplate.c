/* nctemplate - see nctemplate.h. */
#include "nctemplate.h"

#include <string.h>

#include "ncframe.h"
#include "num.h"

enum { WORDS = 11, PLANE = 6, ROOM = 200 };

static const char *const word[WORDS] = {"tool}",        "offset}", "rpm}", "tolerance}",
                                        "orientation}", "level}",  "a}",   "b}",
                                        "i}",           "j}",      "k}"};

/* The word that starts here, behind its brace; -1: none. */
static int find(const char *text)
{
    for (int i = 0; i < WORDS; i++)
        if (strncmp(text, word[i], strlen(word[i])) == 0)
            return i;
    return -1;
}

int nc_template_check(const char *text, struct error *error)
{
    for (const char *s = strchr(text, '{'); s; s = strchr(s + 1, '{'))
        if (find(s + 1) < 0)
            return error_set(
                error,
                "found `%.20s` in the template `%.40s`, expected {tool}, {offset}, {rpm}, "
                "{tolerance}, {orientation}, {level}, {a}, {b}, {i}, {j} or {k}",
                s, text);
    return 0;
}

/* 1 at 0.1 mm and above, for speed, to 10 at 0.001 mm and below, for accuracy. */
static double level(double tolerance)
{
    return fmin(10, fmax(1, round(1 + 4.5 * log10(0.1 / tolerance))));
}

static size_t value(const struct nc_program *p, int i, char *text)
{
    const struct nc_tooling *t = &p->tooling;
    if (i >= PLANE) {
        struct nc_plane plane = {0};
        if (p->at_plane < p->planes.n)
            plane = p->planes.item[p->at_plane];
        const double angle[] = {plane.a, plane.b, plane.i, plane.j, plane.k};
        bool sign = p->w.style.sign && angle[i - PLANE] >= 0;
        *text = '+';
        return sign + num_write_short(text + sign, angle[i - PLANE], p->plan->ability.digits.angle,
                                      p->w.style.point);
    }
    const double values[PLANE] = {
        t->number ? t->number : 1,       t->offset,           t->spindle, p->wish.chord,
        DEGREES(p->wish.axis_tolerance), level(p->wish.chord)};
    return num_write_short(text, values[i], i == 3 || i == 4 ? 4 : 0, false);
}

void nc_template(struct nc_program *p, const char *own, const char *usual)
{
    char block[ROOM + NUM_MAX];
    size_t n = 0;
    for (const char *s = *own ? own : usual;; s++) {
        int i = *s == '{' ? find(s + 1) : -1;
        if (i >= 0) {
            n += value(p, i, block + n);
            s += strlen(word[i]);
        } else if (*s && *s != '|') {
            block[n++] = *s;
        } else {
            block[n] = '\0';
            while (n && block[n - 1] == ' ')
                block[--n] = '\0';
            if (n)
                nc_block(&p->w, block + strspn(block, " "));
            n = 0;
        }
        if (!*s)
            return;
        if (n > ROOM)
            n = ROOM;
    }
}
