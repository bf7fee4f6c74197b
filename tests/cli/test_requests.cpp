// The line parsers alone: they answer every text with a request or an error, and never throw.
#include <gtest/gtest.h>

#include <cmath>

#include "batch_plane_parallel.h"
#include "batch_request.h"
#include "eval_request.h"
#include "number.h"

namespace airlight::cli {
namespace {

const Topic otherwise{"earth", "skyview", nullptr, {}, 0};

TEST(BatchRequest, reads_every_key) {
  const auto request = parse_batch_request(
      R"({"id":"a","atmosphere":"mars-clear","model":"single","quantity":"path_radiance","altitude":12.5,"view_zenith":90,)"
      R"("view_azimuth":90,"sun_zenith":60,"sun_azimuth":0,"distance":1e4,"wavelengths":[440,550.5],"max_order":1})",
      otherwise);
  ASSERT_EQ(request.error, "");
  EXPECT_EQ(request.id, "a");
  EXPECT_EQ(request.topic.atmosphere, "mars-clear");
  EXPECT_EQ(request.topic.model, "single");
  EXPECT_EQ(request.topic.asked->name, "path_radiance");
  EXPECT_EQ(request.topic.wavelengths, (std::vector<double>{440, 550.5}));
  EXPECT_EQ(request.topic.max_order, 1);
  EXPECT_EQ(request.ray.altitude, 12.5);
  EXPECT_EQ(request.ray.distance, 1e4);
  // East along the horizon; the sun north and 30 degrees up. 1e-15: rounding of pi.
  EXPECT_NEAR(request.ray.view[0], 1, 1e-15);
  EXPECT_EQ(request.ray.view[2], 0);
  EXPECT_NEAR(request.ray.sun[1], std::sqrt(0.75), 1e-15);
  EXPECT_NEAR(request.ray.sun[2], 0.5, 1e-15);
}

TEST(BatchRequest, what_a_line_leaves_out) {
  const auto request =
      parse_batch_request(R"({"quantity":"luminance","view_zenith":0,"sun_zenith":0,"distance":null})", otherwise);
  ASSERT_EQ(request.error, "");
  EXPECT_TRUE(request.id.is_null());
  EXPECT_EQ(request.topic.atmosphere, "earth");
  EXPECT_EQ(request.topic.model, "skyview");
  EXPECT_TRUE(request.topic.wavelengths.empty());
  EXPECT_TRUE(std::isinf(request.ray.distance));
  EXPECT_EQ(request.ray.altitude, 0);
}

TEST(BatchRequest, bad_lines_keep_their_id_and_say_why) {
  struct Bad {
    std::string text, id, fragment;
  };
  const std::string start = R"({"id":"x","quantity":"radiance","sun_zenith":60,)";
  for (const auto& [text, id, fragment] : {
           Bad{"", "", "not JSON"},
           Bad{"[]", "", "object"},
           Bad{"17", "", "object"},
           Bad{"{\"id\":\"x\"", "x", "not JSON"},
           Bad{"{\"id\":\"x\",\"id\":\"y\"}", "x", "twice"},
           Bad{"{\"id\":[1]}", "", "id = an array"},
           Bad{"{\"id\":\"x\",\"a\":\"\xff\"}", "x", "UTF-8"},
           Bad{std::string(R"({"id":"x","a":)") + std::string(5000, '[') + std::string(5000, ']') + "}", "x", "deeper"},
           Bad{R"({"id":"x"})", "x", "quantity: missing"},
           Bad{R"({"id":"x","quantity":7})", "x", "quantity = 7: expected a string"},
           Bad{R"({"id":"x","quantity":"radience"})", "x", "did you mean radiance?"},
           Bad{start + R"("wavelengths":[500]})", "x", "view_zenith: missing"},
           Bad{start + R"("view_zenith":10})", "x", "wavelengths: missing"},
           Bad{R"({"id":"x","quantity":"sky_irradiance","wavelengths":[500]})", "x", "sun_zenith: missing"},
           Bad{start + R"("view_zenith":181,"wavelengths":[500]})", "x",
               "view_zenith = 181: expected 0 .. 180 degrees"},
           Bad{start + R"("view_zenith":"10","wavelengths":[500]})", "x", "view_zenith = \"10\""},
           Bad{start + R"("view_zenith":NaN,"wavelengths":[500]})", "x", "not JSON"},
           Bad{start + R"("view_zenith":1e999,"wavelengths":[500]})", "x", "number overflow"},
           Bad{start + R"("view_zenith":null,"wavelengths":[500]})", "x", "view_zenith = null"},
           Bad{start + R"("view_zenith":10,"wavelengths":[]})", "x", "wavelengths"},
           Bad{start + R"("view_zenith":10,"wavelengths":500})", "x", "wavelengths = 500: expected an array"},
           Bad{start + R"("view_zenith":10,"wavelengths":[500,"b"]})", "x", "wavelengths[1] = \"b\""},
           Bad{start + R"("view_zenith":10,"wavelengths":[500],"distance":-1})", "x", "distance = -1"},
           Bad{start + R"("view_zenith":10,"wavelengths":[500],"altitude":1e300})", "x", "altitude = 1e+300"},
           Bad{start + R"("view_zenith":10,"wavelengths":[500],"max_order":1.5})", "x", "max_order = 1.5"},
           Bad{start + R"("view_zenith":10,"wavelengths":[500],"max_order":-1})", "x", "max_order = -1"},
           Bad{start + R"("view_zenith":10,"wavelengths":[500],"max_order":99999999999999999999})", "x", "max_order"},
           Bad{start + R"("view_zenith":10,"wavelenghts":[500],"wavelengths":[500]})", "x",
               "did you mean wavelengths?"},
           Bad{R"({"id":"x","quantity":"luminance","view_zenith":0,"sun_zenith":0,"wavelengths":[550]})", "x",
               "at least 2"},
           Bad{R"({"id":"x","quantity":"luminance","view_zenith":0,"sun_zenith":0,"wavelengths":[550,440]})", "x",
               "wavelengths[1] = 440"},
       }) {
    SCOPED_TRACE(text.substr(0, 120));
    const auto request = parse_batch_request(text, otherwise);
    EXPECT_NE(request.error.find(fragment), std::string::npos) << request.error;
    EXPECT_EQ(request.id, id.empty() ? nlohmann::json() : nlohmann::json(id));
  }
}

TEST(BatchRequest, reads_plane_parallel_air) {
  const auto request = parse_batch_request(
      R"({"id":1,"model":"plane-parallel","quantity":"radiance","layers":[{"scattering_optical_depth":0.1,)"
      R"("absorption_optical_depth":0.02,"phase":{"type":"rayleigh","depolarisation":0.03}},{"parts":[)"
      R"({"scattering_optical_depth":0.2,"phase":{"type":"double-henyey-greenstein","g1":0.8,"g2":-0.3,"weight":0.9}},)"
      R"({"absorption_optical_depth":0.3},{"scattering_optical_depth":0.4,"absorption_optical_depth":0.5,)"
      R"("phase":{"type":"table","angles":[0,180],"values":[7,7]}}]}],"surface_albedo":0.25,"observer":"space",)"
      R"("view_zenith":120,"sun_zenith":30})",
      otherwise);
  ASSERT_EQ(request.error, "");
  EXPECT_EQ(request.topic.atmosphere, "");
  EXPECT_TRUE(request.topic.wavelengths.empty());
  const auto [air, from_space] = parse_plane_parallel(request.topic.own);
  EXPECT_TRUE(from_space);
  EXPECT_EQ(air.surface_albedo, 0.25);
  ASSERT_EQ(air.layers.size(), 2u);
  ASSERT_EQ(air.layers[0].scatterers.size(), 1u);
  EXPECT_EQ(air.layers[0].scatterers[0].optical_depth, 0.1);
  EXPECT_EQ(air.layers[0].scatterers[0].phase, Phase(RayleighPhase{0.03}));
  EXPECT_EQ(air.layers[0].absorption_optical_depth, 0.02);
  ASSERT_EQ(air.layers[1].scatterers.size(), 2u);
  EXPECT_EQ(air.layers[1].scatterers[0].phase, Phase(DoubleHenyeyGreensteinPhase{0.8, -0.3, 0.9}));
  EXPECT_EQ(air.layers[1].absorption_optical_depth, 0.8);
  // Equal everywhere: 1 / (4 pi). 1e-15: rounding.
  const auto& table = std::get<TablePhase>(air.layers[1].scatterers[1].phase);
  EXPECT_NEAR(table.angles[1], 3.141592653589793, 1e-15);
  EXPECT_NEAR(table.values[0], 0.07957747154594767, 1e-15);
}

TEST(BatchRequest, bad_plane_parallel_air_is_named) {
  const auto error = [](const std::string& keys) {
    return parse_batch_request(R"({"model":"plane-parallel","quantity":"radiance","view_zenith":10,)" + keys + "}",
                               otherwise)
        .error;
  };
  const std::string air = R"("layers":[{"scattering_optical_depth":1,"phase":{"type":"isotropic"}}],)";
  const std::string sun = R"("sun_zenith":30)";
  EXPECT_EQ(error(air + sun), "");
  struct Bad {
    std::string keys, fragment;
  };
  for (const auto& [keys, fragment] : {
           Bad{sun, "layers: missing"},
           Bad{R"("layers":{},)" + sun, "layers = an object: expected an array of 1 .. 1000 objects"},
           Bad{R"("layers":[],)" + sun, "layers = an array"},
           Bad{R"("layers":[3],)" + sun, "layers[0] = 3: expected an object"},
           Bad{R"("layers":[{"scattering_optical_depth":1}],)" + sun, "layers[0].phase: missing"},
           Bad{R"("layers":[{"scattering_optical_depth":-1}],)" + sun, "layers[0].scattering_optical_depth = -1"},
           Bad{R"("layers":[{"scatering_optical_depth":1}],)" + sun, "did you mean scattering_optical_depth?"},
           Bad{R"("layers":[{"parts":[{"phase":{"type":"raleigh"}}]}],)" + sun,
               "layers[0].parts[0].phase.type = raleigh: unknown phase function; did you mean rayleigh?"},
           Bad{R"("layers":[{"parts":[{}],"phase":{"type":"rayleigh"}}],)" + sun, "layers[0].phase: unknown key"},
           Bad{R"("layers":[{"phase":{"type":"henyey-greenstein"}}],)" + sun, "layers[0].phase.g: missing"},
           Bad{R"("layers":[{"phase":{"type":"henyey-greenstein","g":1}}],)" + sun, "layers[0].phase.g = 1: expected"},
           Bad{R"("layers":[{"phase":{"type":"henyey-greenstein","g":0.5,"f":1}}],)" + sun, "layers[0].phase.f"},
           Bad{R"("layers":[{"phase":{"type":"table","angles":[0,90],"values":[1,1]}}],)" + sun, "layers[0].phase"},
           Bad{R"("layers":[{"phase":{"type":"table","angles":[0,180],"values":[1]}}],)" + sun, "as many values"},
           Bad{R"("layers":[{"phase":{"type":"table","angles":[],"values":[1]}}],)" + sun, "layers[0].phase.angles"},
           Bad{R"("layers":[{"phase":"rayleigh"}],)" + sun, "layers[0].phase = \"rayleigh\": expected an object"},
           Bad{air + R"("surface_albedo":2,)" + sun, "surface_albedo = 2: expected 0 .. 1"},
           Bad{air + R"("observer":"spce",)" + sun, "did you mean space?"},
           Bad{air + R"("altitude":0,)" + sun, "altitude: unknown key"},
           Bad{air + R"("sun_zenith":90)", "sun_zenith = 90: expected 0 up to less than 90 degrees"},
       }) {
    SCOPED_TRACE(keys);
    EXPECT_NE(error(keys).find(fragment), std::string::npos) << error(keys);
  }
}

TEST(EvalRequest, numbers_that_json_lacks_are_strings) {
  for (const char* text : {"\"nan\"", "\"inf\"", "\"-inf\""}) {
    const auto request = parse_eval_request(
        std::string(R"({"id":1,"fn":"core.phase_rayleigh","inputs":{"one_minus_cos":)") + text + "}}", {});
    ASSERT_EQ(request.error, "");
    ASSERT_EQ(request.varying.size(), 1u);
    EXPECT_FALSE(std::isfinite(request.varying[0]));
    EXPECT_EQ(eval_answer(request, request.varying).dump(), std::string(R"({"id":1,"value":[)") + text + "]}");
  }
}

TEST(EvalRequest, bad_lines_keep_their_id_and_say_why) {
  struct Bad {
    std::string text, fragment;
  };
  for (const auto& [text, fragment] : {
           Bad{R"({"id":1})", "fn: missing"},
           Bad{R"({"id":1,"fn":3})", "fn = 3"},
           Bad{R"({"id":1,"fn":"core.phase_raleigh"})", "did you mean core.phase_rayleigh?"},
           Bad{R"({"id":1,"fn":"core.phase_rayleigh"})", "inputs.one_minus_cos: missing"},
           Bad{R"({"id":1,"fn":"core.phase_rayleigh","inputs":[1]})", "inputs = an array"},
           Bad{R"({"id":1,"fn":"core.phase_rayleigh","inputs":{"one_minus_cos":"x"}})", "inputs.one_minus_cos = \"x\""},
           Bad{R"({"id":1,"fn":"core.phase_rayleigh","inputs":{"one_minus_cos":[1]}})",
               "inputs.one_minus_cos = an array"},
           Bad{R"({"id":1,"fn":"core.phase_rayleigh","inputs":{"one_minus_cos":1,"g":2}})", "inputs.g: unknown key"},
           Bad{R"({"id":1,"fn":"core.phase_rayleigh","input":{"one_minus_cos":1}})", "did you mean inputs?"},
           Bad{R"({"id":1,"fn":"core.one_minus_cos","inputs":{"a":[1,0],"b":[0,0,1]}})",
               "inputs.a = an array of 2: expected an array of 3"},
       }) {
    SCOPED_TRACE(text);
    const auto request = parse_eval_request(text, {});
    EXPECT_NE(request.error.find(fragment), std::string::npos) << request.error;
    EXPECT_EQ(request.id, 1);
  }
}

TEST(Wavelengths, lists_and_ranges) {
  EXPECT_EQ(parse_wavelengths("550", "w"), std::vector<double>{550});
  EXPECT_EQ(parse_wavelengths("440,550.5,680", "w"), (std::vector<double>{440, 550.5, 680}));
  EXPECT_EQ(parse_wavelengths("400:700:100", "w"), (std::vector<double>{400, 500, 600, 700}));
  EXPECT_EQ(parse_wavelengths("400:699:100", "w").size(), 3u);
  EXPECT_EQ(parse_wavelengths("400:400.3:0.1", "w").size(), 4u);  // 0.3 / 0.1 rounds to just below 3
}

}  // namespace
}  // namespace airlight::cli
