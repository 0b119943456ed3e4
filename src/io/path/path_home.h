/*
 * path_home - words that send the tool home or clear of the part: GOHOME, RETRCT, CLEARP; and those
 * that turn a table or head by themselves.
 */
#ifndef CLOUDMILL_PATH_HOME_H
#define CLOUDMILL_PATH_HOME_H

#include "path_parse.h"

/* Row of GOHOME[/x,y,z[,i,j,k]]: at rapid to there, else to where FROM was; counted as unknown when
 * that was not said. */
int path_read_gohome(struct path_parse *p);

/* Row of RETRCT: at rapid along the tool axis to the clearance plane where that is ahead; counted
 * as unknown where there is no such plane. */
int path_read_retrct(struct path_parse *p);

/* Row of CLEARP/XYPLAN,z and CLRSRF/a,b,c,d (a x + b y + c z = d) and of either with z alone. */
int path_read_clearp(struct path_parse *p);

/* Row of ROTABL and its like: by no angle it is dropped, else refused. */
int path_read_rotabl(struct path_parse *p);

#endif
