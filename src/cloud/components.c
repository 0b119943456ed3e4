/* components - see segment_steps.h. */
#include "segment_steps.h"

#include <stdlib.h>
#include <string.h>

enum { VOTES = 4, FEWEST = 30 };

static const double SHARP = 0.64278760968653936;  /* cos 50 degrees */
static const double FACING = 0.34202014332566873; /* cos 70 degrees */
static const double SMALL = 0.01;                 /* of the cloud, that are no part */

static bool faces_direction(const struct components *c, size_t i, int direction)
{
    return vec_dot(c->normal[i], c->direction[direction]) > FACING;
}

bool components_smooth(const struct components *c, size_t i, size_t j)
{
    return vec_dot(c->normal[i], c->normal[j]) > SHARP;
}

/* Whose label a point may take. */
enum voters { DIRECTED, SMOOTH, ANY };

/* The label that most neighbours have, of those that have one; its own where it is among these. */
static int majority_label(const struct components *c, const int *label, size_t i,
                          enum voters voters)
{
    int best = voters == DIRECTED ? label[i] : COMPONENT_NONE, most = 0;

    for (size_t k = 0; k < CLOUD_NEAR; k++) {
        size_t j = c->neighbour[i * CLOUD_NEAR + k];
        int candidate = label[j], count = 0;
        if (candidate == COMPONENT_NONE ||
            (voters == DIRECTED && !faces_direction(c, i, candidate)) ||
            (voters == SMOOTH && !components_smooth(c, i, j)))
            continue;
        for (size_t m = 0; m < CLOUD_NEAR; m++)
            count += label[c->neighbour[i * CLOUD_NEAR + m]] == candidate;
        if (count > most || (count == most && candidate == best)) {
            most = count;
            best = candidate;
        }
    }
    return best;
}

void components_settle(struct components *c)
{
    int *old = mem_alloc(c->n, sizeof *old);

    for (int turn = 0; turn < VOTES; turn++) {
        memcpy(old, c->label, c->n * sizeof *old);
        for (size_t i = 0; i < c->n; i++)
            c->label[i] = majority_label(c, old, i, DIRECTED);
    }
    free(old);
}

/* All of one label that hangs together with a point: appended to `piece`, in `of` their number. */
static void gather_connected(const struct components *c, size_t start, int number, int *of,
                             struct sizes *piece)
{
    size_t next = piece->n;

    of[start] = number;
    *array_push(piece) = start;
    while (next < piece->n) {
        size_t i = piece->item[next++];
        for (size_t k = 0; k < CLOUD_NEAR; k++) {
            size_t j = c->neighbour[i * CLOUD_NEAR + k];
            if (of[j] != COMPONENT_NONE || c->label[j] != c->label[i] ||
                !components_smooth(c, i, j))
                continue;
            of[j] = number;
            *array_push(piece) = j;
        }
    }
}

/* Pieces too small lose their number, and take one from about them. */
static void assign_rest(const struct components *c, int *of, enum voters voters)
{
    bool changed = true;
    int *old = mem_alloc(c->n, sizeof *old);

    while (changed) {
        changed = false;
        memcpy(old, of, c->n * sizeof *old);
        for (size_t i = 0; i < c->n; i++) {
            if (old[i] != COMPONENT_NONE)
                continue;
            of[i] = majority_label(c, old, i, voters);
            changed |= of[i] != COMPONENT_NONE;
        }
    }
    free(old);
}

/* Numbers the pieces of at least so many points among those that have none: each is a part. */
static void number_pieces(const struct components *c, double least, int *of, struct ints *label)
{
    int *seen = mem_alloc(c->n, sizeof *seen);
    struct sizes piece = {0};

    memcpy(seen, of, c->n * sizeof *seen);
    for (size_t i = 0; i < c->n; i++) {
        if (seen[i] != COMPONENT_NONE)
            continue;
        piece.n = 0;
        gather_connected(c, i, 0, seen, &piece);
        if ((double)piece.n < least)
            continue;
        for (size_t k = 0; k < piece.n; k++)
            of[piece.item[k]] = (int)label->n;
        *array_push(label) = c->label[i];
    }
    array_free(&piece);
    free(seen);
}

void components_find(const struct components *c, int *of, struct ints *label)
{
    for (size_t i = 0; i < c->n; i++)
        of[i] = COMPONENT_NONE;
    number_pieces(c, fmax(FEWEST, SMALL * (double)c->n), of, label);
    assign_rest(c, of, SMOOTH);
    assign_rest(c, of, ANY);
    number_pieces(c, FEWEST, of, label); /* far from all parts: islands */
}
