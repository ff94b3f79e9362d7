#!/usr/bin/env python3
"""Draws what tools/bench sweep --json measured: plot_sweep.py SWEEP.json OUT.svg (Debian: python3-matplotlib).

One panel a model: memory against the time of a random query, one line a depth, one mark a length of lists.
"""
import json
import sys

import matplotlib

matplotlib.use("svg")
matplotlib.rcParams["svg.hashsalt"] = "cdfr"  # the same file from the same figures
matplotlib.rcParams["svg.fonttype"] = "none"  # text stays text
matplotlib.rcParams["font.size"] = 8
import matplotlib.pyplot as plt

DEFAULT = (320, 5)


def main(source: str, target: str) -> None:
    rows = [r for r in json.load(open(source))["rows"] if "max_level" in r and "max_triangles_per_leaf" in r]
    meshes = sorted({r["mesh"] for r in rows}, key=lambda m: next(r["triangles"] for r in rows if r["mesh"] == m))
    figure, panels = plt.subplots(1, len(meshes), figsize=(3.2 * len(meshes), 3), squeeze=False)
    for panel, mesh in zip(panels[0], meshes):
        own = [r for r in rows if r["mesh"] == mesh]
        for level in sorted({r["max_level"] for r in own}):
            line = sorted((r for r in own if r["max_level"] == level), key=lambda r: r["max_triangles_per_leaf"])
            x = [r["bytes"] / r["triangles"] for r in line]
            panel.plot(x, [r["random_ns"] for r in line], "o-", markersize=3, linewidth=0.8, label=f"level {level}")
        for r in own:
            if (r["max_triangles_per_leaf"], r["max_level"]) == DEFAULT:
                panel.plot(r["bytes"] / r["triangles"], r["random_ns"], "k*", markersize=9, label="default")
        panel.axvline(400, color="grey", linewidth=0.6, linestyle=":")
        panel.set(title=f"{mesh}, {own[0]['triangles']:.0f} triangles", xlabel="bytes a triangle")
        panel.set_ylim(bottom=0)
    panels[0][0].set_ylabel("random query, ns")
    panels[0][0].legend(fontsize=6)
    figure.tight_layout()
    figure.savefig(target, metadata={"Date": None})


if __name__ == "__main__":
    main(*sys.argv[1:3])
