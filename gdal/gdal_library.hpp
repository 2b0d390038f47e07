// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_vsi.h>
#include <gdal.h>
#include <gdal_utils.h>
#include <ogr_srs_api.h>

#include <memory>
#include <string>

namespace leastcost {

/// The functions of GDAL that we call. GDAL stands on about a hundred shared libraries, which take longer to load than
/// all others together: it is loaded when a function of it is first asked for, not when the program starts.
struct GdalLibrary {
  /// Of what dlopen() returned. Throws InputError for one that lacks a function.
  explicit GdalLibrary(void* handle);

  decltype(::CPLErrorReset)* error_reset = nullptr;
  decltype(::CPLGetLastErrorMsg)* last_error_message = nullptr;
  decltype(::CPLPopErrorHandler)* pop_error_handler = nullptr;
  decltype(::CPLPushErrorHandler)* push_error_handler = nullptr;
  decltype(::CPLQuietErrorHandler)* quiet_error_handler = nullptr;
  decltype(::GDALAllRegister)* register_all = nullptr;
  decltype(::GDALClose)* close = nullptr;
  decltype(::GDALCreate)* create = nullptr;
  decltype(::GDALGetDriverByName)* driver_by_name = nullptr;
  decltype(::GDALGetGeoTransform)* geo_transform = nullptr;
  decltype(::GDALGetMaskBand)* mask_band = nullptr;
  decltype(::GDALGetRasterBand)* raster_band = nullptr;
  decltype(::GDALGetRasterCount)* raster_count = nullptr;
  decltype(::GDALGetRasterOffset)* raster_offset = nullptr;
  decltype(::GDALGetRasterScale)* raster_scale = nullptr;
  decltype(::GDALGetRasterXSize)* raster_x_size = nullptr;
  decltype(::GDALGetRasterYSize)* raster_y_size = nullptr;
  decltype(::GDALGetSpatialRef)* spatial_reference = nullptr;
  decltype(::GDALOpenEx)* open = nullptr;
  decltype(::GDALRasterIO)* raster_io = nullptr;
  decltype(::GDALSetDescription)* set_description = nullptr;
  decltype(::GDALSetGeoTransform)* set_geo_transform = nullptr;
  decltype(::GDALSetRasterNoDataValue)* set_no_data_value = nullptr;
  decltype(::GDALSetRasterUnitType)* set_unit = nullptr;
  decltype(::GDALSetSpatialRef)* set_spatial_reference = nullptr;
  decltype(::GDALVectorTranslate)* translate_vectors = nullptr;
  decltype(::GDALVectorTranslateOptionsFree)* free_translate_options = nullptr;
  decltype(::GDALVectorTranslateOptionsNew)* new_translate_options = nullptr;
  decltype(::GDALVersionInfo)* version_info = nullptr;
  decltype(::OCTDestroyCoordinateTransformation)* destroy_transformation = nullptr;
  decltype(::OCTNewCoordinateTransformation)* new_transformation = nullptr;
  decltype(::OCTTransform)* transform = nullptr;
  decltype(::OSRClone)* clone_reference = nullptr;
  decltype(::OSRDestroySpatialReference)* destroy_reference = nullptr;
  decltype(::OSRExportToWktEx)* export_to_wkt = nullptr;
  decltype(::OSRGetName)* reference_name = nullptr;
  decltype(::OSRIsGeographic)* is_geographic = nullptr;
  decltype(::OSRIsProjected)* is_projected = nullptr;
  decltype(::OSRMorphFromESRI)* morph_from_esri = nullptr;
  decltype(::OSRNewSpatialReference)* new_reference = nullptr;
  decltype(::OSRSetAxisMappingStrategy)* set_axis_mapping = nullptr;
  decltype(::OSRSetFromUserInput)* set_from_user_input = nullptr;
  decltype(::OSRSetWellKnownGeogCS)* set_well_known_system = nullptr;
  decltype(::VSIFCloseL)* close_file = nullptr;
  decltype(::VSIFileFromMemBuffer)* file_from_buffer = nullptr;
  decltype(::VSIFree)* free = nullptr;
  decltype(::VSIGetMemFileBuffer)* file_buffer = nullptr;
  decltype(::VSIUnlink)* unlink = nullptr;
};

/// GDAL, loaded with the first call and never unloaded. Throws InputError where the one of the build is not installed.
const GdalLibrary& gdal();

/// GDAL prints its errors unless it is told otherwise, for each thread.
class GdalSilence {
 public:
  GdalSilence();
  ~GdalSilence();
  GdalSilence(const GdalSilence&) = delete;
  GdalSilence& operator=(const GdalSilence&) = delete;
};

struct CloseGdalDataset {
  void operator()(void* dataset) const { gdal().close(dataset); }
};
using GdalDataset = std::unique_ptr<void, CloseGdalDataset>;

}  // namespace leastcost
