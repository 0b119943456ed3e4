/* path - building, copying and walking a path in memory; see path.h. */
#include "io/path/path.h"

#include <stdlib.h>
#include <string.h>

#include "math/elementary.h"

static char *copy_text(const char *s)
{
    return s ? mem_string(s, strlen(s)) : NULL;
}

void path_free(struct path *path)
{
    free(path->head.partno);
    for (size_t i = 0; i < path->head.ledger.n; i++)
        free(path->head.ledger.item[i].stage);
    for (size_t i = 0; i < path->spline.n; i++) {
        bspline_free(&path->spline.item[i].curve);
        array_free(&path->spline.item[i].fallback);
    }
    for (size_t i = 0; i < path->text.n; i++)
        free(path->text.item[i]);
    for (size_t i = 0; i < path->unknown.n; i++)
        free(path->unknown.item[i].word);
    array_free(&path->head.ledger);
    array_free(&path->head.passes);
    for (size_t i = 0; i < path->spent.n; i++)
        free(path->spent.item[i].entry.stage);
    array_free(&path->spent);
    region_polygons_free(&path->head.region.polygons);
    scan_sources_free(&path->head.scan);
    scan_sources_free(&path->head.mesh);
    unmets_free(&path->head.unmet);
    unmets_free(&path->head.unfitted);
    array_free(&path->item);
    array_free(&path->contact);
    array_free(&path->arc);
    array_free(&path->spline);
    array_free(&path->cycle);
    array_free(&path->tool);
    array_free(&path->text);
    array_free(&path->unknown);
    memset(path, 0, sizeof *path);
}

void path_head_copy(struct path_head *to, const struct path_head *from)
{
    *to = *from;
    to->partno = copy_text(from->partno);
    memset(&to->ledger, 0, sizeof to->ledger);
    memset(&to->passes, 0, sizeof to->passes);
    to->region.polygons = region_polygons_copy(&from->region.polygons);
    to->scan = scan_sources_copy(&from->scan);
    to->mesh = scan_sources_copy(&from->mesh);
    memset(&to->unmet, 0, sizeof to->unmet);
    memset(&to->unfitted, 0, sizeof to->unfitted);
    unmets_add_all(&to->unmet, &from->unmet);
    for (size_t i = 0; i < from->ledger.n; i++)
        *array_push(&to->ledger) = (struct ledger_entry){copy_text(from->ledger.item[i].stage),
                                                         from->ledger.item[i].spent, false};
}

enum path_coolant path_coolant_of(const char *word)
{
    static const struct {
        const char *word;
        enum path_coolant coolant;
    } words[] = {{"", COOLANT_ON},       {"ON", COOLANT_ON},        {"FLOOD", COOLANT_ON},
                 {"TAPKUL", COOLANT_ON}, {"MIST", COOLANT_MIST},    {"OFF", COOLANT_OFF},
                 {"THRU", COOLANT_THRU}, {"THROUGH", COOLANT_THRU}, {"THRUTL", COOLANT_THRU},
                 {"AIR", COOLANT_AIR}};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (strcmp(words[i].word, word) == 0)
            return words[i].coolant;
    return COOLANT_NOT_GIVEN;
}

void path_spend(struct path *path, const char *stage, double spent)
{
    *array_push(&path->head.ledger) = (struct ledger_entry){copy_text(stage), spent, false};
}

void path_spend_pass(struct path *path, const char *stage, double spent, size_t before)
{
    *array_push(&path->spent) = (struct path_spent){before, {copy_text(stage), spent, true}};
}

double path_spent(const struct path *path)
{
    double sum = 0;
    for (size_t i = 0; i < path->head.ledger.n; i++)
        sum += path->head.ledger.item[i].spent;
    return sum;
}

static double ball_of(const double *cutter, int n)
{
    double d = cutter[0], corner = cutter[1];
    return n >= 2 && d > 0 && fabs(corner - d / 2) <= 1e-6 * d ? d / 2 : -1;
}

double path_ball(const struct path *path)
{
    return ball_of(path->head.cutter, path->head.cutter_n);
}

struct holder path_holder(const struct path *path)
{
    double radius = path_ball(path);
    struct tool_body usual = tool_body_usual(radius);

    if (!(radius > 0))
        return (struct holder){0};
    return tool_body_profile(path->head.body_given ? &path->head.body : &usual, radius);
}

double path_tool_ball(const struct path_tool *tool)
{
    return ball_of(tool->cutter, tool->cutter_n);
}

static struct path_item *add_item(struct path *path, enum path_kind kind)
{
    struct path_item *item = array_push(&path->item);
    *item = (struct path_item){.kind = kind};
    return item;
}

struct path_item *path_add_point(struct path *path, struct pose to, bool rapid)
{
    struct path_item *item = add_item(path, PATH_POINT);
    item->to = to;
    item->rapid = rapid;
    return item;
}

struct path_item *path_add_arc(struct path *path, struct pose to, struct path_arc arc)
{
    struct path_item *item = add_item(path, PATH_ARC);
    item->to = to;
    item->index = (unsigned)path->arc.n;
    *array_push(&path->arc) = arc;
    return item;
}

struct path_item *path_add_spline(struct path *path, struct pose to, struct path_spline spline)
{
    struct path_item *item = add_item(path, PATH_SPLINE);
    item->to = to;
    item->index = (unsigned)path->spline.n;
    *array_push(&path->spline) = spline;
    return item;
}

void path_add_hole(struct path *path, struct pose mouth, size_t cycle)
{
    struct path_item *item = add_item(path, PATH_HOLE);
    item->to = mouth;
    item->index = (unsigned)cycle;
}

void path_add_tool(struct path *path, struct path_tool tool)
{
    add_item(path, PATH_TOOL)->index = (unsigned)path->tool.n;
    *array_push(&path->tool) = tool;
}

void path_add_pass(struct path *path, size_t number)
{
    add_item(path, PATH_PASS)->index = (unsigned)number;
}

void path_add_feed(struct path *path, double feed)
{
    add_item(path, PATH_FEED)->feed = feed;
}

void path_add_text(struct path *path, const char *text)
{
    add_item(path, PATH_TEXT)->index = (unsigned)path->text.n;
    *array_push(&path->text) = copy_text(text);
}

size_t path_statements(const struct path *path, const char *word)
{
    size_t n = 0;

    for (size_t i = 0; i < path->text.n; i++)
        n += strncmp(path->text.item[i], word, strlen(word)) == 0;
    return n;
}

void path_set_contact(struct path *path, struct path_item *item, struct contact contact)
{
    item->touches = true;
    item->contact = (unsigned)path->contact.n;
    *array_push(&path->contact) = contact;
}

static struct path_spline copy_spline(const struct path_spline *s)
{
    struct path_spline copy = {.curve = bspline_copy(&s->curve)};
    array_reserve(&copy.fallback, s->fallback.n);
    copy.fallback.n = s->fallback.n;
    if (s->fallback.n)
        memcpy(copy.fallback.item, s->fallback.item, s->fallback.n * sizeof *s->fallback.item);
    return copy;
}

void path_add_items(struct path *path, const struct path *other, size_t from, size_t to)
{
    for (size_t i = from; i < to; i++) {
        const struct path_item *was = &other->item.item[i];
        struct path_item *item = array_push(&path->item);
        *item = *was;
        if (was->touches)
            path_set_contact(path, item, other->contact.item[was->contact]);
        if (was->kind == PATH_ARC) {
            item->index = (unsigned)path->arc.n;
            *array_push(&path->arc) = other->arc.item[was->index];
        } else if (was->kind == PATH_SPLINE) {
            item->index = (unsigned)path->spline.n;
            *array_push(&path->spline) = copy_spline(&other->spline.item[was->index]);
        } else if (was->kind == PATH_HOLE) {
            bool same = i > from && was[-1].kind == PATH_HOLE && was[-1].index == was->index;
            if (!same)
                *array_push(&path->cycle) = other->cycle.item[was->index];
            item->index = (unsigned)path->cycle.n - 1;
        } else if (was->kind == PATH_TOOL) {
            item->index = (unsigned)path->tool.n;
            *array_push(&path->tool) = other->tool.item[was->index];
        } else if (was->kind == PATH_TEXT) {
            item->index = (unsigned)path->text.n;
            *array_push(&path->text) = copy_text(other->text.item[was->index]);
        }
    }
}

static bool any_contact(const struct path *path)
{
    for (size_t i = 0; i < path->item.n; i++)
        if (path->item.item[i].touches)
            return true;
    return false;
}

bool path_next_run(const struct path *path, size_t *from, size_t *to)
{
    bool contacts = any_contact(path);
    size_t i = *from;
    while (i < path->item.n) {
        size_t first = i;
        while (i < path->item.n && path->item.item[i].kind == PATH_POINT &&
               !path->item.item[i].rapid && path->item.item[i].touches == contacts)
            i++;
        if (i - first > 1) {
            *from = first;
            *to = i;
            return true;
        }
        if (i == first)
            i++;
    }
    return false;
}

struct motion path_item_motion(const struct path *path, const struct path_item *item,
                               struct pose from)
{
    if (item->kind == PATH_ARC) {
        const struct path_arc *arc = &path->arc.item[item->index];
        return motion_arc(from, item->to, arc->centre, arc->axis);
    }
    if (item->kind == PATH_SPLINE)
        return motion_spline(from, item->to, &path->spline.item[item->index].curve);
    return motion_line(from, item->to);
}
