/* ncread_iso - see ncread_iso.h. */
#include "ncread_iso.h"

#include "ncread/ncread.h"
#include "ncread_unit.h"

/* Tenths of those that do not change where the tool goes: cutter compensation off, work frames,
 * path control, cycles off. */
static const int no_effect[] = {400, 540, 550, 560, 570, 580, 590, 640, 800};

int ncread_iso_g(struct ncread *c, int tenths, struct error *error)
{
    switch (tenths) {
    case 0:
    case 10:
    case 20:
    case 30:
        c->move = tenths / 10;
        return 1;
    case 170:
    case 180:
    case 190:
        c->plane = tenths / 10;
        return 1;
    case 200:
    case 210:
        return ncread_unit(c, tenths == 200 ? INCH : 1, error) < 0 ? -1 : 1;
    case 900:
    case 910:
        c->absolute = tenths == 900;
        return 1;
    case 930:
    case 940:
        c->inverse_time = tenths == 930;
        return 1;
    default:
        for (size_t i = 0; i < sizeof no_effect / sizeof *no_effect; i++)
            if (tenths == no_effect[i])
                return 1;
        return 0;
    }
}
