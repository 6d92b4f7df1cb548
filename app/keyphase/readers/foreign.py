"""Files that are neither text nor a format keyphase reads, known by their first bytes."""

import re

_WORKBOOK = "it is a workbook of Excel: save the sheet as CSV"
_PICKLE = (
    "it is a pickle, which can run programs and is never loaded: load it where you trust it and "
    "save its arrays with numpy.savez"
)
_ARROW = "it is an Arrow file: write its table as Parquet (pyarrow.parquet.write_table)"
_TAR = "it is a tar archive: unpack it first"
_ZIP = "it is a zip archive of other files: unpack it first"

_KNOWN: tuple[tuple[bytes, str], ...] = (
    (b"\x1f\x8b", "it is packed with gzip: unpack it first"),
    (b"BZh", "it is packed with bzip2: unpack it first"),
    (b"\xfd7zXZ", "it is packed with xz: unpack it first"),
    (b"\x28\xb5\x2f\xfd", "it is packed with zstd: unpack it first"),
    (b"7z\xbc\xaf", "it is packed with 7-Zip: unpack it first"),
    (b"Rar!", "it is packed with RAR: unpack it first"),
    (b"SQLite format 3\0", "it is a database; of a ROS 2 bag name the folder it lies in, "
                             "where metadata.yaml must be (ros2 bag reindex writes it)"),
    (b"\xd0\xcf\x11\xe0", _WORKBOOK),
    (b"ARROW1", _ARROW), (b"FEA1", _ARROW), (b"\xff\xff\xff\xff", _ARROW),
    (b"ULog\x01\x12\x35", "it is a log of PX4: ulog2csv writes its topics as tables"),
    (b"TDSm", "it is a TDMS file of LabVIEW: save its channels as CSV, or with numpy.savez"),
    (b"<?xml", "it is XML: save its numbers as the columns of a CSV"),
    (b"version https://git-lfs.github.com", "it only stands for a file that was not fetched: "
                                            "git lfs pull brings it"),
    (b"RIFF", "it is sound or video: a recording is a table of places over time"),
)  # fmt: skip

_PICKLES = tuple(b"\x80" + bytes([protocol]) for protocol in (2, 3, 4, 5))
_PLAIN_PICKLE = re.compile(rb"\(?[dl]p0\n|\(dp|[}\]]q\x00|\(lp|c[\w.]+\n\w+\n")
"""How the two oldest protocols begin, which have no first bytes of their own."""

_WEB_PAGE = re.compile(rb"(\xef\xbb\xbf)?\s*<(!doctype html|html|head|body)\b", re.I)


def foreign_kind(data: bytes) -> str | None:
    """What a file is and what to do with it, by its first bytes; None where they say nothing."""
    if data.startswith(b"PK"):
        return _in_zip(data)
    if data.lstrip()[:2] in (b'{"', b"[{", b"[[", b"{\n"):
        return "it is JSON: save its numbers as the columns of a CSV, or with numpy.savez"
    if data.startswith(_PICKLES) or (data.rstrip().endswith(b".") and _PLAIN_PICKLE.match(data)):
        return _PICKLE
    if _WEB_PAGE.match(data[:256]):
        return "it is a web page, as a download that failed leaves it: download it again"
    if data[257:262] == b"ustar":
        return _TAR
    if data[4:8] == b"ftyp":
        return "it is a video: it is shown beside a recording of the same name"
    if data[1:2] == b"\x50" and b"\0" in data[:4]:
        return "it is a C3D file: save its markers as the columns of a CSV"
    return next((said for magic, said in _KNOWN if data.startswith(magic)), None)


def _in_zip(data: bytes) -> str | None:
    """What an archive is by its members, the last of which stand at its end."""
    if b"[Content_Types].xml" in data[:4096]:
        return _WORKBOOK
    if b".npy" in data[-65536:] or b".npy" in data[:4096]:
        return None
    return _PICKLE if b"data.pkl" in data[:4096] + data[-65536:] else _ZIP
