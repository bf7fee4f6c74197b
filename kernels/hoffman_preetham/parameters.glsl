#pragma once
// Hoffman & Preetham, "Rendering Outdoor Light Scattering in Real Time", Game Developers Conference 2002. Colours are taken at one
// wavelength a channel: red 650, green 570, blue 475 nm. Radiance is relative to the sunlight outside the air.

struct HoffmanPreetham {
  Scalar4 beta_rayleigh;     // [1/m] in 0..5e-4  scattering coefficient of molecules
  Scalar4 beta_mie;          // [1/m] in 0..5e-3  scattering coefficient of aerosols
  Scalar4 beta_absorption;   // [1/m] in 0..1e-3  absorption coefficient; the authors set 0
  Scalar4 solar_irradiance;  // [1] in 0..1e3     sunlight outside the air
  Scalar4 fog_colour;        // [1/sr] in 0..1e3  radiance of the fog that is compared
  Scalar g;                  // [1] in -0.999..0.999  of Henyey and Greenstein in the authors' sign: negative is forward
  Scalar printed;            // [1] in 0..1   1: the numerator (1 - g)^2 as printed, which does not integrate to 1
  Scalar dome_sunlight;      // [1] in 0..1   0: clear-sky attenuation of Preetham, Shirley & Smits 1999; 1: through the dome
  Scalar turbidity;          // [1] in 1..20  of the clear-sky attenuation
  Scalar ozone;              // [1] in 0..1   1: with 0.35 cm of ozone
  Scalar per_species;        // [1] in 0..1   1: aerosols have a dome of their own
  Scalar inscatter_scale;    // [1] in 0..4   a study's multiplier; should be 1
  Scalar extinction_scale;   // [1] in 0..4   a study's multiplier; should be 1
  Scalar rayleigh_height;    // [m] in 500..16000   the dome of molecules: height / (cos + a (b - degrees)^-c)
  Scalar rayleigh_a;         // [1] in 0.01..2
  Scalar rayleigh_b;         // [degrees] in 91..120
  Scalar rayleigh_c;         // [1] in 1..3
  Scalar mie_height;         // [m] in 500..16000   the dome of aerosols
  Scalar mie_a;              // [1] in 0.01..2
  Scalar mie_b;              // [degrees] in 91..120
  Scalar mie_c;              // [1] in 1..3
  Scalar fog_density;        // [1/m] in 0..1e-3
  Scalar show;               // [1] in 0..5   0: all; 1: L0, 2: F_ex, 3: L0 F_ex, 4: L_in, 5: fog in place of scattering
  Scalar clamp8bit;          // [1] in 0..1   1: both terms as 8-bit colours, as the hardware of 2002 kept them
  Scalar exposure;           // [1] in 0.01..1e3  display value of a radiance of 1, for clamp8bit
  Scalar ambient;            // [1] in 0..4   part of the sky's light that reaches the land; the authors have none
  Scalar pad0;               // [1] in 0..1
  Scalar pad1;               // [1] in 0..1
  Scalar pad2;               // [1] in 0..1
};
