/* trim_told - see trim_told.h. */
#include "trim_told.h"

#include "base/array.h"

/* Places that are asked, along each parameter; the part of them that must answer alike: the told
 * loops are rough, and so are their borders. */
enum { PLACES = 61 };
static const double MOST = 0.8;

/* The told loops as polygons through the poles of their curves, which are straight in between. */
static void told_polygons(const struct patch *patch, struct uv_polygon *told)
{
    for (size_t i = 0; i < patch->told.n; i++) {
        const struct patch_loop *from = &patch->told.item[i];
        struct uvs loop = {0};
        for (size_t k = 0; k < from->n; k++)
            for (size_t m = 0; m < from->item[k].t.poles; m++) {
                const struct nurbs_pole *p = &from->item[k].pole[m];
                *array_push(&loop) = (struct uv){p->wx / p->w, p->wy / p->w};
            }
        *array_push(told) = loop;
    }
}

bool trim_told_outside(const struct patch *patch, const struct uv_polygon *loops)
{
    const struct nurbs *s = &patch->surface;
    struct uv_polygon told = {0};
    struct uv_rows a, b;
    size_t other = 0;
    if (patch->open || patch->told.n != patch->loop.n || loops->n == 0)
        return false;
    told_polygons(patch, &told);
    uv_rows_make(&told, &a);
    uv_rows_make(loops, &b);
    for (int i = 0; i < PLACES; i++)
        for (int k = 0; k < PLACES; k++) {
            struct uv at = {s->u.from + (s->u.to - s->u.from) * (i + 0.5) / PLACES,
                            s->v.from + (s->v.to - s->v.from) * (k + 0.5) / PLACES};
            other += uv_rows_inside(&a, false, at) != uv_rows_inside(&b, false, at);
        }
    uv_rows_free(&a);
    uv_rows_free(&b);
    uv_polygon_free(&told);
    return (double)other > MOST * PLACES * PLACES;
}
