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

/* A delimiter as the global section declares it: 1Hx, or nothing, which means the default. */
static int take_delimiter(struct iges_cursor *c, char *delimiter, struct error *error)
{
    while (iges_peek(c) == ' ')
        iges_take(c);
    if (iges_peek(c) == *delimiter || iges_peek(c) == c->comma) {
        iges_take(c);
        return 0;
    }
    char one = iges_take(c), h = iges_take(c), ch = iges_take(c);
    bool sound = one == '1' && h == 'H' && ch > ' ' && !strchr("+-.0123456789DEH", ch);
    if (!sound)
        return error_at(error, c->name, iges_line(c),
                        "a global section that begins '%c%c', expected 1H and a delimiter",
                        one > ' ' ? one : '?', h > ' ' ? h : '?');
    *delimiter = ch;
    return 0;
}

/* Behind a declared delimiter stands the one of parameters, or the one of records. */
static int pass_comma(struct iges_cursor *c, bool declared, struct error *error)
{
    while (declared && iges_peek(c) == ' ')
        iges_take(c);
    if (declared && iges_take(c) != c->comma)
        return error_at(error, c->name, iges_line(c),
                        "no '%c' behind a delimiter in the global section, expected it", c->comma);
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
    struct iges_value value;
    double flag = 1;
    char text[32], unit[32] = "";
    bool declared = iges_peek(&c) != ',';
    if (take_delimiter(&c, &c.comma, error) < 0 || pass_comma(&c, declared, error) < 0)
        return -1;
    declared = iges_peek(&c) != c.comma;
    if (take_delimiter(&c, &c.semicolon, error) < 0 || pass_comma(&c, declared, error) < 0)
        return -1;
    iges->comma = c.comma;
    iges->semicolon = c.semicolon;
    iges->scale = 1;
    for (int number = 3, got = 1; got == 1; number++) {
        got = iges_next(&c, &value, text, sizeof text, error);
        if (got < 0)
            return -1;
        if (number == SCALE && value.kind == IGES_NUMBER)
            iges->scale = value.number;
        if (number == UNIT_FLAG && value.kind == IGES_NUMBER)
            flag = value.number;
        if (number == UNIT_NAME)
            snprintf(unit, sizeof unit, "%s", text);
    }
    return take_unit(iges, flag, unit, error);
}
