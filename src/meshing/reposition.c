/* reposition - see reposition.h. */
#include "meshing/reposition.h"

#include <stdlib.h>

#include "base/parallel.h"
#include "math/pair.h"

static const double STEPS = 1e9;

enum { EMPTY = 1, BESIDE = 2, CORNER = 4 /* of a rhombus with one beside */ };

/* A point as it looks from a node, in units of t. */
struct view {
    bool upper, middle;
};

static struct view view_from(const struct grid *g, int column, int row, struct vec3 p)
{
    const double rounding = 1e-9;
    struct vec3 node = grid_node(g, column, row);
    double dx = (p.x - node.x) / g->t, dy = (p.y - node.y) / g->t;
    return (struct view){dy >= -rounding, fabs(dy) >= sqrt(3) * fabs(dx) - rounding};
}

/* Both are equally near to the node: does `a` come before `b`? */
static bool comes_first(const struct grid *g, int column, int row, const struct node_choice *a,
                        const struct node_choice *b)
{
    struct vec3 p = plan_extent_turn(&g->plan_extent, a->at);
    struct vec3 q = plan_extent_turn(&g->plan_extent, b->at);
    struct view from_p = view_from(g, column, row, p), from_q = view_from(g, column, row, q);
    if (from_p.upper != from_q.upper)
        return from_p.upper;
    if (from_p.middle != from_q.middle)
        return from_p.middle;
    if (p.x != q.x)
        return p.x > q.x;
    if (p.z != q.z)
        return p.z > q.z;
    if (p.y != q.y)
        return p.y > q.y;
    return a->point < b->point;
}

/* The place of a node in the lists, NO_POINT: it is not kept. */
static size_t index_of(const struct reposition *r, int column, int row)
{
    if (row < 0 || row >= r->grid.rows || column >= r->grid.columns)
        return NO_POINT;
    int at = column - r->first[row];
    if (at < 0 || at >= r->width)
        return NO_POINT;
    return (size_t)row * (size_t)r->width + (size_t)at;
}

const struct node_choice *reposition_node(const struct reposition *r, int column, int row)
{
    size_t at = index_of(r, column, row);
    return at == NO_POINT || r->choice[at].point == NO_CHOICE ? NULL : &r->choice[at];
}

void reposition_move(struct reposition *r, int column, int row, struct vec3 to)
{
    size_t at = index_of(r, column, row);

    if (at != NO_POINT)
        r->choice[at].at = to;
}

static uint32_t nearness_of(double distance2)
{
    return (uint32_t)(distance2 * STEPS + 0.5);
}

static void compete_for_node(struct reposition *r, struct vec3 p, size_t index, int column, int row,
                             double distance2)
{
    struct node_choice *c = &r->choice[index_of(r, column, row)];
    struct node_choice this = {nearness_of(distance2), (uint32_t)index, p};
    if (this.nearness > c->nearness)
        return;
    if (this.nearness == c->nearness && !comes_first(&r->grid, column, row, &this, c))
        return;
    *c = this;
}

/* Where a point lies: the lower left node of its rhombus and what is left over, 0 to 1. */
struct place {
    int column, row;
    double right, up; /* along e1 and e2 */
};

static int whole_part(double x, int most)
{
    int i = (int)x;
    return i > most ? most : i;
}

static struct place place_of(const struct grid *g, struct vec3 point)
{
    struct vec3 p = plan_extent_turn(&g->plan_extent, point);
    double v = (p.y - g->y) / (g->t * GRID_SLANT), u = (p.x - g->x) / g->t - 0.5 * v;
    u = u > 0 ? u : 0;
    int column = whole_part(u, g->columns - 2), row = whole_part(v, g->rows - 2);
    return (struct place){column, row, u - column, v - row};
}

/* |a e1 + b e2|^2 in units of t^2. */
static double oblique_length2(double a, double b)
{
    return a * a + a * b + b * b;
}

/* The nearest node is a corner of the rhombus; of equally near ones the lower, then left one. */
static double nearest_node(const struct grid *g, struct vec3 p, int *column, int *row)
{
    static const double further = 1e-9;
    struct place at = place_of(g, p);
    pair right = {at.right, at.right - 1}, up = pair_both(at.up), above = pair_both(at.up - 1);
    pair low = right * right + right * up + up * up;
    pair high = right * right + right * above + above * above;
    const double d2[4] = {low[0], low[1], high[0], high[1]};
    double least = d2[0];
    int best = 0;
    for (int corner = 1; corner < 4; corner++) { /* no jumps: no one can tell where they go */
        bool nearer = d2[corner] < least - further;
        best = nearer ? corner : best;
        least = nearer ? d2[corner] : least;
    }
    *column = at.column + (best & 1);
    *row = at.row + (best >> 1);
    return least;
}

/* Nodes nearer than `within2` t^2 are corners of the rhombus, or of one of the rhombi around it:
 * all of them, or the empty ones. */
static void compete_circle(struct reposition *r, struct vec3 p, size_t index, double within2,
                           const unsigned char *empty)
{
    struct place at = place_of(&r->grid, p);
    for (int up = -1; up <= 2; up++)
        for (int right = -1; right <= 2; right++) {
            int column = at.column + right, row = at.row + up;
            double d2 = oblique_length2(at.right - right, at.up - up);
            if (!(d2 < within2))
                continue;
            size_t node = index_of(r, column, row);
            if (node != NO_POINT && (!empty || (empty[node] & EMPTY)))
                compete_for_node(r, p, index, column, row, d2);
        }
}

int reposition_begin(const struct grid *grid, size_t n, enum reach reach, struct reposition *r,
                     struct error *error)
{
    const struct plan_extent *f = &grid->plan_extent;
    if (n >= NO_CHOICE)
        return error_set(error, "found %zu points, expected fewer than %lu", n,
                         (unsigned long)NO_CHOICE);
    int width = (int)ceil((f->xmax - f->xmin) / grid->t) + 8;
    *r = (struct reposition){.grid = *grid,
                             .reach = reach,
                             .width = width < grid->columns ? width : grid->columns,
                             .first = mem_alloc((size_t)grid->rows, sizeof *r->first)};
    for (int row = 0; row < grid->rows; row++) { /* where a point in the box may compete */
        double left = (f->xmin - grid->x) / grid->t - 0.5 * (row + 1);
        r->first[row] = left > 2 ? (int)left - 2 : 0;
    }
    size_t nodes = (size_t)grid->rows * (size_t)r->width;
    r->choice = mem_alloc(nodes, sizeof *r->choice);
    for (size_t i = 0; i < nodes; i++)
        r->choice[i].nearness = r->choice[i].point = NO_CHOICE;
    return 0;
}

void reposition_free(struct reposition *r)
{
    free(r->choice);
    free(r->first);
    free(r->empty);
    r->choice = NULL;
    r->first = NULL;
    r->empty = NULL;
}

enum { SOME = 256 };

/* Points from number `index` on that each compete for their nearest node, at most SOME: first the
 * nodes of all of them, then what these have, which is anywhere in memory, looked up at once; most
 * points are farther. */
static void compete_some(struct reposition *r, const struct vec3 *point, size_t index, size_t n)
{
    struct {
        int column, row;
        double distance2;
        size_t at;
    } nearest[SOME];
    uint32_t taken[SOME];
    for (size_t i = 0; i < n; i++) {
        nearest[i].distance2 =
            nearest_node(&r->grid, point[i], &nearest[i].column, &nearest[i].row);
        nearest[i].at = index_of(r, nearest[i].column, nearest[i].row);
    }
    for (size_t i = 0; i < n; i++)
        taken[i] = r->choice[nearest[i].at].nearness;
    for (size_t i = 0; i < n; i++)
        if (nearness_of(nearest[i].distance2) <= taken[i])
            compete_for_node(r, point[i], index + i, nearest[i].column, nearest[i].row,
                             nearest[i].distance2);
}

static void compete_all(struct reposition *r, const struct vec3 *point, size_t index, size_t n)
{
    for (size_t i = 0; i < n; i += SOME)
        compete_some(r, point + i, index + i, n - i < SOME ? n - i : SOME);
}

void reposition_add(struct reposition *r, const struct vec3 *point, size_t n)
{
    static const double inside = 1 - 1e-9;
    for (size_t i = 0; i < n && r->reach == REACH_CIRCLE; i++)
        compete_circle(r, point[i], r->n++, inside, NULL);
    if (r->reach == REACH_CIRCLE)
        return;
    compete_all(r, point, r->n, n);
    r->n += n;
}

/* Parts of the points, each with the rows of nodes that it may compete for. */
enum { PARTS = 32, LEAST_OF_PART = 2048 };

struct parts {
    struct reposition *r;
    const struct vec3 *point;
    size_t n;
    int low[PARTS], high[PARTS];
    size_t first; /* the even parts, or the odd ones */
};

static size_t part_begins(const struct parts *p, size_t part)
{
    return p->n / PARTS * part + (part < p->n % PARTS ? part : p->n % PARTS);
}

static void find_rows(void *context, size_t from, size_t to)
{
    struct parts *p = context;
    for (size_t part = from; part < to; part++) {
        int low = p->r->grid.rows, high = 0;
        for (size_t i = part_begins(p, part); i < part_begins(p, part + 1); i++) {
            int row = place_of(&p->r->grid, p->point[i]).row;
            low = row < low ? row : low;
            high = row + 1 > high ? row + 1 : high;
        }
        p->low[part] = low;
        p->high[part] = high;
    }
}

static void compete_parts(void *context, size_t from, size_t to)
{
    const struct parts *p = context;
    for (size_t k = from; k < to; k++) {
        size_t begin = part_begins(p, p->first + 2 * k), end = part_begins(p, p->first + 2 * k + 1);
        compete_all(p->r, p->point + begin, begin, end - begin);
    }
}

/* Are the rows of each part over those of the part before the last? */
static bool are_apart(const struct parts *p)
{
    for (size_t part = 2; part < PARTS; part++)
        if (p->low[part] <= p->high[part - 2])
            return false;
    return true;
}

/* All points at once.  Which of two comes first for a node does not depend on their order, so that
 * every other part of them may be looked at at a time where these have no row in common. */
static void add_all(struct reposition *r, const struct vec3 *point, size_t n, int threads)
{
    struct parts parts = {.r = r, .point = point, .n = n};
    bool many = threads != 1 && r->reach == REACH_NEAREST && n >= (size_t)PARTS * LEAST_OF_PART;

    if (many)
        parallel_for(threads, PARTS, find_rows, &parts);
    if (!many || !are_apart(&parts)) {
        reposition_add(r, point, n);
        return;
    }
    for (; parts.first < 2; parts.first++)
        parallel_for(threads, PARTS / 2, compete_parts, &parts);
    r->n += n;
}

/* The nodes around one, where they are kept; how many there are, and how many have a point. */
static int nodes_around(const struct reposition *r, int column, int row, size_t around[6],
                        int *full)
{
    static const int RIGHT[6] = {1, 0, -1, -1, 0, 1}, UP[6] = {0, 1, 1, 0, -1, -1};
    int n = 0;
    *full = 0;
    for (int k = 0; k < 6; k++) {
        size_t node = index_of(r, column + RIGHT[k], row + UP[k]);
        if (node == NO_POINT)
            continue;
        around[n++] = node;
        *full += r->choice[node].point != NO_CHOICE;
    }
    return n;
}

/* Marks the lower left nodes of the rhombi that a node beside an empty one is a corner of. */
static void mark_rhombi(struct reposition *r, int column, int row)
{
    for (int corner = 0; corner < 4; corner++) {
        size_t node = index_of(r, column - (corner & 1), row - (corner >> 1));
        if (node != NO_POINT)
            r->empty[node] |= CORNER;
    }
}

/* Marks an empty node inside the cloud, where all but one of those around have a point. */
static bool mark_empty(struct reposition *r, int column, int row, size_t node)
{
    size_t around[6];
    int full, n = nodes_around(r, column, row, around, &full);

    if (full < 5)
        return false;
    r->empty[node] |= EMPTY;
    for (int k = 0; k < n; k++) {
        int beside = (int)(around[k] / (size_t)r->width);
        r->empty[around[k]] |= BESIDE;
        mark_rhombi(r, (int)(around[k] % (size_t)r->width) + r->first[beside], beside);
    }
    return true;
}

bool reposition_empty(struct reposition *r)
{
    bool any = false;
    if (r->reach == REACH_CIRCLE)
        return false;
    r->n = 0;
    r->empty = mem_alloc((size_t)r->grid.rows * (size_t)r->width, sizeof *r->empty);
    for (int row = 0; row < r->grid.rows; row++)
        for (int k = 0, first = r->first[row]; k < r->width; k++) {
            size_t node = (size_t)row * (size_t)r->width + (size_t)k;
            if (first + k < r->grid.columns && r->choice[node].point == NO_CHOICE &&
                mark_empty(r, first + k, row, node))
                any = true;
        }
    return any;
}

/* Lets a point that no node has taken compete for the empty ones nearer than 0.7 t: from further
 * off facets might fold. */
void reposition_fill(struct reposition *r, const struct vec3 *point, size_t n)
{
    const double within = 0.49; /* t^2 */
    int column, row;
    for (size_t i = 0; i < n; i++, r->n++) {
        struct place at = place_of(&r->grid, point[i]);
        size_t node = index_of(r, at.column, at.row);
        if (node != NO_POINT && !(r->empty[node] & CORNER))
            continue;
        nearest_node(&r->grid, point[i], &column, &row);
        node = index_of(r, column, row); /* one beside, if it is near an empty one at all */
        if ((r->empty[node] & BESIDE) && r->choice[node].point != r->n)
            compete_circle(r, point[i], r->n, within, r->empty);
    }
}

/* Has an empty node before this one the same point?  It is no farther than 1.4 t. */
static bool taken_before(const struct reposition *r, int column, int row, uint32_t point)
{
    enum { FAR = 3 };
    for (int up = -FAR; up <= 0; up++)
        for (int right = -FAR; right <= (up < 0 ? FAR : -1); right++) {
            const struct node_choice *other = reposition_node(r, column + right, row + up);
            if (other && other->point == point)
                return true;
        }
    return false;
}

/* A point that two empty nodes took is left to the first. */
void reposition_settle(struct reposition *r)
{
    for (int row = 0; row < r->grid.rows; row++)
        for (int k = 0, first = r->first[row]; k < r->width; k++) {
            size_t node = (size_t)row * (size_t)r->width + (size_t)k;
            struct node_choice *c = &r->choice[node];
            if ((r->empty[node] & EMPTY) && c->point != NO_CHOICE &&
                taken_before(r, first + k, row, c->point))
                c->point = NO_CHOICE;
        }
}

size_t *reposition(const struct grid *grid, const struct vec3 *point, size_t n, enum reach reach,
                   int threads)
{
    size_t nodes = grid_nodes(grid), *chosen = mem_alloc(nodes, sizeof *chosen);
    struct reposition r = {0};
    struct error error;
    for (size_t i = 0; i < nodes; i++)
        chosen[i] = NO_POINT;
    if (reposition_begin(grid, n, reach, &r, &error) < 0)
        return chosen;
    add_all(&r, point, n, threads);
    if (reposition_empty(&r)) {
        reposition_fill(&r, point, n);
        reposition_settle(&r);
    }
    for (int row = 0; row < grid->rows; row++)
        for (int k = 0, first = r.first[row]; k < r.width; k++) {
            const struct node_choice *c = reposition_node(&r, first + k, row);
            if (c)
                chosen[(size_t)row * (size_t)grid->columns + (size_t)(first + k)] = c->point;
        }
    reposition_free(&r);
    return chosen;
}
