/* ncoutput - see ncoutput.h. */
#include "post/ncoutput.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ncexplain.h"

static void begin(const struct dialect *dialect, struct nc_program *p, struct out *out)
{
    nc_writer_begin(&p->w, out, dialect->style, p->machine->number_step, p->machine->number_max);
}

static void write_program(const struct dialect *dialect, struct nc_program *p, const char *file)
{
    struct out *out = out_open(file);
    begin(dialect, p, out);
    dialect_write(dialect, p);
    out_close(out);
}

/* part.nc: part-2.nc */
static char *mesh_for_rows_name(const char *file, size_t part)
{
    size_t size = strlen(file) + 24;
    const char *slash = strrchr(file, '/'), *dot = strrchr(slash ? slash : file, '.');
    int n = dot ? (int)(dot - file) : (int)strlen(file);
    char *name = mem_alloc(size, 1);
    snprintf(name, size, "%.*s-%zu%s", n, file, part, dot ? dot : "");
    return name;
}

/* Makes the i-th part and, with a file, writes it. */
static int one_part(const struct dialect *dialect, const struct nc_program *whole,
                    const struct sizes *ends, size_t i, const char *file, struct error *error)
{
    struct nc_plan part;
    struct nc_program p = *whole;
    int result = nc_part_make(&part, whole, i ? ends->item[i - 1] : 0, ends->item[i], error);
    p.plan = &part;
    p.part = i + 1;
    p.parts = ends->n;
    if (result == 0 && file) {
        char *name = mesh_for_rows_name(file, i + 1);
        write_program(dialect, &p, name);
        free(name);
    }
    nc_part_free(&part);
    return result;
}

static int write_parts(const struct dialect *dialect, struct nc_program *whole,
                       struct nc_limit limit, const char *file, size_t *files, struct error *error)
{
    struct sizes ends = {0};
    begin(dialect, whole, NULL);
    int result = nc_part_ends(&ends, dialect, whole, limit, error);
    *files = ends.n;
    for (size_t i = 0; i < ends.n && result == 0; i++) /* all before the first is written */
        result = one_part(dialect, whole, &ends, i, NULL, error);
    for (size_t i = 0; i < ends.n && result == 0; i++)
        result = one_part(dialect, whole, &ends, i, file, error);
    array_free(&ends);
    return result;
}

static int explain(const struct dialect *dialect, struct nc_program *p, long number,
                   const char *file, struct error *error)
{
    begin(dialect, p, NULL);
    return nc_explain(file, dialect, p, number, error);
}

int nc_output(const struct dialect *dialect, struct nc_program *p, struct nc_extract extract,
              const char *file, size_t *files, struct error *error)
{
    const struct nc_plan *whole = p->plan;
    struct nc_plan later = {0};
    int result = 0;
    *files = 1;
    if (extract.from >= 0) {
        size_t first = nc_part_pass(whole, (size_t)extract.from);
        if (first == whole->move.n)
            return error_set(error, "option --from: found no pass %d in %s", extract.from,
                             p->path->name);
        result = nc_part_make(&later, p, first, whole->move.n, error);
        p->plan = &later;
    }
    if (result == 0 && extract.explain >= 0)
        result = explain(dialect, p, extract.explain, file, error);
    else if (result == 0 && (extract.limit.blocks || extract.limit.bytes))
        result = write_parts(dialect, p, extract.limit, file, files, error);
    else if (result == 0)
        write_program(dialect, p, file);
    p->plan = whole;
    nc_part_free(&later);
    return result;
}
