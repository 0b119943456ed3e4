/*
 * path_feed - feeds and the spindle of a path stream: FEDRAT in all its units, SPINDL, DELAY.
 */
#ifndef CLOUDMILL_PATH_FEED_H
#define CLOUDMILL_PATH_FEED_H

#include "path_parse.h"

/* Rows of these words. */
int path_read_spindle(struct path_parse *p);
int path_read_feed(struct path_parse *p);
int path_read_delay(struct path_parse *p);

/*
 * The factor that turns a feed in the unit of this word (MMPM, IPM, PERMIN, MMPR, IPR, PERREV) into
 * mm/min; 0: the word is no unit; NAN: by the turn, and the spindle's speed was not said.
 */
double path_feed_unit(const struct path_parse *p, const char *word);

/* Adds the feed that takes this motion 1 / inverse minutes, under FEDRAT/INVERS. */
void path_feed_inverse(struct path_parse *p, double length);

#endif
