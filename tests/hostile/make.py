"""Files that no tool writes: python3 make.py KIND FILE [VALUE...]

tiff FILE COLUMNS ROWS VALUE   a GeoTIFF of doubles in cells of a metre; all of VALUE, on one strip
                               that all rows share; VALUE may be nan or inf
png FILE WIDTH HEIGHT          a picture whose header says so; its pixels end after the first row
fits FILE WIDTH HEIGHT DEPTH   a cube of bytes
asc FILE VALUE [NODATA]        20 x 20 cells of a metre, 7 m high; VALUE at row 10, column 10
"""

import struct
import sys
import zlib


def tiff(columns, rows, value):
    columns, rows = int(columns), int(rows)
    strip = struct.pack("<d", float(value)) * columns
    scale, place = struct.pack("<3d", 1, 1, 0), struct.pack("<6d", 0, 0, 0, 0, rows, 0)
    tags = [
        (256, 4, 1, columns),
        (257, 4, 1, rows),
        (258, 3, 1, 64),
        (259, 3, 1, 1),
        (262, 3, 1, 1),
        (273, 4, rows, "offsets"),
        (277, 3, 1, 1),
        (278, 4, 1, 1),
        (279, 4, rows, "counts"),
        (339, 3, 1, 3),
        (33550, 12, 3, "scale"),
        (33922, 12, 6, "place"),
    ]
    at = 8 + 2 + 12 * len(tags) + 4
    blocks, where = b"", {}
    for name, block in (("scale", scale), ("place", place), ("strip", strip)):
        where[name] = at + len(blocks)
        blocks += block
    for name, number in (("offsets", where["strip"]), ("counts", len(strip))):
        where[name] = at + len(blocks)
        blocks += struct.pack("<I", number) * rows
        if rows == 1:
            where[name] = number
    entries = b"".join(
        struct.pack("<HHII", tag, kind, count, where.get(number, number))
        for tag, kind, count, number in tags
    )
    header = struct.pack("<2sHIH", b"II", 42, 8, len(tags))
    return header + entries + struct.pack("<I", 0) + blocks


def png(width, height):
    def chunk(kind, data):
        check = zlib.crc32(kind + data)
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", check)

    header = struct.pack(">IIBBBBB", int(width), int(height), 8, 2, 0, 0, 0)
    row = zlib.compress(bytes(1 + 3 * min(int(width), 1000)))
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", row) + chunk(b"IEND", b"")


def fits(width, height, depth):
    cards = ["SIMPLE  =                    T", "BITPIX  =                    8"]
    cards.append("NAXIS   =                    3")
    for number, size in enumerate((width, height, depth)):
        cards.append(f"NAXIS{number + 1}  = {size:>20}")
    text = "".join(card.ljust(80) for card in [*cards, "END"])
    data = bytes(int(width) * int(height) * int(depth))
    return text.ljust(2880).encode() + data.ljust(-(-len(data) // 2880) * 2880, b"\0")


def asc(value, nodata=None):
    lines = ["ncols 20", "nrows 20", "xllcorner 0", "yllcorner 0", "cellsize 1"]
    lines += [] if nodata is None else [f"NODATA_value {nodata}"]
    heights = [["7"] * 20 for _ in range(20)]
    heights[9][9] = value
    return "\n".join([*lines, *(" ".join(row) for row in heights), ""]).encode()


if __name__ == "__main__":
    kind, path, *values = sys.argv[1:]
    with open(path, "wb") as file:
        file.write({"tiff": tiff, "png": png, "fits": fits, "asc": asc}[kind](*values))
