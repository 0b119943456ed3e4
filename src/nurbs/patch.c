/* patch - see patch.h. */
#include "nurbs/patch.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "math/box.h"

struct nurbs_curve patch_curve(int degree, size_t poles)
{
    struct nurbs_curve c = {.t = {.degree = degree, .poles = poles, .from = 0, .to = 1}};
    c.t.knot = mem_alloc(poles + (size_t)degree + 1, sizeof *c.t.knot);
    for (size_t i = poles; i < poles + (size_t)degree + 1; i++)
        c.t.knot[i] = 1;
    c.pole = mem_alloc(poles, sizeof *c.pole);
    return c;
}

struct nurbs_curve patch_line(struct uv from, struct uv to)
{
    struct nurbs_curve c = patch_curve(1, 2);
    c.pole[0] = (struct nurbs_pole){from.u, from.v, 0, 1};
    c.pole[1] = (struct nurbs_pole){to.u, to.v, 0, 1};
    return c;
}

void patch_loop_free(struct patch_loop *loop)
{
    for (size_t i = 0; i < loop->n; i++)
        nurbs_curve_free(&loop->item[i]);
    array_free(loop);
}

void patch_loop_turn(struct patch_loop *loop, size_t first)
{
    for (size_t i = first; i < loop->n; i++)
        nurbs_curve_reverse(&loop->item[i]);
    for (size_t i = first, k = loop->n; i + 1 < k; i++) {
        struct nurbs_curve last = loop->item[--k];
        loop->item[k] = loop->item[i];
        loop->item[i] = last;
    }
}

void patch_free(struct patch *patch)
{
    for (size_t i = 0; i < patch->loop.n; i++)
        patch_loop_free(&patch->loop.item[i]);
    array_free(&patch->loop);
    for (size_t i = 0; i < patch->told.n; i++)
        patch_loop_free(&patch->told.item[i]);
    array_free(&patch->told);
    nurbs_free(&patch->surface);
    free(patch->file);
    *patch = (struct patch){0};
}

bool patch_may_join(const struct patch *a, const struct patch *b)
{
    return a->body == b->body && a->group == b->group;
}

void patches_leave_out(struct patches *patches, const char *file, const char *kind, int entity)
{
    for (size_t i = 0; i < patches->left.n; i++) {
        struct patches_left *l = &patches->left.item[i];
        if (strcmp(l->kind, kind) == 0 && strcmp(l->file, file) == 0) {
            l->count++;
            return;
        }
    }
    struct patches_left *l = array_push(&patches->left);
    *l = (struct patches_left){.entity = entity, .count = 1};
    strncpy(l->kind, kind, sizeof l->kind - 1);
    l->file = mem_string(file, strlen(file));
}

void patches_free(struct patches *patches)
{
    for (size_t i = 0; i < patches->left.n; i++)
        free(patches->left.item[i].file);
    array_free(&patches->left);
    scan_sources_free(&patches->scan);
    for (size_t i = 0; i < patches->n; i++)
        patch_free(&patches->item[i]);
    array_free(patches);
}

double patches_size(const struct patches *patches)
{
    struct box box = box_empty();
    for (size_t i = 0; i < patches->n; i++) {
        const struct nurbs *s = &patches->item[i].surface;
        for (size_t k = 0; k < s->u.poles * s->v.poles; k++) {
            struct nurbs_pole p = s->pole[k];
            box_add(&box, vec_scale(1 / p.w, vec(p.wx, p.wy, p.wz)));
        }
    }
    return box_diagonal(&box);
}
