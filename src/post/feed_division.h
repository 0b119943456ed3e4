/*
 * feed_division - where to divide a motion of one feed, so that its slow parts do not slow the
 * rest.
 */
#ifndef CLOUDMILL_FEED_DIVISION_H
#define CLOUDMILL_FEED_DIVISION_H

#include <stddef.h>

/* A span of the motion: where it ends (s), how long it is, mm, and what a mm of it takes at least,
 * minutes. */
struct feed_span {
    double s, length, rate;
};

struct feed_spans {
    size_t n, cap;
    struct feed_span *item;
};

/*
 * The s of the first place of one or of two where the feed changes, each part at the rate of its
 * slowest span: the one place that saves most, or, where it saves too little, the two that do, for
 * a motion may be slow at both ends.  1: less than a tenth of the time is saved, or than 0.2
 * seconds for a place.  Two are looked for among no more than 256 even groups of spans.
 */
double feed_division(const struct feed_spans *spans);

#endif
