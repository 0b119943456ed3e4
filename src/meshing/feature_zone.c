/* feature_zone - see feature_zone.h. */
#include "meshing/feature_zone.h"

#include <stdlib.h>

#include "math/box.h"
#include "math/elementary.h"

static const double CLEAR = 0.3, NEAR = 1.5; /* distances, of `fine` */

/* The squares are as wide as `near` reaches, and no more than MOST in a row. */
static struct zone_cells cells_of(const struct vec3s *place, double fine)
{
    enum { MOST = 1000 };
    const double spare = 1.001; /* for rounding */
    struct box box = box_around(place->item, place->n);
    double width = box.high.x - box.low.x, height = box.high.y - box.low.y;
    double side = fmax(spare * NEAR * fine, fmax(width, height) / MOST);
    struct zone_cells c = {box.low.x - side,
                           box.low.y - side,
                           side,
                           (size_t)(width / side) + 3,
                           (size_t)(height / side) + 3,
                           NULL};
    c.beside = mem_alloc(c.columns * c.rows, 1);
    for (size_t i = 0; i < place->n; i++) {
        size_t column = (size_t)((place->item[i].x - c.x) / side);
        size_t row = (size_t)((place->item[i].y - c.y) / side);
        for (size_t r = row - 1; r <= row + 1; r++)
            for (size_t k = column - 1; k <= column + 1; k++)
                c.beside[r * c.columns + k] = 1;
    }
    return c;
}

/* Most places are near to none. */
static bool may_be_near(const struct zone_cells *c, double x, double y)
{
    double column = (x - c->x) / c->side, row = (y - c->y) / c->side;

    return column >= 0 && row >= 0 && column < (double)c->columns && row < (double)c->rows &&
           c->beside[(size_t)row * c->columns + (size_t)column];
}

struct feature_zone feature_zone_make(const struct vec3 *place, size_t n, double fine)
{
    struct feature_zone zone = {.fine = fine};

    for (size_t i = 0; i < n; i++)
        *array_push(&zone.place) = vec(place[i].x, place[i].y, 0);
    zone.tree = kdtree_new(zone.place.item, n);
    if (n > 0)
        zone.cells = cells_of(&zone.place, fine);
    return zone;
}

void feature_zone_free(struct feature_zone *zone)
{
    kdtree_free(zone->tree);
    free(zone->cells.beside);
    array_free(&zone->place);
}

static bool is_within(const struct feature_zone *zone, double x, double y, double reach)
{
    size_t nearest;
    double distance2;

    return may_be_near(&zone->cells, x, y) &&
           kdtree_nearest(zone->tree, vec(x, y, 0), 1, &nearest, &distance2) == 1 &&
           distance2 < reach * reach;
}

bool feature_zone_clear(const struct feature_zone *zone, double x, double y)
{
    return is_within(zone, x, y, CLEAR * zone->fine);
}

bool feature_zone_near(const struct feature_zone *zone, double x, double y)
{
    return is_within(zone, x, y, NEAR * zone->fine);
}
