#!/usr/bin/env python3
"""Adds up the light along one view from what `airlight tables --model precomputed` wrote: all orders of scattering.

usage: read_precomputed.py FOLDER VIEW_ZENITH VIEW_AZIMUTH   [degrees; azimuth from north, clockwise]
"""
import json, math, sys
from read_tables import Tables

STEPS = 400  # along the view, crowded at the observer


class Precomputed(Tables):
    def __init__(self, folder):
        super().__init__(folder)
        self.air, self.lattice = self.index["air"], self.index["lattice"]
        self.radius, self.top, self.classes = self.air["ground_radius"], self.air["top_altitude"], int(self.air["classes"])

    def coefficients(self, h):
        """Row 0: extinction, then the scattering of each phase class [1/m]; linear inside a cell of a zone."""
        zones = self.texels["zones"]
        at = next(i for i in reversed(range(int(self.air["zones"]))) if h >= zones[4 * i] or i == 0)
        bottom, _, per_height, number = zones[4 * at : 4 * at + 4]
        cell = (number + min(max((h - bottom) * per_height, 0), 0.999999)) * self.air["cells"]
        first = int(cell)
        return [self.lookup("profile", 2 * first + (cell - first), row) for row in range(1 + self.classes)]

    def sunlight(self, h, mu_s):
        """Part of the sun's light that arrives: table `sunlight`, over the direction of the disc's upper limb."""
        s = self.air["sun_radius"]
        mu = 1 if mu_s > 1 - s * s / 2 else mu_s + s * (math.sqrt(max(1 - mu_s * mu_s, 0)) - s * mu_s / 2)
        if mu <= -math.sqrt(h * (2 * self.radius + h)) / (self.radius + h): return [0] * 4
        longest, rho = math.sqrt(self.top * (2 * self.radius + self.top)), math.sqrt(h * (2 * self.radius + h))
        path, nearest = self.to_shell(h, mu, self.top), self.top - h
        return [math.exp(-d) for d in self.mapped("sunlight", (path - nearest) / max(rho + longest - nearest, 1e-3), rho / longest)]

    def source(self, h, mu, mu_s, nu):
        """Light of the second order and higher that a unit of air sends into a direction: table `source`, between two altitudes."""
        l, u = self.lattice, self.sun_place(mu_s) * (self.lattice["suns"] - 1)
        across = math.sqrt(max(1 - mu * mu, 0)) * math.sqrt(max(1 - mu_s * mu_s, 0))
        w = math.acos(min(max((nu - mu * mu_s) / max(across, 1e-6), -1), 1)) / math.pi * (l["azimuths"] - 1)
        zenith = math.acos(min(max(mu, -1), 1)) / math.pi * (l["zeniths"] - 1)
        root = math.sqrt(min(max(h / self.top, 0), 1))
        place = 3 * root / (root + 2) * (l["altitudes"] - 1)
        band, slice = min(int(place), int(l["altitudes"]) - 2), min(int(w), int(l["azimuths"]) - 2)
        row = lambda b, s: self.lookup("source", u, s * self.index["tables"]["source"]["height"] + b * l["zeniths"] + zenith)
        mix = lambda a, b, t: [x + t * (y - x) for x, y in zip(a, b)]
        at = lambda b: mix(row(b, slice), row(b, slice + 1), w - slice)
        return [math.exp(-d) for d in mix(at(band), at(band + 1), place - band)]

    def radiance(self, view):
        """[W m^-2 sr^-1 nm^-1], the sun's disc left out."""
        sun, h0, r0 = self.index["observer"]["sun"], self.index["observer"]["altitude"], self.radius + self.index["observer"]["altitude"]
        nu, x = sum(a * b for a, b in zip(view, sun)), math.dist(view, sun[:3]) / 2
        phase = [self.mapped("phases", x, c) for c in range(self.classes)]
        ground = view[2] < -math.sqrt(h0 * (2 * self.radius + h0)) / r0
        reach = self.to_ground(h0, view[2]) if ground else self.to_shell(h0, view[2], self.top)
        light, depth = [0.0] * 4, [0.0] * 4
        for i in range(STEPS):
            path, length = reach * ((i + 0.5) / STEPS) ** 2, reach * (2 * i + 1) / STEPS**2
            gap = path * path + 2 * path * r0 * view[2] + h0 * (2 * self.radius + h0)  # of squared radii, above the ground's
            h = gap / (self.radius + math.sqrt(self.radius**2 + gap))
            mu, mu_s = (r0 * view[2] + path) / (self.radius + h), (r0 * sun[2] + path * nu) / (self.radius + h)
            extinction, *scattering = self.coefficients(h)
            lit, sent = self.sunlight(h, mu_s), self.source(h, mu, mu_s, nu)
            for k in range(4):
                step = extinction[k] * length
                through = math.exp(-depth[k]) * (-math.expm1(-step) / extinction[k] if step > 1e-9 else length)
                light[k] += through * sum(s[k] * (p[k] * lit[k] + sent[k]) for s, p in zip(scattering, phase))
                depth[k] += step
        if ground:
            mu_s = (r0 * sun[2] + reach * nu) / self.radius
            others = self.lookup("ground_light", self.sun_place(mu_s) * (self.index["tables"]["ground_light"]["width"] - 1), 0)
            for k, direct in enumerate(self.sunlight(0, mu_s)):
                arriving = direct * max(mu_s, 0) + math.exp(-others[k])
                light[k] += math.exp(-depth[k]) * arriving * self.air["albedo"][k] / math.pi
        return [a * e for a, e in zip(light, self.air["solar_irradiance"])]

    def mapped(self, name, u, v):
        """Where u runs from 0 to 1; v too, or is a row of `phases`."""
        table = self.index["tables"][name]
        return self.lookup(name, min(max(u, 0), 1) * (table["width"] - 1), v if name == "phases" else min(max(v, 0), 1) * (table["height"] - 1))

    def sun_place(self, mu_s):
        """Place among the suns of the tables, 0 to 1: crowded about the horizon, from 25 degrees below it."""
        last = 0.42 * min(1, math.sqrt(6.4e6 / self.radius))
        down = min(-mu_s, last)
        return 0.55 * (1 - 17 * down / (7 * down + 10 * last)) if mu_s < 0 else 0.55 + 0.585 * mu_s / (mu_s + 0.3)

    def to_shell(self, h, mu, shell):
        b = (self.radius + h) * mu
        gap = (shell - h) * (2 * self.radius + shell + h)
        return gap / (b + math.sqrt(b * b + gap)) if mu > 0 else math.sqrt(b * b + gap) - b

    def to_ground(self, h, mu):
        b = (self.radius + h) * mu
        gap = h * (2 * self.radius + h)
        return gap / (math.sqrt(max(b * b - gap, 0)) - b)


if __name__ == "__main__":
    tables, (zenith, azimuth) = Precomputed(sys.argv[1]), map(math.radians, map(float, sys.argv[2:4]))
    view = [math.sin(zenith) * math.sin(azimuth), math.sin(zenith) * math.cos(azimuth), math.cos(zenith)]
    print(json.dumps({"wavelengths_nm": tables.index["wavelengths_nm"], "radiance": tables.radiance(view)}))
