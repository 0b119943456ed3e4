/* nctemplate - see nctemplate.h. */
#include "nctemplate.h"

#include <string.h>

#include "post/ncframe.h"
#include "base/num.h"
#include "machine/template.h"

enum { ROOM = 200 };

/* 1 at 0.1 mm and above, for speed, to 10 at 0.001 mm and below, for accuracy. */
static double level(double tolerance)
{
    return fmin(10, fmax(1, round(1 + 4.5 * log10(0.1 / tolerance))));
}

static size_t value(const struct nc_program *p, enum template_word word, char *text)
{
    const struct nc_tooling *t = &p->tooling;
    if (word >= TEMPLATE_PLANE) {
        struct nc_plane plane = {0};
        if (p->at_plane < p->planes.n)
            plane = p->planes.item[p->at_plane];
        const double angle[] = {plane.a, plane.b, plane.i, plane.j, plane.k};
        int i = (int)word - TEMPLATE_PLANE;
        bool sign = p->w.style.sign && angle[i] >= 0;
        *text = '+';
        return sign + num_write_short(text + sign, angle[i], p->plan->ability.digits.angle,
                                      p->w.style.point);
    }
    const double values[TEMPLATE_PLANE] = {[TEMPLATE_TOOL] = t->number ? t->number : 1,
                                           [TEMPLATE_OFFSET] = t->offset,
                                           [TEMPLATE_RPM] = t->spindle,
                                           [TEMPLATE_TOLERANCE] = p->wish.chord,
                                           [TEMPLATE_ORIENTATION] = DEGREES(p->wish.axis_tolerance),
                                           [TEMPLATE_LEVEL] = level(p->wish.chord)};
    bool angle_or_length = word == TEMPLATE_TOLERANCE || word == TEMPLATE_ORIENTATION;
    return num_write_short(text, values[word], angle_or_length ? 4 : 0, false);
}

void nc_template(struct nc_program *p, const char *own, const char *usual)
{
    char block[ROOM + NUM_MAX];
    size_t n = 0;
    for (const char *s = *own ? own : usual;; s++) {
        size_t length;
        enum template_word word = template_word(s, &length);
        if (word != TEMPLATE_NONE) {
            n += value(p, word, block + n);
            s += length - 1;
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
