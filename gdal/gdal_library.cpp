// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "gdal/gdal_library.hpp"

#include <dlfcn.h>

#include <leastcost/framework/base/errors.hpp>

namespace leastcost {
namespace {

/// LEASTCOST_GDAL_FILE: the name under which programs that are linked with GDAL ask for it, "libgdal.so.32".
constexpr const char* kFile = LEASTCOST_GDAL_FILE;

[[noreturn]] void refuse_missing() {
  const char* why = ::dlerror();
  throw InputError(std::string("GDAL is needed for this file, but ") + kFile +
                   " cannot be loaded: install the GDAL that this build was made with (" +
                   (why == nullptr ? "unknown reason" : why) + ")");
}

template <class F>
void find(F*& function, void* handle, const char* name) {
  function = reinterpret_cast<F*>(::dlsym(handle, name));
  if (function == nullptr) refuse_missing();
}

void* load() {
  void* handle = ::dlopen(kFile, RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) refuse_missing();
  return handle;
}

}  // namespace

GdalLibrary::GdalLibrary(void* handle) {
  find(error_reset, handle, "CPLErrorReset");
  find(last_error_message, handle, "CPLGetLastErrorMsg");
  find(pop_error_handler, handle, "CPLPopErrorHandler");
  find(push_error_handler, handle, "CPLPushErrorHandler");
  find(quiet_error_handler, handle, "CPLQuietErrorHandler");
  find(register_all, handle, "GDALAllRegister");
  find(close, handle, "GDALClose");
  find(create, handle, "GDALCreate");
  find(driver_by_name, handle, "GDALGetDriverByName");
  find(geo_transform, handle, "GDALGetGeoTransform");
  find(mask_band, handle, "GDALGetMaskBand");
  find(raster_band, handle, "GDALGetRasterBand");
  find(raster_count, handle, "GDALGetRasterCount");
  find(raster_offset, handle, "GDALGetRasterOffset");
  find(raster_scale, handle, "GDALGetRasterScale");
  find(raster_x_size, handle, "GDALGetRasterXSize");
  find(raster_y_size, handle, "GDALGetRasterYSize");
  find(spatial_reference, handle, "GDALGetSpatialRef");
  find(open, handle, "GDALOpenEx");
  find(raster_io, handle, "GDALRasterIO");
  find(set_description, handle, "GDALSetDescription");
  find(set_geo_transform, handle, "GDALSetGeoTransform");
  find(set_no_data_value, handle, "GDALSetRasterNoDataValue");
  find(set_unit, handle, "GDALSetRasterUnitType");
  find(set_spatial_reference, handle, "GDALSetSpatialRef");
  find(translate_vectors, handle, "GDALVectorTranslate");
  find(free_translate_options, handle, "GDALVectorTranslateOptionsFree");
  find(new_translate_options, handle, "GDALVectorTranslateOptionsNew");
  find(version_info, handle, "GDALVersionInfo");
  find(destroy_transformation, handle, "OCTDestroyCoordinateTransformation");
  find(new_transformation, handle, "OCTNewCoordinateTransformation");
  find(transform, handle, "OCTTransform");
  find(clone_reference, handle, "OSRClone");
  find(destroy_reference, handle, "OSRDestroySpatialReference");
  find(export_to_wkt, handle, "OSRExportToWktEx");
  find(reference_name, handle, "OSRGetName");
  find(is_geographic, handle, "OSRIsGeographic");
  find(is_projected, handle, "OSRIsProjected");
  find(morph_from_esri, handle, "OSRMorphFromESRI");
  find(new_reference, handle, "OSRNewSpatialReference");
  find(set_axis_mapping, handle, "OSRSetAxisMappingStrategy");
  find(set_from_user_input, handle, "OSRSetFromUserInput");
  find(set_well_known_system, handle, "OSRSetWellKnownGeogCS");
  find(close_file, handle, "VSIFCloseL");
  find(file_from_buffer, handle, "VSIFileFromMemBuffer");
  find(free, handle, "VSIFree");
  find(file_buffer, handle, "VSIGetMemFileBuffer");
  find(unlink, handle, "VSIUnlink");
}

const GdalLibrary& gdal() {
  static const GdalLibrary library(load());  // the next call tries again where this one has thrown
  return library;
}

GdalSilence::GdalSilence() {
  gdal().push_error_handler(gdal().quiet_error_handler);
  gdal().error_reset();
}

GdalSilence::~GdalSilence() { gdal().pop_error_handler(); }

}  // namespace leastcost
