/* excursion - see excursion.h. */
#include "simulate/excursion.h"

#include <math.h>

#include "math/kdtree.h"

#define RISES 0.5    /* cosine between the tool axis and the way up, at least */
#define ALONG 0.8    /* the same of a few straight blocks out along the tool and back: a link */
#define OVER 0.9     /* the same between up and what the end of a curve stands over */
#define NEAR_END 0.1 /* of a piece, from its end: how it goes there */
#define MOST 0.5     /* of its height: so far a spike amid a link rises over both its feet */

#define ASIDE_RADII 2 /* two straight blocks, or an arc, are told that go aside by so many radii */
#define ASIDE_MORE 10 /* and mm more, for nobody knows what stands beside the part, ... */
#define ASIDE_CURVE 3 /* ... and curves so many times as far: they may run out of a row and back */
#define SHARP 0.78    /* radians that the course bends where straight blocks turn aside, and back */
#define SMOOTH 0.17 /* radians that the course bends where an arc goes on from what is before it */

/* Spans of a curve: no pole or coefficient reaches over more than six; the last pole, which is the
 * curve's end, over the last alone, so that the ball leaves the part there or shortly before. */
enum { REACH = 8, END_REACH = 2 };

struct search {
    const struct nc_motion *motion;
    const struct centre_path *path;
    const struct vec3 *point;
    size_t n;
    const struct excursion_options *options;
    struct kdtree *part; /* made when it is needed */
    struct excursion found;
};

/* True if the two segments are of one curve, or of straight blocks one after the other. */
static bool continues_curve(const struct search *s, size_t from, size_t to)
{
    const struct nc_piece *piece = s->motion->piece.item;
    unsigned p = s->path->item[from].piece, q = s->path->item[to].piece;
    if (p == q)
        return true;
    if (q != p + 1 || piece[p].shape != piece[q].shape || piece[p].shape == SHAPE_ARC)
        return false;
    return piece[p].shape != SHAPE_SPLINE || piece[p].index == piece[q].index;
}

/* True if the straight blocks from one segment to another are two that go up and come back. */
static bool is_spike(const struct search *s, size_t from, size_t to)
{
    const struct centre_segment *a = &s->path->item[from], *b = &s->path->item[to];
    if (b->piece != a->piece + 1)
        return false;
    size_t top = from;
    while (s->path->item[top].piece == a->piece)
        top++;
    struct vec3 corner = s->path->item[top].a;
    return vec_dot(vec_sub(a->a, corner), vec_sub(b->b, corner)) > 0;
}

/* From the nearest point of the part to the ball's centre. */
static struct vec3 from_part(struct search *s, struct vec3 centre)
{
    size_t index;
    double distance2;
    if (!s->part)
        s->part = kdtree_new(s->point, s->n);
    kdtree_nearest(s->part, centre, 1, &index, &distance2);
    return vec_sub(centre, s->point[index]);
}

static double clearance(struct search *s, struct vec3 centre)
{
    return vec_length(from_part(s, centre)) - s->options->radius;
}

/* Where the ball's centre is at a part of a piece, from 0 to 1, and the axis. */
static struct nc_motion_pose pose_of(const struct search *s, size_t piece, double part)
{
    return nc_motion_ball(s->motion, piece, part, s->options->radius);
}

static void add_excursion(struct search *s, size_t segment, double height)
{
    s->found.count++;
    if (height <= s->found.height)
        return;
    s->found.height = height;
    s->found.piece = s->path->item[segment].piece;
    s->found.at = s->path->item[segment].b;
}

/* True if the path turns back where one piece ends and another begins: a sharp angle. */
static bool turns_back(const struct search *s, const struct nc_piece *piece,
                       const struct nc_piece *next)
{
    struct vec3 before = nc_motion_at(s->motion, piece, 1 - NEAR_END).p;
    struct vec3 corner = nc_motion_at(s->motion, piece, 1).p;
    struct vec3 after = nc_motion_at(s->motion, next, NEAR_END).p;
    return vec_dot(vec_sub(before, corner), vec_sub(after, corner)) > 0;
}

/* True if what comes after a piece can bring the ball down from a wrong end: a straight block
 * after a curve, or a curve that begins at a sharp angle. */
static bool may_come_down(const struct search *s, const struct nc_piece *piece,
                          const struct nc_piece *next)
{
    if (piece->shape == SHAPE_ARC || next->shape == SHAPE_ARC)
        return false;
    if (next->shape == SHAPE_LINE)
        return piece->shape != SHAPE_LINE;
    return turns_back(s, piece, next);
}

/* A piece that ends off the part counts if it rises to an end over the part and the next one comes
 * down again; one that goes down where the part has no points may end anywhere. */
static void look_at_end(struct search *s, size_t to)
{
    size_t piece = s->path->item[to].piece, next = piece + 1;
    const struct nc_piece *all = s->motion->piece.item;
    while (next < s->motion->piece.n && all[next].shape == SHAPE_LINE &&
           vec_distance(all[next].p[0], all[next].p[1]) == 0)
        next++; /* the tool turns where it is */
    if (next == s->motion->piece.n || !may_come_down(s, &all[piece], &all[next]))
        return;
    struct nc_motion_pose end = pose_of(s, piece, 1);
    struct vec3 up = from_part(s, end.p);
    double height = vec_length(up) - s->options->radius;
    if (fmax(vec_dot(up, end.a), up.z) >= OVER * vec_length(up) &&
        clearance(s, pose_of(s, piece, 1 - NEAR_END).p) < height &&
        clearance(s, pose_of(s, next, 1).p) < height - s->options->band)
        add_excursion(s, to, height);
}

/* Straight blocks off the part, the last of which begins near it: a curve may follow. */
static void look_at_last_line(struct search *s, size_t from, size_t to)
{
    const struct centre_segment *segment = s->path->item;
    size_t first = to;
    while (first > from && segment[first - 1].piece == segment[to].piece)
        first--;
    if (clearance(s, segment[first].a) <= s->options->band &&
        clearance(s, segment[to].b) > s->options->band)
        look_at_end(s, to);
}

/* Straight blocks off the part, two of which go up and come back amid the others: a link with one
 * place thrown up.  A way in or out, with one end off the part, may well turn sharply: down past
 * the part and in along an axis that leans below the horizontal. */
static void look_at_spikes(struct search *s, size_t from, size_t to)
{
    const struct centre_segment *segment = s->path->item;
    struct vec3 before = segment[from].a;
    double band = s->options->band;

    if (fmax(clearance(s, before), clearance(s, segment[to].b)) > band)
        return;
    for (size_t i = from; i < to; i++) {
        if (segment[i].piece == segment[i + 1].piece)
            continue;
        size_t end = i + 1;
        while (end < to && segment[end + 1].piece == segment[i + 1].piece)
            end++;
        struct vec3 corner = segment[i].b, after = segment[end].b;
        if (vec_dot(vec_sub(before, corner), vec_sub(after, corner)) > 0) {
            double height = clearance(s, corner);
            double over = height - fmax(clearance(s, before), clearance(s, after));
            if (over > fmax(band, MOST * height))
                add_excursion(s, i, height);
        }
        before = corner;
    }
}

/* From the straight line between two places to a third, at right angles. */
static struct vec3 rise_over_line(struct vec3 from, struct vec3 to, struct vec3 p)
{
    return vec_sub(p, vec_segment_nearest(from, to, p));
}

/* Of the segments from one to another the one whose end is furthest off the line between both ends,
 * and how far: *most. */
static size_t top_between(const struct centre_segment *segment, size_t from, size_t to,
                          double *most)
{
    size_t top = from;

    *most = 0;
    for (size_t i = from; i < to; i++) {
        double high = vec_length(rise_over_line(segment[from].a, segment[to].b, segment[i].b));
        top = high > *most ? i : top;
        *most = fmax(*most, high);
    }
    return top;
}

/* How far a rise goes up the axis of its top or of one of its feet: poles thrown past the other end
 * of the tool turn it over. */
static double up_the_tool(const struct search *s, size_t from, size_t top, size_t to,
                          struct vec3 rise)
{
    const size_t place[] = {from, top, to};
    double up = -INFINITY;

    for (int i = 0; i < 3; i++) {
        const struct centre_segment *segment = &s->path->item[place[i]];
        const struct nc_piece *piece = &s->motion->piece.item[segment->piece];
        double at = (double)segment->s[place[i] != from];
        up = fmax(up, vec_dot(nc_motion_at(s->motion, piece, at).a, rise));
    }
    return up;
}

/* The ball's course bends so much where a piece begins. */
static double bend_before(const struct search *s, size_t piece)
{
    struct vec3 before = pose_of(s, piece - 1, 1 - NEAR_END / 4).p, at = pose_of(s, piece, 0).p;
    return vec_angle(vec_sub(at, before), vec_sub(pose_of(s, piece, NEAR_END / 4).p, at));
}

/* An arc between pieces that go over into it and on from it: one of another centre bends there. */
static bool is_smooth_arc(const struct search *s, size_t piece)
{
    const struct nc_piece *p = &s->motion->piece.item[piece];
    if (p->shape != SHAPE_ARC || piece == 0 || piece + 1 == s->motion->piece.n || p[-1].rapid ||
        p[1].rapid)
        return false;
    return bend_before(s, piece) < SMOOTH && bend_before(s, piece + 1) < SMOOTH;
}

/* So far aside a stretch may go that begins in this piece. */
static double aside(const struct search *s, size_t piece)
{
    double off = ASIDE_RADII * s->options->radius + ASIDE_MORE;
    const struct nc_piece *p = &s->motion->piece.item[piece];
    return p->shape == SHAPE_LINE || p->shape == SHAPE_ARC ? off : ASIDE_CURVE * off;
}

/* A few straight blocks that turn off the row, go far aside and come back onto it at once: one
 * place's word thrown aside, which the blocks after it have not said anew. */
static void look_at_detour(struct search *s, size_t from, size_t to)
{
    const struct centre_segment *segment = s->path->item;
    const struct nc_piece *piece = s->motion->piece.item;
    size_t first = segment[from].piece, last = segment[to].piece;
    struct vec3 a = segment[from].a, b = segment[to].b;
    double most;

    if (first == 0 || last + 1 == s->motion->piece.n || last - first >= REACH ||
        piece[first - 1].rapid || piece[last + 1].rapid ||
        fmax(clearance(s, a), clearance(s, b)) > s->options->band)
        return;
    size_t top = top_between(segment, from, to, &most);
    struct vec3 rise = rise_over_line(a, b, segment[top].b);
    double height = clearance(s, segment[top].b);
    if (height > aside(s, first) && up_the_tool(s, from, top, to, rise) < ALONG * most &&
        bend_before(s, first) > SHARP && bend_before(s, last + 1) > SHARP)
        add_excursion(s, top, height);
}

/* A stretch of segments off the part, both ends among them. */
static void look_at_stretch(struct search *s, size_t from, size_t to)
{
    const struct centre_segment *segment = s->path->item;
    struct vec3 a = segment[from].a, b = segment[to].b;
    double most, band = s->options->band;
    if (s->motion->piece.item[segment[from].piece].shape == SHAPE_LINE && !is_spike(s, from, to)) {
        look_at_spikes(s, from, to);
        look_at_last_line(s, from, to);
        look_at_detour(s, from, to);
        return;
    }
    size_t top = top_between(segment, from, to, &most);
    if (fmax(most, vec_distance(a, b)) <= band || clearance(s, a) > band)
        return;
    size_t spans = segment[to].piece - segment[from].piece;
    if (clearance(s, b) > band) {
        if (spans < END_REACH)
            look_at_end(s, to);
        return;
    }
    if (spans >= REACH)
        return; /* a link */
    struct vec3 rise = rise_over_line(a, b, segment[top].b);
    double height = clearance(s, segment[top].b);
    bool up = up_the_tool(s, from, top, to, rise) >= RISES * most;
    bool link = up && is_smooth_arc(s, segment[from].piece);
    if (!link && most > band && height > (up ? band : aside(s, segment[from].piece)))
        add_excursion(s, top, height);
}

struct excursion excursion_find(const struct nc_motion *motion, const struct centre_path *path,
                                const struct vec3 *point, size_t n,
                                const struct excursion_options *options)
{
    struct search s = {motion, path, point, n, options, NULL, {0}};
    for (size_t i = 0; n > 0 && i < path->n; i++) {
        size_t from = i;
        if (path->item[i].on)
            continue;
        while (i + 1 < path->n && !path->item[i + 1].on && continues_curve(&s, i, i + 1))
            i++;
        look_at_stretch(&s, from, i);
    }
    if (s.part)
        kdtree_free(s.part);
    return s.found;
}
