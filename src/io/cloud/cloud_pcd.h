/* cloud_pcd - PCD, the Point Cloud Library's files, where their data are ASCII. */
#ifndef CLOUDMILL_CLOUD_PCD_H
#define CLOUDMILL_CLOUD_PCD_H

#include "cloud_source.h"

int cloud_pcd_read(struct cloud_source *source, struct error *error);

#endif
