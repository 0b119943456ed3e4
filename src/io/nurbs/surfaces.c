/* surfaces - see surfaces.h. */
#include "io/nurbs/surfaces.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/cli.h"
#include "iges.h"
#include "iges_surface.h"
#include "nurbs_text.h"
#include "step_model.h"

enum { LETTER = 72 }; /* column 73 of an IGES line says its section */

static int read_iges(struct reader *r, double mm, struct patches *patches,
                     struct surfaces_unit *unit, struct error *error)
{
    struct iges iges;
    if (iges_read(r, &iges, error) < 0)
        return -1;
    int status = iges_surfaces(&iges, mm, patches, error);
    unit->scale = iges.scale;
    snprintf(unit->flag, sizeof unit->flag, "%s", iges.unit_name);
    size_t n = strlen(iges.unit_text);
    if (n > 0 && strncmp(iges.unit_name, iges.unit_text, n) != 0)
        snprintf(unit->other, sizeof unit->other, "%s", iges.unit_text);
    for (size_t i = 0; i < iges.scan.n; i++) {
        *array_push(&patches->scan) = iges.scan.item[i];
        patches->scan.placed = iges.scan.placed;
        patches->scan.place = iges.scan.place;
    }
    array_free(&iges.scan);
    iges_free(&iges);
    return status;
}

/* Is a unit of length stated anywhere? */
static bool has_length_unit(const struct step *step)
{
    static const char word[] = "LENGTH_UNIT";
    const char *text = step->text.item;
    size_t length = sizeof word - 1;
    for (size_t i = 0; i + length <= step->text.n; i++)
        if (text[i] == 'L' && memcmp(text + i, word, length) == 0)
            return true;
    return false;
}

static int read_step(struct reader *r, double mm, struct patches *patches,
                     struct surfaces_unit *unit, struct error *error)
{
    struct step step;
    if (step_read(r, &step, error) < 0)
        return -1;
    int status = step_surfaces(&step, mm, patches, error);
    unit->missing = !has_length_unit(&step);
    step_free(&step);
    return status;
}

/* The first line that is not blank decides. */
static int read_any(struct reader *r, double mm, struct patches *patches,
                    struct surfaces_unit *unit, struct error *error)
{
    char none[] = "", *line = none;
    size_t n = 0;
    int got = 1;
    while (got > 0 && strspn(line, " \t") == n)
        got = reader_line(r, &line, &n, error);
    if (got < 0)
        return -1;
    if (got == 0)
        return error_at(error, r->name, 1, "an empty file, expected IGES, STEP or NURBS text");
    bool iges = n > LETTER && strchr("SCB", line[LETTER]) && line[LETTER] != '\0';
    const char *word = line + strspn(line, " \t");
    bool text = *word == '#' || (strncmp(word, "nurbs", 5) == 0 && strspn(word + 5, " \t") > 0);
    bool step = strncmp(word, "ISO-10303-21", 12) == 0 || strncmp(word, "/*", 2) == 0;
    reader_unread(r);
    if (step)
        return read_step(r, mm, patches, unit, error);
    if (iges)
        return read_iges(r, mm, patches, unit, error);
    if (text)
        return nurbs_text_read(r, mm, patches, error);
    return error_at(error, r->name, r->line + 1,
                    "neither IGES (a section letter in column 73) nor STEP (ISO-10303-21) nor "
                    "NURBS text (nurbs "
                    "1), expected one of them");
}

int surfaces_read(const char *file, double mm, struct patches *patches, struct surfaces_unit *unit,
                  struct error *error)
{
    struct reader r;
    *unit = (struct surfaces_unit){.scale = 1};
    if (reader_open(&r, file, error) < 0)
        return -1;
    int status = read_any(&r, mm, patches, unit, error);
    reader_close(&r);
    return status;
}

bool surfaces_tell(const struct patches *patches)
{
    bool whole = patches->left.n == 0;
    size_t unnamed = 0, first = 0;
    for (size_t i = 0; i < patches->n; i++) {
        const struct patch *p = &patches->item[i];
        whole = whole && p->ignored == 0;
        first = p->unnamed && unnamed++ == 0 ? i : first;
        if (p->ignored > 0)
            say("%s: surface %d: %d trimming curve%s ignored, the first at directory entry %d "
                "(entity type %d is not understood there)",
                p->file, p->entity, p->ignored, p->ignored == 1 ? "" : "s", p->ignored_entity,
                p->ignored_type);
    }
    if (unnamed > 0)
        say("%s: surface %d: flag 1 for an outer loop, and none is named: bounded by the border "
            "of the surface, as are %zu in all",
            patches->item[first].file, patches->item[first].entity, unnamed);
    for (size_t i = 0; i < patches->left.n; i++) {
        const struct patches_left *l = &patches->left.item[i];
        say("%s: %zu surface%s of %s left out, the first is entity %d", l->file, l->count,
            l->count == 1 ? "" : "s", l->kind, l->entity);
    }
    return whole;
}

void surfaces_tell_unit(const char *file, const struct surfaces_unit *unit, const char *taken)
{
    if (unit->flag[0] && !taken)
        note("%s: unit %s", file, unit->flag);
    if (unit->missing && !taken)
        say("%s: no unit of length is stated, taken for mm (-u)", file);
    if (unit->other[0])
        say("%s: the unit flag is %s, the name beside it %s: used %s", file, unit->flag,
            unit->other, taken ? taken : unit->flag);
    if ((unit->scale < 1 || unit->scale > 1) && !taken)
        say("%s: model scale %g worked in", file, unit->scale);
}
