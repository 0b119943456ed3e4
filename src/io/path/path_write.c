/* path_write - a path as APT CL text; see path.h and cloudmill-path(5). */
#include <inttypes.h>
#include <string.h>

#include "math/elementary.h"
#include "base/num.h"
#include "gouge/holder_text.h"
#include "io/path/path.h"
#include "path_parse.h"

enum { COORDINATE = 6, VECTOR = 9, LINE_MAX = 72 };

static void write_vec(struct out *out, struct vec3 v, int digits)
{
    out_num(out, v.x, digits);
    out_text(out, ",");
    out_num(out, v.y, digits);
    out_text(out, ",");
    out_num(out, v.z, digits);
}

static void write_goto(struct out *out, struct pose pose)
{
    out_text(out, "GOTO/");
    write_vec(out, pose.p, COORDINATE);
    out_text(out, ",");
    write_vec(out, pose.a, VECTOR);
    out_text(out, "\n");
}

static void write_cutter(struct out *out, const double *cutter, int n)
{
    for (int i = 0; i < n; i++) {
        out_text(out, i ? "," : "CUTTER/");
        out_num(out, cutter[i], COORDINATE);
    }
    out_text(out, n ? "\n" : "");
}

static void write_load(struct out *out, int number, int offset)
{
    out_printf(out, "LOADTL/%d", number);
    if (offset)
        out_printf(out, ",OSETNO,%d", offset);
    out_text(out, "\n");
}

static void write_body(struct out *out, const struct tool_body *body)
{
    char text[HOLDER_TEXT];
    if (body->ball_only) {
        out_text(out, "$$-> TOOL/BALL-ONLY\n");
        return;
    }
    out_text(out, "$$-> TOOL/FLUTE,");
    out_num(out, body->flute, COORDINATE);
    holder_text_write(&body->above, text);
    if (body->above.n > 0)
        out_printf(out, ",HOLDER,%s", text);
    out_text(out, "\n");
}

/* A line for each file, as SCAN/ or MESH/. */
static void write_sources(struct out *out, const char *word, const struct scan_sources *sources)
{
    for (size_t i = 0; i < sources->n; i++) {
        const struct scan_source *s = &sources->item[i];
        out_printf(out, "$$-> %s/%" PRIu64 ",%016" PRIx64 ",", word, s->points, s->hash);
        for (const char *p = s->name; *p; p++)
            out_bytes(out, (unsigned char)*p < ' ' ? "?" : p, 1);
        /* A single $ at the end of a line would continue it. */
        out_text(out, *s->name && s->name[strlen(s->name) - 1] == '$' ? "$\n" : "\n");
    }
}

/* The place has a line for each row, since other readers of CL know no continued comments. */
static void write_scan(struct out *out, const struct scan_sources *scan)
{
    write_sources(out, "SCAN", scan);
    for (int row = 0; row < 3 && scan->n > 0 && scan->placed; row++) {
        out_printf(out, "$$-> PLACE/%d", row + 1);
        for (int k = 0; k < 4; k++) {
            out_text(out, ",");
            out_exact(out, scan->place.m[row][k]);
        }
        out_text(out, "\n");
    }
}

/* Box and polygons, of these a few corners in a line. */
static void write_region(struct out *out, const struct region *region)
{
    enum { IN_A_LINE = 3 };
    const struct region_polygons *p = &region->polygons;

    out_text(out, "$$-> REGION/BORDER,");
    out_num(out, region->border, COORDINATE);
    out_text(out, "\n");
    if (region->boxed) {
        out_text(out, "$$-> REGION/BOX,");
        write_vec(out, region->box.low, COORDINATE);
        out_text(out, ",");
        write_vec(out, region->box.high, COORDINATE);
        out_text(out, "\n");
    }
    for (size_t k = 0; k < p->from.n; k++) {
        size_t from = (size_t)p->from.item[k], end = region_polygons_end(p, k);
        for (size_t i = from; i < end; i++) {
            const struct vec3 *c = &p->corner.item[i];
            bool first = (i - from) % IN_A_LINE == 0;
            if (first)
                out_text(out, i == from ? "$$-> REGION/POLYGON" : "$$-> REGION/CORNERS");
            out_text(out, ",");
            out_num(out, c->x, COORDINATE);
            out_text(out, ",");
            out_num(out, c->y, COORDINATE);
            if (i + 1 == end || (i + 1 - from) % IN_A_LINE == 0)
                out_text(out, "\n");
        }
    }
}

static void write_spent(struct out *out, const struct ledger_entry *entry)
{
    out_printf(out, "$$-> LEDGER/%s,%.6f\n", entry->stage, entry->spent);
}

void path_write_head(struct out *out, const struct path_head *head)
{
    static const char *const coolant[] = {NULL, "OFF", "ON", "MIST", "THRU", "AIR"};
    static const char *const track[] = {NULL, "CENTER", "CONTACT"};
    if (head->partno)
        out_printf(out, "PARTNO/%s\n", head->partno);
    out_text(out, "UNITS/MM\n");
    if (head->multax)
        out_text(out, "MULTAX/ON\n");
    write_cutter(out, head->cutter, head->cutter_n);
    if (head->tool)
        write_load(out, head->tool, head->offset);
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
    if (head->body_given)
        write_body(out, &head->body);
    for (size_t i = 0; i < head->ledger.n; i++)
        write_spent(out, &head->ledger.item[i]);
    if (!isnan(head->chord))
        out_printf(out, "$$-> CHORD/%.6f\n", head->chord);
    if (!isnan(head->clearance))
        out_printf(out, "$$-> CLEAR/%.6f\n", head->clearance);
    if (head->scallop > 0)
        out_printf(out, "$$-> SCALLOP/%.6f\n", head->scallop);
    if (head->noise_given)
        out_printf(out, "$$-> NOISE/%.6f\n", head->noise);
    if (head->runs.points > 0) {
        out_printf(out, "$$-> RUNS/%zu,", head->runs.points);
        out_num(out, head->runs.feed, COORDINATE);
        out_text(out, "\n");
    }
    path_write_passes(out, &head->passes);
    if (region_given(&head->region))
        write_region(out, &head->region);
    write_scan(out, &head->scan);
    write_sources(out, "MESH", &head->mesh);
}

/* The numbers of one long statement, over lines that end in ` $`. */
struct list {
    struct out *out;
    int column;
};

static void list_number(struct list *list, double x)
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

static void write_poles(struct out *out, const char *start, const struct vec3 *pole, size_t n)
{
    struct list list = begin_list(out, start);
    for (size_t i = 0; i < n; i++) {
        list_number(&list, pole[i].x);
        list_number(&list, pole[i].y);
        list_number(&list, pole[i].z);
    }
    out_text(out, "\n");
}

static void write_spline(struct out *out, const struct path_spline *spline)
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
        list_number(&list, c->knot[i]);
    out_text(out, "\n");
    write_poles(out, "MOVNRB/2", c->pole, c->poles);
    if (c->head)
        write_poles(out, "MOVNRB/3", c->head, c->poles);
    out_text(out, "MOVNRB/NEXT\n");
    for (size_t i = 0; i < spline->fallback.n; i++)
        write_goto(out, spline->fallback.item[i]);
    out_text(out, "MOVNRB/OFF\n");
}

static void write_arc(struct out *out, const struct path_arc *arc)
{
    out_text(out, "CIRCLE/");
    write_vec(out, arc->centre, COORDINATE);
    out_text(out, ",");
    write_vec(out, arc->axis, VECTOR);
    out_text(out, ",");
    out_num(out, arc->radius, COORDINATE);
    out_text(out, "\n");
}

static void write_contact(struct out *out, struct contact contact)
{
    out_text(out, "$$-> CONTCT/");
    write_vec(out, contact.p, COORDINATE);
    out_text(out, ",");
    write_vec(out, contact.n, VECTOR);
    out_text(out, "\n");
}

static void write_tool(struct out *out, const struct path_tool *tool)
{
    write_cutter(out, tool->cutter, tool->cutter_n);
    write_load(out, tool->number, tool->offset);
}

static bool is_motion(const struct path_item *item)
{
    return item->kind == PATH_POINT || item->kind == PATH_ARC || item->kind == PATH_SPLINE;
}

/* Writes CYCLE before the first hole of each, CYCLE/OFF after the last; *on is the one in force. */
static void write_cycle(struct out *out, const struct path *path, const struct path_item *item,
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

static void write_item(struct out *out, const struct path *path, const struct path_item *item)
{
    if (item->touches)
        write_contact(out, path->contact.item[item->contact]);
    switch (item->kind) {
    case PATH_POINT:
        if (item->rapid)
            out_text(out, "RAPID\n");
        write_goto(out, item->to);
        break;
    case PATH_ARC:
        write_arc(out, &path->arc.item[item->index]);
        write_goto(out, item->to);
        break;
    case PATH_SPLINE:
        write_spline(out, &path->spline.item[item->index]);
        break;
    case PATH_PLANE:
    case PATH_HOLE:
        write_goto(out, item->to);
        break;
    case PATH_TOOL:
        write_tool(out, &path->tool.item[item->index]);
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
    for (size_t i = 0, k = 0; i < path->item.n; i++) {
        write_cycle(out, path, &path->item.item[i], &on);
        write_item(out, path, &path->item.item[i]);
        for (; k < path->spent.n && path->spent.item[k].before == i + 1; k++)
            write_spent(out, &path->spent.item[k].entry);
    }
    if (on)
        out_text(out, "CYCLE/OFF\n");
}

/* A $ at the end of a line would continue it: it becomes a `?` anywhere. */
static void write_said(struct out *out, const char *word, const struct unmets *said)
{
    for (size_t i = 0; i < said->n; i++) {
        out_printf(out, "$$-> %s/%s,", word, said->item[i].stage);
        for (const char *p = said->item[i].text; *p; p++)
            out_bytes(out, *p == '$' ? "?" : p, 1);
        out_text(out, "\n");
    }
}

void path_write_unmet(struct out *out, const struct unmets *unmet)
{
    write_said(out, "UNMET", unmet);
}

void path_write_end(struct out *out, const struct path_head *head)
{
    path_write_unmet(out, &head->unmet);
    write_said(out, "UNFITTED", &head->unfitted);
    out_text(out, "FINI\n");
}

void path_write(struct out *out, const struct path *path)
{
    path_write_head(out, &path->head);
    path_write_items(out, path);
    path_write_end(out, &path->head);
}
