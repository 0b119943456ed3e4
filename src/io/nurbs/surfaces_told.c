/* surfaces_told - see surfaces_told.h. */
#include "io/nurbs/surfaces_told.h"

#include "base/cli.h"
#include "math/elementary.h"

/* Why a surface is refused; false: it is not. */
static bool refuse(const struct patch *p, const struct sheet *sheet, double limit,
                   struct error *error)
{
    if (sheet->off > limit)
        error_set(error,
                  "%s: surface %d: its trimming curves in space lie up to %g mm off it, expected "
                  "%g mm at most",
                  p->file, p->entity, sheet->off, limit);
    else if (sheet->unclear > 0)
        error_set(error,
                  "%s: surface %d: its trimming crosses itself, in %zu places, expected loops that "
                  "do not",
                  p->file, p->entity, sheet->unclear);
    return sheet->off > limit || sheet->unclear > 0;
}

size_t surfaces_tell_refused(const struct patches *patches, struct sheet *sheet, double limit,
                            struct error *error)
{
    size_t refused = 0;
    for (size_t i = 0; i < patches->n; i++) {
        struct error why;
        if (!refuse(&patches->item[i], &sheet[i], limit, &why))
            continue;
        if (error && refused++ == 0)
            *error = why;
        if (error)
            continue;
        say("%s: left out", why.text);
        sheet_free(&sheet[i]);
        sheet[i].refused = true;
        refused++;
    }
    return refused;
}

void surfaces_tell_trimming(const struct patches *patches, const struct sheet *sheet, double fine)
{
    for (size_t i = 0; i < patches->n; i++) {
        const struct patch *p = &patches->item[i];
        if (sheet[i].lost > 0)
            say("%s: surface %d: %zu trimming loops that go around it more than once ignored",
                p->file, p->entity, sheet[i].lost);
        if (sheet[i].side != PATCH_SIDE_TOLD && sheet[i].lost == 0)
            say("%s: surface %d: the file does not tell which side of its only trimming loop it is "
                "on: taken to be %s",
                p->file, p->entity,
                sheet[i].side == PATCH_SIDE_LEFT ? "on the left of the loop" : "within the loop");
        if (sheet[i].off > fine)
            note("%s: surface %d: its trimming curves in space lie up to %g mm off it and were put "
                 "onto it",
                 p->file, p->entity, sheet[i].off);
        if (sheet[i].face.n == 0 && !sheet[i].refused)
            say("%s: surface %d: nothing is left of it by its trimming", p->file, p->entity);
    }
}

size_t surfaces_tell_gaps(const struct patches *patches, const struct sheet *sheet, double limit)
{
    size_t found = 0;
    for (size_t i = 0; i < patches->n; i++) {
        const struct patch *p = &patches->item[i];
        struct vec3 at = sheet[i].gap_at;
        if (sheet[i].refused || !(sheet[i].gap > limit))
            continue;
        found++;
        say("%s: surface %d: the curves of a trimming loop are %g mm apart at %.3f %.3f %.3f, "
            "expected %g mm at most: a straight line is taken between them",
            p->file, p->entity, sheet[i].gap, at.x + 0.0, at.y + 0.0, at.z + 0.0, limit);
    }
    return found;
}
