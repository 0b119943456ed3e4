/*
 * iges_write - surfaces as an IGES 5.3 file; see surfaces_write.h.  The parameters of all entities
 * are gathered first, then the sections written: start, global, directory, parameters, terminate.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "math/elementary.h"
#include "base/array.h"
#include "base/num.h"
#include "io/nurbs/surfaces_write.h"

enum { WIDE = 72, FIELD = 64 }; /* columns of a line; of a parameter line */

struct entity {
    int type;
    size_t from, lines; /* of its parameters, from 0 */
    const char *status;
};

/* Its parameters so far, as lines of up to FIELD characters. */
struct file {
    struct {
        size_t n, cap;
        struct entity *item;
    } entity;
    struct {
        size_t n, cap;
        char (*item)[FIELD + 1];
    } line;
};

/* Where entity k stands in the directory: what points to it. */
static long pointer_to(size_t k)
{
    return 2 * (long)k + 1;
}

static void add_word(struct file *f, const char *word)
{
    char *last = f->line.item[f->line.n - 1];

    if (strlen(last) + strlen(word) > FIELD) {
        (*array_push(&f->line))[0] = '\0';
        f->entity.item[f->entity.n - 1].lines++;
        last = f->line.item[f->line.n - 1];
    }
    memcpy(last + strlen(last), word, strlen(word) + 1);
}

static void add_int(struct file *f, long i)
{
    char word[32];

    snprintf(word, sizeof word, ",%ld", i);
    add_word(f, word);
}

static void add_real(struct file *f, double x)
{
    char word[64] = ",";
    size_t n = num_write(word + 1, x, 9);

    word[1 + n] = '\0';
    if (!strchr(word, '.'))
        memcpy(word + 1 + n, ".", 2);
    add_word(f, word);
}

/* A new entity; its parameters are added one by one, then end_entity. */
static void begin_entity(struct file *f, int type, const char *status)
{
    *array_push(&f->entity) = (struct entity){type, f->line.n, 1, status};
    (*array_push(&f->line))[0] = '\0';
    snprintf(f->line.item[f->line.n - 1], FIELD, "%d", type);
}

static size_t end_entity(struct file *f)
{
    add_word(f, ";");
    return f->entity.n - 1;
}

static void add_ints(struct file *f, const long *value, size_t n)
{
    for (size_t i = 0; i < n; i++)
        add_int(f, value[i]);
}

static void add_knots(struct file *f, const struct nurbs_axis *axis)
{
    for (size_t k = 0; k < axis->poles + (size_t)axis->degree + 1; k++)
        add_real(f, axis->knot[k]);
}

static size_t add_surface(struct file *f, const struct nurbs *s, bool trimmed)
{
    size_t n = s->u.poles * s->v.poles;
    bool rational = false;

    for (size_t k = 0; k < n; k++)
        rational = rational || s->pole[k].w < 1 || s->pole[k].w > 1;
    begin_entity(f, 128, trimmed ? "00010000" : "00000000");
    add_ints(f,
             (long[]){(long)s->u.poles - 1, (long)s->v.poles - 1, s->u.degree, s->v.degree, 0, 0,
                      !rational, 0, 0},
             9);
    add_knots(f, &s->u);
    add_knots(f, &s->v);
    for (size_t k = 0; k < n; k++)
        add_real(f, s->pole[k].w);
    for (size_t k = 0; k < n; k++) {
        add_real(f, s->pole[k].wx / s->pole[k].w);
        add_real(f, s->pole[k].wy / s->pole[k].w);
        add_real(f, s->pole[k].wz / s->pole[k].w);
    }
    add_real(f, s->u.from);
    add_real(f, s->u.to);
    add_real(f, s->v.from);
    add_real(f, s->v.to);
    return end_entity(f);
}

static struct uv corner(const struct patch_loop *loop, size_t k)
{
    struct nurbs_pole p = loop->item[k < loop->n ? k : 0].pole[0];

    return (struct uv){p.wx / p.w, p.wy / p.w};
}

/* A closed polygon as a curve of the first degree, on the surface. */
static size_t add_loop(struct file *f, const struct patch_loop *loop, size_t surface)
{
    long n = (long)loop->n;

    begin_entity(f, 126, "00010500");
    add_ints(f, (long[]){n, 1, 1, 1, 1, 0}, 6);
    for (long k = -1; k <= n + 1; k++)
        add_real(f, (double)(k < 0 ? 0 : k > n ? n : k));
    for (long k = 0; k <= n; k++)
        add_real(f, 1);
    for (long k = 0; k <= n; k++) {
        struct uv at = corner(loop, (size_t)k);
        add_real(f, at.u);
        add_real(f, at.v);
        add_real(f, 0);
    }
    add_real(f, 0);
    add_real(f, (double)n);
    add_real(f, 0);
    add_real(f, 0);
    add_real(f, 1);
    size_t curve = end_entity(f);
    begin_entity(f, 142, "00010000");
    add_ints(f, (long[]){0, pointer_to(surface), pointer_to(curve), 0, 1}, 5);
    return end_entity(f);
}

/* Twice the area inside, positive for a loop that runs counter-clockwise. */
static double area2(const struct patch_loop *loop)
{
    double sum = 0;

    for (size_t k = 0; k < loop->n; k++) {
        struct uv a = corner(loop, k), b = corner(loop, k + 1);
        sum += a.u * b.v - a.v * b.u;
    }
    return sum;
}

static bool is_inside(const struct patch_loop *loop, struct uv p)
{
    bool inside = false;

    for (size_t k = 0; k < loop->n; k++) {
        struct uv a = corner(loop, k), b = corner(loop, k + 1);
        if ((a.v > p.v) != (b.v > p.v) && p.u < a.u + (b.u - a.u) * (p.v - a.v) / (b.v - a.v))
            inside = !inside;
    }
    return inside;
}

/* The smallest loop that runs counter-clockwise about loop k. */
static size_t outer_of(const struct patch *patch, size_t k)
{
    size_t outer = k;
    double least = HUGE_VAL;

    for (size_t i = 0; i < patch->loop.n; i++) {
        double area = area2(&patch->loop.item[i]);
        if (i != k && area > 0 && area < least &&
            is_inside(&patch->loop.item[i], corner(&patch->loop.item[k], 0))) {
            least = area;
            outer = i;
        }
    }
    return outer;
}

static void add_trimmed(struct file *f, const struct patch *patch, size_t outer,
                        const size_t *outer_of_loop)
{
    size_t surface = add_surface(f, &patch->surface, true);
    struct sizes inner = {0};
    size_t border = add_loop(f, &patch->loop.item[outer], surface);

    for (size_t k = 0; k < patch->loop.n; k++)
        if (k != outer && outer_of_loop[k] == outer && area2(&patch->loop.item[k]) <= 0)
            *array_push(&inner) = add_loop(f, &patch->loop.item[k], surface);
    begin_entity(f, 144, "00000000");
    add_ints(f, (long[]){pointer_to(surface), 1, (long)inner.n, pointer_to(border)}, 4);
    for (size_t k = 0; k < inner.n; k++)
        add_int(f, pointer_to(inner.item[k]));
    end_entity(f);
    array_free(&inner);
}

static void add_patch(struct file *f, const struct patch *patch)
{
    size_t *outer = mem_alloc(patch->loop.n + 1, sizeof *outer);

    if (patch->loop.n == 0)
        add_surface(f, &patch->surface, false);
    for (size_t k = 0; k < patch->loop.n; k++)
        outer[k] = outer_of(patch, k);
    for (size_t k = 0; k < patch->loop.n; k++)
        if (area2(&patch->loop.item[k]) > 0)
            add_trimmed(f, patch, k, outer);
    free(outer);
}

static size_t write_start(struct out *out, const char *remark)
{
    size_t lines = 0;

    while (*remark) {
        int n = (int)strcspn(remark, "\n");
        for (; n > WIDE; n -= WIDE - 1, remark += WIDE - 1)
            out_printf(out, "%.*s\\S%7zu\n", WIDE - 1, remark, ++lines);
        out_printf(out, "%-*.*sS%7zu\n", WIDE, n, remark, ++lines);
        remark += n + (remark[n] == '\n');
    }
    return lines;
}

static size_t write_global(struct out *out)
{
    static const char *const line[] = {
        "1H,,1H;,9Hcloudmill,9Hcloudmill,9Hcloudmill,9Hcloudmill,32,38,6,308,15,",
        "9Hcloudmill,1.,2,2HMM,1,0.01,15H19700101.000000,1.E-9,0.,,,11,0;"};

    for (size_t i = 0; i < 2; i++)
        out_printf(out, "%-*sG%7zu\n", WIDE, line[i], i + 1);
    return 2;
}

void surfaces_write_iges(struct out *out, const struct patches *patches, const char *remark)
{
    struct file f = {.entity = {0}};

    for (size_t i = 0; i < patches->n; i++)
        add_patch(&f, &patches->item[i]);
    size_t start = write_start(out, remark), global = write_global(out);
    for (size_t i = 0; i < f.entity.n; i++) {
        const struct entity *e = &f.entity.item[i];
        long at = pointer_to(i);
        out_printf(out, "%8d%8zu%8d%8d%8d%8d%8d%8d%8sD%7ld\n", e->type, e->from + 1, 0, 0, 0, 0, 0,
                   0, e->status, at);
        out_printf(out, "%8d%8d%8d%8zu%8d%8s%8s%8s%8dD%7ld\n", e->type, 0, 0, e->lines, 0, "", "",
                   "", 0, at + 1);
    }
    for (size_t i = 0; i < f.entity.n; i++)
        for (size_t k = f.entity.item[i].from; k < f.entity.item[i].from + f.entity.item[i].lines;
             k++)
            out_printf(out, "%-*s%8ldP%7zu\n", FIELD, f.line.item[k], pointer_to(i), k + 1);
    out_printf(out, "S%7zuG%7zuD%7zuP%7zu%40sT%7d\n", start, global, 2 * f.entity.n, f.line.n, "",
               1);
    array_free(&f.entity);
    array_free(&f.line);
}
