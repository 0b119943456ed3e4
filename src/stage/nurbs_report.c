/* nurbs_report - see nurbs_report.h. */
#include "stage/nurbs_report.h"

#include <stdlib.h>

#include "base/cli.h"
#include "base/out.h"
#include "math/elementary.h"
#include "nurbs/hollow_edge.h"
#include "nurbs/skin.h"

/* 1/mm: what is less curved is not hollow. */
static const double FLAT = 1e-9;

/* 15 digits, never -0. */
static void write_number(struct out *out, double x)
{
    out_printf(out, ",%.15g", x + 0.0);
}

static void write_vec(struct out *out, struct vec3 p)
{
    write_number(out, p.x);
    write_number(out, p.y);
    write_number(out, p.z);
}

static double place_on_range(const struct nurbs_axis *a, int i, int n)
{
    return i == n - 1 ? a->to : a->from + (a->to - a->from) * i / (n - 1);
}

void nurbs_report_grid(const char *file, const struct patches *patches, int n)
{
    struct out *out = out_open(file);
    out_text(out, "entity,u,v,x,y,z,nx,ny,nz\n");
    for (size_t k = 0; k < patches->n; k++) {
        const struct nurbs *s = &patches->item[k].surface;
        struct nurbs whole = *s; /* a range that ends on a knot: the span after it counts */
        whole.u.to = s->u.knot[s->u.poles];
        whole.v.to = s->v.knot[s->v.poles];
        for (int i = 0; i < n; i++)
            for (int j = 0; j < n; j++) {
                struct uv at = {place_on_range(&s->u, i, n), place_on_range(&s->v, j, n)};
                struct nurbs_place p = nurbs_place(&whole, at);
                out_printf(out, "%d", patches->item[k].entity);
                write_number(out, at.u);
                write_number(out, at.v);
                write_vec(out, p.point);
                write_vec(out, p.normal);
                out_text(out, "\n");
            }
    }
    out_close(out);
}

/* One surface: where it is most hollow, which is its hollow edge, if it has one. */
static void write_radius(struct out *out, const struct patch *p,
                         const struct concave_radius *concave, const struct hollow_edge *edge)
{
    double radius = edge->angle > 0 ? 0 : 1 / concave->curvature;
    struct uv at = edge->angle > 0 ? edge->uv[0] : concave->at;
    struct vec3 point = edge->angle > 0 ? edge->at : concave->point;

    out_printf(out, "%s:%d", p->file, p->entity);
    if (edge->angle > 0 || concave->curvature > FLAT)
        out_printf(out, ",%.6f,%.9g,%.9g,%.6f,%.6f,%.6f\n", radius, at.u + 0.0, at.v + 0.0,
                   point.x + 0.0, point.y + 0.0, point.z + 0.0);
    else
        out_text(out, ",none,,,,,\n");
}

static void write_edge(struct out *out, const struct patches *patches,
                       const struct hollow_edge *edge)
{
    const struct patch *a = &patches->item[edge->sheet[0]], *b = &patches->item[edge->sheet[1]];

    out_printf(out, "# hollow edge: %.3f degrees at %.6f %.6f %.6f (%s:%d", DEGREES(edge->angle),
               edge->at.x + 0.0, edge->at.y + 0.0, edge->at.z + 0.0, a->file, a->entity);
    if (a != b)
        out_printf(out, " and %s:%d", b->file, b->entity);
    out_text(out, "): no ball fits there\n");
}

void nurbs_report_radii(const char *file, const struct patches *patches,
                        const struct concave_radius *concave, const struct patch_mesh *mesh)
{
    struct hollow_edge sharpest, *within = hollow_edges_find(mesh, &sharpest);
    struct out *out = out_open(file);
    size_t tightest = 0;

    out_text(out, "surface,radius,u,v,x,y,z\n");
    for (size_t i = 0; i < patches->n; i++) {
        write_radius(out, &patches->item[i], &concave[i], &within[i]);
        if (concave[i].curvature > concave[tightest].curvature)
            tightest = i;
    }
    const char *but = sharpest.angle > 0 ? "none; but for hollow edges " : "";
    const struct patch *p = &patches->item[tightest];
    if (sharpest.angle > 0)
        write_edge(out, patches, &sharpest);
    if (concave[tightest].curvature > FLAT)
        out_printf(out, "# largest ball: %sradius %.6f (%s:%d)\n", but,
                   1 / concave[tightest].curvature, p->file, p->entity);
    else
        out_printf(out, "# largest ball: %sany, nothing is hollow\n", but);
    out_close(out);
    free(within);
}

const struct patch *nurbs_report_roughest(const struct patches *patches, double *rough)
{
    const struct patch *roughest = NULL;
    *rough = 0;
    for (size_t i = 0; i < patches->n; i++) {
        const struct patch *p = &patches->item[i];
        double most = p->rough;
        for (size_t k = 0; k < p->loop.n; k++)
            most = fmax(most, p->loop.item[k].rough);
        if (most > *rough) {
            *rough = most;
            roughest = p;
        }
    }
    return roughest;
}

/* Loops that are named one by one. */
enum { NAMED = 8 };

/* Where the skin is open; without -v one line for each of the longest loops. */
static void tell_loops(const struct patches *patches, const struct skin *skin)
{
    for (size_t i = 0; i < skin->loop.n && i < NAMED; i++) {
        const struct skin_loop *l = &skin->loop.item[i];
        const struct patch *p = &patches->item[l->sheet];
        if (isfinite(l->gap))
            say("open: %zu edges, %.4f mm long, gap up to %.4f mm at %.3f %.3f %.3f (surface %d)",
                l->edges, l->length, l->gap, l->at.x, l->at.y, l->at.z, p->entity);
        else
            say("open: %zu edges, %.4f mm long, at %.3f %.3f %.3f (surface %d)", l->edges,
                l->length, l->at.x, l->at.y, l->at.z, p->entity);
    }
    if (skin->loop.n > NAMED)
        say("open: %zu loops more, the longest %.4f mm", skin->loop.n - NAMED,
            skin->loop.item[NAMED].length);
}

void nurbs_report_skin(const struct patches *patches, const struct skin *skin)
{
    for (size_t i = 0; i < skin->body.n && i < NAMED; i++) {
        const struct skin_body *b = &skin->body.item[i];
        const char *about = b->volume < 0 ? " about a void" : "";
        const char *of = b->exact ? "" : " (of the facets)";
        if (skin_body_closed(b) && b->many > 0)
            note("body %zu: closed%s, touches itself along %zu edges, area %.10g mm2, "
                 "volume %.10g mm3%s, %zu facets",
                 i + 1, about, b->many, b->area, b->volume, of, b->facets);
        else if (skin_body_closed(b))
            note("body %zu: closed%s, genus %ld, area %.10g mm2, volume %.10g mm3%s, %zu facets",
                 i + 1, about, b->genus, b->area, b->volume, of, b->facets);
        else
            note("body %zu: open at %zu edges, area %.10g mm2%s, %zu facets", i + 1, b->open,
                 b->area, of, b->facets);
    }
    if (skin->body.n > NAMED)
        note("%zu bodies more", skin->body.n - NAMED);
    double area = 0, volume = 0;
    for (size_t i = 0; i < skin->body.n; i++) {
        area += skin->body.item[i].area;
        volume += skin_body_closed(&skin->body.item[i]) ? skin->body.item[i].volume : 0;
    }
    if (skin->body.n > 1)
        note("all %zu bodies: area %.10g mm2, volume %.10g mm3", skin->body.n, area, volume);
    tell_loops(patches, skin);
}
