/* holder_text - see holder_text.h. */
#include "gouge/holder_text.h"

#include <stdbool.h>
#include <string.h>

#include "base/num.h"

#define LONGEST 1e4 /* mm */

static char *write_number(char *end, char before, double value)
{
    char number[NUM_MAX];
    size_t n = num_write_short(number, value, 6, false);
    if (before)
        *end++ = before;
    memcpy(end, number, n + 1);
    return end + n;
}

void holder_text_write(const struct holder *holder, char text[HOLDER_TEXT])
{
    char *end = text;
    *end = '\0';
    for (int i = 0; i < holder->n && i < HOLDER_PARTS; i++) {
        const struct holder_part *part = &holder->part[i];
        end = write_number(end, i > 0 ? '+' : '\0', part->low);
        if (part->high != part->low)
            end = write_number(end, ':', part->high);
        end = write_number(end, ':', part->length);
    }
}

/* One cone, up to `+` or the end of the text. */
static bool read_part(const char **s, struct holder_part *part)
{
    double value[3];
    int n = 0;
    do {
        if (n == 3 || !strchr(".0123456789", **s) || !num_read(s, &value[n]) ||
            !(value[n] >= 0 && value[n] <= LONGEST))
            return false;
        n++;
    } while (*(*s)++ == ':');
    --*s;
    if (n < 2 || (**s && **s != '+'))
        return false;
    *part = (struct holder_part){value[0], value[n - 2], value[n - 1]};
    return part->length > 0 && part->low + part->high > 0;
}

int holder_text_read(const char *text, struct holder *holder, struct error *error)
{
    const char *s = text;
    holder->n = 0;
    for (;;) {
        const char *from = s;
        if (holder->n == HOLDER_PARTS)
            return error_set(error, "found more than %d cones", HOLDER_PARTS);
        if (!read_part(&s, &holder->part[holder->n++]))
            return error_set(error, "found `%.40s`, expected R:L or R0:R1:L in mm, joined by +",
                             from);
        if (!*s)
            return 0;
        s++;
    }
}
