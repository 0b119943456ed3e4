/* nurbs_text_write - surfaces as plain text, cloudmill-nurbs(5); see surfaces_write.h. */
#include <string.h>

#include "io/nurbs/surfaces_write.h"

enum { A_LINE = 6 };

/* Nine decimals: the ninth is a millionth of a micrometre. */
static void write_number(struct out *out, double x, size_t k)
{
    enum { DIGITS = 9 };

    out_text(out, k % A_LINE == 0 ? "\n  " : " ");
    out_num(out, x, DIGITS);
}

static void write_knots(struct out *out, const char *name, const struct nurbs_axis *axis)
{
    out_text(out, name);
    for (size_t k = 0; k < axis->poles + (size_t)axis->degree + 1; k++)
        write_number(out, axis->knot[k], k);
    out_text(out, "\n");
}

static void write_poles(struct out *out, const struct nurbs *s)
{
    size_t n = s->u.poles * s->v.poles;
    bool rational = false;

    out_text(out, "points");
    for (size_t k = 0; k < n; k++) {
        struct nurbs_pole p = s->pole[k];
        write_number(out, p.wx / p.w, 3 * k);
        write_number(out, p.wy / p.w, 3 * k + 1);
        write_number(out, p.wz / p.w, 3 * k + 2);
        rational = rational || p.w < 1 || p.w > 1;
    }
    out_text(out, "\n");
    if (!rational)
        return;
    out_text(out, "weights");
    for (size_t k = 0; k < n; k++)
        write_number(out, s->pole[k].w, k);
    out_text(out, "\n");
}

static void write_surface(struct out *out, const struct patch *patch)
{
    const struct nurbs *s = &patch->surface;

    out_printf(out, "surface\ndegree %d %d\npoles %zu %zu\n", s->u.degree, s->v.degree, s->u.poles,
               s->v.poles);
    write_knots(out, "knots_u", &s->u);
    write_knots(out, "knots_v", &s->v);
    write_poles(out, s);
    for (size_t i = 0; i < patch->loop.n; i++) {
        out_text(out, "loop");
        for (size_t k = 0; k < patch->loop.item[i].n; k++) {
            struct nurbs_pole p = patch->loop.item[i].item[k].pole[0];
            write_number(out, p.wx / p.w, 2 * k);
            write_number(out, p.wy / p.w, 2 * k + 1);
        }
        out_text(out, "\n");
    }
}

void surfaces_write_text(struct out *out, const struct patches *patches, const char *remark)
{
    out_text(out, "nurbs 1\nunit mm\n");
    while (*remark) {
        size_t n = strcspn(remark, "\n");
        out_text(out, "# ");
        out_bytes(out, remark, n);
        out_text(out, "\n");
        remark += n + (remark[n] == '\n');
    }
    for (size_t i = 0; i < patches->n; i++)
        write_surface(out, &patches->item[i]);
    out_text(out, "end\n");
}
