/* reading - what the unit tests of a control's words as read share: the state that they change. */
#ifndef CLOUDMILL_TEST_READING_H
#define CLOUDMILL_TEST_READING_H

#include "base/array.h"
#include "ncread/ncread_state.h"

static struct ncread_options options;
static struct nc_motion motion;
static struct ncread c;
static struct error error;

/* Before the first line of a program for a Fanuc, of which nothing is known. */
static inline void reading_begin(void)
{
    options = (struct ncread_options){.dialect = &ncread_fanuc};
    motion = (struct nc_motion){0};
    c = (struct ncread){.options = &options, .motion = &motion, .name = "p.nc"};
}

static inline void reading_end(void)
{
    array_free(&c.words);
    nc_motion_free(&motion);
}

#endif
