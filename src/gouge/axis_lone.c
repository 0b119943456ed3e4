/* axis_lone - see axis_chain.h, axis_chain_lead_to_lone. */
#include <stdlib.h>

#include "axis_chain.h"

static const double LONE = RADIANS(2); /* off an even turn between its neighbours */
static const double TURNS = 0.03;      /* radians for each mm: on the way to one and back */

/* The stations [from, to) that turn towards one, as they were, and the one after them; NULL: taken
 * back. */
struct lead {
    size_t from, to;
    struct axis_station *was;
};

struct leads {
    size_t n, cap;
    struct lead *item;
};

/* How far the axis of each station is off an even turn between its neighbours, radians; 0: it has
 * none, or is at the pole.  The caller frees it. */
static double *lone_by(const struct axis_chain *c)
{
    double *off = mem_alloc(c->n + 1, sizeof *off);
    struct vec3 *axis = mem_alloc(c->n + 1, sizeof *axis);

    for (size_t i = 0; i < c->n; i++)
        axis[i] = axis_chain_point(c, &c->at[i]).axis;
    for (size_t i = 1; i + 1 < c->n; i++) {
        const struct axis_station *s = &c->at[i];
        double before = s->along - s[-1].along, after = s[1].along - s->along;
        double part = before + after > 0 ? before / (before + after) : 0.5;
        if (!s->begins && !s[1].begins && !axis_chain_at_pole(s))
            off[i] = vec_angle(vec_unit(vec_mix(axis[i - 1], axis[i + 1], part)), axis[i]);
    }
    free(axis);
    return off;
}

/* The stations that are to turn towards this one: of its own run of the chain, and not through the
 * pole. */
static struct lead lead_to(const struct axis_chain *c, size_t lone, double reach)
{
    const struct axis_station *at = c->at;
    struct lead l = {lone, lone + 1, NULL};

    while (l.from > 0 && !at[l.from].begins && !axis_chain_at_pole(&at[l.from - 1]) &&
           at[lone].along - at[l.from - 1].along < reach)
        l.from--;
    while (l.to < c->n && !at[l.to].begins && !axis_chain_at_pole(&at[l.to]) &&
           at[l.to].along - at[lone].along < reach)
        l.to++;
    return l;
}

/* Their angles: those of the lone one there, less and less so further off, where they may be. */
static void turn_towards(struct axis_chain *c, size_t lone, struct lead *l, double reach)
{
    struct rotary_angles to = c->at[lone].angles;

    l->was = mem_alloc(l->to + 1 - l->from, sizeof *l->was);
    for (size_t i = l->from; i <= l->to && i < c->n; i++)
        l->was[i - l->from] = c->at[i];
    for (size_t i = l->from; i < l->to; i++) {
        struct axis_station *s = &c->at[i];
        double part = 1 - fabs(s->along - c->at[lone].along) / reach;
        struct rotary_angles a = {s->angles.lean + part * (to.lean - s->angles.lean),
                                  s->angles.turn + part * (to.turn - s->angles.turn)};
        if (i == lone || !axis_chain_may_have(c, s, a))
            continue;
        s->angles = a;
        s->part = 1;
    }
}

static void take_back(struct axis_chain *c, struct lead *l)
{
    for (size_t i = l->from; i <= l->to && i < c->n; i++)
        c->at[i] = l->was[i - l->from];
    free(l->was);
    l->was = NULL;
}

static bool is_bad(const struct axis_chain *c, const struct lead *l)
{
    for (size_t i = l->from; i <= l->to && i < c->n; i++)
        if (c->at[i].bad)
            return true;
    return false;
}

/* Leads on which, to which or from which the tool is not clear are as before. */
static void keep_clear(struct axis_chain *c, struct leads *leads)
{
    bool back = leads->n > 0;

    while (back && axis_chain_find_bad(c) > 0) {
        back = false;
        for (size_t k = 0; k < leads->n; k++) {
            struct lead *l = &leads->item[k];
            if (l->was && is_bad(c, l)) {
                take_back(c, l);
                back = true;
            }
        }
    }
}

void axis_chain_lead_to_lone(struct axis_chain *c)
{
    struct leads leads = {0};
    double *off = lone_by(c);
    size_t end = 0; /* of the last lead */

    for (size_t i = 1; i + 1 < c->n; i++) {
        if (off[i] < LONE || off[i] < fmax(off[i - 1], off[i + 1]))
            continue;
        struct lead l = lead_to(c, i, off[i] / TURNS);
        if (l.from < end)
            continue;
        turn_towards(c, i, &l, off[i] / TURNS);
        *array_push(&leads) = l;
        end = l.to + 1;
    }
    keep_clear(c, &leads);
    for (size_t k = 0; k < leads.n; k++)
        free(leads.item[k].was);
    array_free(&leads);
    free(off);
}
