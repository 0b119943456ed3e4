/* iges_global - see iges_global.h. */
#include "iges_global.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "iges_text.h"

/* Columns of the section, and the numbers of its parameters that count here. */
enum { WIDTH = 72, SCALE = 13, UNIT_FLAG = 14, UNIT_NAME = 15 };

struct unit {
    int flag;
    const char *name, *other;
    double mm;
};

static const struct unit unit_table[] = {
    {1, "INCH", "IN", 25.4},           {2, "MM", "MILLIMETER", 1}, {4, "FT", "FOOT", 304.8},
    {5, "MI", "MILE", 1609344},        {6, "M", "METER", 1000},    {7, "KM", "KILOMETER", 1e6},
    {8, "MIL", "MIL", 0.0254},         {9, "UM", "MICRON", 0.001}, {10, "CM", "CENTIMETER", 10},
    {11, "UIN", "MICROINCH", 2.54e-5},
};

/* Flag 3 means the unit by name. */
static const struct unit *unit_of(long flag, const char *name)
{
    for (size_t i = 0; i < sizeof unit_table / sizeof *unit_table; i++) {
        const struct unit *u = &unit_table[i];
        if (flag == 3 ? strcmp(u->name, name) == 0 || strcmp(u->other, name) == 0 : u->flag == flag)
            return u;
    }
    return NULL;
}

static int take_unit(struct iges *iges, double flag, const char *name, struct error *error)
{
    size_t line = iges->global.item[0].line;
    const struct unit *unit = flag >= 1 && flag <= 11 ? unit_of((long)flag, name) : NULL;
    if (!unit)
        return error_at(error, iges->name, line,
                        "unit flag %g with unit '%.12s', expected one that IGES knows", flag, name);
    if (!(iges->scale > 0))
        return error_at(error, iges->name, line, "model space scale %g, expected a positive one",
                        iges->scale);
    iges->unit = unit->mm / iges->scale;
    snprintf(iges->unit_name, sizeof iges->unit_name, "%s", unit->name);
    snprintf(iges->unit_text, sizeof iges->unit_text, "%s", name);
    return 0;
}

static char peek_text(struct iges_cursor *c)
{
    while (iges_peek(c) == ' ')
        iges_take(c);
    return iges_peek(c);
}

/* One of the two delimiters, as 1Hx or as nothing, which means the default; then the one of
 * parameters, or, where the section ends there, the one of records, which is left standing. */
static int take_delimiter(struct iges_cursor *c, char *delimiter, struct error *error)
{
    char next = peek_text(c);
    if (next == ';' || next == c->comma) {
        if (next == c->comma)
            iges_take(c);
        return 0;
    }
    char one = iges_take(c), h = iges_take(c), ch = iges_take(c);
    if (one != '1' || h != 'H' || ch <= ' ' || strchr("+-.0123456789DEH", ch))
        return error_at(error, c->name, iges_line(c),
                        "a global section that begins '%c%c', expected 1H and a delimiter",
                        one > ' ' ? one : '?', h > ' ' ? h : '?');
    *delimiter = ch;
    next = peek_text(c);
    if (next == c->comma)
        iges_take(c);
    else if (next != c->semicolon)
        return error_at(error, c->name, iges_line(c),
                        "'%c' behind a delimiter in the global section, expected '%c'",
                        next > ' ' ? next : '?', c->comma);
    return 0;
}

/* The parameters behind the delimiters. */
static int read_rest(struct iges *iges, struct iges_cursor *c, double *flag, char *unit,
                     size_t size, struct error *error)
{
    struct iges_value value;
    char text[32];
    for (int number = 3, got = 1; got == 1; number++) {
        got = iges_next(c, &value, text, sizeof text, error);
        if (got < 0)
            return -1;
        if (number == SCALE && value.kind == IGES_NUMBER)
            iges->scale = value.number;
        if (number == UNIT_FLAG && value.kind == IGES_NUMBER)
            *flag = value.number;
        if (number == UNIT_NAME)
            snprintf(unit, size, "%s", text);
    }
    return 0;
}

int iges_global(struct iges *iges, struct error *error)
{
    if (iges->global.n == 0)
        return error_at(error, iges->name, 0, "no G section, expected one as in IGES");
    struct iges_cursor c = {.name = iges->name,
                            .record = iges->global.item,
                            .records = iges->global.n,
                            .width = WIDTH,
                            .comma = ',',
                            .semicolon = ';'};
    double flag = 1;
    char unit[32] = "";
    if (take_delimiter(&c, &c.comma, error) < 0 || take_delimiter(&c, &c.semicolon, error) < 0)
        return -1;
    iges->comma = c.comma;
    iges->semicolon = c.semicolon;
    iges->scale = 1;
    if (read_rest(iges, &c, &flag, unit, sizeof unit, error) < 0)
        return -1;
    return take_unit(iges, flag, unit, error);
}
