#include "image/whole_picture.h"

#include "load_module.h"

namespace airlight {

EncodePicture& encode_picture() {
  static EncodePicture* const function = reinterpret_cast<EncodePicture*>(
      load_from_module("airlight_openimageio", encode_picture_symbol, "pictures other than EXR need OpenImageIO"));
  return *function;
}

}  // namespace airlight
