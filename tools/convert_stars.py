#!/usr/bin/env python3
"""Makes data/stars.csv from the star catalogue of d3-celestial.

usage: convert_stars.py stars.6.json > stars.csv

The input is data/stars.6.json of the npm package d3-celestial: GeoJSON points, longitude being the right ascension, east positive.
"""
import json
import sys


def main():
    features = json.load(open(sys.argv[1], encoding="utf-8"))["features"]
    print("# Stars to magnitude 6: https://github.com/ofrohn/d3-celestial, data/stars.6.json, after the Hipparcos catalogue.")
    print("# Copyright (c) 2015, Olaf Frohn; BSD-3-Clause, see data/stars.LICENSE. Missing colours stand as 0.5.")
    print("right_ascension_deg,declination_deg,v_magnitude,b_v")
    for star in sorted(features, key=lambda f: f["properties"]["mag"]):
        ascension, declination = star["geometry"]["coordinates"]
        print(f"{ascension % 360:.4f},{declination:.4f},{star['properties']['mag']:.2f},{float(star['properties'].get('bv') or 0.5):.3f}")


if __name__ == "__main__":
    main()
