#!/usr/bin/env python3
"""Sets what bench_tables measured beside the papers' figures: draw_tables.py FOLDER (Debian: python3-matplotlib).

Reads the FOLDER's .csv files and papers/; writes README.md and two plots there.
"""
import csv
import os
import statistics
import sys

import matplotlib

matplotlib.use("svg")
matplotlib.rcParams["svg.hashsalt"] = "cdfr"  # the same file from the same figures
matplotlib.rcParams["svg.fonttype"] = "none"  # text stays text
matplotlib.rcParams["font.size"] = 8
import matplotlib.pyplot as plt

PAPERS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "papers")
WAYS = ["uniform", "octree-band", "octree-own", "octree", "default"]
MADE = ["cube", "tetrahedron", "one-tooth", "six-star", "connector", "brevi"]
SHORT = {"kcl_focusrite-scarlett-mounting-bracket_d3_a60": "bracket (real)", "NIST_MBE_PMI_1_d3_a40": "NIST 1 (real)",
         "head_res222": "head (real)"}


def read(folder: str, name: str) -> list:
    with open(os.path.join(folder, name), newline="") as file:
        return list(csv.DictReader(file))


def figure(text, digits=3) -> str:
    """As many digits as say something."""
    if text in ("", None):
        return ""
    value = float(text)
    if value == int(value) and abs(value) < 1e15:
        return f"{int(value):,}"
    return f"{value:,.0f}" if abs(value) >= 1000 else f"{value:.{digits}g}"


def table(header: list, rows: list) -> str:
    lines = ["| " + " | ".join(header) + " |", "|" + " --- |" * len(header)]
    return "\n".join(lines + ["| " + " | ".join(str(c) for c in row) + " |" for row in rows]) + "\n"


def short(part: str) -> str:
    return SHORT.get(part, part)


def find(rows: list, **wanted) -> dict:
    return next((r for r in rows if all(r[k] == str(v) for k, v in wanted.items())), {})


def ratio(a, b) -> str:
    return figure(float(a) / float(b)) if a and b and float(b) > 0 else ""


def paper_fields() -> list:
    """Rows of tables 2 to 4 under the names of ours; counts in voxels, not thousands."""
    rows = []
    for number in ("2", "3", "4"):
        for r in read(os.path.join(PAPERS, "huang-2001"), f"table-{number}.csv"):
            resolution = max(int(r[f"resolution_{axis}"]) for axis in "xyz")
            rows.append({"part": r["model"], "resolution": str(resolution), "way": "paper",
                         "inside": str(float(r["inside_kvoxels"]) * 1000), "surface": str(float(r["surface_kvoxels"]) * 1000),
                         "outside": str(float(r["outside_kvoxels"]) * 1000), "surface_mean": r["surface_mean_triangles"],
                         "inside_mean": r["inside_mean_triangles"], "stated_kb": r["size_kb"], "real_mb": "", "grid": " x ".join(r[f"resolution_{axis}"] for axis in "xyz"),
                         "build_ms": str(float(r["time_s"]) * 1000)})
    return rows


def parts_section(folder: str) -> str:
    rows = [[short(r["part"]), ("over " if r["part"] == "engine" else "") + figure(r["paper_triangles"]), figure(r["triangles"]),
             " x ".join(figure(r[f"paper_{a}"]) for a in "xyz") if r["paper_x"] else "",
             " x ".join(figure(r[a]) for a in "xyz"), figure(r["paper_depth"]), figure(r["depth"], 4)]
            for r in read(folder, "table-1.csv")]
    return ("## Table 1: the parts\n\nInches; cylinder head and engine in millimetres, the real parts in their own unit. The paper's head is printed as 266 x 480 "
            "x 157 cm (papers/huang-2001/README.md). Our depths are lower bounds, good to a thousandth.\n\n") + table(
        ["part", "triangles: paper", "ours", "box: paper", "ours", "greatest depth: paper", "ours"], rows)


def field_rows(fields: list, part: str, resolution: str) -> list:
    rows = []
    for way in ["paper"] + WAYS:
        r = find(fields, part=part, resolution=resolution, way=way)
        if r:
            rows.append([f"{short(part)} {resolution}" if not rows else "", way, r.get("grid", "") or r.get("refused", "")] +
                        [figure(r[c]) for c in ("inside", "surface", "outside", "surface_mean", "inside_mean",
                                                "stated_kb", "real_mb", "build_ms")])
    return rows


def fields_section(folder: str, fields: list) -> str:
    text = ""
    for number, title in (("2", "fields of resolution 32"), ("3", "fields of resolution 64"),
                          ("4", "fields of the two large parts, and of two real ones")):
        rows = []
        for part, resolution in dict.fromkeys((r["part"], r["resolution"]) for r in read(folder, f"table-{number}.csv")):
            rows += field_rows(fields, part, resolution)
        text += f"## Table {number}: {title}\n\n" + table(
            ["part", "way", "grid", "inside", "surface", "outside", "triangles a surface voxel", "an inside one",
             "stated KB", "real MB", "build ms"], rows) + "\n"
    return text


def reproduced_section(fields: list) -> str:
    rows = []
    for r in fields:
        if r["way"] != "paper":
            continue
        own = find(fields, part=r["part"], resolution=r["resolution"], way="uniform")
        printed = dict(r)
        if (r["part"], r["resolution"]) == ("connector", "256"):
            printed["inside"] = "306900"
        rows.append([f"{r['part']} {r['resolution']}"] +
                    [f"{100 * (float(own[c]) / float(printed[c]) - 1):+.0f} %"
                     for c in ("inside", "surface", "outside", "surface_mean", "inside_mean", "stated_kb")])
    return ("## The uniform field against the printed figures\n\nHow far ours is from theirs. The four simple parts are prisms and a cube's "
            "corner whose counts the papers' shapes must have had too; connector and brevi only stand in. Connector 256 is printed with 30.7 "
            "thousand inner voxels; the grid asks for 306.9, taken here.\n\n" +
            table(["part", "inside", "surface", "outside", "triangles a surface voxel", "an inside one", "size"], rows))


def growth_section(fields: list) -> str:
    rows = []
    for part, coarse, fine in [(p, "32", "64") for p in MADE[:4]] + [(p, "128", "256") for p in MADE[4:] + list(SHORT)[:2]]:
        for cost, name in (("stated_kb", "size"), ("build_ms", "time")):
            row = [short(part) if name == "size" else "", name]
            for way in ["paper", "uniform", "octree-own", "octree"]:
                a, b = (find(fields, part=part, resolution=n, way=way) for n in (fine, coarse))
                row.append(ratio(a.get(cost), b.get(cost)))
            rows.append(row)
    return ("## Growth for twice the resolution\n\nTimes as much; of sizes no machine changes that. The papers tell of more than 8.\n\n" +
            table(["part", "of", "paper", "uniform", "octree-own", "octree"], rows))


def printed_contours() -> dict:
    """Seconds and microseconds a point of tables 5 to 7."""
    papers = os.path.join(PAPERS, "huang-2001")
    printed = {}
    for name in ("table-5.csv", "table-6.csv", "table-7.csv"):
        for r in read(papers, name):
            printed.setdefault((r["model"], r["field_resolution"], r["contour_resolution"]), {}).update(r)
    return printed


def contours_section(contours: list) -> str:
    printed, rows, last = printed_contours(), [], None
    for r in contours:
        if r["way"] != "uniform":
            continue
        key = (r["part"], r["resolution"], r["contour_resolution"])
        own = {w: find(contours, part=key[0], resolution=key[1], contour_resolution=key[2], way=w)
               for w in ("octree-paper-rule", "octree", "default")}
        paper = printed.get(key, {})
        points = float(paper["time_s"]) / float(paper["time_per_point_us"]) * 1e6 if paper else ""
        head = f"{short(key[0])} at {figure(r['depth'])}"
        rows.append([head if head != last else "", key[1], key[2], figure(points), figure(r["points"]), figure(own["octree"]["points"]),
                     figure(1000 * float(paper["time_s"])) if paper else "", figure(r["time_ms"])] +
                    [figure(own[w]["time_ms"]) for w in ("octree-paper-rule", "octree", "default")] +
                    [figure(paper.get("time_per_point_us", "")), figure(r["us_point"])] +
                    [figure(own[w]["us_point"]) for w in ("octree-paper-rule", "octree", "default")])
        last = head
    return ("## Tables 5 to 7: contours\n\nMilliseconds, and microseconds a point. A contour resolution is the number of sub-voxels along the whole "
            "grid, its empty voxels too: so many points the papers must have had, for times over times a point (their points below) are 3.0 layers of such "
            "sub-voxels on the cube. The tolerance is the least that their rule allows for them; by that rule a sheet has 0.87 layers. "
            "The uniform field's points and those of `octree-paper-rule` are by this rule; `octree` and `default` are by cdfr's, "
            "which has no holes, places each point on the contour, and takes several times as many for the same tolerance.\n\n" +
            table(["contour", "field", "contour resolution", "points: paper", "uniform", "octree", "ms: paper", "uniform", "octree-paper-rule",
                   "octree", "default", "us a point: paper", "uniform", "octree-paper-rule", "octree", "default"], rows))


def examples_section(folder: str) -> str:
    rows = [[r["source"], short(r["part"]), figure(r["depth"]), figure(r["tolerance"]), figure(r["points"]), figure(r["field_ms"]),
             figure(r["contour_ms"]), figure(r["peak_resident_mib"]), figure(r["paper_plain_volume_gb"]),
             figure(r["paper_contour_s"])] for r in read(folder, "examples.csv")]
    text = ("## The runs of the text\n\nA process each, one thread, the default field: all that the process ever had resident, its "
            "part and the program included. Millimetres; the real head has no unit.\n\n" +
            table(["source", "part", "depth", "tolerance", "points", "field ms", "contour ms", "peak MiB",
                   "plain volume, GB", "paper's contour, s"], rows))
    for r in read(folder, "uniform-engine.csv"):
        text += (f"\nThe same engine by the papers' uniform field of resolution {r['resolution']}: {figure(r['stated_mb'])} MB by their "
                 f"count, {figure(float(r['field_ms']) / 1000)} s to build, {figure(float(r['contour_ms']) / 1000)} s for "
                 f"{figure(r['points'])} points at 10 mm to 0.1 mm (theirs: 30 s).\n")
    return text


def scaling_section(folder: str) -> str:
    resolution = read(folder, "resolution.csv")
    rows = []
    for part in ("connector", "brevi"):
        for n in dict.fromkeys(r["resolution"] for r in resolution):
            row = [part if n == "32" else "", n]
            for way in ("uniform", "octree-band", "octree-own", "octree"):
                r = find(resolution, part=part, resolution=n, way=way)
                row.append("refused: " + r["refused"] if r.get("refused") else
                           f"{figure(r['real_mb'])} MB, {figure(r['build_ms'])} ms" if r else "")
            rows.append(row)
    triangles = [[r["part"], r["splits"], figure(r["triangles"]), figure(r["real_mb"]), figure(r["build_ms"]),
                  r["bytes_triangle"], r["build_us_triangle"], r["query_ns"]] for r in read(folder, "triangles.csv")]
    laws = [[r["what"], {"lists": "lists", "real_mb": "bytes", "build_ms": "time"}[r["cost"]], r["over"],
             f"{figure(r['from'])} to {figure(r['to'])}", r["exponent"]] for r in read(folder, "power-laws.csv")]
    return ("## Resolution, 32 to 4096\n\nThe uniform field ends where it is refused: more than 2^27 voxels, 6.7 GB and their lists; an octree where its next build might take more than 100 s.\n\n" +
            table(["part", "resolution", "uniform", "octree-band", "octree-own", "octree"], rows) +
            "\n![size and time against resolution](resolution.svg)\n\n"
            "## Triangles, 12 to 5 million\n\nThe default field; every split makes four triangles of one.\n\n" +
            table(["part", "splits", "triangles", "MB", "build ms", "bytes a triangle", "us a triangle", "random query, ns"],
                  triangles) +
            "\n![size and time against triangles](triangles.svg)\n\n"
            "## Power laws\n\nLeast squares of the logarithms; over resolution from 64 on, over triangles from 1000 on.\n\n" +
            table(["what", "of", "over", "from, to", "exponent"], laws))


def targets_section(folder: str, fields: list, contours: list) -> str:
    rows = []
    for part in ("connector", "brevi"):
        u = find(fields, part=part, resolution="256", way="uniform")
        for cost, name, wanted in (("real_mb", "memory", "5"), ("build_ms", "time to build", "10")):
            shares = [ratio(u[cost], find(fields, part=part, resolution="256", way=w)[cost])
                      for w in ("octree", "octree-own", "octree-band")]
            rows.append([f"{part} 256, {name}: uniform / octree of the same finest cell", wanted,
                         f"{shares[0]} (octree-own {shares[1]}, octree-band {shares[2]})"])
    for kind in ("surface", "inside"):
        above = []
        for r in fields:
            if r["way"] == "paper":
                own = find(fields, part=r["part"], resolution=r["resolution"], way="octree-own")
                if float(own[f"{kind}_mean"]) >= float(r[f"{kind}_mean"]):
                    least = own.get(f"least_{kind}_mean")
                    above.append(f"{r['part']} {r['resolution']} ({figure(own[f'{kind}_mean'])} for {figure(r[f'{kind}_mean'])}" +
                                 (f"; no complete list is below {figure(least)})"
                                  if least and float(least) >= float(r[f"{kind}_mean"]) else ")"))
        rows.append([f"octree-own: triangles a voxel, {kind}, below the paper's in all 12 rows", "all",
                     "all" if not above else "all but " + ", ".join(above)])
    for way, cost, name in (("octree", "us_point", "time a point"), ("octree-paper-rule", "us_point", "time a point, both by the papers' rule"),
                            ("octree", "time_ms", "the whole contour at the same tolerance")):
        gains = sorted(float(r[cost]) / float(find(contours, part=r["part"], resolution=r["resolution"],
                                                   contour_resolution=r["contour_resolution"], way=way)[cost])
                       for r in contours if r["way"] == "uniform")
        rows.append([f"contours, {name}: uniform / octree of the same finest cell", "20" if name == "time a point" else "",
                     f"median {figure(statistics.median(gains))}, least {figure(gains[0])}; {sum(g >= 20 for g in gains)} of {len(gains)} rows have 20"])
    head = find(read(folder, "examples.csv"), part="cylinder-head")
    rows.append(["8.5 mm at 0.137 mm, field included: MiB in all", "at most 256", figure(head["peak_resident_mib"])])
    rows.append(["the same: seconds on one core", "at most 10",
                 figure((float(head["field_ms"]) + float(head["contour_ms"])) / 1000)])
    return "## What was aimed at\n\n" + table(["what", "wanted, at least", "measured"], rows)


def plot(folder: str, name: str, rows: list, size: str, series: str, panels: list) -> None:
    drawn, axes = plt.subplots(1, len(panels), figsize=(3.4 * len(panels), 3), squeeze=False)
    for axis, (title, own, cost, label) in zip(axes[0], panels):
        for one in dict.fromkeys(r[series] for r in own):
            points = sorted((float(r[size]), float(r[cost])) for r in own if r[series] == one and r.get(cost))
            axis.plot(*zip(*points), "o-", markersize=3, linewidth=0.8, label=one)
        axis.set(title=title, xlabel=size, ylabel=label, xscale="log", yscale="log")
        axis.grid(linewidth=0.3)
    axes[0][0].legend(fontsize=6, loc="upper left")
    drawn.tight_layout()
    drawn.savefig(os.path.join(folder, name), metadata={"Date": None})
    plt.close(drawn)


def plots(folder: str) -> None:
    resolution = [r for r in read(folder, "resolution.csv") if not r.get("refused")]
    panels = []
    for part in ("connector", "brevi"):
        own = [r for r in resolution if r["part"] == part]
        panels += [(part, own, "real_mb", "MB"), (part, own, "build_ms", "build, ms")]
    plot(folder, "resolution.svg", resolution, "resolution", "way", panels)
    triangles = read(folder, "triangles.csv")
    plot(folder, "triangles.svg", triangles, "triangles", "part",
         [("size", triangles, "real_mb", "MB"), ("build", triangles, "build_ms", "ms"),
          ("random query", triangles, "query_ns", "ns")])


HEAD = """# The papers' tables, run again

Made by `./tools/bench tables`: {date}, {processor}, {cores} cores; all on one thread. Times are of processor time. The paper's
machine was a 300 MHz SGI Octane: its times are for their growth alone.

The papers' models are not public. The made parts (`cdfr make-part`) stand in for them: their triangles, boxes and greatest depths,
not their shapes. Real parts stand beside them.

| way | what it is |
| --- | --- |
| paper | as printed |
| uniform | the papers' own field, built here as they say (`reference` room): all voxels of one size |
| octree-band | an octree whose cells split while they list more than one triangle, by the papers' own range: what the papers name as future work |
| octree-own | the same with corner dominance instead of the range |
| octree | cells split while they list more than 8 triangles, a group, and if it pays |
| default | what a caller gets who asks for nothing: as many leaves as queries need, coarser than the voxels |

All but the default have the same finest cell: the mesh is counted in voxels, so that the octree's deepest cells are the uniform field's
voxels, the same cubes. Only cells that the surface or the inside comes into have lists.

**One convention for all rows.** The grid has N voxels along the longest side, four empty ones at each end: a voxel is longest side / (N - 8). A
voxel is a point of the lattice with the cube around it; the lowest corner of the mesh's box is such a point. It is a surface voxel if
its point is at most a voxel away from a triangle and not outside, and those triangles are its list; inside if it is deeper. For octrees,
`inside` and `surface` count leaves, and `outside` leaves that have no list; triangles a voxel count a leaf for every voxel in it. Stated KB: 4 n + 5
bytes for a voxel or leaf with n triangles, 1 for another. Real MB: what malloc holds for all of it, mesh included.
`papers/huang-2001/README.md` says where and why the uniform field and the printed counts differ.
"""


def main(folder: str) -> None:
    fields = paper_fields() + [r for n in (2, 3, 4) for r in read(folder, f"table-{n}.csv")]
    contours = read(folder, "tables-5-and-6.csv") + read(folder, "table-7.csv")
    sections = [HEAD.format(**read(folder, "machine.csv")[0]), targets_section(folder, fields, contours), parts_section(folder),
                fields_section(folder, fields), reproduced_section(fields), growth_section(fields), contours_section(contours), examples_section(folder),
                scaling_section(folder)]
    with open(os.path.join(folder, "README.md"), "w") as file:
        file.write("\n".join(s.rstrip("\n") + "\n" for s in sections))
    plots(folder)


if __name__ == "__main__":
    main(sys.argv[1])
