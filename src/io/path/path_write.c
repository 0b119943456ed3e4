/* path_write - a path as APT CL text; see path.h and cloudmill-path(5). */
#include <math.h>
#include <string.h>

#include "base/num.h"
#include "io/path/path.h"
#include "path_cycle.h"

enum { COORDINATE = 6, VECTOR = 9, LINE_MAX = 72 };

static void put_vec(struct out *out, struct vec3 v, int digits)
{
    out_num(out, v.x, digits);
    out_text(out, ",");
    out_num(out, v.y, digits);
    out_text(out, ",");
    out_num(out, v.z, digits);
}

static void put_goto(struct out *out, struct pose pose)
{
    out_text(out, "GOTO/");
    put_vec(out, pose.p, COORDINATE);
    out_text(out, ",");
    put_vec(out, pose.a, VECTOR);
    out_text(out, "\n");
}

static void put_cutter(struct out *out, const double *cutter, int n)
{
    for (int i = 0; i < n; i++) {
        out_text(out, i ? "," : "CUTTER/");
        out_num(out, cutter[i], COORDINATE);
    }
    out_text(out, n ? "\n" : "");
}

static void put_load(struct out *out, int number, int offset)
{
    out_printf(out, "LOADTL/%d", number);
    if (offset)
        out_printf(out, ",OSETNO,%d", offset);
    out_text(out, "\n");
}

void path_write_head(struct out *out, const struct path_head *head)
{
    static const char *const coolant[] = {NULL, "OFF", "ON", "MIST"};
    static const char *const track[] = {NULL, "CENTER", "CONTACT"};
    if (head->partno)
        out_printf(out, "PARTNO/%s\n", head->partno);
    out_text(out, "UNITS/MM\n");
    if (head->multax)
        out_text(out, "MULTAX/ON\n");
    put_cutter(out, head->cutter, head->cutter_n);
    if (head->tool)
        put_load(out, head->tool, head->offset);
    if (head->spindle > 0) {
        out_text(out, "SPINDL/RPM,");
        out_num(out, head->spindle, COORDINATE);
        out_text(out, head->spindle_ccw ? ",CCLW\n" : ",CLW\n");
    }
    if (head->coolant)
        out_printf(out, "COOLNT/%s\n", coolant[head->coolant]);
    out_text(out, "$$-> CLOUDMILL/1\n");
    if (head->track != TRACK_TIP)
        out_printf(out, "$$-> TRACK/%s\n", track[head->track]);
    for (size_t i = 0; i < head->ledger.n; i++)
        out_printf(out, "$$-> LEDGER/%s,%.6f\n", head->ledger.item[i].stage,
                   head->ledger.item[i].spent);
    if (!isnan(head->chord))
        out_printf(out, "$$-> CHORD/%.6f\n", head->chord);
    if (!isnan(head->clearance))
        out_printf(out, "$$-> CLEAR/%.6f\n", head->clearance);
}

/* Numbers of one long statement, broken over lines that end in ` $`. */
struct list {
    struct out *out;
    int column;
};

static void put_in_list(struct list *list, double x)
{
    char number[NUM_MAX];
    int n = (int)num_write(number, x, COORDINATE);
    if (list->column + n + 3 > LINE_MAX) {
        out_text(list->out, ", $\n");
        list->column = 0;
    } else {
        out_text(list->out, ",");
    }
    out_text(list->out, number);
    list->column += n + 1;
}

static struct list begin_list(struct out *out, const char *start)
{
    out_text(out, start);
    return (struct list){out, (int)strlen(start)};
}

static void put_poles(struct out *out, const char *start, const struct vec3 *pole, size_t n)
{
    struct list list = begin_list(out, start);
    for (size_t i = 0; i < n; i++) {
        put_in_list(&list, pole[i].x);
        put_in_list(&list, pole[i].y);
        put_in_list(&list, pole[i].z);
    }
    out_text(out, "\n");
}

static void put_spline(struct out *out, const struct path_spline *spline)
{
    const struct bspline *c = &spline->curve;
    size_t knots = c->poles + (size_t)c->degree + 1;
    if (c->head) {
        out_text(out, "MOVNRB/5AXIS,LENGTH,");
        out_num(out, c->length, COORDINATE);
        out_text(out, "\n");
    } else {
        out_text(out, "MOVNRB/M3AXIS\n");
    }
    out_printf(out, "MOVNRB/ON,%d,%zu,0,%zu,", c->degree + 1, knots, c->poles);
    out_num(out, c->knot[knots - 1] - c->knot[0], COORDINATE);
    out_text(out, "\n");

    struct list list = begin_list(out, "MOVNRB/1");
    for (size_t i = 0; i < knots; i++)
        put_in_list(&list, c->knot[i]);
    out_text(out, "\n");
    put_poles(out, "MOVNRB/2", c->pole, c->poles);
    if (c->head)
        put_poles(out, "MOVNRB/3", c->head, c->poles);
    out_text(out, "MOVNRB/NEXT\n");
    for (size_t i = 0; i < spline->fallback.n; i++)
        put_goto(out, spline->fallback.item[i]);
    out_text(out, "MOVNRB/OFF\n");
}

static void put_arc(struct out *out, const struct path_arc *arc)
{
    out_text(out, "CIRCLE/");
    put_vec(out, arc->centre, COORDINATE);
    out_text(out, ",");
    put_vec(out, arc->axis, VECTOR);
    out_text(out, ",");
    out_num(out, arc->radius, COORDINATE);
    out_text(out, "\n");
}

static void put_contact(struct out *out, struct contact contact)
{
    out_text(out, "$$-> CONTCT/");
    put_vec(out, contact.p, COORDINATE);
    out_text(out, ",");
    put_vec(out, contact.n, VECTOR);
    out_text(out, "\n");
}

static void put_tool(struct out *out, const struct path_tool *tool)
{
    put_cutter(out, tool->cutter, tool->cutter_n);
    put_load(out, tool->number, tool->offset);
}

static bool is_motion(const struct path_item *item)
{
    return item->kind == PATH_POINT || item->kind == PATH_ARC || item->kind == PATH_SPLINE;
}

/* CYCLE before the first hole of each, CYCLE/OFF behind the last: *on is the one in force. */
static void put_cycle(struct out *out, const struct path *path, const struct path_item *item,
                      const struct path_cycle **on)
{
    const struct path_cycle *cycle =
        item->kind == PATH_HOLE ? &path->cycle.item[item->index] : NULL;
    if (cycle == *on || (!cycle && !is_motion(item)))
        return;
    char text[CYCLE_TEXT];
    if (cycle)
        path_cycle_text(cycle, text);
    out_printf(out, "%s\n", cycle ? text : "CYCLE/OFF");
    *on = cycle;
}

static void put_item(struct out *out, const struct path *path, const struct path_item *item)
{
    if (item->touches)
        put_contact(out, path->contact.item[item->contact]);
    switch (item->kind) {
    case PATH_POINT:
        if (item->rapid)
            out_text(out, "RAPID\n");
        put_goto(out, item->to);
        break;
    case PATH_ARC:
        put_arc(out, &path->arc.item[item->index]);
        put_goto(out, item->to);
        break;
    case PATH_SPLINE:
        put_spline(out, &path->spline.item[item->index]);
        break;
    case PATH_PLANE:
    case PATH_HOLE:
        put_goto(out, item->to);
        break;
    case PATH_TOOL:
        put_tool(out, &path->tool.item[item->index]);
        break;
    case PATH_PASS:
        out_printf(out, "$$-> PASS/%u\n", item->index);
        break;
    case PATH_FEED:
        out_text(out, "FEDRAT/MMPM,");
        out_num(out, item->feed, COORDINATE);
        out_text(out, "\n");
        break;
    case PATH_TEXT:
        out_text(out, path->text.item[item->index]);
        out_text(out, "\n");
        break;
    }
}

void path_write_items(struct out *out, const struct path *path)
{
    const struct path_cycle *on = NULL;
    for (size_t i = 0; i < path->item.n; i++) {
        put_cycle(out, path, &path->item.item[i], &on);
        put_item(out, path, &path->item.item[i]);
    }
    if (on)
        out_text(out, "CYCLE/OFF\n");
}

void path_write_end(struct out *out)
{
    out_text(out, "FINI\n");
}

void path_write(struct out *out, const struct path *path)
{
    path_write_head(out, &path->head);
    path_write_items(out, path);
    path_write_end(out);
}
