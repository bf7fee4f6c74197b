#!/usr/bin/env python3
"""Looks up what `airlight tables` wrote: the sky's radiance and the air's transmittance in one direction.

usage: read_tables.py FOLDER VIEW_ZENITH VIEW_AZIMUTH   [degrees; azimuth from north, clockwise]
"""
import array, json, math, sys


class Tables:
    def __init__(self, folder):
        self.index = json.load(open(f"{folder}/tables.json"))
        self.texels = {}
        for name, table in self.index["tables"].items():
            self.texels[name] = array.array("f", open(f"{folder}/{table['raw']}", "rb").read())

    def lookup(self, name, column, row):
        """Linear between four texels; column and row count from 0 at the first texel's centre."""
        table, texels = self.index["tables"][name], self.texels[name]
        last_row = table["height"] * table["depth"] - 1  # slices lie one below the other
        x, y = min(int(column), table["width"] - 2), min(int(row), max(last_row - 1, 0))
        below = min(y + 1, last_row)
        at = lambda i, j, k: texels[4 * (j * table["width"] + i) + k]
        mix = lambda a, b, t: a + t * (b - a)
        return [mix(mix(at(x, y, k), at(x + 1, y, k), column - x), mix(at(x, below, k), at(x + 1, below, k), column - x), row - y) for k in range(4)]

    def transmittance(self, mu):
        """To space along a view of zenith cosine mu: table `optical_depth`; none where the ground is in the way."""
        air, h = self.index["air"], self.index["observer"]["altitude"]
        radius, top, table = air["ground_radius"], air["top_altitude"], self.index["tables"]["optical_depth"]
        if mu < self.index["dome"]["horizon"]: return None
        longest, rho = math.sqrt(top * (2 * radius + top)), math.sqrt(h * (2 * radius + h))
        along = (radius + h) * mu
        path = math.sqrt(along * along + (top - h) * (2 * radius + top + h)) - along
        u, v = (path - (top - h)) / (rho + longest - (top - h)), rho / longest
        return [math.exp(-d) for d in self.lookup("optical_depth", u * (table["width"] - 1), v * (table["height"] - 1))]

    def radiance(self, view):
        """Of the sky or the ground, the sun's disc left out [W m^-2 sr^-1 nm^-1]: tables `sky_view`, `sky_class1` and so on."""
        sun, dome, air = self.index["observer"]["sun"], self.index["dome"], self.index["air"]
        flat = lambda d: [c / max(math.hypot(d[0], d[1]), 1e-12) for c in d[:2]]
        u, above, half = 0.5 * math.dist(flat(view), flat(sun)), view[2] - dome["horizon"], dome["height"] / 2
        part = math.sqrt(abs(above) / (1 - dome["horizon"] if above >= 0 else 1 + dome["horizon"]))
        column, row = min(u, 1) * (dome["width"] - 1), part * (half - 1) + (half if above < 0 else 0)
        light, x = self.lookup("sky_view", column, row), math.dist(view, sun[:3]) / 2
        for c in range(1, int(air["classes"])):
            phase = self.lookup("phases", x * (self.index["tables"]["phases"]["width"] - 1), c)
            light = [a + b * p for a, b, p in zip(light, self.lookup(f"sky_class{c}", column, row), phase)]
        return [a * e for a, e in zip(light, air["solar_irradiance"])]


if __name__ == "__main__":
    tables, (zenith, azimuth) = Tables(sys.argv[1]), map(math.radians, map(float, sys.argv[2:4]))
    view = [math.sin(zenith) * math.sin(azimuth), math.sin(zenith) * math.cos(azimuth), math.cos(zenith)]
    print(json.dumps({"wavelengths_nm": tables.index["wavelengths_nm"], "radiance": tables.radiance(view), "transmittance": tables.transmittance(view[2])}))
