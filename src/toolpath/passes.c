/* passes - see passes.h. */
#include "toolpath/passes.h"

#include <stdlib.h>

/* Points nearer than this are one, mm (as in slice). */
static const double CROWDED = 1e-3;

void edge_roll(struct contacts *to, struct vec3 forward, struct contact last, struct contact next,
               double radius, double tolerance)
{
    if (vec_dot(next.n, forward) < vec_dot(last.n, forward))
        return;
    double step = 2 * acos(fmax(1 - tolerance / radius, 0));
    double parts = ceil(vec_angle(last.n, next.n) / step);
    for (double i = 1; i < parts; i++)
        *array_push(to) = (struct contact){vec_mix(last.p, next.p, i / parts),
                                           vec_slerp(last.n, next.n, i / parts)};
}

static bool is_away(const struct pass_options *rule, const struct contact *c)
{
    return rule->faced && vec_dot(c->n, rule->facing) < -1e-6;
}

/* Appends what of a chain does not face away; returns how many points do. */
static size_t drop_away(const struct contact *c, struct slice_chain chain,
                        const struct pass_options *rule, struct slice_chains *to)
{
    size_t n = chain.to - chain.from, begin = 0, left_out = 0, from = to->point.n;

    while (begin < n && !is_away(rule, &c[begin]))
        begin++;
    if (begin == n) {
        for (size_t i = 0; i < n; i++)
            *array_push(&to->point) = c[i];
        slice_chains_end(to, from, chain.closed);
        return 0;
    }
    /* A closed chain is walked round from there, an open one from its start. */
    size_t turn = chain.closed ? n - 1 : n, first = chain.closed ? begin : 0;
    for (size_t i = 0; i < turn; i++) {
        const struct contact *p = &c[(first + i) % turn];
        if (is_away(rule, p)) {
            left_out++;
            slice_chains_end(to, from, false);
            from = to->point.n;
        } else {
            *array_push(&to->point) = *p;
        }
    }
    slice_chains_end(to, from, false);
    return left_out;
}

/* A closed chain from its point least along, over its upper side first. */
static void open_loop(struct contact *c, size_t n, const struct pass_options *rule)
{
    struct contact *turned = mem_alloc(n, sizeof *turned);
    size_t least = 0;

    for (size_t i = 1; i + 1 < n; i++) {
        if (vec_dot(c[i].p, rule->along) < vec_dot(c[least].p, rule->along))
            least = i;
    }
    for (size_t i = 0; i < n; i++)
        turned[i] = c[(least + i) % (n - 1)];
    for (size_t i = 0; i < n; i++)
        c[i] = turned[i];
    free(turned);
    /* Chains run as normal x n: on the upper side along, unless the normal has along on its left.
     */
    if (vec_dot(vec_cross(rule->normal, vec(0, 0, 1)), rule->along) < 0)
        contacts_reverse(c, n);
}

static void direct_chains(struct slice_chains *chains, const struct pass_options *rule)
{
    for (size_t k = 0; k < chains->chain.n; k++) {
        const struct slice_chain *chain = &chains->chain.item[k];
        struct contact *c = &chains->point.item[chain->from];
        size_t n = chain->to - chain->from;
        if (chain->closed)
            open_loop(c, n, rule);
        else if (vec_dot(vec_sub(c[n - 1].p, c[0].p), rule->along) < 0)
            contacts_reverse(c, n);
    }
}

/* The unused chain that starts least along. */
static size_t next_start(const struct slice_chains *chains, const bool *used, struct vec3 along)
{
    size_t best = chains->chain.n;
    double least = HUGE_VAL;

    for (size_t k = 0; k < chains->chain.n; k++) {
        double at = vec_dot(chains->point.item[chains->chain.item[k].from].p, along);
        if (!used[k] && at < least) {
            least = at;
            best = k;
        }
    }
    return best;
}

/* Is there a hole of the scan between two points? */
static bool is_bare(const struct pass_options *rule, struct vec3 a, struct vec3 b)
{
    double steps = rule->guard ? ceil(4 * vec_distance(a, b) / rule->bare) : 0;

    for (double i = 1; i < steps; i++)
        if (gouge_distance(rule->guard, vec_mix(a, b, i / steps), rule->bare) >= rule->bare)
            return true;
    return false;
}

/* The unused open chain with an end nearest to p, within the gap; *turned: it is its last one. */
static size_t next_joined(const struct slice_chains *chains, const bool *used, struct vec3 p,
                          const struct pass_options *rule, bool *turned)
{
    size_t best = chains->chain.n;
    double least = rule->gap;

    for (size_t k = 0; k < chains->chain.n; k++) {
        const struct slice_chain *chain = &chains->chain.item[k];
        if (used[k] || chain->closed)
            continue;
        double start = vec_distance(p, chains->point.item[chain->from].p);
        double end = vec_distance(p, chains->point.item[chain->to - 1].p);
        size_t nearest = end < start ? chain->to - 1 : chain->from;
        if (fmin(start, end) <= least && !is_bare(rule, p, chains->point.item[nearest].p)) {
            least = fmin(start, end);
            *turned = end < start;
            best = k;
        }
    }
    return best;
}

/* From the start of an open chain, or (*turned) from its last point, over the chains that join it
 * as long as there are such: the last of them, *turned when that ends with its own last point, and
 * that end.  Where they lead round to the chain it is that one. */
static size_t last_joined(const struct slice_chains *chains, const bool *used, size_t k,
                          const struct pass_options *rule, bool *turned, struct vec3 *end)
{
    const struct slice_chain *chain = &chains->chain.item[k];
    struct vec3 own = chains->point.item[*turned ? chain->to - 1 : chain->from].p;
    struct vec3 other = chains->point.item[*turned ? chain->from : chain->to - 1].p;
    bool *seen = mem_alloc(chains->chain.n, sizeof *seen), from = *turned, to = from;
    size_t last = k;

    for (size_t i = 0; i < chains->chain.n; i++)
        seen[i] = used[i];
    for (size_t next = k; next < chains->chain.n; to = !to) {
        last = next;
        *turned = to;
        seen[last] = true;
        chain = &chains->chain.item[last];
        *end = chains->point.item[to ? chain->to - 1 : chain->from].p;
        next = next_joined(chains, seen, *end, rule, &to);
    }
    free(seen);
    if (last == k || vec_distance(*end, other) > rule->gap)
        return last;
    *turned = from;
    *end = own;
    return k;
}

/* The chain with which the strip begins that holds an open one: that at its end least along, walked
 * from its last point where *turned. */
static size_t first_joined(const struct slice_chains *chains, const bool *used, size_t k,
                           const struct pass_options *rule, bool *turned)
{
    struct vec3 start, end;
    bool back = true;
    *turned = false;
    size_t first = last_joined(chains, used, k, rule, turned, &start);
    size_t last = last_joined(chains, used, k, rule, &back, &end);

    if (vec_dot(vec_sub(end, start), rule->along) >= -CROWDED)
        return first;
    *turned = back;
    return last;
}

/* Points that turn the normal from one side of a ridge to the other; none in a valley. */
static void roll_over_edge(struct slice_chains *to, size_t from, struct contact next,
                           const struct pass_options *rule)
{
    struct contact last = to->point.item[to->point.n - 1];

    if (to->point.n < from + 2)
        return;
    struct vec3 forward = vec_sub(last.p, to->point.item[to->point.n - 2].p);
    edge_roll(&to->point, forward, last, next, rule->radius, rule->tolerance);
}

/* Appends a chain to the strip that begins at point `from`. */
static void append_chain(struct slice_chains *to, size_t from, const struct contact *c, size_t n,
                         bool turned, const struct pass_options *rule)
{
    for (size_t i = 0; i < n; i++) {
        struct contact next = c[turned ? n - 1 - i : i];
        if (i == 0 && to->point.n > from) {
            struct contact last = to->point.item[to->point.n - 1];
            roll_over_edge(to, from, next, rule);
            /* One point where the surface goes on, two where it has an edge. */
            if (vec_distance(last.p, next.p) <= CROWDED && vec_angle(last.n, next.n) < 1e-3)
                continue;
        }
        *array_push(&to->point) = next;
    }
}

size_t passes_make(const struct slice_chains *chains, const struct pass_options *rule,
                   struct slice_chains *strips)
{
    struct slice_chains kept = {0};
    size_t left_out = 0;

    for (size_t k = 0; k < chains->chain.n; k++) {
        const struct slice_chain *chain = &chains->chain.item[k];
        left_out += drop_away(&chains->point.item[chain->from], *chain, rule, &kept);
    }
    direct_chains(&kept, rule);
    bool *used = mem_alloc(kept.chain.n, sizeof *used);
    for (size_t k; (k = next_start(&kept, used, rule->along)) < kept.chain.n;) {
        size_t from = strips->point.n;
        bool turned = false, closed = kept.chain.item[k].closed;
        if (!closed)
            k = first_joined(&kept, used, k, rule, &turned);
        while (k < kept.chain.n) {
            const struct slice_chain *chain = &kept.chain.item[k];
            used[k] = true;
            append_chain(strips, from, &kept.point.item[chain->from], chain->to - chain->from,
                         turned, rule);
            k = closed ? kept.chain.n
                       : next_joined(&kept, used, strips->point.item[strips->point.n - 1].p, rule,
                                     &turned);
        }
        slice_chains_end(strips, from, closed);
    }
    free(used);
    slice_chains_free(&kept);
    return left_out;
}

void passes_reverse(struct slice_chains *strips)
{
    size_t n = strips->point.n, chains = strips->chain.n;
    struct slice_chain *turned = mem_alloc(chains, sizeof *turned);

    contacts_reverse(strips->point.item, n);
    for (size_t k = 0; k < chains; k++) {
        const struct slice_chain *chain = &strips->chain.item[chains - 1 - k];
        turned[k] = (struct slice_chain){n - chain->to, n - chain->from, chain->closed};
    }
    for (size_t k = 0; k < chains; k++)
        strips->chain.item[k] = turned[k];
    free(turned);
}

struct vec3 passes_forward(const struct slice_chains *strips, size_t strip, struct vec3 normal)
{
    const struct slice_chain *chain = &strips->chain.item[strip];
    double sum =
        contacts_forward(&strips->point.item[chain->from], chain->to - chain->from, normal);

    return vec_scale(sum < 0 ? -1 : 1, normal);
}

struct vec3 passes_along(struct vec3 normal)
{
    struct vec3 along = vec_cross(normal, vec(0, 0, 1));

    return vec_length(along) > 1e-9 ? vec_unit(along) : vec(1, 0, 0);
}
