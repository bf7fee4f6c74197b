#include "image/whole_picture.h"

#include "load_module.h"

namespace airlight {

EncodePicture& encode_picture() {
  static EncodePicture* const function = reinterpret_cast<EncodePicture*>(
      load_from_module("airlight_openimageio", encode_picture_symbol, "pictures other than EXR need OpenImageIO"));
  return *function;
}

DrawText& draw_text() {
  static DrawText* const function = reinterpret_cast<DrawText*>(
      load_from_module("airlight_openimageio", draw_text_symbol, "words in pictures need OpenImageIO"));
  return *function;
}

TextWidth& text_width() {
  static TextWidth* const function = reinterpret_cast<TextWidth*>(
      load_from_module("airlight_openimageio", text_width_symbol, "words in pictures need OpenImageIO"));
  return *function;
}

}  // namespace airlight
