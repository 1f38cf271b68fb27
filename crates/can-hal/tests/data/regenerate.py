#!/usr/bin/env python3
"""Makes linux.csv and python_can.csv anew: bit timings that other programs calculate with the limits of our controllers.

    apt-get source can-utils            # needs a deb-src line; contains the algorithm of the Linux kernel
    python3 -m venv venv && venv/bin/pip install python-can==4.6.1
    venv/bin/python crates/can-hal/tests/data/regenerate.py can-utils-*/can-calc-bit-timing.c

Needs cargo and a C compiler. The tests read the tables and need none of this.
"""

import csv
import io
import pathlib
import subprocess
import sys
import tempfile

import can

HERE = pathlib.Path(__file__).parent
CLOCKS = [20, 40, 48, 60, 64, 80, 120, 160]
NOMINAL = [10_000, 20_000, 50_000, 100_000, 125_000, 250_000, 500_000, 800_000, 1_000_000]
DATA = [1_000_000, 2_000_000, 4_000_000, 5_000_000, 8_000_000]


def sample_point(bit_rate):
    """CiA's recommendation in tenths of a percent."""
    return 875 if bit_rate <= 500_000 else 800 if bit_rate <= 800_000 else 750


def limits():
    command = ["cargo", "run", "--quiet", "-p", "can-hal", "--example", "limits"]
    text = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    for row in csv.DictReader(io.StringIO(text)):
        yield {key: value if key in ("controller", "phase") else int(value) for key, value in row.items()}


def build(source, folder, phases):
    """can-calc-bit-timing with our controllers among the ones it knows."""
    table = "static struct calc_bittiming_const can_calc_consts[] = {"
    entries = "".join(
        "\n\t{ .bittiming_const = { .name = \"phase%d\", .tseg1_min = %d, .tseg1_max = %d, .tseg2_min = %d, .tseg2_max = %d,"
        " .sjw_max = %d, .brp_min = %d, .brp_max = %d, .brp_inc = 1 }, .printf_btr = printf_btr_sja1000 },"
        % (number, *(p[k] for k in ("tseg1_min", "tseg1_max", "tseg2_min", "tseg2_max", "sjw_max", "brp_min", "brp_max")))
        for number, p in enumerate(phases))
    text = source.read_text()
    assert table in text, "another version of can-calc-bit-timing"
    (folder / "tool.c").write_text(text.replace(table, table + entries))
    tool = folder / "tool"
    subprocess.run(["cc", "-w", "-I", source.parent / "include", "-o", tool, folder / "tool.c"], check=True)
    return tool


def linux(tool, phases):
    for number, p in enumerate(phases):
        for clock in CLOCKS:
            clock *= 1_000_000
            if clock > p["max_clock"]:
                continue
            for rate in NOMINAL if p["phase"] == "nominal" else DATA:
                command = [tool, "-q", "-c", str(clock // p["divider"]), "-b", str(rate), f"phase{number}"]
                words = subprocess.run(command, check=True, capture_output=True, text=True).stdout.split()
                result = [""] * 4
                if "possible***" not in words:
                    prop, phase1, phase2, sjw, brp = map(int, words[2:7])
                    result = [brp, prop + phase1, phase2, sjw]
                yield [p["controller"], p["phase"], clock, rate, sample_point(rate)] + result


def python_can():
    for clock in CLOCKS:
        clock *= 1_000_000
        for nominal in NOMINAL:
            for data in DATA:
                points = sample_point(nominal), sample_point(data)
                try:
                    t = can.BitTimingFd.from_sample_point(clock, nominal, points[0] / 10, data, points[1] / 10)
                except ValueError:
                    yield [clock, nominal, points[0], data, points[1]] + [""] * 9
                    continue
                tolerance = t.oscillator_tolerance(node_loop_delay_ns=0, bus_length_m=0)
                yield [clock, nominal, points[0], data, points[1], t.nom_brp, t.nom_tseg1, t.nom_tseg2, t.nom_sjw,
                       t.data_brp, t.data_tseg1, t.data_tseg2, t.data_sjw, round(tolerance * 10_000)]


def write(name, header, rows):
    with open(HERE / name, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(header.split(","))
        writer.writerows(rows)


def main():
    phases = list(limits())
    with tempfile.TemporaryDirectory() as folder:
        tool = build(pathlib.Path(sys.argv[1]), pathlib.Path(folder), phases)
        write("linux.csv", "controller,phase,clock,bit_rate,sample_point,brp,tseg1,tseg2,sjw", linux(tool, phases))
    write("python_can.csv",
          "clock,bit_rate,sample_point,data_bit_rate,data_sample_point,brp,tseg1,tseg2,sjw,data_brp,data_tseg1,data_tseg2,"
          "data_sjw,tolerance_ppm", python_can())


main()
