// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_vsi.h>
#include <gdal.h>
#include <gdal_utils.h>
#include <ogr_srs_api.h>

#include <string>

namespace leastcost {

/// Every function of GDAL that is called here.
#define LEASTCOST_GDAL_FUNCTIONS(FUNCTION)     \
  FUNCTION(CPLErrorReset)                      \
  FUNCTION(CPLGetLastErrorMsg)                 \
  FUNCTION(CPLPopErrorHandler)                 \
  FUNCTION(CPLPushErrorHandler)                \
  FUNCTION(CPLQuietErrorHandler)               \
  FUNCTION(GDALAllRegister)                    \
  FUNCTION(GDALClose)                          \
  FUNCTION(GDALGetDriverByName)                \
  FUNCTION(GDALGetGeoTransform)                \
  FUNCTION(GDALGetMaskBand)                    \
  FUNCTION(GDALGetRasterBand)                  \
  FUNCTION(GDALGetRasterCount)                 \
  FUNCTION(GDALGetRasterOffset)                \
  FUNCTION(GDALGetRasterScale)                 \
  FUNCTION(GDALGetRasterXSize)                 \
  FUNCTION(GDALGetRasterYSize)                 \
  FUNCTION(GDALGetSpatialRef)                  \
  FUNCTION(GDALOpenEx)                         \
  FUNCTION(GDALRasterIO)                       \
  FUNCTION(GDALVectorTranslate)                \
  FUNCTION(GDALVectorTranslateOptionsFree)     \
  FUNCTION(GDALVectorTranslateOptionsNew)      \
  FUNCTION(GDALVersionInfo)                    \
  FUNCTION(OCTDestroyCoordinateTransformation) \
  FUNCTION(OCTNewCoordinateTransformation)     \
  FUNCTION(OCTTransform)                       \
  FUNCTION(OSRClone)                           \
  FUNCTION(OSRDestroySpatialReference)         \
  FUNCTION(OSRGetName)                         \
  FUNCTION(OSRIsGeographic)                    \
  FUNCTION(OSRIsProjected)                     \
  FUNCTION(OSRMorphFromESRI)                   \
  FUNCTION(OSRNewSpatialReference)             \
  FUNCTION(OSRSetAxisMappingStrategy)          \
  FUNCTION(OSRSetFromUserInput)                \
  FUNCTION(OSRSetWellKnownGeogCS)              \
  FUNCTION(VSIFCloseL)                         \
  FUNCTION(VSIFileFromMemBuffer)               \
  FUNCTION(VSIGetMemFileBuffer)                \
  FUNCTION(VSIUnlink)

/// GDAL's functions under their own names: gdal().GDALOpenEx(..). Programs are not linked with GDAL, which brings a
/// hundred other libraries: loading them took longer than most paths take.
struct GdalCalls {
#define LEASTCOST_GDAL_POINTER(name) decltype(&::name) name = nullptr;
  LEASTCOST_GDAL_FUNCTIONS(LEASTCOST_GDAL_POINTER)
#undef LEASTCOST_GDAL_POINTER
};

/// Loads GDAL at the first call, and keeps it. Throws InputError where its library cannot be loaded.
const GdalCalls& gdal();
/// Why it cannot be loaded, and what to install; empty if it can be.
const std::string& gdal_fault();

/// GDAL prints its errors unless it is told otherwise, for each thread.
class QuietGdal {
 public:
  QuietGdal() {
    gdal().CPLPushErrorHandler(gdal().CPLQuietErrorHandler);
    gdal().CPLErrorReset();
  }
  ~QuietGdal() { gdal().CPLPopErrorHandler(); }
  QuietGdal(const QuietGdal&) = delete;
  QuietGdal& operator=(const QuietGdal&) = delete;
};

}  // namespace leastcost
