/* chains - rotary axes of every kind of machine, and repeatable random numbers, for unit tests. */
#ifndef CLOUDMILL_TEST_CHAINS_H
#define CLOUDMILL_TEST_CHAINS_H

#include <stdint.h>

#include "machine/kinematics.h"

/* Work to tool, as a machine's maker would name them. */
enum {
    KIND_TABLE_AC,
    KIND_TABLE_BC,
    KIND_HEAD_TABLE,
    KIND_HEAD_HEAD,
    KIND_NUTATING_HEAD,
    KIND_NUTATING_TABLE,
    KINDS
};

/* An axis whose travel has no end. */
struct rotary rotary_of(struct vec3 axis, struct vec3 centre, bool table);

struct kinematic_chain chain_of(int kind);

/* Where the random numbers begin. */
extern uint64_t seed;

/* 0 <= x < 1 */
double chance(void);

struct vec3 random_unit(void);

#endif
