"""Files that are neither text nor a format keyphase reads, known by their first bytes."""

_WORKBOOK = "it is a workbook of Excel: save the sheet as CSV"

_KNOWN: tuple[tuple[bytes, str], ...] = (
    (b"\x80\x02", "it is a pickle, which can run programs and is never loaded: save plain arrays "
                  "with numpy.savez"),
    (b"\x1f\x8b", "it is packed with gzip: unpack it first"),
    (b"BZh", "it is packed with bzip2: unpack it first"),
    (b"\xfd7zXZ", "it is packed with xz: unpack it first"),
    (b"SQLite format 3\0", "it is a database; of a ROS 2 bag name the folder it lies in, "
                             "where metadata.yaml must be (ros2 bag reindex writes it)"),
    (b"\xd0\xcf\x11\xe0", _WORKBOOK),
    (b"ARROW1", "it is an Arrow file: save its columns with numpy.savez"),
)  # fmt: skip

_PICKLES = tuple(b"\x80" + bytes([protocol]) for protocol in (2, 3, 4, 5))


def foreign_kind(data: bytes) -> str | None:
    """What a file is and what to do with it, by its first bytes; None where they say nothing."""
    if data.startswith(b"PK") and b"[Content_Types].xml" in data[:4096]:
        return _WORKBOOK
    if data.lstrip()[:2] in (b'{"', b"[{", b"[[", b"{\n"):
        return "it is JSON: save its numbers as the columns of a CSV, or with numpy.savez"
    if data.startswith(_PICKLES):
        data = b"\x80\x02"
    return next((said for magic, said in _KNOWN if data.startswith(magic)), None)
